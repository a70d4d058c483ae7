// Colours of the gas's disks: one for those of no shade, and a ramp from 0 to 1.

export type Colour3 = readonly [number, number, number];

/** Dark blue to yellow by way of green: even steps of lightness, told apart by all (after the map "viridis"). */
export const ramp: readonly Colour3[] = [
  [68, 1, 84],
  [59, 82, 139],
  [33, 145, 140],
  [94, 201, 98],
  [253, 231, 37],
];

/** Of disks whose shade is below 0. */
export const plain: Colour3 = [74, 127, 181];

/** The colour of a shade as CSS writes it. */
export function shadeColour(shade: number): string {
  if (shade < 0) return `rgb(${plain.join(',')})`;
  const at = Math.min(0.9999, shade) * (ramp.length - 1);
  const [a, b] = [ramp[Math.floor(at)]!, ramp[Math.floor(at) + 1]!];
  const part = at % 1;
  return `rgb(${[0, 1, 2].map((k) => Math.round(a[k]! + part * (b[k]! - a[k]!))).join(',')})`;
}
