// Lines that lead from what is being moved to its numbers: of a disk to both axes, of an arrow to its components.
import type { Vec } from '../engine/playback';
import type { Disk } from '../engine/scene';
import { shown } from '../strings';
import { disksNow, grid, playing, setup, touched } from './model';
import { arrowOf, observer, scale, toPicture } from './view';

/** Decimals that tell fine steps of the grid apart. */
const decimals = (): number => Math.max(0, Math.ceil(-Math.log10(grid.value / 10 / setup.value.arrow) - 1e-9));

interface LineProps {
  from: Vec;
  to: Vec;
  base: string;
  index?: string;
  value: number;
  at: Vec;
  anchor?: 'start' | 'middle' | 'end';
}

function Leader({ from, to, base, index = '', value, at, anchor = 'middle' }: LineProps) {
  return (
    <g>
      <line x1={from.x} y1={from.y} x2={to.x} y2={to.y} />
      <text x={at.x} y={at.y} text-anchor={anchor} dominant-baseline="central">
        <tspan class="letter">{base}</tspan>
        {index && (
          <tspan class="index" dy="6">
            {index}
          </tspan>
        )}
        <tspan dy={index ? -6 : 0}> = {shown(value, decimals())}</tspan>
      </text>
    </g>
  );
}

function OfPlace({ disk }: { disk: Disk }) {
  const at = toPicture(disk);
  const below = toPicture({ x: disk.x, y: 0 });
  const left = toPicture({ x: 0, y: disk.y });
  return (
    <>
      <Leader from={at} to={below} base="x" value={disk.x} at={{ x: below.x + 10, y: below.y - 34 }} anchor="start" />
      <Leader from={at} to={left} base="y" value={disk.y} at={{ x: left.x + 44, y: left.y - 18 }} anchor="start" />
    </>
  );
}

function OfVelocity({ disk }: { disk: Disk }) {
  const from = toPicture(disk);
  const by = arrowOf({ x: disk.vx, y: disk.vy });
  const tip = { x: from.x + by.x, y: from.y + by.y };
  const corner = { x: tip.x, y: from.y };
  const away = by.x < 0 ? -1 : 1;
  // Beyond the disk, and below it beyond its speed.
  const beside = disk.radius * scale.value + (by.y > 0 ? 16 : 48);
  return (
    <>
      <Leader from={from} to={corner} base="v" index="x" value={disk.vx} at={{ x: (from.x + corner.x) / 2, y: from.y + (by.y > 0 ? -beside : beside) }} />
      <Leader
        from={corner}
        to={tip}
        base="v"
        index="y"
        value={disk.vy}
        at={{ x: corner.x + away * 26, y: (corner.y + tip.y) / 2 }}
        anchor={away > 0 ? 'start' : 'end'}
      />
    </>
  );
}

export function Leaders() {
  const disk = touched.value && disksNow.value[touched.value.disk];
  // An observer who moves sees other velocities than the table.
  const still = observer.value.vx === 0 && observer.value.vy === 0;
  if (!disk || playing.value || !still) return null;
  return (
    <g class="leaders" aria-hidden="true">
      {touched.value!.what === 'place' ? <OfPlace disk={disk} /> : <OfVelocity disk={disk} />}
    </g>
  );
}
