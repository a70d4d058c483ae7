// The piston: a round disk, as wide as the box is high but for a gap that no disk of the gas passes.
export interface Piston {
  x: number;
  y: number;
  radius: number;
  mass: number;
}

/** On either side, in diameters of the smallest disk. */
const gap = 0.1;

/** Touching a wall at `x` from the right; `kinds` are radius and mass of each disk of the gas, and its mass is in units of theirs. */
export function pistonFor(x: number, height: number, kinds: Float64Array, mass: number): Piston {
  let [smallest, total] = [Infinity, 0];
  for (let k = 0; k < kinds.length; k += 2) {
    smallest = Math.min(smallest, 2 * kinds[k]!);
    total += kinds[k + 1]!;
  }
  const radius = height / 2 - gap * smallest;
  return { x: x + radius, y: height / 2, radius, mass: mass * total };
}

/** The width in which the gas has room for as much again as to the left of `x`. */
export function roomWith(x: number, piston: Piston | null): number {
  return 2 * x + (piston ? 2 * piston.radius : 0);
}
