// Charts of the gas: speeds against Maxwell's, and what changes with time.
import { shown, strings } from '../strings';
import { maxwellH, maxwellShare } from './measure';
import type { Measured } from './messages';
import { history, parameters } from './model';
import { compressibilityOf } from './theory';

const width = 320;
const height = 150;
const edge = { left: 40, right: 8, top: 10, bottom: 24 };
const inner = { width: width - edge.left - edge.right, height: height - edge.top - edge.bottom };

const polyline = (points: [number, number][]): string => points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' ');

/** Round numbers between two values, some four of them. */
export function ticks(low: number, high: number): number[] {
  const rough = (high - low) / 4;
  if (!(rough > 0)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((one) => one >= rough)!;
  const first = Math.ceil(low / step - 1e-9) * step;
  return Array.from({ length: 12 }, (_, k) => first + k * step).filter((tick) => tick <= high + 1e-9 * step);
}

const decimalsFor = (marks: number[]): number => {
  const step = (marks[1] ?? 1) - (marks[0] ?? 0);
  return Math.max(0, Math.min(4, -Math.floor(Math.log10(step || 1) + 1e-9)));
};

interface FrameProps {
  caption: string;
  note: string;
  label: string;
  x: [number, number];
  y: [number, number];
  children: preact.ComponentChildren;
}

function Chart({ caption, note, label, x, y, children }: FrameProps) {
  const xs = ticks(...x);
  const ys = ticks(...y);
  const px = (value: number): number => edge.left + ((value - x[0]) / (x[1] - x[0] || 1)) * inner.width;
  const py = (value: number): number => edge.top + inner.height - ((value - y[0]) / (y[1] - y[0] || 1)) * inner.height;
  return (
    <figure class="chart">
      <figcaption>{caption}</figcaption>
      <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-label={label}>
        <path class="axes" d={`M${edge.left},${edge.top}V${edge.top + inner.height}H${width - edge.right}`} />
        {xs.map((tick) => (
          <text key={`x${tick}`} x={px(tick)} y={height - 7} text-anchor="middle">
            {shown(tick, decimalsFor(xs))}
          </text>
        ))}
        {ys.map((tick) => (
          <g key={`y${tick}`}>
            <line class="gridline" x1={edge.left} x2={width - edge.right} y1={py(tick)} y2={py(tick)} />
            <text x={edge.left - 5} y={py(tick) + 4} text-anchor="end">
              {shown(tick, decimalsFor(ys))}
            </text>
          </g>
        ))}
        {children}
      </svg>
      <p class="note">{note}</p>
    </figure>
  );
}

export function SpeedChart({ measured }: { measured: Measured }) {
  const words = strings.value.gas;
  const { histogram, binWidth } = measured;
  const unit = binWidth / (4 / histogram.length); // √(kT/m)
  const most = Math.max(0.12 * (32 / histogram.length), ...histogram) * 1.05;
  const bar = inner.width / histogram.length;
  const y = (share: number): number => edge.top + inner.height * (1 - share / most);
  const line: [number, number][] = [...histogram].map((_, k) => [
    edge.left + (k + 0.5) * bar,
    y(maxwellShare((k * 4) / histogram.length, ((k + 1) * 4) / histogram.length)),
  ]);
  const perUnit = (share: number): number => share / binWidth;
  return (
    <Chart caption={words.histogram} note={words.histogramNote} label={`${words.histogram}. ${words.histogramNote}`} x={[0, 4 * unit]} y={[0, perUnit(most)]}>
      {[...histogram].map((share, k) => (
        <rect key={k} class="bar-of-chart" x={edge.left + k * bar + 0.5} width={bar - 1} y={y(share)} height={Math.max(0, edge.top + inner.height - y(share))} />
      ))}
      <polyline class="theory" points={polyline(line)} />
    </Chart>
  );
}

interface SeriesProps {
  caption: string;
  note: string;
  of: 'h' | 'z';
  least?: number;
  theory?: number;
}

export function Series({ caption, note, of, theory }: SeriesProps) {
  const points = history.value.filter((point) => Number.isFinite(point[of]));
  const values = points.map((point) => point[of]);
  const bounds = theory === undefined ? values : [...values, theory];
  const [lowest, highest] = bounds.length > 0 ? [Math.min(...bounds), Math.max(...bounds)] : [0, 1];
  const room = (highest - lowest) * 0.1 || 0.05 * Math.abs(highest) || 0.1;
  const y: [number, number] = [lowest - room, highest + room];
  const x: [number, number] = [points[0]?.time ?? 0, points[points.length - 1]?.time ?? 1];
  if (x[0] === x[1]) x[1] = x[0] + 1;
  const px = (value: number): number => edge.left + ((value - x[0]) / (x[1] - x[0])) * inner.width;
  const py = (value: number): number => edge.top + inner.height - ((value - y[0]) / (y[1] - y[0])) * inner.height;
  const now = values[values.length - 1];
  return (
    <Chart caption={caption} note={note} label={`${caption}: ${now === undefined ? '–' : shown(now, 3)}. ${note}`} x={x} y={y}>
      {theory !== undefined && <line class="theory dashed" x1={edge.left} x2={width - edge.right} y1={py(theory)} y2={py(theory)} />}
      <polyline class="series" points={polyline(points.map((point) => [px(point.time), py(point[of])]))} />
    </Chart>
  );
}

export function HChart() {
  const words = strings.value.gas;
  return <Series caption={words.h} note={words.hNote} of="h" theory={maxwellH} />;
}

export function PressureChart({ measured }: { measured: Measured }) {
  const words = strings.value.gas;
  const { fraction, restitution } = parameters.value;
  const theory = fraction === 0 && restitution === 1 ? compressibilityOf(measured.packing) : undefined;
  return <Series caption={words.pressure} note={words.pressureNote} of="z" theory={theory} />;
}
