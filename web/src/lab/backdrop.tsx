// What lies behind the disks: grid, walls, scale, and the paths that were flown.
import { computed } from '@preact/signals';
import type { Vec } from '../engine/playback';
import { shown, strings } from '../strings';
import { contactsSoFar, cursor, disksNow, playback, setup } from './model';
import { observer, pictureHeight, pictureWidth, scale, show, toPicture } from './view';

/** Width of the grid's cells: a round length, some ten of them across. */
const cell = computed(() => {
  const power = 10 ** Math.floor(Math.log10(setup.value.width / 5));
  return [1, 2, 5, 10].map((digit) => digit * power).find((width) => setup.value.width / width <= 20)!;
});

function lines(size: number): number[] {
  return Array.from({ length: Math.floor(size / cell.value + 1e-9) + 1 }, (_, k) => k * cell.value);
}

export function Backdrop() {
  const { width, height, boundary } = setup.value;
  const low = toPicture({ x: 0, y: 0 });
  const high = toPicture({ x: width, y: height });
  const decimals = cell.value < 0.1 ? 2 : cell.value < 1 ? 1 : 0;
  return (
    <g class="backdrop" aria-hidden="true">
      <rect class="ground" x="0" y="0" width={pictureWidth} height={pictureHeight.value} />
      {show.value.has('grid') && (
        <g class="grid">
          {lines(width).map((x) => (
            <line key={`x${x}`} x1={toPicture({ x, y: 0 }).x} x2={toPicture({ x, y: 0 }).x} y1={high.y} y2={low.y} />
          ))}
          {lines(height).map((y) => (
            <line key={`y${y}`} x1={low.x} x2={high.x} y1={toPicture({ x: 0, y }).y} y2={toPicture({ x: 0, y }).y} />
          ))}
          {lines(width).slice(1, -1).map((x) => (
            <text key={x} x={toPicture({ x, y: 0 }).x} y={low.y - 8} text-anchor="middle">
              {shown(x, decimals)}
            </text>
          ))}
          {lines(height).slice(1, -1).map((y) => (
            <text key={y} x={low.x + 8} y={toPicture({ x: 0, y }).y + 5}>
              {shown(y, decimals)}
            </text>
          ))}
        </g>
      )}
      {boundary[0] === 'reflecting' && <path class="wall" d={`M${low.x},${low.y}V${high.y}M${high.x},${low.y}V${high.y}`} />}
      {boundary[1] === 'reflecting' && <path class="wall" d={`M${low.x},${low.y}H${high.x}M${low.x},${high.y}H${high.x}`} />}
      <text class="unit" x={pictureWidth - 14} y={28} text-anchor="end">
        {strings.value.timeIs(shown(cursor.value.time, 2))}
      </text>
    </g>
  );
}

/** Where each disk has been: straight from contact to contact. */
export function Paths() {
  const corners: Vec[][] = setup.value.disks.map(({ x, y }) => [{ x, y }]);
  const last = contactsSoFar.value;
  for (let k = Math.max(0, last - 200); k < last; ++k) {
    const { i, j, positionI, positionJ } = playback.value.contact(k)!;
    corners[i]!.push(positionI);
    if (typeof j === 'number') corners[j]!.push(positionJ);
  }
  disksNow.value.forEach((disk, k) => corners[k]!.push(disk));
  // In the frame of the centre of mass paths would have to bend with it; they are drawn as the table sees them.
  const moving = observer.value.vx !== 0 || observer.value.vy !== 0;
  if (moving) return null;
  return (
    <g class="paths" aria-hidden="true">
      {corners.map((points, k) => (
        <polyline
          key={k}
          class={`disk-${k % 6}`}
          stroke-dasharray={k % 2 ? '10 6' : undefined}
          stroke-width={Math.min(4, 0.2 * setup.value.disks[k]!.radius * scale.value)}
          points={points.map((point) => toPicture(point)).map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ')}
        />
      ))}
    </g>
  );
}
