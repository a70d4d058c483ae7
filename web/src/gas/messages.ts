// What the page and the worker that runs the gas say to each other.
export type Colour = 'speed' | 'kind' | 'order' | 'none';

export interface GasParameters {
  number: number;
  packing: number;
  temperature: number;
  boundary: 'periodic' | 'reflecting';
  restitution: number;
  fraction: number;
  radiusRatio: number;
  massRatio: number;
  speeds: 'equal' | 'maxwell';
  seed: number;
}

export type Request =
  | { kind: 'start'; module: WebAssembly.Module }
  | { kind: 'make'; toml: string; equalSpeeds: boolean }
  | { kind: 'advance'; time: number; colour: Colour; tag: boolean; measure: boolean }
  | { kind: 'reverse' }
  | { kind: 'removeWall' }
  | { kind: 'save' };

/** The disks as they are drawn: x, y and a colour from 0 to 1 (below 0: none) for each. */
export interface Picture {
  kind: 'picture';
  disks: Float32Array;
  /** The tagged disk's path since the last picture that had one: x, y, not folded into the box. */
  tagged: Vec | null;
  time: number;
  /** What was asked for took longer than a frame may. */
  limited: boolean;
  /** Of the engine's work for this frame (ms). */
  work: number;
  measured: Measured | null;
}

interface Vec {
  x: number;
  y: number;
}

export interface Measured {
  time: number;
  collisions: number;
  kT: number;
  /** Collisions per disk and time since the last measurement. */
  rate: number;
  drift: number;
  packing: number;
  /** βP/ρ over the last stretch of time; NaN where there is none. */
  compressibility: number;
  density: number;
  order: number;
  /** Share of disks per bin of speed, in units of bins of `binWidth`. */
  histogram: Float64Array;
  binWidth: number;
  /** ∫ f ln f over the velocity components of disks of mean mass, in units in which Maxwell's value is its least. */
  h: number;
}

export interface Made {
  kind: 'made';
  width: number;
  height: number;
  /** Radius and mass of each disk. */
  kinds: Float64Array;
}

export type Answer =
  | Picture
  | Made
  | { kind: 'reversed'; time: number; returnsAt: number }
  | { kind: 'returned'; distance: number }
  | { kind: 'saved'; toml: string }
  | { kind: 'error'; message: string };
