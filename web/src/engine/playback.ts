// A few disks on their way through time: every contact exact, every earlier state again.
import { Engine } from './module';
import { Disk, Scene, sceneToml } from './scene';

export type Wall = 'left' | 'right' | 'bottom' | 'top';
const walls: Wall[] = ['left', 'right', 'bottom', 'top'];

export interface Vec {
  x: number;
  y: number;
}

/** One contact of two disks, or of a disk and a wall; positions at contact, velocities before and after. */
export interface Contact {
  index: number;
  time: number;
  i: number;
  j: number | Wall;
  positionI: Vec;
  positionJ: Vec;
  beforeI: Vec;
  beforeJ: Vec;
  afterI: Vec;
  afterJ: Vec;
  point: Vec;
  normal: Vec;
  impulse: number;
  restitution: number;
}

/** A contact of two disks. */
export type Collision = Contact & { j: number };
export const isCollision = (contact: Contact | undefined): contact is Collision => typeof contact?.j === 'number';

/** No contact is looked for beyond this time after the one before. */
const horizon = 1e5;

export class Playback {
  private readonly count: number;

  /** Throws EngineError if the scene cannot be simulated. One playback of an engine at a time. */
  constructor(
    private readonly engine: Engine,
    readonly scene: Scene,
  ) {
    engine.setInput(sceneToml(scene));
    this.count = engine.tryCall('play_open', -1);
  }

  /** All disks at `time`; what happens at exactly this time has not happened yet. */
  disksAt(time: number): Disk[] {
    return this.disks(this.engine.numbers('play_frame', 4 * this.count, time));
  }

  /** All disks at contact k: those before it in the log have happened, and k itself too. */
  disksAfter(contact: Contact): Disk[] {
    const disks = this.disks(this.engine.numbers('play_frame_after', 4 * this.count, contact.index));
    // Others of the same moment have happened there too: they are taken back, the last one first.
    const later: Contact[] = [];
    for (let next = this.contact(contact.index + 1); next?.time === contact.time; next = this.contact(next.index + 1)) {
      later.unshift(next);
    }
    for (const { i, j, beforeI, beforeJ } of later) {
      Object.assign(disks[i]!, { vx: beforeI.x, vy: beforeI.y });
      if (typeof j === 'number') Object.assign(disks[j]!, { vx: beforeJ.x, vy: beforeJ.y });
    }
    return disks;
  }

  private disks(n: Float64Array): Disk[] {
    const c = this.count;
    return this.scene.disks.map((disk, k) => ({
      ...disk,
      x: n[k]!,
      y: n[c + k]!,
      vx: n[2 * c + k]!,
      vy: n[3 * c + k]!,
    }));
  }

  /** How many contacts there are up to and at `time`. */
  contactsUntil(time: number): number {
    return this.engine.tryCall('play_contacts', -1, time);
  }

  /** Contact k, counted from 0, or nothing if so many never happen. */
  contact(k: number): Contact | undefined {
    if (k < 0) return undefined;
    const previous = k > 0 && this.engine.call('play_has', k - 1, 0) ? this.row(k - 1)[0]! : 0;
    if (!this.engine.call('play_has', k, previous + horizon)) return undefined;
    const n = this.row(k);
    const vec = (at: number): Vec => ({ x: n[at]!, y: n[at + 1]! });
    const j = n[2]!;
    return {
      index: k,
      time: n[0]!,
      i: n[1]!,
      j: j < 0 ? walls[-1 - j]! : j,
      positionI: vec(3),
      positionJ: vec(5),
      beforeI: vec(7),
      beforeJ: vec(9),
      afterI: vec(11),
      afterJ: vec(13),
      point: vec(15),
      normal: vec(17),
      impulse: n[19]!,
      restitution: n[20]!,
    };
  }

  private row(k: number): Float64Array {
    return this.engine.numbers('play_contact', 22, k);
  }
}
