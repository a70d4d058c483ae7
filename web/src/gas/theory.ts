// What theory says of hard disks of one kind.

/** Coefficients of Z = Σ c_k x^k, x = η/(1 − η), by power: J. Kolafa and M. Rottner, Mol. Phys. 104, 3435 (2006). */
const coefficients: readonly [number, number][] = [
  [0, 1],
  [1, 2],
  [2, 1.12801775],
  [3, 0.00181895291],
  [4, -0.0526134737],
  [5, 0.0504960168],
  [6, -0.0325537792],
  [7, 0.0134578632],
  [8, 0.00140888182],
  [9, -0.00834273601],
  [10, 0.00694127367],
  [11, -0.00262254723],
  [12, 0.000355746352],
  [22, -5.24672938e-9],
  [57, 5.88054639e-23],
];

/** βP/ρ of the fluid; undefined beyond it. */
export function compressibilityOf(packing: number): number | undefined {
  if (!(packing >= 0 && packing <= 0.7)) return undefined;
  const x = packing / (1 - packing);
  return coefficients.reduce((sum, [power, c]) => sum + c * x ** power, 0);
}

/** Collisions per disk and time at temperature kT, for unit mass and diameter d: Γ = (4/√π) (Z − 1) √kT / d. */
export function collisionRateOf(packing: number, kT: number, diameter: number, mass: number): number | undefined {
  const z = compressibilityOf(packing);
  if (z === undefined) return undefined;
  return ((4 / Math.sqrt(Math.PI)) * (z - 1) * Math.sqrt(kT / mass)) / diameter;
}
