// Charts of the gas: speeds against Maxwell's, and what changes with time.
import { useMemo } from 'preact/hooks';
import uPlot from 'uplot';
import { shown, strings } from '../strings';
import { maxwellH, maxwellShare } from './measure';
import type { Measured } from './messages';
import { history, parameters, wallStands } from './model';
import { Column, Plot, themeColour } from './plot';
import { compressibilityOf } from './theory';

const bars: uPlot.Series = { stroke: themeColour('--disk-1'), fill: themeColour('--disk-1'), width: 0, points: { show: false }, paths: uPlot.paths.bars!({ size: [0.9] }) };
const measuredLine: uPlot.Series = { stroke: themeColour('--disk-1'), width: 2, points: { show: false } };
const theoryLine: uPlot.Series = { stroke: themeColour('--disk-2'), width: 2.5, points: { show: false } };
const theoryCurve: uPlot.Series = { ...theoryLine, paths: uPlot.paths.spline!() };
const theoryDashed: uPlot.Series = { ...theoryLine, dash: [7, 5] };

/** Speeds at the middle of bins, the density of disks there, and Maxwell's. */
export function speedColumns({ histogram, binWidth }: Pick<Measured, 'histogram' | 'binWidth'>): Column[] {
  const edge = (k: number): number => (4 * k) / histogram.length; // in √(kT/m)
  return [
    Array.from(histogram, (_, k) => (k + 0.5) * binWidth),
    Array.from(histogram, (share) => share / binWidth),
    Array.from(histogram, (_, k) => maxwellShare(edge(k), edge(k + 1)) / binWidth),
  ];
}

export function SpeedChart({ measured }: { measured: Measured }) {
  const words = strings.value.gas;
  const columns = useMemo(() => speedColumns(measured), [measured]);
  return (
    <Plot
      caption={words.histogram}
      note={words.histogramNote}
      label={`${words.histogram}. ${words.histogramNote}`}
      axes={['v', 'f']}
      series={[bars, theoryCurve]}
      yRange={(_, __, most) => [0, 1.05 * (most || 1)]}
      columns={columns}
    />
  );
}

/** From a little below the least value to a little above the greatest. */
export function roomy(least: number | null, most: number | null): [number, number] {
  if (least === null || most === null || !Number.isFinite(least) || !Number.isFinite(most)) return [0, 1];
  const room = (most - least) * 0.1 || 0.05 * Math.abs(most) || 0.1;
  return [least - room, most + room];
}

interface SeriesProps {
  caption: string;
  note: string;
  axis: string;
  of: 'h' | 'compressibility';
  theory: number | undefined;
}

function Series({ caption, note, axis, of, theory }: SeriesProps) {
  const points = history.value;
  const columns = useMemo(() => {
    // Of the last minute and some.
    const known = points.slice(-300).filter((point) => Number.isFinite(point[of]));
    return [known.map(({ time }) => time), known.map((point) => point[of]), known.map(() => theory ?? null)];
  }, [points, theory]);
  const now = columns[1]!.at(-1);
  return (
    <Plot
      caption={caption}
      note={note}
      label={`${caption}: ${now === undefined ? '–' : shown(now!, 3)}. ${note}`}
      axes={['t', axis]}
      series={[measuredLine, theoryDashed]}
      yRange={(_, least, most) => roomy(least, most)}
      columns={columns}
    />
  );
}

export function HChart() {
  const words = strings.value.gas;
  return <Series caption={words.h} note={words.hNote} axis="H" of="h" theory={maxwellH} />;
}

export function PressureChart({ measured }: { measured: Measured }) {
  const words = strings.value.gas;
  const { fraction, restitution } = parameters.value;
  const simple = fraction === 0 && restitution === 1 && !(measured.piston && !wallStands.value);
  const theory = simple ? compressibilityOf(measured.packing) : undefined;
  return <Series caption={words.pressure} note={words.pressureNote} axis="Z" of="compressibility" theory={theory} />;
}
