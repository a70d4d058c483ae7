// Arrows: told apart by colour, by stroke and by the name at the tip.
import type { Vec } from '../engine/playback';

export type ArrowKind = 'velocity' | 'velocity-before' | 'momentum' | 'normal' | 'tangential' | 'impulse' | 'change' | 'unit';

interface Props {
  kind: ArrowKind;
  from: Vec;
  /** From its tail to its tip, in the picture's units. */
  by: Vec;
  /** Base letter and index, as in v₁ₙ. */
  name?: [string, string] | undefined;
  /** Which side of the tip the name stands on. */
  side?: 1 | -1;
}

const head = 15;

export function Arrow({ kind, from, by, name, side = 1 }: Props) {
  const length = Math.hypot(by.x, by.y);
  if (length < 1.5) return null;
  const u = { x: by.x / length, y: by.y / length };
  const tip = { x: from.x + by.x, y: from.y + by.y };
  const reach = Math.min(head, 0.8 * length);
  const neck = { x: tip.x - u.x * reach, y: tip.y - u.y * reach };
  const half = reach * 0.48;
  const corners = [tip, { x: neck.x - u.y * half, y: neck.y + u.x * half }, { x: neck.x + u.y * half, y: neck.y - u.x * half }];
  const label = { x: tip.x + u.x * 14 - side * u.y * 16, y: tip.y + u.y * 14 + side * u.x * 16 };
  return (
    <g class={`arrow ${kind}`} aria-hidden="true">
      <line class="halo" x1={from.x} y1={from.y} x2={tip.x} y2={tip.y} />
      <line class="shaft" x1={from.x} y1={from.y} x2={neck.x} y2={neck.y} />
      <polygon points={corners.map(({ x, y }) => `${x.toFixed(2)},${y.toFixed(2)}`).join(' ')} />
      {name && <Label at={label} base={name[0]} index={name[1]} />}
    </g>
  );
}

export function Label({ at, base, index }: { at: Vec; base: string; index: string }) {
  return (
    <text class="name" x={at.x} y={at.y} text-anchor="middle" dominant-baseline="central">
      <tspan class="letter">{base}</tspan>
      <tspan class="index" dy="7">
        {index}
      </tspan>
    </text>
  );
}
