// Runs the gas beside the page, so that neither waits for the other.
import { Engine } from '../engine/module';
import { csvHeader } from '../share/table';
import { Measurer } from './measure';
import { Piston, pistonFor, roomWith } from './piston';
import type { Answer, Behind, Colour, Measured, Request } from './messages';

const frameBudget = 13; // ms of work between two pictures

let engine: Engine;
let count = 0;
/** Disks that are no piston; one is the last disk. */
let gas = 0;
let size = { x: 1, y: 1 };
let kinds = new Float64Array();
let measurer: Measurer;
/** Time the engine covers per ms, as last seen. */
let pace = 0.001;
/**
 * Where the disks stood at the start, and when: each reversal turns that time over into the future, or back into the past.
 * NaN if the way that the gas is on does not lead there.
 */
let start = { x: new Float64Array(), y: new Float64Array(), time: 0 };
/** What holds the gas, until it is taken away. */
interface Wall {
  x: number;
  /** Turned over as the time of the start is; NaN while it stands. */
  removedAt: number;
  behind: Behind;
}
let wall: Wall | null = null;
/** Whether contacts are being recorded. */
let recording = false;
/** The disk that is tagged: the one nearest to the middle at the start. */
let tagged = 0;

const say = (answer: Answer, moved: Transferable[] = []): void =>
  (self as unknown as Worker).postMessage(answer, moved);
const column = (name: string): Float64Array => engine.view(engine.call(`gas_${name}`), count);
const time = (): number => engine.call('gas_time');

function made(continues: boolean): void {
  const summary = engine.numbers('gas_summary', 12);
  size = { x: summary[9]!, y: summary[10]! };
  kinds = engine.numbers('gas_kinds', 2 * count);
  measurer = new Measurer(kinds.subarray(0, 2 * gas), size, summary[11]!, { time: summary[0]!, collisions: summary[1]! });
  const waiting = wall && size.x === wall.x ? pistonOf(wall) : null;
  say({ kind: 'made', width: size.x, height: size.y, room: wall ? roomOf(wall) : size.x, kinds, continues, waiting, piston: count > gas });
}

const pistonOf = ({ x, behind }: Wall): Piston | null => (behind.piston === null ? null : pistonFor(x, size.y, kinds.subarray(0, 2 * gas), behind.piston));
const roomOf = (held: Wall): number => roomWith(held.x, pistonOf(held));

function make({ toml, equalSpeeds, behind, record }: Request & { kind: 'make' }): void {
  engine.setInput(toml);
  count = gas = engine.tryCall('gas_open', -1);
  if (equalSpeeds) engine.tryCall('gas_equal_speeds', 0);
  start = { x: column('x').slice(), y: column('y').slice(), time: 0 };
  pace = 0.001;
  wall = behind ? { x: engine.numbers('gas_summary', 12)[9]!, removedAt: NaN, behind } : null;
  made(false);
  tagged = nearestToMiddle();
  recording = false;
  if (record) setRecording(true);
}

function setRecording(on: boolean): void {
  recording = on;
  engine.tryCall('gas_record', 0, on ? 1 : 0);
  sayRecorded();
}

function sayRecorded(): void {
  const [contacts, most, from] = engine.numbers('gas_recorded', 3);
  say({ kind: 'recorded', count: contacts!, most: most!, from: from! });
}

/** The table is put together in parts, none of which is large. */
function saveRecorded(): void {
  const parts = [`${csvHeader}\n`];
  const next = (row: number): number => engine.tryCall('gas_recorded_rows', -1, row);
  for (let row = 0, rows = next(0); rows > 0; row += rows, rows = next(row)) parts.push(engine.text());
  say({ kind: 'savedRecorded', csv: new Blob(parts, { type: 'text/csv;charset=utf-8' }) });
}

function nearestToMiddle(): number {
  const [x, y] = [column('x'), column('y')];
  const distance = (k: number): number => Math.hypot(x[k]! - size.x / 2, y[k]! - size.y / 2);
  let nearest = 0;
  for (let k = 1; k < count; ++k) if (distance(k) < distance(nearest)) nearest = k;
  return nearest;
}

/** Goes on by `span`, or as far as it gets in a frame's budget. Returns whether it got there. */
function advance(span: number): boolean {
  const moments = [start.time, wall?.removedAt ?? NaN].filter((moment) => moment > time());
  const end = Math.min(time() + span, ...moments);
  const begin = performance.now();
  let spent = 0;
  let arrived = false;
  while (!arrived && spent < frameBudget) {
    const from = time();
    const chunk = Math.max(pace * (frameBudget - spent) * 0.5, 1e-9 * (1 + from));
    const before = performance.now();
    engine.tryCall('gas_run_until', 0, Math.min(end, from + chunk));
    const now = performance.now();
    spent = now - begin;
    arrived = time() >= end || time() === from; // what is left may be less than a tick of the clock
    if (time() > from) pace = Math.min(1e6, ((time() - from) / Math.max(0.05, now - before)) * 0.7 + pace * 0.3);
  }
  if (moments.includes(time())) arriveAtMoment();
  return arrived;
}

/** On its way back the gas is where the wall was taken away, or where it started. */
function arriveAtMoment(): void {
  if (wall && time() === wall.removedAt) putBack(wall);
  if (time() === start.time) say({ kind: 'returned', distance: distanceFromStart() });
}

/** To the other size of the box at this moment, with the piston or without; all others go on as they are. */
function resize(width: number, piston: Piston | null): void {
  if (!piston && count > gas) engine.tryCall('gas_remove_last_disk', 0);
  engine.tryCall('gas_resize', 0, width, size.y);
  if (piston) engine.tryCall('gas_add_disk', 0, piston.radius, piston.mass, piston.x, piston.y);
  count = gas + (piston ? 1 : 0);
  made(true);
}

function removeWall(): void {
  if (!wall || size.x > wall.x) return;
  wall.removedAt = time();
  // A gas on its way back has another way from here on.
  if (start.time > time()) start.time = NaN;
  resize(roomOf(wall), pistonOf(wall));
}

/** Where the gas, on its way back, stands as when the wall was taken away; if it forgot the way, it is not behind it. */
function putBack(from: Wall): void {
  const x = column('x');
  let over = 0;
  for (let k = 0; k < gas; ++k) if (x[k]! + kinds[2 * k]! > from.x * (1 + 1e-12)) ++over;
  wall = { ...from, removedAt: NaN };
  if (over > 0) start.time = NaN;
  else resize(from.x, null);
  say({ kind: 'wallBack', over });
}

function reverse(): void {
  engine.tryCall('gas_reverse', 0);
  start.time = 2 * time() - start.time;
  if (wall) wall.removedAt = 2 * time() - wall.removedAt;
  say({ kind: 'reversed', time: time(), returnsAt: start.time > time() ? start.time : null });
}

/** Share of the disks left of where the wall stands or stood. */
function shareInHalf(): number {
  const x = column('x');
  return x.reduce((sum, one) => sum + (one < wall!.x ? 1 : 0), 0) / count;
}

function pistonNow({ x, mass }: Piston): NonNullable<Measured['piston']> {
  const [vx, vy] = [column('vx')[gas]!, column('vy')[gas]!];
  const energy = engine.numbers('gas_summary', 12)[4]!;
  return { moved: column('x')[gas]! - x, energy: (0.5 * mass * (vx * vx + vy * vy)) / energy };
}

/** Root mean square distance from the places at the start, in mean diameters. */
function distanceFromStart(): number {
  const x = column('x');
  const y = column('y');
  let sum = 0;
  let diameters = 0;
  for (let k = 0; k < gas; ++k) {
    const folded = (d: number, length: number): number => d - length * Math.round(d / length);
    sum += folded(x[k]! - start.x[k]!, size.x) ** 2 + folded(y[k]! - start.y[k]!, size.y) ** 2;
    diameters += 2 * kinds[2 * k]!;
  }
  return Math.sqrt(sum / gas) / (diameters / gas);
}

function disksOf(colour: Colour): Float32Array {
  const order = colour === 'order' ? engine.numbers('gas_order', count + 1) : null;
  const [x, y, vx, vy] = [column('x'), column('y'), column('vx'), column('vy')];
  const picture = new Float32Array(3 * count);
  const fastest = 3 * measurer.thermalSpeed;
  const lightest = kinds[1]!;
  for (let k = 0; k < count; ++k) {
    picture[3 * k] = x[k]!;
    picture[3 * k + 1] = y[k]!;
    let shade = -1;
    if (colour === 'speed') shade = Math.min(1, Math.sqrt(vx[k]! * vx[k]! + vy[k]! * vy[k]!) / fastest);
    else if (colour === 'kind') shade = kinds[2 * k + 1] === lightest && kinds[2 * k] === kinds[0] ? 0.25 : 0.85;
    else if (order) shade = order[k + 1]!;
    picture[3 * k + 2] = shade;
  }
  // What is said of disks by their colours is not said of a piston.
  if (count > gas) picture[3 * gas + 2] = -1;
  return picture;
}

/** Not folded into the box. */
function placeOfTagged(): { x: number; y: number } {
  const turns = (axis: 'x' | 'y'): number => Number(engine.integers(engine.call(`gas_winding_${axis}`), count)[tagged]!);
  return { x: column('x')[tagged]! + turns('x') * size.x, y: column('y')[tagged]! + turns('y') * size.y };
}

function tellOf(held: Wall, measured: Measured): void {
  const piston = pistonOf(held);
  if (!piston) measured.inHalf = shareInHalf();
  else measured.piston = count > gas ? pistonNow(piston) : { moved: 0, energy: 0 };
}

function show(request: Request & { kind: 'advance' }): void {
  const begin = performance.now();
  const arrived = request.time > 0 ? advance(request.time) : true;
  const measured = request.measure ? measurer.measure(engine, count > gas) : null;
  if (measured && wall) tellOf(wall, measured);
  if (request.measure) engine.call('gas_measure_anew');
  if (request.measure && recording) sayRecorded();
  const disks = disksOf(request.colour);
  const work = performance.now() - begin;
  say({ kind: 'picture', disks, tagged: request.tag ? placeOfTagged() : null, time: time(), limited: !arrived, work, measured }, [disks.buffer]);
}

async function answer(request: Request): Promise<void> {
  // Of a first gas that could not be made there is nothing to ask.
  if (count === 0 && request.kind !== 'start' && request.kind !== 'make') return;
  switch (request.kind) {
    case 'start':
      engine = await Engine.start(request.module);
      break;
    case 'make':
      make(request);
      break;
    case 'advance':
      show(request);
      break;
    case 'reverse':
      reverse();
      break;
    case 'removeWall':
      removeWall();
      break;
    case 'record':
      setRecording(request.on);
      break;
    case 'countRecorded':
      sayRecorded();
      break;
    case 'saveRecorded':
      saveRecorded();
      break;
    case 'save':
      engine.tryCall('gas_toml', 0);
      say({ kind: 'saved', toml: engine.text() });
      break;
  }
}

// Requests are answered in their order, also while the engine is still starting.
let last: Promise<void> = Promise.resolve();
self.onmessage = (event: MessageEvent<Request>): void => {
  last = last
    .then(() => answer(event.data))
    .catch((error: unknown) => say({ kind: 'error', message: error instanceof Error ? error.message : String(error) }));
};
