// The state of the tab "Two disks": what was set up, where on its way it is, and what is shown of it.
import { batch, computed, signal } from '@preact/signals';
import { takeApart } from '../engine/collision';
import { Engine } from '../engine/module';
import { Collision, Contact, Playback, isCollision } from '../engine/playback';
import { Boundary, Disk, Scene } from '../engine/scene';
import { strings } from '../strings';
import { placed } from './placing';
import { presets } from './presets';
import { sentence } from './sentences';

export interface Setup {
  preset: string;
  width: number;
  height: number;
  boundary: [Boundary, Boundary];
  restitution: number;
  wallRestitution: number;
  disks: Disk[];
  /** Simulated time per second of the clock on the wall. */
  rate: number;
  /** Length of the arrow for velocity 1. */
  arrow: number;
}

/** Where on its way: at a time, or at a contact, just after it. */
interface Cursor {
  time: number;
  at?: Contact;
}

export const mostDisks = 5;
export const smallStep = 0.1;

let theEngine: Engine;
export const engine = (): Engine => theEngine;

export const setup = signal<Setup>({ ...presets[0]!.make(undefined as unknown as Engine), preset: presets[0]!.name });
export const cursor = signal<Cursor>({ time: 0 });
export const playing = signal(false);
export const slow = signal(false);
export const pauseAtContact = signal(true);
export const announcement = signal('');
/** Whether a disk keeps its radius when its mass changes; else it keeps its density. */
export const constantSize = signal(true);
/** The disk whose row and arrow are marked because it is being changed. */
export const touched = signal<{ disk: number; what: 'place' | 'velocity' } | null>(null);

/** Call before anything is shown. */
export function startLab(started: Engine): void {
  theEngine = started;
}

export function sceneOf(s: Setup): Scene {
  const { width, height, boundary, restitution, wallRestitution, disks } = s;
  const title = s.preset === 'custom' ? 'Disks' : s.preset;
  return { title, width, height, boundary, restitution, wallRestitution, disks };
}

export const playback = computed(() => new Playback(theEngine, sceneOf(setup.value)));
export const bordered = computed(() => setup.value.boundary.every((boundary) => boundary === 'reflecting'));
export const grid = computed(() => 10 ** Math.round(Math.log10(setup.value.width / 8)) / 10);

export const disksNow = computed<Disk[]>(() => {
  const { time, at } = cursor.value;
  return at ? playback.value.disksAfter(at) : playback.value.disksAt(time);
});

export const contactsSoFar = computed(() => {
  const { time, at } = cursor.value;
  return at ? at.index + 1 : playback.value.contactsUntil(time);
});

/** The collision of two disks that is taken apart: the one we are at, else the last one, else the next one. */
export const collisionShown = computed<Collision | undefined>(() => {
  const { at } = cursor.value;
  if (isCollision(at)) return at;
  const known = contactsSoFar.value;
  for (let k = known - 1; k >= Math.max(0, known - 200); --k) {
    const contact = playback.value.contact(k);
    if (isCollision(contact)) return contact;
  }
  for (let k = known; k < known + 50; ++k) {
    const contact = playback.value.contact(k);
    if (!contact) return undefined;
    if (isCollision(contact)) return contact;
  }
  return undefined;
});

/** Whether the collision shown lies behind us, ahead of us, or we are at it. */
export const collisionIs = computed<'past' | 'now' | 'ahead'>(() => {
  const shownOne = collisionShown.value;
  if (!shownOne || shownOne.index >= contactsSoFar.value) return 'ahead';
  return cursor.value.at?.index === shownOne.index ? 'now' : 'past';
});

/** All disks at the moment of that collision. */
export const disksAtCollision = computed(() => (collisionShown.value ? playback.value.disksAfter(collisionShown.value) : disksNow.value));

export const anatomy = computed(() =>
  collisionShown.value ? takeApart(theEngine, collisionShown.value, setup.value.disks) : undefined,
);

export function announce(words: string): void {
  announcement.value = words;
}

/** Says what the contact did, to those who do not see it. */
function tell(contact: Contact): void {
  announce(sentence(contact, strings.value));
}

export function goTo(time: number): void {
  cursor.value = { time: Math.max(0, time) };
}

export function goToContact(k: number): void {
  const contact = playback.value.contact(k);
  if (!contact) {
    announce(strings.value.noMoreContacts);
    return;
  }
  batch(() => {
    playing.value = false;
    cursor.value = { time: contact.time, at: contact };
  });
  tell(contact);
}

export const nextContact = (): void => goToContact(contactsSoFar.value);

export function previousContact(): void {
  const { at } = cursor.value;
  const k = (at ? at.index : contactsSoFar.value) - 1;
  if (k >= 0) goToContact(k);
  else restart();
}

export function restart(): void {
  batch(() => {
    playing.value = false;
    cursor.value = { time: 0 };
  });
}

/** A step of a tenth of a second of the page's clock. */
export function step(direction: 1 | -1): void {
  playing.value = false;
  const by = direction * smallStep * setup.value.rate;
  goTo(Math.round((cursor.value.time + by) * 1e9) / 1e9);
}

/** Goes on for so many seconds of the clock on the wall; stops at a contact on the way if that is wanted. */
export function playFor(seconds: number): void {
  const from = contactsSoFar.value;
  const target = cursor.value.time + seconds * setup.value.rate * (slow.value ? 0.2 : 1);
  const next = playback.value.contact(from);
  if (next && next.time <= target) {
    if (pauseAtContact.value && isCollision(next)) {
      goToContact(from);
      return;
    }
    const last = playback.value.contact(playback.value.contactsUntil(target) - 1);
    if (last) tell(last);
  }
  goTo(target);
}

export function load(next: Setup): void {
  batch(() => {
    playing.value = false;
    cursor.value = { time: 0 };
    setup.value = next;
    announcement.value = ''; // of what was before
  });
}

/** An edit starts anew from what is shown. */
function edit(change: Partial<Setup>): void {
  load({ ...setup.value, preset: 'custom', disks: disksNow.value, ...change });
}

/** Changes one disk; it is pushed off others and walls. Returns false if there is no room for it. */
export function changeDisk(k: number, change: Partial<Disk>): boolean {
  const disks = disksNow.value;
  const wanted = { ...disks[k]!, ...change };
  const place = placed(wanted, disks.filter((_, other) => other !== k), { ...setup.value, grid: grid.value });
  if (!place) {
    announce(strings.value.noRoom);
    return false;
  }
  edit({ disks: disks.map((disk, other) => (other === k ? place : disk)) });
  return true;
}

export function changeMass(k: number, mass: number): boolean {
  const disk = disksNow.value[k]!;
  return changeDisk(k, constantSize.value ? { mass } : { mass, radius: disk.radius * Math.sqrt(mass / disk.mass) });
}

export function addDisk(): void {
  const disks = disksNow.value;
  const { width, height } = setup.value;
  const radius = Math.min(...disks.map((disk) => disk.radius));
  const mean = { x: width / 2, y: height - 2 * radius, vx: 0, vy: 0, mass: 1, radius };
  const place = placed(mean, disks, { ...setup.value, grid: grid.value });
  if (disks.length < mostDisks && place) edit({ disks: [...disks, place] });
  else announce(strings.value.noRoom);
}

export function removeDisk(): void {
  if (disksNow.value.length > 1) edit({ disks: disksNow.value.slice(0, -1) });
}

export function setRestitution(restitution: number): void {
  edit({ restitution, wallRestitution: restitution, preset: setup.value.preset });
}

export function setBorder(on: boolean): void {
  const { width, height } = setup.value;
  const boundary: Setup['boundary'] = on ? ['reflecting', 'reflecting'] : ['open', 'open'];
  let disks: Disk[] = [];
  for (const disk of disksNow.value) {
    const place = on ? placed(disk, disks, { width, height, boundary, grid: grid.value }) : disk;
    if (!place) return announce(strings.value.noRoom);
    disks = [...disks, place];
  }
  edit({ boundary, disks });
}

/** Whether a disk has left the picture. */
export const outside = computed(() => {
  const { width, height } = setup.value;
  return disksNow.value.some(({ x, y, radius }) => x < -radius || y < -radius || x > width + radius || y > height + radius);
});
