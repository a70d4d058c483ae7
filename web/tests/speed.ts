// How fast the engine is beside the native program with one thread, on a gas of 10,000 disks; printed, not asserted.
import { carom, startEngine } from './engine';

const scene = carom(['make', 'gas', '--disks', '10000', '--packing', process.argv[2] ?? '0.5', '--seed', '1', '-o', '-']);
const engine = await startEngine();
const rounds: number[][] = [];
for (let round = 0; round < 3; ++round) {
  const native = JSON.parse(carom(['run', '-', '--collisions', '1000000', '--json', '--quiet'], scene));
  engine.setInput(scene);
  engine.tryCall('gas_open', -1);
  const start = performance.now();
  engine.tryCall('gas_run_collisions', 0, 1000000);
  const seconds = (performance.now() - start) / 1000;
  const summary = engine.numbers('gas_summary', 12);
  rounds.push([native.collisions / native.wall_seconds, summary[1]! / seconds]);
}
const best = (which: number): number => Math.max(...rounds.map((round) => round[which]!));
console.log(`native  ${best(0).toExponential(3)} collisions/s`);
console.log(`wasm    ${best(1).toExponential(3)} collisions/s: ${((100 * best(1)) / best(0)).toFixed(0)} %`);
