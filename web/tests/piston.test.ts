// Property: the piston is a disk like any other: no disk passes it, it keeps the energy, and the program goes on with it.
import { describe, expect, it } from 'vitest';
import { defaults, gasToml } from '../src/gas/model';
import { pistonFor, roomWith } from '../src/gas/piston';
import { carom, startEngine } from './engine';

const engine = await startEngine();

/** A gas whose wall is taken away at time 1. */
function released(parameters: Partial<typeof defaults>): { count: number; x: () => Float64Array } {
  engine.setInput(gasToml({ ...defaults, boundary: 'piston', ...parameters }));
  const count = engine.tryCall('gas_open', -1);
  const [width, height] = engine.numbers('gas_summary', 12).subarray(9) as unknown as [number, number];
  const piston = pistonFor(width, height, engine.numbers('gas_kinds', 2 * count), 0.5);
  engine.tryCall('gas_run_until', 0, 1);
  engine.tryCall('gas_resize', 0, roomWith(width, piston), height);
  engine.tryCall('gas_add_disk', 0, piston.radius, piston.mass, piston.x, piston.y);
  return { count, x: () => engine.view(engine.call('gas_x'), count + 1).slice() };
}

describe('piston', () => {
  for (const [name, parameters] of [
    ['of one kind of disks', { number: 80, packing: 0.3 }],
    ['of a mixture with small ones', { number: 80, packing: 0.3, fraction: 0.5, radiusRatio: 0.2, massRatio: 0.1 }],
  ] as const) {
    it(`holds a gas ${name}`, () => {
      const { count, x } = released(parameters);
      let farthest = 0;
      const start = x()[count]!;
      for (let time = 2; time < 200; time += 3) {
        engine.tryCall('gas_run_until', 0, time);
        const places = x();
        expect(Math.max(...places.subarray(0, count))).toBeLessThan(places[count]!);
        farthest = Math.max(farthest, places[count]! - start);
      }
      expect(farthest).toBeGreaterThan(2);
      expect(Math.abs(engine.numbers('gas_summary', 12)[5]!)).toBeLessThan(1e-12);
    });
  }
  it('goes the program’s way, to the bit', () => {
    released({ number: 50 });
    engine.tryCall('gas_toml', 0);
    const scene = engine.text();
    engine.setInput(scene);
    engine.tryCall('gas_open', -1);
    engine.tryCall('gas_run_until', 0, 30);
    engine.tryCall('gas_digest', 0);
    expect(engine.text()).toBe(JSON.parse(carom(['run', '-', '--until', '30', '--json', '--quiet'], scene)).digest);
  });
  it('is gone when it is taken out', () => {
    const { count } = released({ number: 50 });
    engine.tryCall('gas_remove_last_disk', 0);
    engine.tryCall('gas_toml', 0);
    engine.setInput(engine.text());
    expect(engine.tryCall('gas_open', -1)).toBe(count);
  });
});
