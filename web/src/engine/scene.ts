// Scenes: as the page knows them, and as the TOML text that the engine and the command line read.
import { Engine } from './module';

export interface Disk {
  x: number;
  y: number;
  vx: number;
  vy: number;
  mass: number;
  radius: number;
}

export type Boundary = 'periodic' | 'reflecting' | 'open';
const boundaries: Boundary[] = ['periodic', 'reflecting', 'open'];

export interface Scene {
  title: string;
  width: number;
  height: number;
  boundary: [Boundary, Boundary];
  restitution: number;
  wallRestitution: number;
  disks: Disk[];
}

/** A number that TOML reads as a float, with the digits that give the same double again. */
export function tomlNumber(value: number): string {
  const text = String(value);
  return /[.e]/.test(text) ? text : `${text}.0`;
}

export function sceneToml(scene: Scene): string {
  const pair = (a: number, b: number): string => `[${tomlNumber(a)}, ${tomlNumber(b)}]`;
  const quoted = (words: string): string => JSON.stringify(words);
  const [alongX, alongY] = scene.boundary;
  const lines = [
    `title = ${quoted(scene.title)}`,
    '',
    '[box]',
    `size = ${pair(scene.width, scene.height)}`,
    `boundary = ${alongX === alongY ? quoted(alongX) : `[${quoted(alongX)}, ${quoted(alongY)}]`}`,
    '',
    '[physics]',
    `restitution = ${tomlNumber(scene.restitution)}`,
  ];
  if (scene.wallRestitution !== scene.restitution) {
    lines.push(`wall_restitution = ${tomlNumber(scene.wallRestitution)}`);
  }
  for (const disk of scene.disks) {
    lines.push(
      '',
      '[[disk]]',
      `position = ${pair(disk.x, disk.y)}`,
      `velocity = ${pair(disk.vx, disk.vy)}`,
      `radius = ${tomlNumber(disk.radius)}`,
      `mass = ${tomlNumber(disk.mass)}`,
    );
  }
  return `${lines.join('\n')}\n`;
}

/** Reads a scene file. Throws EngineError with every problem, each with line and column. */
export function parseScene(engine: Engine, text: string): Scene {
  engine.setInput(text);
  const address = engine.tryCall('scene', 0);
  const count = engine.view(address, 1)[0]!;
  const n = engine.view(address, 7 + 6 * count).slice();
  const disks: Disk[] = [];
  for (let k = 0; k < count; ++k) {
    const [x, y, vx, vy, mass, radius] = n.subarray(7 + 6 * k);
    disks.push({ x: x!, y: y!, vx: vx!, vy: vy!, mass: mass!, radius: radius! });
  }
  return {
    title: /^title\s*=\s*"([^"\\]*)"/m.exec(text)?.[1] ?? '',
    width: n[1]!,
    height: n[2]!,
    boundary: [boundaries[n[3]!]!, boundaries[n[4]!]!],
    restitution: n[5]!,
    wallRestitution: n[6]!,
    disks,
  };
}

/** A scene that `carom make NAME` writes. */
export function presetScene(engine: Engine, name: string, number = 0): Scene {
  engine.setInput(name);
  engine.tryCall('preset', 0, number);
  return parseScene(engine, engine.text());
}
