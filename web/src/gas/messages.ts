// What the page and the worker that runs the gas say to each other.
export type Colour = 'speed' | 'kind' | 'order' | 'none';

export interface GasParameters {
  number: number;
  packing: number;
  temperature: number;
  /** "half", "piston": walls, and the gas left of one of them until it is taken away; behind it is nothing, or a piston. */
  boundary: 'periodic' | 'reflecting' | 'half' | 'piston';
  restitution: number;
  fraction: number;
  radiusRatio: number;
  massRatio: number;
  /** Of that of the gas. */
  pistonMass: number;
  speeds: 'equal' | 'maxwell';
  seed: number;
}

/** What is behind the wall that is going to be taken away: as much room again, and perhaps a piston (its mass, of the gas's). */
export interface Behind {
  piston: number | null;
}

export type Request =
  | { kind: 'start'; module: WebAssembly.Module }
  | { kind: 'make'; toml: string; equalSpeeds: boolean; behind: Behind | null; record: boolean }
  | { kind: 'advance'; time: number; colour: Colour; tag: boolean; measure: boolean }
  | { kind: 'reverse' }
  | { kind: 'removeWall' }
  | { kind: 'record'; on: boolean }
  | { kind: 'countRecorded' }
  | { kind: 'saveRecorded' }
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
  /** Of the worker's work for this picture (ms). */
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
  /** Share of the disks in the left half, where there was a wall. */
  inHalf?: number;
  piston?: {
    /** How far the gas has pushed it. */
    moved: number;
    /** Share of the kinetic energy that it has. */
    energy: number;
  };
  /** Share of disks per bin of speed, in units of bins of `binWidth`. */
  histogram: Float64Array;
  binWidth: number;
  /** ∫ f ln f over the velocity components of disks of mean mass, in units in which Maxwell's value is its least. */
  h: number;
}

/** Contacts that are kept to be saved. */
export interface Recorded {
  count: number;
  /** As many as are kept at most. */
  most: number;
  /** The time from which they are kept. */
  from: number;
}

export interface Made {
  kind: 'made';
  width: number;
  height: number;
  /** The width that the picture has room for: that of the box, or more if a wall can be taken away. */
  room: number;
  /** Whether these are the disks of before, in a box of another size. */
  continues: boolean;
  /** A piston that waits behind the wall. */
  waiting: { x: number; y: number; radius: number } | null;
  /** Whether the last disk is one. */
  piston: boolean;
  /** Radius and mass of each disk. */
  kinds: Float64Array;
}

export type Answer =
  | Picture
  | Made
  | { kind: 'reversed'; time: number; returnsAt: number | null }
  | { kind: 'returned'; distance: number }
  /** At the moment the wall should stand again; it does if no disk is over it. */
  | { kind: 'wallBack'; over: number }
  | { kind: 'saved'; toml: string }
  | ({ kind: 'recorded' } & Recorded)
  | { kind: 'savedRecorded'; csv: Blob }
  | { kind: 'error'; message: string };
