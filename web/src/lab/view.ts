// What the picture shows, and how lengths of the scene become lengths of the picture.
import { computed, signal } from '@preact/signals';
import { Vec } from '../engine/playback';
import type { Disk } from '../engine/scene';
import { disksNow, setup } from './model';

/** In the order of the check boxes. */
export const layers = [
  'velocity',
  'momentum',
  'lines',
  'parts',
  'ghosts',
  'impulse',
  'change',
  'centre',
  'centreFrame',
  'paths',
  'wholePaths',
  'grid',
  'scale',
  'values',
] as const;
export type Layer = (typeof layers)[number];

export const initialLayers: readonly Layer[] = ['velocity', 'lines', 'ghosts', 'values', 'grid', 'scale'];
export const show = signal<ReadonlySet<Layer>>(new Set(initialLayers));

export function toggle(layer: Layer): void {
  const next = new Set(show.value);
  if (!next.delete(layer)) next.add(layer);
  show.value = next;
}

/** A vector that a step of the derivation speaks of. n: along the normal, t: the tangent, f: after the collision. */
export type Focus = 'v' | 'vf' | 'vn' | 'vt' | 'vnf' | 'lines' | 'units' | 'J';

/** What the step shown speaks of; nothing outside the derivation. */
export const focus = signal<ReadonlySet<Focus> | null>(null);

/** The picture is 1000 units wide. */
export const pictureWidth = 1000;
export const scale = computed(() => pictureWidth / setup.value.width);
/** A long narrow scene has room above and below it. */
export const pictureHeight = computed(() => Math.max(0.3 * pictureWidth, setup.value.height * scale.value));
const margin = computed(() => (pictureHeight.value - setup.value.height * scale.value) / 2);

export const totalMass = computed(() => setup.value.disks.reduce((sum, { mass }) => sum + mass, 0));

/** Centre of mass of these disks, and its velocity. */
function centreOf(disks: readonly Disk[]) {
  const mean = (of: 'x' | 'y' | 'vx' | 'vy'): number => disks.reduce((sum, disk) => sum + disk.mass * disk[of], 0) / totalMass.value;
  return { x: mean('x'), y: mean('y'), vx: mean('vx'), vy: mean('vy') };
}
export const centre = computed(() => centreOf(disksNow.value));

/** The frame of reference: what is taken off places and velocities. */
export const observer = computed(() => {
  if (!show.value.has('centreFrame')) return { x: 0, y: 0, vx: 0, vy: 0 };
  const { x, y, vx, vy } = centre.value;
  return { x: x - setup.value.width / 2, y: y - setup.value.height / 2, vx, vy };
});

/** From the scene to the picture. */
export function toPicture({ x, y }: Vec): Vec {
  return { x: (x - observer.value.x) * scale.value, y: margin.value + (setup.value.height - (y - observer.value.y)) * scale.value };
}

/** The same for a place at another time, when all disks stood like this: as the frame of reference saw it then. */
export function toPictureThen({ x, y }: Vec, then: readonly Disk[]): Vec {
  if (!show.value.has('centreFrame')) return toPicture({ x, y });
  const there = centreOf(then);
  return toPicture({ x: x - there.x + centre.value.x, y: y - there.y + centre.value.y });
}

/** From the picture to the scene. */
export function toScene({ x, y }: Vec): Vec {
  return { x: x / scale.value + observer.value.x, y: setup.value.height - (y - margin.value) / scale.value + observer.value.y };
}

/** An arrow of the picture for a velocity as the frame of reference sees it. */
export function arrowOf(v: Vec): Vec {
  const length = setup.value.arrow * scale.value;
  return { x: (v.x - observer.value.vx) * length, y: -(v.y - observer.value.vy) * length };
}

/** The same for a difference or a part of velocities, which no frame of reference changes. */
export function arrowOfPart(v: Vec): Vec {
  const length = setup.value.arrow * scale.value;
  return { x: v.x * length, y: -v.y * length };
}
