// A gas in the page's address: its parameters, its seed, and how it is shown.
import type { Colour, GasParameters } from '../gas/messages';
import { colour, defaults, limits, pace, recording, tagging } from '../gas/model';
import { valuesOf } from './values';

/** How the gas is shown. */
export interface GasView {
  pace: number;
  colour: Colour;
  tag: boolean;
  record: boolean;
}

export const usualGasView: GasView = { pace: 1, colour: 'speed', tag: false, record: false };
const colours = ['speed', 'kind', 'order', 'none'] as const satisfies readonly Colour[];
const boundaries = ['periodic', 'reflecting', 'half', 'piston'] as const satisfies readonly GasParameters['boundary'][];

export function gasHash(p: GasParameters, view: GasView = usualGasView): string {
  const changed = (Object.keys(defaults) as (keyof GasParameters)[]).filter((key) => p[key] !== defaults[key] || key === 'seed');
  const parts = changed.map((key) => `${key}=${p[key]}`);
  if (view.pace !== usualGasView.pace) parts.push(`pace=${view.pace}`);
  if (view.colour !== usualGasView.colour) parts.push(`colour=${view.colour}`);
  if (view.tag) parts.push('tag=1');
  if (view.record) parts.push('record=1');
  return `#gas&${parts.join('&')}`;
}

const whole = (key: string, value: number): number => (key === 'number' || key === 'seed' ? Math.round(value) : value);

export function gasOf(hash: string): GasParameters {
  const values = valuesOf(hash);
  const next: Record<string, unknown> = { ...defaults };
  for (const [key, given] of values) {
    const usual = defaults[key as keyof GasParameters];
    const [least, most] = limits[key as keyof typeof limits] ?? [0, 0];
    if (typeof usual === 'number' && Number.isFinite(Number(given))) next[key] = Math.min(most, Math.max(least, whole(key, Number(given))));
    if (key === 'boundary') next[key] = boundaries.find((one) => one === given) ?? usual;
    if (key === 'speeds' && (given === 'equal' || given === 'maxwell')) next[key] = given;
  }
  return next as unknown as GasParameters;
}

export function gasViewOf(hash: string): GasView {
  const values = valuesOf(hash);
  const given = Number(values.get('pace'));
  return {
    pace: given > 0 ? Math.min(1000, Math.max(0.01, given)) : usualGasView.pace,
    colour: colours.find((one) => one === values.get('colour')) ?? usualGasView.colour,
    tag: values.get('tag') === '1',
    record: values.get('record') === '1',
  };
}

export const gasViewNow = (): GasView => ({ pace: pace.value, colour: colour.value, tag: tagging.value, record: recording.value });

export function showGasAs(view: GasView): void {
  pace.value = view.pace;
  colour.value = view.colour;
  tagging.value = view.tag;
  recording.value = view.record;
}
