// Property: the page's own small parts: places without overlap, addresses that come back, theory of the cited values.
import { describe, expect, it } from 'vitest';
import { broken, membersOf } from '../src/derivation/formula';
import { roomy, speedColumns } from '../src/gas/charts';
import { maxwellShare } from '../src/gas/measure';
import { defaults, gasToml } from '../src/gas/model';
import { collisionRateOf, compressibilityOf } from '../src/gas/theory';
import { fits, placed } from '../src/lab/placing';
import { presets } from '../src/lab/presets';
import { direction } from '../src/lab/sentences';
import { labHash, labOf } from '../src/share/address';
import { gasHash, gasOf, gasViewOf, usualGasView } from '../src/share/gas-address';
import { startEngine } from './engine';

const engine = await startEngine();

describe('placing', () => {
  const room = { width: 8, height: 5, boundary: ['reflecting', 'reflecting'] as ['reflecting', 'reflecting'], grid: 0.1 };
  const disk = (x: number, y: number, radius = 0.5) => ({ x, y, vx: 0, vy: 0, mass: 1, radius });
  it('leaves a disk where it fits', () => expect(placed(disk(1, 1), [disk(2, 1)], room)).toEqual(disk(1, 1)));
  it('pushes a disk off another and off walls, not far', () => {
    for (const wanted of [disk(2.3, 1.1), disk(-3, 9), disk(2, 1), disk(7.9, 2.5, 1)]) {
      const place = placed(wanted, [disk(2, 1)], room)!;
      expect(fits(place, [disk(2, 1)], room)).toBe(true);
    }
    expect(placed(disk(2.9, 1), [disk(2, 1)], room)).toMatchObject({ x: 3, y: 1 });
  });
  it('says so where there is no room', () => expect(placed(disk(1, 1, 3), [], room)).toBeUndefined());
});

describe('addresses', () => {
  for (const preset of presets) {
    it(`give the set-up back: ${preset.name}`, () => {
      const setup = { ...preset.make(engine), preset: preset.name };
      const show = new Set(['velocity', 'change', 'paths', 'scale'] as const);
      const view = { show, constantSize: false, time: 0, contact: 3, slow: true, pauseAtContact: false, panel: 'derivation' as const, step: 4 };
      const back = labOf(labHash(setup, view))!;
      expect(back.setup.disks).toEqual(setup.disks);
      expect(back.setup).toMatchObject({ width: setup.width, height: setup.height, boundary: setup.boundary, restitution: setup.restitution });
      expect(back.view).toEqual(view);
      expect(labOf(labHash(setup, { ...view, time: 1.25, contact: 0 }))!.view).toMatchObject({ time: 1.25, contact: 0 });
    });
  }
  it('of a gas', () => {
    const gas = { ...defaults, number: 5000, boundary: 'half' as const, seed: 9 };
    const view = { pace: 0.1, colour: 'order' as const, tag: true, record: true };
    expect(gasOf(gasHash(gas, view))).toEqual(gas);
    expect(gasViewOf(gasHash(gas, view))).toEqual(view);
    expect(gasViewOf(gasHash(gas))).toEqual(usualGasView);
  });
  it('that are broken are refused', () => {
    for (const hash of ['#lab', '#lab&box=8,5,rr', '#lab&box=8,5,rr&disks=1,2', '#lab&box=a,5,rr&disks=1,2,3,4,5,6']) {
      expect(labOf(hash)).toBeUndefined();
    }
    expect(gasOf('#gas&number=x&boundary=round')).toEqual(defaults);
  });
});

describe('gas', () => {
  it('scenes of mixtures have the packing fraction asked for', () => {
    engine.setInput(gasToml({ ...defaults, number: 400, packing: 0.4, fraction: 0.25 }));
    expect(engine.tryCall('gas_open', -1)).toBe(400);
    expect(engine.numbers('gas_summary', 12)[6]).toBeCloseTo(0.4, 9);
  });
  // Kolafa and Rottner (2006); Γ from Z, as in shared tables of hard disks.
  it('theory has the cited values', () => {
    expect(compressibilityOf(0.5)).toBeCloseTo(4.10636, 5);
    expect(compressibilityOf(0.69)).toBeCloseTo(10.2007, 3);
    expect(collisionRateOf(0.3, 1, 1, 1)).toBeCloseTo(2.39952, 4);
    expect(compressibilityOf(0.75)).toBeUndefined();
  });
  it('shares of Maxwell add up to one', () => {
    let sum = 0;
    for (let v = 0; v < 10; v += 0.1) sum += maxwellShare(v, v + 0.1);
    expect(sum).toBeCloseTo(1, 9);
  });
  it('equal speeds become Maxwell’s, going back restores the start', () => {
    engine.setInput(gasToml({ ...defaults, number: 100, packing: 0.1 }));
    engine.tryCall('gas_open', -1);
    engine.tryCall('gas_equal_speeds', 0);
    const x = (): number[] => [...engine.view(engine.call('gas_x'), 100)];
    const start = x();
    engine.tryCall('gas_run_until', 0, 3);
    engine.tryCall('gas_reverse', 0);
    engine.tryCall('gas_run_until', 0, 6);
    x().forEach((value, k) => expect(Math.abs(value - start[k]!)).toBeLessThan(1e-6));
  });
});

describe('details', () => {
  it('charts have room around what they show, also for nothing and for one value', () => {
    for (const [least, most] of [[0, 1], [-3.1, 2.2], [2, 2], [0, 0]] as const) {
      const [low, high] = roomy(least, most);
      expect(low).toBeLessThan(least);
      expect(high).toBeGreaterThan(most);
    }
    expect(roomy(null, null)).toEqual([0, 1]);
  });
  it('the histogram and Maxwell’s line are densities: they sum to one over the speeds', () => {
    const histogram = new Float64Array(32).fill(1 / 32);
    const [speeds, densities, theory] = speedColumns({ histogram, binWidth: 0.25 }) as number[][];
    expect(speeds![0]).toBeCloseTo(0.125, 12);
    expect(densities!.reduce((sum, f) => sum + 0.25 * f, 0)).toBeCloseTo(1, 12);
    expect(theory!.reduce((sum, f) => sum + 0.25 * f, 0)).toBeCloseTo(1 - Math.exp(-8), 12);
  });
  it('directions', () => expect([{ x: 1, y: 0 }, { x: 0, y: 1 }, { x: -1, y: 0 }, { x: 1, y: -1 }].map(direction)).toEqual([0, 2, 4, 7]));
  it('chains of equations break at their relations only', () => {
    expect(membersOf('a = \\frac{b = c}{d} \\approx 2')).toEqual(['a', '= \\frac{b = c}{d}', '\\approx 2']);
    expect(broken('a = b = c \\tag{5}')).toContain('\\tag{5}');
    expect(broken('a = b')).toBe('a = b');
  });
  it('rows break between their equations, whether the engine had them on one line or on several', () => {
    const lines = '\\begin{aligned}\n\\text{Disk 1:} \\quad & m_1 = 1 \\\\\n& R_1 = 0.5 \\\\\n& v = \\langle a, b \\rangle = 2\n\\end{aligned}';
    expect(broken('\\text{Disk 1:} \\quad m_1 = 1 \\quad R_1 = 0.5 \\quad v = \\langle a, b \\rangle = 2')).toBe(lines);
    expect(broken(lines)).toBe(lines);
  });
});
