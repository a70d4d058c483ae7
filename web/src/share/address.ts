// The whole state in the page's address, after the #: nothing leaves the page.
import { GasParameters } from '../gas/messages';
import { change, defaults, limits, parameters } from '../gas/model';
import { Boundary, Disk, parseScene, sceneToml } from '../engine/scene';
import { Setup, announce, engine, load, sceneOf, setup } from '../lab/model';
import { setupOf } from '../lab/presets';
import { Layer, layers, show } from '../lab/view';
import { Tab, tab } from '../ui/app';

const letters: Record<Boundary, string> = { periodic: 'p', reflecting: 'r', open: 'o' };
const fields: (keyof Disk)[] = ['x', 'y', 'vx', 'vy', 'mass', 'radius'];

export function labHash(s: Setup, visible: ReadonlySet<Layer>): string {
  const parts = [
    `box=${s.width},${s.height},${s.boundary.map((one) => letters[one]).join('')}`,
    `e=${s.restitution === s.wallRestitution ? s.restitution : `${s.restitution},${s.wallRestitution}`}`,
    `show=${layers.filter((layer) => visible.has(layer)).join(',')}`,
    `disks=${s.disks.map((disk) => fields.map((field) => disk[field]).join(',')).join(';')}`,
  ];
  if (s.preset !== 'custom') parts.unshift(`preset=${s.preset}`);
  return `#lab&${parts.join('&')}`;
}

export function gasHash(p: GasParameters): string {
  const changed = (Object.keys(defaults) as (keyof GasParameters)[]).filter((key) => p[key] !== defaults[key] || key === 'seed');
  return `#gas&${changed.map((key) => `${key}=${p[key]}`).join('&')}`;
}

/** Reads an address; undefined where it does not say a set-up of disks. */
export function labOf(hash: string): { setup: Setup; show: Set<Layer> } | undefined {
  const values = valuesOf(hash);
  const box = values.get('box')?.split(',');
  const rows = values.get('disks')?.split(';') ?? [];
  if (!box || box.length !== 3 || rows.length === 0 || rows.length > 20) return undefined;
  const boundaryOf = (letter: string | undefined): Boundary =>
    (Object.keys(letters) as Boundary[]).find((one) => letters[one] === letter) ?? 'reflecting';
  const disks = rows.map((row) => {
    const numbers = row.split(',').map(Number);
    return Object.fromEntries(fields.map((field, k) => [field, numbers[k]])) as unknown as Disk;
  });
  const [restitution, wallRestitution] = (values.get('e') ?? '1').split(',').map(Number);
  const numbers = [Number(box[0]), Number(box[1]), restitution!, wallRestitution ?? restitution!, ...disks.flatMap((disk) => Object.values(disk))];
  if (!numbers.every(Number.isFinite)) return undefined;
  const scene = {
    title: '',
    width: Number(box[0]),
    height: Number(box[1]),
    boundary: [boundaryOf(box[2]![0]), boundaryOf(box[2]![1])] as [Boundary, Boundary],
    restitution: restitution!,
    wallRestitution: wallRestitution ?? restitution!,
    disks,
  };
  const names = values.get('show')?.split(',') ?? [];
  return { setup: setupOf(scene, values.get('preset') ?? 'custom'), show: new Set(layers.filter((layer) => names.includes(layer))) };
}

export function gasOf(hash: string): GasParameters {
  const values = valuesOf(hash);
  const next: Record<string, unknown> = { ...defaults };
  for (const [key, given] of values) {
    const usual = defaults[key as keyof GasParameters];
    const [least, most] = limits[key as keyof typeof limits] ?? [0, 0];
    if (typeof usual === 'number' && Number.isFinite(Number(given))) next[key] = Math.min(most, Math.max(least, Number(given)));
    if (key === 'boundary' && (given === 'periodic' || given === 'reflecting' || given === 'half')) next[key] = given;
    if (key === 'speeds' && (given === 'equal' || given === 'maxwell')) next[key] = given;
  }
  return next as unknown as GasParameters;
}

function valuesOf(hash: string): Map<string, string> {
  const parts = decodeURIComponent(hash).slice(1).split('&').slice(1);
  return new Map(parts.map((part) => [part.slice(0, part.indexOf('=')), part.slice(part.indexOf('=') + 1)]));
}

export function addressNow(): string {
  const hash = tab.value === 'lab' ? labHash(setup.value, show.value) : gasHash(parameters.value);
  return location.href.split('#')[0] + hash;
}

/** Whether the engine can simulate it; says why if not. */
function isSound(found: Setup): boolean {
  try {
    parseScene(engine(), sceneToml(sceneOf(found)));
    return true;
  } catch (error) {
    announce(error instanceof Error ? error.message : String(error));
    return false;
  }
}

/** Opens what the page's address says, now and when it changes. */
export function openAddress(): void {
  const open = (): void => {
    const name = location.hash.slice(1).split('&')[0];
    if (name === 'gas') {
      change(gasOf(location.hash));
      tab.value = 'gas' satisfies Tab;
    }
    const found = name === 'lab' ? labOf(location.hash) : undefined;
    if (found && isSound(found.setup)) {
      load(found.setup);
      show.value = found.show;
      tab.value = 'lab';
    }
  };
  open();
  addEventListener('hashchange', open);
}
