// The play area: disks that can be taken and moved, arrows whose tips can be dragged.
import { useRef } from 'preact/hooks';
import type { Vec } from '../engine/playback';
import type { Disk } from '../engine/scene';
import { shown, strings } from '../strings';
import { Arrow } from './arrow';
import { Backdrop } from './backdrop';
import { ChangesOfMomentum } from './change';
import { ContactVectors, FocusedVectors, Lines, Outlines } from './contact';
import { arrowKey } from './keys';
import { Leaders } from './leaders';
import { changeDisk, collisionIs, collisionShown, disksNow, grid, mostDisks, playing, setup, touched } from './model';
import { Paths } from './paths';
import { tintOf } from './tint';
import { arrowOf, centre, focus, observer, pictureHeight, pictureWidth, scale, show, toPicture, toScene } from './view';

/** Where the pointer is, in the picture's units. */
function pointerAt(event: PointerEvent, svg: SVGSVGElement): Vec {
  const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
  return { x, y };
}

/** To the grid, or with Shift to a tenth of it. */
function snapped(value: number, fine: boolean): number {
  const width = fine ? grid.value / 10 : grid.value;
  return Math.round(Math.round(value / width) * width * 1e9) / 1e9;
}

interface Grip {
  disk: number;
  what: 'place' | 'velocity';
  /** From where it was taken to what it stands for. */
  offset: Vec;
}

export function PlayArea() {
  const svg = useRef<SVGSVGElement>(null);
  const grip = useRef<Grip | null>(null);

  const take = (event: PointerEvent, disk: number, what: Grip['what'], at: Vec): void => {
    const pointer = pointerAt(event, svg.current!);
    grip.current = { disk, what, offset: { x: at.x - pointer.x, y: at.y - pointer.y } };
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    playing.value = false;
    touched.value = { disk, what };
  };
  const drag = (event: PointerEvent): void => {
    if (!grip.current) return;
    const { disk, what, offset } = grip.current;
    const pointer = pointerAt(event, svg.current!);
    const at = { x: pointer.x + offset.x, y: pointer.y + offset.y };
    if (what === 'place') movedTo(disk, at, event.shiftKey);
    else aimedAt(disk, at, event.shiftKey);
  };
  const release = (): void => {
    grip.current = null;
    touched.value = null;
  };

  return (
    <svg
      ref={svg}
      id="play-area"
      class="play-area"
      viewBox={`0 0 ${pictureWidth} ${pictureHeight.value.toFixed(1)}`}
      role="group"
      aria-label={strings.value.playArea}
      onPointerMove={drag}
      onPointerUp={release}
      onPointerCancel={release}
    >
      <Backdrop />
      <Paths />
      <Lines />
      <Outlines />
      {disksNow.value.map((disk, k) => (
        <DiskBody key={k} disk={disk} number={k} take={take} />
      ))}
      {show.value.has('centre') && <CentreOfMass />}
      <ContactVectors />
      <FocusedVectors />
      <ChangesOfMomentum />
      {!focus.value && disksNow.value.map((disk, k) => <DiskArrows key={k} disk={disk} number={k} take={take} />)}
      {disksNow.value.map((disk, k) => (
        <DiskNumber key={k} disk={disk} number={k} />
      ))}
      <Leaders />
    </svg>
  );
}

function movedTo(disk: number, at: Vec, fine: boolean): void {
  const radius = disksNow.value[disk]!.radius;
  const place = toScene(at);
  const inside = (x: number, size: number): number => Math.min(size - radius, Math.max(radius, x));
  const { width, height } = setup.value;
  changeDisk(disk, { x: snapped(inside(place.x, width), fine), y: snapped(inside(place.y, height), fine) });
}

function aimedAt(disk: number, tip: Vec, fine: boolean): void {
  const from = toPicture(disksNow.value[disk]!);
  const length = setup.value.arrow * scale.value;
  const v = { x: (tip.x - from.x) / length + observer.value.vx, y: -(tip.y - from.y) / length + observer.value.vy };
  const unit = setup.value.arrow;
  changeDisk(disk, { vx: snapped(v.x * unit, fine) / unit, vy: snapped(v.y * unit, fine) / unit });
}

interface BodyProps {
  disk: Disk;
  number: number;
  take: (event: PointerEvent, disk: number, what: Grip['what'], at: Vec) => void;
}

function DiskBody({ disk, number, take }: BodyProps) {
  const at = toPicture(disk);
  const words = strings.value;
  const tint = tintOf(disk, disksNow.value);
  const move = (event: KeyboardEvent): void => {
    const by = arrowKey(event);
    if (!by) return;
    event.preventDefault();
    const width = event.shiftKey ? grid.value / 10 : grid.value;
    changeDisk(number, { x: nearby(disk.x + by.x * width), y: nearby(disk.y + by.y * width) });
  };
  return (
    <g
      class={`disk disk-${number % 6}`}
      tabindex={0}
      role="button"
      aria-roledescription={words.movableDisk}
      aria-label={words.diskAt(number + 1, shown(disk.x), shown(disk.y))}
      data-disk={number + 1}
      onKeyDown={move}
      onFocus={() => (touched.value = { disk: number, what: 'place' })}
      onBlur={() => (touched.value = null)}
      onPointerDown={(event) => take(event, number, 'place', at)}
    >
      <circle class="focus-ring" cx={at.x} cy={at.y} r={disk.radius * scale.value + 7} />
      <circle class="body" cx={at.x} cy={at.y} r={disk.radius * scale.value} />
      {tint && <circle class={tint.denser ? 'tint denser' : 'tint'} cx={at.x} cy={at.y} r={disk.radius * scale.value} style={{ opacity: tint.amount }} />}
    </g>
  );
}

function DiskNumber({ disk, number }: Omit<BodyProps, 'take'>) {
  const at = toPicture(disk);
  const size = Math.min(34, 1.1 * disk.radius * scale.value);
  return (
    <text class="number" x={at.x} y={at.y} style={{ fontSize: `${size}px` }} aria-hidden="true">
      {number + 1}
    </text>
  );
}

const nearby = (value: number): number => Math.round(value * 1e9) / 1e9;

/** Velocity and momentum of one disk, and the handle at the velocity's tip. */
function DiskArrows({ disk, number, take }: BodyProps) {
  const words = strings.value;
  const from = toPicture(disk);
  const v = { x: disk.vx, y: disk.vy };
  const by = arrowOf(v);
  const tip = { x: from.x + by.x, y: from.y + by.y };
  const collision = collisionShown.value;
  const collides = collision?.i === number || collision?.j === number;
  const after = collisionIs.value === 'now' && collides ? 'f' : '';
  // Of many disks only the two that collide have room for names.
  const named = collides || setup.value.disks.length <= mostDisks;
  const name = (letter: string): [string, string] | undefined => (named ? [letter, `${number + 1}${after}`] : undefined);
  const aim = (event: KeyboardEvent): void => {
    const key = arrowKey(event);
    if (!key) return;
    event.preventDefault();
    const width = (event.shiftKey ? 0.1 : 1) * (grid.value / setup.value.arrow);
    changeDisk(number, { vx: nearby(v.x + key.x * width), vy: nearby(v.y + key.y * width) });
  };
  const momentum = { x: by.x * disk.mass, y: by.y * disk.mass };
  return (
    <g>
      {show.value.has('momentum') && <Arrow kind="momentum" from={from} by={momentum} name={name('p')} side={-1} />}
      {show.value.has('velocity') && <Arrow kind="velocity" from={from} by={by} name={name('v')} />}
      {show.value.has('velocity') && show.value.has('values') && disk.radius * scale.value > 15 && (
        <text class="value" x={from.x} y={from.y + disk.radius * scale.value + 22} text-anchor="middle" aria-hidden="true">
          {shown(Math.hypot(v.x - observer.value.vx, v.y - observer.value.vy))}
        </text>
      )}
      {show.value.has('velocity') && !playing.value && setup.value.disks.length <= mostDisks && (
        <g
          class="handle"
          tabindex={0}
          role="button"
          aria-roledescription={words.movableTip}
          aria-label={words.velocityOf(number + 1, shown(v.x), shown(v.y))}
          data-tip={number + 1}
          onKeyDown={aim}
          onFocus={() => (touched.value = { disk: number, what: 'velocity' })}
          onBlur={() => (touched.value = null)}
          onPointerDown={(event) => take(event, number, 'velocity', tip)}
        >
          <circle class="focus-ring" cx={tip.x} cy={tip.y} r="20" />
          <circle class="reach" cx={tip.x} cy={tip.y} r="16" />
        </g>
      )}
    </g>
  );
}

function CentreOfMass() {
  const at = toPicture(centre.value);
  const { vx, vy } = centre.value;
  return (
    <g class="centre-of-mass" aria-hidden="true">
      <path d={`M${at.x - 12},${at.y}h24M${at.x},${at.y - 12}v24`} />
      <circle cx={at.x} cy={at.y} r="6" />
      {!show.value.has('centreFrame') && show.value.has('velocity') && (
        <Arrow kind="unit" from={at} by={arrowOf({ x: vx, y: vy })} name={['V', '']} />
      )}
    </g>
  );
}
