// A chart of uPlot's in the page's colours and with its numbers.
import { useEffect, useRef, useState } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { inLanguage, language } from '../strings';
import { dark } from '../ui/theme';

const height = 170;

/** A colour of the theme, as it is when it is drawn with. */
export const themeColour = (name: string) => (): string => getComputedStyle(document.documentElement).getPropertyValue(name);

export type Column = (number | null)[];

interface Props {
  caption: string;
  note: string;
  /** What the picture says, for those who do not see it. */
  label: string;
  /** Names of what stands along x and y, for the reading under the pointer. */
  axes: [string, string];
  /** One for each column after the first, which is x. */
  series: uPlot.Series[];
  yRange: uPlot.Range.Function;
  columns: Column[];
}

const axis = (): uPlot.Axis => ({
  stroke: themeColour('--soft'),
  font: '11px system-ui, sans-serif',
  grid: { stroke: themeColour('--grid'), width: 1 },
  ticks: { stroke: themeColour('--grid'), width: 1, size: 4 },
  values: (_, ticks) => ticks.map((tick) => inLanguage(tick)),
});

function optionsOf({ series, yRange, axes }: Props, width: number, read: (words: string) => void): uPlot.Options {
  const told = (u: uPlot): void => {
    const at = u.cursor.idx;
    const [x, y] = at === null || at === undefined ? [null, null] : [u.data[0][at], u.data[1]![at]];
    const short = (value: number): string => inLanguage(Number(value.toPrecision(4)));
    read(x === null || x === undefined || y === null || y === undefined ? '' : `${axes[0]} ${short(x)}, ${axes[1]} ${short(y)}`);
  };
  return {
    width,
    height,
    padding: [8, 16, 0, 0],
    legend: { show: false },
    cursor: { y: false, drag: { x: false, y: false }, points: { show: false } },
    scales: { x: { time: false, range: (_, least, most) => (least < most ? [least, most] : [least, least + 1]) }, y: { range: yRange } },
    axes: [{ ...axis(), size: 24, space: 45 }, { ...axis(), size: 44, space: 26 }],
    series: [{}, ...series],
    hooks: { setCursor: [told] },
  };
}

/** Keeps the chart as wide as its place, and in the colours of the page or of paper. */
function kept(chart: uPlot, place: HTMLElement): () => void {
  const resize = new ResizeObserver(() => chart.setSize({ width: place.clientWidth, height }));
  resize.observe(place);
  const redraw = (): void => chart.redraw(false);
  addEventListener('beforeprint', redraw);
  addEventListener('afterprint', redraw);
  return () => {
    resize.disconnect();
    removeEventListener('beforeprint', redraw);
    removeEventListener('afterprint', redraw);
    chart.destroy();
  };
}

export function Plot(props: Props) {
  const place = useRef<HTMLDivElement>(null);
  const chart = useRef<uPlot | null>(null);
  const [reading, read] = useState('');
  useEffect(() => {
    const made = new uPlot(optionsOf(props, place.current!.clientWidth, read), props.columns as uPlot.AlignedData, place.current!);
    chart.current = made;
    return kept(made, place.current!);
  }, [language.value]);
  useEffect(() => chart.current!.setData(props.columns as uPlot.AlignedData), [props.columns]);
  useEffect(() => chart.current!.redraw(false), [dark.value]);
  return (
    <figure class="chart">
      <figcaption>
        {props.caption} <span class="reading">{reading}</span>
      </figcaption>
      <div class="plot" ref={place} role="img" aria-label={props.label} />
      <p class="note">{props.note}</p>
    </figure>
  );
}
