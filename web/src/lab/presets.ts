// Collisions worth looking at.
import { Engine } from '../engine/module';
import { Disk, Scene, presetScene } from '../engine/scene';
import type { Setup } from './model';

export interface Preset {
  name: string;
  make: (engine: Engine) => Omit<Setup, 'preset'>;
}

const disk = (x: number, y: number, vx: number, vy: number, mass = 1, radius = 0.5): Disk => ({
  x,
  y,
  vx,
  vy,
  mass,
  radius,
});

const table = (disks: Disk[], restitution = 1): Omit<Setup, 'preset'> => ({
  width: 8,
  height: 5,
  boundary: ['reflecting', 'reflecting'],
  restitution,
  wallRestitution: restitution,
  disks,
  rate: 1,
  arrow: 1,
});

/** A step of 1, 2, 5, 10, … nearest below. */
function roundedDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [5, 2, 1].find((digit) => digit * power <= value * (1 + 1e-9))!;
}

/** Any scene of few disks, at a pace and with arrows that suit its speeds. */
export function setupOf(scene: Scene, preset = 'custom'): Setup {
  const { title: _, ...rest } = scene;
  let { width, height } = rest;
  if (!(width > 0 && height > 0)) {
    // An open plane: whatever shows all disks.
    width = Math.max(8, ...scene.disks.map((d) => d.x + 3 * d.radius));
    height = Math.max(5, ...scene.disks.map((d) => d.y + 3 * d.radius));
  }
  const fastest = Math.max(...scene.disks.map((d) => Math.hypot(d.vx, d.vy)));
  const slowly = fastest > 0 ? roundedDown(width / 3 / fastest) : 1;
  const quickly = fastest > 0 ? roundedDown(width / 10 / fastest) : 1;
  const arrow = fastest > width / 4 || (fastest > 0 && fastest < width / 40) ? roundedDown(width / 5 / fastest) : 1;
  return { ...rest, width, height, preset, rate: Math.max(quickly, Math.min(1, slowly)), arrow };
}

const made = (name: string, number?: number) => (engine: Engine): Omit<Setup, 'preset'> =>
  setupOf(presetScene(engine, name, number));

export const presets: Preset[] = [
  { name: 'oblique', make: () => table([disk(1.5, 2, 1, 0), disk(4.5, 2.8, 0, 0)]) },
  { name: 'headOn', make: () => table([disk(1.5, 2.5, 1, 0), disk(6.5, 2.5, -0.5, 0)]) },
  { name: 'overtaking', make: () => table([disk(1, 2.5, 1.2, 0), disk(3, 2.5, 0.4, 0)]) },
  { name: 'heavyOnLight', make: () => table([disk(1.5, 2.3, 1, 0, 8, 0.8), disk(5, 2.7, 0, 0, 1, 0.4)]) },
  { name: 'rightAngle', make: () => table([disk(1, 1.5, 1.5, 0), disk(4, 2.1, 0, 0)]) },
  { name: 'inelastic', make: () => table([disk(1.5, 2.2, 1, 0.1), disk(5.5, 2.8, -1, 0)], 0.4) },
  {
    name: 'five',
    make: () =>
      table([
        disk(1.2, 2.5, 1.5, 0.1),
        disk(3.6, 2.5, 0, 0),
        disk(4.6, 3.1, 0, 0),
        disk(4.6, 1.9, 0, 0),
        disk(6.5, 3.6, -0.4, -0.2, 2, 0.7),
      ]),
  },
  { name: 'cradle', make: made('cradle', 5) },
  { name: 'galperin', make: made('galperin', 3) },
  { name: 'break', make: made('break') },
];

export function presetSetup(engine: Engine, name: string): Setup | undefined {
  const preset = presets.find((one) => one.name === name);
  return preset && { ...preset.make(engine), preset: name };
}
