// The whole state in the page's address, after the #: nothing leaves the page.
import { batch } from '@preact/signals';
import { Boundary, Disk, parseScene, sceneToml } from '../engine/scene';
import type { GasParameters } from '../gas/messages';
import { change, parameters } from '../gas/model';
import * as lab from '../lab/model';
import { panel } from '../lab/panel';
import { setupOf } from '../lab/presets';
import { layers, show } from '../lab/view';
import { stepShown } from '../derivation/panel';
import { tab } from '../ui/app';
import { GasView, gasHash, gasOf, gasViewNow, gasViewOf, showGasAs } from './gas-address';
import { valuesOf } from './values';

const letters: Record<Boundary, string> = { periodic: 'p', reflecting: 'r', open: 'o' };
const fields: (keyof Disk)[] = ['x', 'y', 'vx', 'vy', 'mass', 'radius'];
/** Times and counts in an address are no larger. */
const latest = 1e5;

/** What the tab "Two disks" shows of its set-up. */
export interface LabView {
  show: typeof show.value;
  constantSize: boolean;
  time: number;
  /** The contact that it stands at, counted from 1; 0 if it stands at none. */
  contact: number;
  slow: boolean;
  pauseAtContact: boolean;
  panel: typeof panel.value;
  /** Of the derivation, counted from 1. */
  step: number;
}

export function labHash(s: lab.Setup, view: LabView): string {
  const parts = [
    `box=${s.width},${s.height},${s.boundary.map((one) => letters[one]).join('')}`,
    `e=${s.restitution === s.wallRestitution ? s.restitution : `${s.restitution},${s.wallRestitution}`}`,
    `show=${layers.filter((layer) => view.show.has(layer)).join(',')}`,
    `disks=${s.disks.map((disk) => fields.map((field) => disk[field]).join(',')).join(';')}`,
  ];
  if (s.preset !== 'custom') parts.unshift(`preset=${s.preset}`);
  if (view.contact > 0) parts.push(`contact=${view.contact}`);
  else if (view.time > 0) parts.push(`t=${view.time}`);
  if (!view.constantSize) parts.push('size=mass');
  if (view.slow) parts.push('slow=1');
  if (!view.pauseAtContact) parts.push('stop=0');
  if (view.panel !== 'controls') parts.push(`panel=${view.panel}`, `step=${view.step}`);
  return `#lab&${parts.join('&')}`;
}

/** Reads an address; undefined where it does not say a set-up of disks. */
export function labOf(hash: string): { setup: lab.Setup; view: LabView } | undefined {
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
  return { setup: setupOf(scene, values.get('preset') ?? 'custom'), view: viewOf(values) };
}

function viewOf(values: Map<string, string>): LabView {
  const names = values.get('show')?.split(',') ?? [];
  const number = (key: string): number => Math.min(latest, Math.max(0, Number(values.get(key)) || 0));
  return {
    show: new Set(layers.filter((layer) => names.includes(layer))),
    constantSize: values.get('size') !== 'mass',
    time: number('t'),
    contact: Math.round(number('contact')),
    slow: values.get('slow') === '1',
    pauseAtContact: values.get('stop') !== '0',
    panel: values.get('panel') === 'derivation' ? 'derivation' : 'controls',
    step: Math.max(1, Math.round(number('step'))),
  };
}

function labViewNow(): LabView {
  const { time, at } = lab.cursor.value;
  return {
    show: show.value,
    constantSize: lab.constantSize.value,
    time,
    contact: at ? at.index + 1 : 0,
    slow: lab.slow.value,
    pauseAtContact: lab.pauseAtContact.value,
    panel: panel.value,
    step: stepShown.value + 1,
  };
}

export function addressNow(): string {
  const hash = tab.value === 'lab' ? labHash(lab.setup.value, labViewNow()) : gasHash(parameters.value, gasViewNow());
  return location.href.split('#')[0] + hash;
}

/** Whether the engine can simulate it; says why if not. */
function isSound(found: lab.Setup): boolean {
  try {
    parseScene(lab.engine(), sceneToml(lab.sceneOf(found)));
    return true;
  } catch (error) {
    lab.announce(error instanceof Error ? error.message : String(error));
    return false;
  }
}

function openLab(found: lab.Setup, view: LabView): void {
  batch(() => {
    lab.load(found);
    show.value = view.show;
    lab.constantSize.value = view.constantSize;
    lab.slow.value = view.slow;
    lab.pauseAtContact.value = view.pauseAtContact;
    panel.value = view.panel;
    stepShown.value = view.step - 1;
    tab.value = 'lab';
  });
  if (view.contact > 0) lab.goToContact(view.contact - 1);
  else lab.goTo(view.time);
}

function openGas(gas: GasParameters, view: GasView): void {
  batch(() => {
    showGasAs(view);
    tab.value = 'gas';
  });
  change(gas);
}

/** Opens what the page's address says, now and when it changes. */
export function openAddress(): void {
  const open = (): void => {
    const name = location.hash.slice(1).split('&')[0];
    if (name === 'gas') openGas(gasOf(location.hash), gasViewOf(location.hash));
    const found = name === 'lab' ? labOf(location.hash) : undefined;
    if (found && isSound(found.setup)) openLab(found.setup, found.view);
  };
  open();
  addEventListener('hashchange', open);
}
