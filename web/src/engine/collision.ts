// One collision taken apart: what `carom collide --json` prints, and the derivation that `--explain` prints.
import { Engine } from './module';
import { Collision, Vec } from './playback';
import { Disk } from './scene';

export interface Parts {
  n: number;
  t: number;
}

export interface Anatomy {
  normal: Vec;
  tangent: Vec;
  before: [Parts, Parts];
  after: [Parts, Parts];
  velocityAfter: [Vec, Vec];
  momentumBefore: Vec;
  momentumAfter: Vec;
  energyBefore: number;
  energyAfter: number;
  impulse: Vec;
  approaching: boolean;
}

function setPair(engine: Engine, collision: Collision, disks: readonly Disk[]): void {
  const one = disks[collision.i]!;
  const two = disks[collision.j]!;
  const { positionI, positionJ, beforeI, beforeJ } = collision;
  const pair = [
    ...[positionI.x, positionI.y, beforeI.x, beforeI.y, one.mass, one.radius],
    ...[positionJ.x, positionJ.y, beforeJ.x, beforeJ.y, two.mass, two.radius],
  ];
  engine.view(engine.call('pair'), 12).set(pair);
}

export function takeApart(engine: Engine, collision: Collision, disks: readonly Disk[]): Anatomy {
  setPair(engine, collision, disks);
  const n = engine.numbers('collide', 25, collision.restitution);
  const vec = (at: number): Vec => ({ x: n[at]!, y: n[at + 1]! });
  const parts = (at: number): Parts => ({ n: n[at]!, t: n[at + 1]! });
  return {
    normal: vec(0),
    tangent: vec(2),
    before: [parts(4), parts(6)],
    after: [parts(8), parts(10)],
    velocityAfter: [vec(12), vec(14)],
    momentumBefore: vec(16),
    momentumAfter: vec(18),
    energyBefore: n[20]!,
    energyAfter: n[21]!,
    impulse: vec(22),
    approaching: n[24] === 1,
  };
}

export type Format = 'text' | 'markdown' | 'latex';
const formats: Format[] = ['text', 'markdown', 'latex'];

export function explain(engine: Engine, collision: Collision, disks: readonly Disk[], format: Format): string {
  setPair(engine, collision, disks);
  engine.tryCall('explain', 0, collision.restitution, collision.time, formats.indexOf(format));
  return engine.text();
}
