// What is measured of the gas while it runs.
import type { Engine } from '../engine/module';
import type { Measured } from './messages';

const bins = 32;

export class Measurer {
  private readonly meanMass: number;
  private readonly density: number;
  private kT = 1;

  constructor(
    private readonly kinds: Float64Array,
    size: { x: number; y: number },
    readonly restitution: number,
    /** Where rates are counted from. */
    private last: { time: number; collisions: number },
  ) {
    const count = kinds.length / 2;
    this.meanMass = kinds.filter((_, k) => k % 2 === 1).reduce((sum, mass) => sum + mass, 0) / count;
    this.density = count / (size.x * size.y);
  }

  /** √(kT/m) of the mean mass. */
  get thermalSpeed(): number {
    return Math.sqrt(Math.max(this.kT, 1e-12) / this.meanMass);
  }

  /** Of the gas alone: a piston among its disks is the last one. */
  measure(engine: Engine, piston: boolean): Measured {
    const count = this.kinds.length / 2;
    const s = engine.numbers('gas_summary', 12);
    const vx = engine.view(engine.call('gas_vx'), count);
    const vy = engine.view(engine.call('gas_vy'), count);
    const [time, collisions] = [s[0]!, s[1]!];
    const kT = piston ? this.temperature(vx, vy) : s[3]!;
    if (kT > 0) this.kT = kT;
    const span = time - this.last.time;
    const rate = span > 0 ? (2 * (collisions - this.last.collisions)) / (count * span) : NaN;
    this.last = { time, collisions };
    const { histogram, binWidth } = this.speeds(vx, vy);
    const h = this.boltzmann(vx, vy);
    // Asked for last: the engine's memory may move, and what was seen of it with that.
    const order = count <= 20000 ? engine.numbers('gas_order', 1)[0]! : NaN;
    return {
      time,
      collisions,
      kT,
      rate,
      drift: s[5]!,
      packing: s[6]!,
      // On a curved wall that moves there is no telling.
      compressibility: piston ? NaN : s[7]! / this.density,
      density: this.density,
      order,
      histogram,
      binWidth,
      h,
    };
  }

  /** Between walls that take up momentum. */
  private temperature(vx: Float64Array, vy: Float64Array): number {
    let energy = 0;
    for (let k = 0; k < vx.length; ++k) energy += 0.5 * this.kinds[2 * k + 1]! * (vx[k]! * vx[k]! + vy[k]! * vy[k]!);
    return energy / vx.length;
  }

  /** Speeds times √(m/mean m), so that all kinds share one Maxwell distribution. */
  private speeds(vx: Float64Array, vy: Float64Array): { histogram: Float64Array; binWidth: number } {
    const binWidth = (4 * this.thermalSpeed) / bins;
    const histogram = new Float64Array(bins);
    for (let k = 0; k < vx.length; ++k) {
      const speed = Math.sqrt(vx[k]! * vx[k]! + vy[k]! * vy[k]!) * Math.sqrt(this.kinds[2 * k + 1]! / this.meanMass);
      const bin = Math.floor(speed / binWidth);
      if (bin < bins) histogram[bin]! += 1 / vx.length;
    }
    return { histogram, binWidth };
  }

  /** H per disk from a histogram of speeds in units of √(kT/m): Σ p ln(p / (2π v Δv)). Maxwell: −1 − ln 2π. */
  private boltzmann(vx: Float64Array, vy: Float64Array): number {
    const cells = 40;
    const width = 5 / cells;
    const shares = new Float64Array(cells + 1);
    for (let k = 0; k < vx.length; ++k) {
      const speed = Math.sqrt(vx[k]! * vx[k]! + vy[k]! * vy[k]!) * Math.sqrt(this.kinds[2 * k + 1]! / Math.max(this.kT, 1e-12));
      shares[Math.min(cells, Math.floor(speed / width))]! += 1 / vx.length;
    }
    return shares.reduce((sum, p, k) => (p > 0 ? sum + p * Math.log(p / (Math.PI * width * width * (2 * k + 1))) : sum), 0);
  }
}

/** Maxwell's H in these units. */
export const maxwellH = -1 - Math.log(2 * Math.PI);

/** Maxwell's share of disks in a bin of speed, in units of √(kT/m). */
export function maxwellShare(from: number, to: number): number {
  return Math.exp((-from * from) / 2) - Math.exp((-to * to) / 2);
}
