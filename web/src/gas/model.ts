// The state of the tab "Gas", and the worker that runs it.
import { batch, signal } from '@preact/signals';
import { startWorker } from '#worker';
import { tomlNumber } from '../engine/scene';
import { counted, shown, shownSmall, strings } from '../strings';
import type { Answer, Behind, Colour, GasParameters, Made, Measured, Picture, Recorded, Request } from './messages';

export const defaults: GasParameters = {
  number: 2000,
  packing: 0.3,
  temperature: 1,
  boundary: 'periodic',
  restitution: 1,
  fraction: 0,
  radiusRatio: 2,
  massRatio: 4,
  pistonMass: 1,
  speeds: 'equal',
  seed: 1,
};

/** From where to where they go. */
export const limits = {
  number: [10, 20000],
  packing: [0.001, 0.8],
  temperature: [0.001, 1000],
  restitution: [0, 1],
  fraction: [0, 1],
  radiusRatio: [0.1, 10],
  massRatio: [0.001, 1000],
  pistonMass: [0.01, 100],
  seed: [0, 1e9],
} as const;

export const parameters = signal<GasParameters>(defaults);
export const running = signal(false);
/** Time units of the gas per second. */
export const pace = signal(1);
export const colour = signal<Colour>('speed');
export const tagging = signal(false);
/** Whether collisions are being recorded, and what is kept of them; that is there also when no more are. */
export const recording = signal(false);
export const recorded = signal<Recorded | null>(null);
export const box = signal<Made | null>(null);
/** Whether the gas is held by a wall that can be taken away. */
export const wallStands = signal(false);
export const measured = signal<Measured | null>(null);
/** What was measured, four times a second. */
export const history = signal<Measured[]>([]);
/** Measurements that are kept, at most. */
const longestHistory = 5000;
export const frameTimes = signal({ work: 0, draw: 0, perSecond: 0 });
export const limited = signal(false);
export const said = signal('');
/** A gas that was opened from a file rather than made from parameters: its TOML. */
export const opened = signal<string | null>(null);

let module: WebAssembly.Module;
let worker: Worker | null = null;
let onPicture: (picture: Picture) => void = () => undefined;
let onSaved: (toml: string) => void = () => undefined;
let onSavedRecorded: (csv: Blob) => void = () => undefined;
let ratesSeen = 0;

export function startGas(compiled: WebAssembly.Module): void {
  module = compiled;
}

export function onEveryPicture(draw: (picture: Picture) => void): void {
  onPicture = draw;
}

/** A worker that has not answered for so long (ms) when a new gas is asked for never will. */
const patience = 4000;
/** Since when a picture has been waited for; none is if it is Infinity. */
let waitingSince = Infinity;

export function ask(request: Request): void {
  if (request.kind === 'make' && performance.now() - waitingSince > patience) {
    worker!.terminate();
    worker = null;
    waitingSince = Infinity;
  }
  if (request.kind === 'advance') waitingSince = Math.min(waitingSince, performance.now());
  if (!worker) {
    worker = startWorker();
    worker.onmessage = (event: MessageEvent<Answer>) => hear(event.data);
    worker.postMessage({ kind: 'start', module } satisfies Request);
  }
  worker.postMessage(request);
}

/** The TOML of a gas with these parameters. */
export function gasToml(p: GasParameters): string {
  const second = Math.round(p.fraction * p.number);
  const first = p.number - second;
  const kinds = [
    { count: first, radius: 0.5, mass: 1 },
    { count: second, radius: 0.5 * p.radiusRatio, mass: p.massRatio },
  ].filter(({ count }) => count > 0);
  const area = kinds.reduce((sum, { count, radius }) => sum + count * radius * radius, 0);
  const lines = ['[box]', `boundary = "${p.boundary === 'periodic' ? 'periodic' : 'reflecting'}"`, '', '[physics]', `restitution = ${tomlNumber(p.restitution)}`, 'wall_restitution = 1.0'];
  for (const { count, radius, mass } of kinds) {
    const share = (count * radius * radius) / area;
    lines.push('', '[[gas]]', `count = ${count}`, `packing_fraction = ${tomlNumber(p.packing * share)}`);
    lines.push(`radius = ${tomlNumber(radius)}`, `mass = ${tomlNumber(mass)}`);
    lines.push(`temperature = ${tomlNumber(p.temperature)}`, `seed = ${p.seed}`);
    // The lattice has room for the largest disks on every site.
    if (kinds.length > 1) lines.push('start = "random"');
  }
  return `title = "Gas of ${p.number} disks at packing fraction ${p.packing}"\n\n${lines.join('\n')}\n`;
}

function behindWall({ boundary, pistonMass }: GasParameters): Behind | null {
  if (boundary === 'piston') return { piston: pistonMass };
  return boundary === 'half' ? { piston: null } : null;
}

export function makeGas(): void {
  batch(() => {
    history.value = [];
    measured.value = null;
    said.value = '';
    recorded.value = null;
  });
  ratesSeen = 0;
  const made = opened.value === null;
  const { speeds } = parameters.value;
  ask({
    kind: 'make',
    toml: opened.value ?? gasToml(parameters.value),
    equalSpeeds: made && speeds === 'equal',
    behind: made ? behindWall(parameters.value) : null,
    record: recording.value,
  });
  ask({ kind: 'advance', time: 0, colour: colour.value, tag: tagging.value, measure: true });
}

export function change(next: Partial<GasParameters>): void {
  opened.value = null;
  parameters.value = { ...parameters.value, ...next };
  makeGas();
}

/** Calls back with the scene as it is now. */
export function saveGas(then: (toml: string) => void): void {
  onSaved = then;
  ask({ kind: 'save' });
}

/** What was recorded before is lost when recording starts anew. */
export function setRecording(on: boolean): void {
  recording.value = on;
  ask({ kind: 'record', on });
}

/** Calls back with the table of what was recorded. */
export function saveRecorded(then: (csv: Blob) => void): void {
  onSavedRecorded = then;
  ask({ kind: 'saveRecorded' });
}

/** Says when no more are kept. */
function noteRecorded(next: Recorded): void {
  const full = next.count === next.most && (recorded.value?.count ?? 0) < next.most;
  recorded.value = next;
  if (full) said.value = strings.value.gas.recordingFull(counted(next.most));
}

function hear(answer: Answer): void {
  if (answer.kind === 'picture' || answer.kind === 'error') waitingSince = Infinity;
  const words = strings.value.gas;
  switch (answer.kind) {
    case 'made':
      box.value = answer;
      wallStands.value = answer.width < answer.room;
      break;
    case 'picture':
      limited.value = answer.limited;
      if (answer.measured) note(answer.measured);
      onPicture(answer);
      break;
    case 'reversed':
      said.value =
        answer.returnsAt === null ? words.reversedAgain(shown(answer.time)) : words.reversed(shown(answer.time), shown(answer.returnsAt));
      break;
    case 'returned':
      batch(() => {
        running.value = false;
        const far = answer.distance > 0.1;
        said.value = `${words.returned(shownSmall(answer.distance))} ${far ? words.forgot : words.remembers}`;
      });
      break;
    case 'wallBack':
      said.value = answer.over === 0 ? words.wallBack : words.wallNotBack(answer.over);
      if (answer.over > 0) running.value = false;
      break;
    case 'saved':
      onSaved(answer.toml);
      break;
    case 'recorded':
      noteRecorded(answer);
      break;
    case 'savedRecorded':
      onSavedRecorded(answer.csv);
      break;
    case 'error':
      batch(() => {
        said.value = answer.message;
        running.value = false;
      });
      break;
  }
}

function note(next: Measured): void {
  batch(() => {
    measured.value = next;
    // The first stretch after a start has no rate yet.
    if (ratesSeen++ > 0) {
      history.value = [...history.value.slice(1 - longestHistory), next];
    }
  });
}
