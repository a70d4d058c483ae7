// Property: numbers are read and written as the language wants, sums add up as shown, and no word lacks a translation.
import { beforeAll, describe, expect, it } from 'vitest';
import { explain } from '../src/engine/collision';
import type { Engine } from '../src/engine/module';
import { Playback, isCollision } from '../src/engine/playback';
import { sceneToml, type Scene } from '../src/engine/scene';
import { stepsOf } from '../src/derivation/document';
import { translated } from '../src/derivation/translate';
import { language, languages, shown, shownSmall, shownToAddUp, typed } from '../src/strings';
import { startEngine } from './engine';

describe('numbers', () => {
  it('are read with comma or point, and nothing else is', () => {
    expect(typed('1,5')).toBe(1.5);
    expect(typed(' −0.25 ')).toBe(-0.25);
    expect(typed('3e-2')).toBe(0.03);
    for (const wrong of ['', '1.2.3', 'abc', '1 2', '0x10', 'Infinity', '1,2,3']) expect(typed(wrong)).toBeNaN();
  });
  it('are shown without a minus before zero, and with the mark of the language', () => {
    language.value = 'en';
    expect(shown(-0.001)).toBe('0.00');
    expect(shown(-1.5)).toBe('−1.50');
    expect(shown(NaN)).toBe('–');
    language.value = 'de';
    expect(shown(-1.5)).toBe('−1,50');
    language.value = 'en';
  });
  it('far below 1 are shown with a power of ten', () => {
    language.value = 'de';
    expect([1.14e-15, -2e-3, 0, 3.25, NaN].map(shownSmall)).toEqual(['1,1·10⁻¹⁵', '−2,0·10⁻³', '0', '3,3·10⁰', '–']);
    language.value = 'en';
  });
  it('add up as shown', () => {
    for (const parts of [[0.005, 0.005, 0.005], [0.333, 0.333, 0.334], [-0.126, 0.124, 1.0049], [1e-9, -1e-9]]) {
      const { parts: rounded, total } = shownToAddUp(parts);
      expect(rounded.reduce((sum, part) => sum + part, 0)).toBeCloseTo(total, 9);
      rounded.forEach((part, k) => expect(Math.abs(part - parts[k]!)).toBeLessThanOrEqual(0.0101));
    }
  });
});

/** Keys and kinds of everything in a language, with its lists' lengths. */
function shape(value: unknown): unknown {
  if (typeof value === 'function') return `function of ${value.length}`;
  if (Array.isArray(value)) return value.map(shape);
  if (value && typeof value === 'object') return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, key === 'derivation' ? '' : shape(one)]));
  return typeof value;
}

describe('languages', () => {
  it('have the same words', () => expect(shape(languages.de)).toEqual(shape(languages.en)));
});

const scene = (disks: number[][], restitution: number): Scene => ({
  title: '',
  width: 100,
  height: 100,
  boundary: ['open', 'open'],
  restitution,
  wallRestitution: restitution,
  disks: disks.map(([x, y, vx, vy, mass]) => ({ x: x!, y: y!, vx: vx!, vy: vy!, mass: mass!, radius: 0.5 })),
});

describe('derivation', () => {
  let engine: Engine;
  beforeAll(async () => void (engine = await startEngine()));
  const collisions: [string, number[][], number][] = [
    ['elastic, equal', [[1, 5, 1, 0, 1], [4, 5.8, 0, 0, 1]], 1],
    ['elastic, uneven numbers', [[1, 5, 1.37, 0.113, 1], [4, 5.8, -0.319, 0.07, 1]], 1],
    ['elastic, unequal', [[1, 5, 1, 0, 3], [4, 5.3, -0.37, 0.1, 0.7]], 1],
    ['with loss', [[1, 5, 1, 0, 3], [4, 5.3, -0.37, 0.1, 0.7]], 0.35],
    ['plastic', [[1, 5, 1, 0, 1], [3, 5, 0, 0, 1]], 0],
  ];
  for (const [name, disks, restitution] of collisions) {
    it(`has a German sentence for every one of the engine's: ${name}`, () => {
      language.value = 'de';
      const playback = new Playback(engine, scene(disks, restitution));
      const contact = playback.contact(0)!;
      expect(isCollision(contact)).toBe(true);
      if (!isCollision(contact)) return;
      const steps = stepsOf(explain(engine, contact, playback.scene.disks, 'markdown'));
      expect(steps.length).toBeGreaterThan(7);
      for (const step of steps) {
        expect(translated(step.heading)).not.toBe(step.heading);
        for (const block of step.blocks) {
          if (block.kind !== 'paragraph') continue;
          const text = block.runs.map((run) => (run.kind === 'words' ? run.text : run.kind === 'code' ? `\`${run.text}\`` : `$${run.text}$`)).join('');
          expect(translated(text)).not.toBe(text);
          expect(translated(text)).not.toMatch(/\{\d\}/);
        }
      }
      language.value = 'en';
    });
  }
  it('scenes are written so that the engine reads them', () => {
    engine.setInput(sceneToml(scene([[1, 5, 1e-7, 0, 3]], 1)));
    expect(engine.call('scene')).not.toBe(0);
  });
});
