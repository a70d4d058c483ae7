// The paths that were flown, straight from contact to contact: those of the last seconds, which fade, or all.
import type { Vec } from '../engine/playback';
import type { Disk } from '../engine/scene';
import { contactsSoFar, cursor, disksNow, playback, setup } from './model';
import { observer, scale, show, toPicture, totalMass } from './view';

/** Seconds of the page's clock after which a path has faded. */
const lasting = 3;
/** Steps of fading. */
const slices = 12;
/** Contacts that are looked back at, at most. */
const mostContacts = 200;

/** Where a disk was at a time. */
interface Stay extends Vec {
  time: number;
}

/** Where all disks were from one time on up to now. */
class Past {
  readonly from: number;
  readonly to = cursor.value.time;
  private readonly stays: Stay[][];
  /** Times of all contacts. */
  readonly contacts: number[] = [];

  constructor(from: number) {
    const last = contactsSoFar.value;
    const first = Math.max(last - mostContacts, from > 0 ? playback.value.contactsUntil(from) : 0);
    this.from = first > 0 ? Math.max(from, playback.value.contact(first - 1)!.time) : from;
    const start = this.from > 0 ? playback.value.disksAt(this.from) : setup.value.disks;
    this.stays = start.map(({ x, y }) => [{ time: this.from, x, y }]);
    for (let k = first; k < last; ++k) {
      const { i, j, time, positionI, positionJ } = playback.value.contact(k)!;
      this.stays[i]!.push({ time, ...positionI });
      if (typeof j === 'number') this.stays[j]!.push({ time, ...positionJ });
      this.contacts.push(time);
    }
    disksNow.value.forEach(({ x, y }, k) => this.stays[k]!.push({ time: this.to, x, y }));
  }

  placeOf(disk: number, time: number): Vec {
    const stays = this.stays[disk]!;
    const next = stays.findIndex((stay) => stay.time >= time);
    const [a, b] = [stays[Math.max(0, next - 1)]!, stays[next < 0 ? stays.length - 1 : next]!];
    const part = b.time > a.time ? (time - a.time) / (b.time - a.time) : 1;
    return { x: a.x + part * (b.x - a.x), y: a.y + part * (b.y - a.y) };
  }

  centre(time: number): Vec {
    const sum = { x: 0, y: 0 };
    setup.value.disks.forEach(({ mass }, k) => {
      const { x, y } = this.placeOf(k, time);
      sum.x += (mass * x) / totalMass.value;
      sum.y += (mass * y) / totalMass.value;
    });
    return sum;
  }
}

/** Points in the picture between two times, by way of the contacts between, as the frame of reference saw them then. */
function between(past: Past, body: (time: number) => Vec, a: number, b: number): Vec[] {
  const times = [a, ...past.contacts.filter((time) => time > a && time < b), b];
  const moving = show.value.has('centreFrame');
  const now = moving ? past.centre(past.to) : { x: 0, y: 0 };
  return times.map((time) => {
    const { x, y } = body(time);
    if (!moving) return toPicture({ x, y });
    const then = past.centre(time);
    return toPicture({ x: x - then.x + now.x, y: y - then.y + now.y });
  });
}

interface TrailProps {
  past: Past;
  body: (time: number) => Vec;
  name: string;
  width: number;
  dash: string | undefined;
  fades: boolean;
}

function Trail({ past, body, name, width, dash, fades }: TrailProps) {
  const line = (a: number, b: number, opacity: number) => (
    <polyline
      key={a}
      class={name}
      stroke-dasharray={dash}
      stroke-width={width}
      style={{ opacity }}
      points={between(past, body, a, b).map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ')}
    />
  );
  if (!fades) return line(past.from, past.to, 0.65);
  const step = (lasting * setup.value.rate) / slices;
  const parts = Math.min(slices, Math.ceil((past.to - past.from) / step - 1e-9));
  return (
    <>
      {Array.from({ length: parts }, (_, k) => {
        const until = past.to - k * step;
        return line(Math.max(past.from, until - step), until, 0.9 * (1 - (k + 0.5) / slices));
      })}
    </>
  );
}

const widthOf = ({ radius }: Disk): number => Math.min(4, 0.2 * radius * scale.value);

export function Paths() {
  const whole = show.value.has('wholePaths');
  if (!whole && !show.value.has('paths')) return null;
  // Seen by an observer who moves, paths bend at the contacts of others too.
  void observer.value;
  const past = new Past(whole ? 0 : Math.max(0, cursor.value.time - lasting * setup.value.rate));
  if (past.to <= past.from) return null;
  return (
    <g class="paths" aria-hidden="true">
      {setup.value.disks.map((disk, k) => (
        <Trail
          key={k}
          past={past}
          body={(time) => past.placeOf(k, time)}
          name={`disk-${k % 6}`}
          width={widthOf(disk)}
          dash={k % 2 ? '10 6' : undefined}
          fades={!whole}
        />
      ))}
      {show.value.has('centre') && (
        <Trail past={past} body={(time) => past.centre(time)} name="of-centre" width={2.5} dash="3 5" fades={!whole} />
      )}
    </g>
  );
}
