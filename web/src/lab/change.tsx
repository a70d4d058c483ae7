// What a collision changed: the change in momentum of both disks, drawn where they met and tied to where they are.
import { Collision, isCollision, Vec } from '../engine/playback';
import { reducedMotion } from '../ui/motion';
import { Arrow } from './arrow';
import { contactsSoFar, cursor, disksNow, playback, playing, setup } from './model';
import { arrowOfPart, show, toPicture, toPictureThen } from './view';

/** Seconds of the page's clock in full strength, and then of fading. */
const full = 0.5;
const fading = 0.5;
/** Collisions of one moment or close together that are shown, at most. */
const most = 20;

/** From 1 to 0. Where nothing is to fade, it is there until the next step. */
export function strength(age: number, standing: boolean, reduced: boolean): number {
  if (reduced) return standing || age === 0 ? 1 : 0;
  return Math.max(0, Math.min(1, 1 - (age - full) / fading));
}

interface Recent {
  collision: Collision;
  strength: number;
}

function recent(): Recent[] {
  const { time, at } = cursor.value;
  const found: Recent[] = [];
  for (let k = contactsSoFar.value - 1; k >= 0 && found.length < most; --k) {
    const contact = playback.value.contact(k)!;
    const age = (time - contact.time) / setup.value.rate;
    if (age > full + fading) break;
    // While it plays, a step is too short to see.
    const standing = at?.index === k || playing.value;
    const now = strength(age, standing, reducedMotion.value);
    if (isCollision(contact) && now > 0) found.push({ collision: contact, strength: now });
  }
  return found;
}

function Changes({ collision, strength }: Recent) {
  const { i, j, positionI, positionJ, beforeI, beforeJ, afterI, afterJ } = collision;
  const disks = setup.value.disks;
  const then = show.value.has('centreFrame') ? playback.value.disksAfter(collision) : disks;
  const one = (disk: number, place: Vec, before: Vec, after: Vec) => {
    const from = toPictureThen(place, then);
    const to = toPicture(disksNow.value[disk]!);
    const mass = disks[disk]!.mass;
    const by = arrowOfPart({ x: mass * (after.x - before.x), y: mass * (after.y - before.y) });
    return (
      <g key={disk} data-change={disk + 1}>
        <line class="tie" x1={from.x} y1={from.y} x2={to.x} y2={to.y} />
        <Arrow kind="change" from={from} by={by} name={['Δp', `${disk + 1}`]} side={-1} />
      </g>
    );
  };
  return (
    <g style={{ opacity: strength }}>
      {one(i, positionI, beforeI, afterI)}
      {one(j, positionJ, beforeJ, afterJ)}
    </g>
  );
}

export function ChangesOfMomentum() {
  if (!show.value.has('change')) return null;
  return (
    <g aria-hidden="true">
      {recent().map((one) => (
        <Changes key={one.collision.index} {...one} />
      ))}
    </g>
  );
}
