// How fast the engine is beside the native program with one thread, on a gas of 10,000 disks; printed, not asserted.
// Processor time, the best of some rounds in turn: a busy machine must not decide.
import { execFileSync } from 'node:child_process';
import { carom, program, startEngine } from './engine';

const collisions = 1000000;
const scene = carom(['make', 'gas', '--disks', '10000', '--packing', process.argv[2] ?? '0.5', '--seed', '1', '-o', '-']);
const engine = await startEngine();

/** Collisions done, and seconds of processor time for them. */
function native(): [number, number] {
  const command = `TIMEFORMAT=%U; time "$0" run - --collisions ${collisions} --json --quiet 2> /dev/null`;
  const words = ['-c', `{ ${command}; } 2>&1`, program];
  const printed = execFileSync('bash', words, { input: scene, encoding: 'utf8' });
  const end = printed.lastIndexOf('}') + 1;
  return [JSON.parse(printed.slice(0, end)).collisions, Number(printed.slice(end))];
}

function wasm(): [number, number] {
  engine.setInput(scene);
  engine.tryCall('gas_open', -1);
  const start = process.cpuUsage();
  engine.tryCall('gas_run_collisions', 0, collisions);
  const { user } = process.cpuUsage(start);
  return [engine.numbers('gas_summary', 12)[1]!, user / 1e6];
}

const best = { native: 0, wasm: 0 };
for (let round = 0; round < 5; ++round) {
  const [done, seconds] = native();
  best.native = Math.max(best.native, done / seconds);
  const [doneHere, secondsHere] = wasm();
  best.wasm = Math.max(best.wasm, doneHere / secondsHere);
}
console.log(`native  ${best.native.toExponential(3)} collisions per second of processor time`);
console.log(`wasm    ${best.wasm.toExponential(3)}: ${((100 * best.wasm) / best.native).toFixed(0)} %`);
