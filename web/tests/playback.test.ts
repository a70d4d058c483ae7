// Property: contacts are exact, going back gives the very bits of before, and what is shown is what `carom collide` says.
import { beforeAll, describe, expect, it } from 'vitest';
import { takeApart } from '../src/engine/collision';
import { EngineError, type Engine } from '../src/engine/module';
import { Playback, isCollision } from '../src/engine/playback';
import { parseScene, presetScene, sceneToml, type Scene } from '../src/engine/scene';
import { presets } from '../src/lab/presets';
import { carom, startEngine } from './engine';

let engine: Engine;
beforeAll(async () => void (engine = await startEngine()));

function sceneOfPreset(name: string): Scene {
  const setup = presets.find((preset) => preset.name === name)!.make(engine);
  return { title: name, ...setup };
}

describe('playback', () => {
  for (const { name } of presets) {
    it(`${name}: going back gives the same bits`, () => {
      const playback = new Playback(engine, sceneOfPreset(name));
      const last = playback.contact(Math.min(30, playback.contactsUntil(60) - 1))!;
      const times = [0, 0.3, 0.9, 1].map((share) => share * last.time);
      const forward = times.map((time) => playback.disksAt(time));
      const back = [...times].reverse().map((time) => playback.disksAt(time)).reverse();
      expect(back).toEqual(forward);
    });

    it(`${name}: after every contact the disks move as the contact says`, () => {
      const playback = new Playback(engine, sceneOfPreset(name));
      for (let k = 0; k < 12; ++k) {
        const contact = playback.contact(k);
        if (!contact) break;
        const disks = playback.disksAfter(contact);
        expect(disks[contact.i]).toMatchObject({ vx: contact.afterI.x, vy: contact.afterI.y });
        if (isCollision(contact)) expect(disks[contact.j]).toMatchObject({ vx: contact.afterJ.x, vy: contact.afterJ.y });
      }
    });
  }

  it('agrees with `carom collide --json` to the last bit', () => {
    for (const name of ['oblique', 'headOn', 'heavyOnLight', 'inelastic', 'five']) {
      const playback = new Playback(engine, sceneOfPreset(name));
      const contact = [0, 1, 2, 3].map((k) => playback.contact(k)).find(isCollision)!;
      const disks = playback.scene.disks;
      const parts = takeApart(engine, contact, disks);
      const words = (p: { x: number; y: number }, v: { x: number; y: number }, k: number): string =>
        [p.x, p.y, v.x, v.y, disks[k]!.mass].join(',');
      const json = JSON.parse(
        carom(['collide', '--disk', words(contact.positionI, contact.beforeI, contact.i), '--disk', words(contact.positionJ, contact.beforeJ, contact.j), '--restitution', String(contact.restitution), '--json']),
      );
      expect([contact.afterI.x, contact.afterI.y].map((v) => v + 0)).toEqual(json.velocity1_after);
      expect([contact.afterJ.x, contact.afterJ.y].map((v) => v + 0)).toEqual(json.velocity2_after);
      expect([parts.normal.x, parts.normal.y]).toEqual(json.normal.map((v: number) => v + 0));
      expect(parts.before[0]).toEqual({ n: json.v1n, t: json.v1t });
      expect(parts.after.map(({ n }) => n)).toEqual([json.v1n_after, json.v2n_after]);
      expect([parts.energyBefore, parts.energyAfter]).toEqual([json.energy_before, json.energy_after]);
      expect([parts.impulse.x + 0, parts.impulse.y + 0]).toEqual(json.impulse);
    }
  });

  it('knows that nothing will happen any more', () => {
    const at = (x: number, vx: number) => ({ x, y: 2, vx, vy: 0, mass: 1, radius: 0.5 });
    const plane = { title: '', width: 8, height: 5, restitution: 1, wallRestitution: 1 };
    const still = new Playback(engine, { ...plane, boundary: ['reflecting', 'reflecting'], disks: [at(1, 0), at(3, 0)] });
    expect(still.contact(0)).toBeUndefined();
    const parting = new Playback(engine, { ...plane, boundary: ['open', 'open'], disks: [at(1, -1), at(3, 1)] });
    expect(parting.contact(0)).toBeUndefined();
    const alone = new Playback(engine, { ...plane, boundary: ['periodic', 'periodic'], disks: [at(1, 1)] });
    expect(alone.contact(0)).toBeUndefined();
    const bouncing = new Playback(engine, { ...plane, boundary: ['reflecting', 'open'], disks: [at(1, 1)] });
    expect(bouncing.contact(0)).toMatchObject({ i: 0, j: 'right', time: 6.5 });
  });

  it('counts the digits of pi', () => {
    const playback = new Playback(engine, presetScene(engine, 'galperin', 3));
    // Later the disks come back from the far wall.
    expect(playback.contactsUntil(16)).toBe(314);
  });

  it('says what is wrong with a scene, line by line', () => {
    expect(() => parseScene(engine, '[box]\nsize = [1, 1]\nboundry = "open"\n')).toThrow(EngineError);
    expect(() => parseScene(engine, '[box]\nsize = [1, 1]\nboundry = "open"\n')).toThrow(/scene:3:1: .*boundry.*boundary/);
    expect(() => parseScene(engine, '')).toThrow(EngineError);
    expect(() => parseScene(engine, '\u0000')).toThrow(EngineError);
  });

  it('reads what it writes', () => {
    const scene = sceneOfPreset('five');
    expect(parseScene(engine, sceneToml(scene)).disks).toEqual(scene.disks);
    expect(carom(['check', '-'], sceneToml(scene))).toBeDefined();
  });
});
