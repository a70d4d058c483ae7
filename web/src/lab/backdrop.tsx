// What lies behind the disks: grid, walls and scale.
import { computed } from '@preact/signals';
import { shown, strings } from '../strings';
import { cursor, setup } from './model';
import { pictureHeight, pictureWidth, scale, show, toPicture } from './view';

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
      {show.value.has('scale') && <ScaleBar decimals={decimals} />}
      <text class="unit" x={pictureWidth - 14} y={28} text-anchor="end">
        {strings.value.timeIs(shown(cursor.value.time, 2))}
      </text>
    </g>
  );
}

/** How long a cell of the grid is. */
function ScaleBar({ decimals }: { decimals: number }) {
  const length = cell.value * scale.value;
  return (
    <g class="scale">
      <path d={`M16,14v14M16,21h${length}M${16 + length},14v14`} />
      <text x={28 + length} y={27}>
        {strings.value.scaleIs(shown(cell.value, decimals))}
      </text>
    </g>
  );
}
