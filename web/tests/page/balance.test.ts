// Property: what is drawn and written of momenta and energies is what the program says, and adds up as shown.
import type { Locator } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { handsOn } from './hands';
import { openedLab } from './lab';

const lab = openedLab();
const { row, collided } = handsOn(lab);

interface Ends {
  from: [number, number];
  to: [number, number];
}

async function endsOf(arrow: Locator): Promise<Ends> {
  const at = async (name: string): Promise<number> => Number(await arrow.locator('.shaft').getAttribute(name));
  const [x, y] = (await arrow.locator('polygon').getAttribute('points'))!.split(' ')[0]!.split(',').map(Number);
  return { from: [await at('x1'), await at('y1')], to: [x!, y!] };
}

const close = (a: [number, number], b: [number, number]): void => a.forEach((one, k) => expect(one).toBeCloseTo(b[k]!, 1));

describe('with loss', () => {
  it('momenta stand tip to tail and end where their sum does, energies add up to what is left', async () => {
    const { page } = lab;
    await page.check('#preset-inelastic', { force: true });
    const json = collided(await row(1), await row(2), 0.4);
    await page.click('#next-contact');
    const arrows = page.locator('.diagram:not(.energy) .arrow');
    const [one, two, sum] = [await endsOf(arrows.nth(0)), await endsOf(arrows.nth(1)), await endsOf(arrows.nth(2))];
    close(two.from, one.to);
    close(sum.from, one.from);
    close(sum.to, two.to);
    const [m, , , , vx, vy] = (await row(1)) as [number, number, number, number, number, number];
    const zoom = (one.to[0] - one.from[0]) / (m * vx);
    expect((one.from[1] - one.to[1]) / zoom).toBeCloseTo(m * vy, 1);
    const [px, py] = json.momentum_after as [number, number];
    expect((sum.to[0] - sum.from[0]) / zoom).toBeCloseTo(px, 1);
    expect((sum.from[1] - sum.to[1]) / zoom).toBeCloseTo(py, 1);
    const [parts, total] = (await page.textContent('.energy .sum'))!.split('=');
    const numbers = [...parts!.matchAll(/[\d.]+/g)].map(Number);
    expect(numbers.length).toBe(2);
    expect(numbers[0]! + numbers[1]!).toBeCloseTo(parseFloat(total!), 9);
    expect(parseFloat(total!)).toBeCloseTo(json.energy_after, 2);
    const widths = await page.locator('.energy .bar > span').evaluateAll((bars) => bars.map((bar) => parseFloat((bar as HTMLElement).style.width)));
    expect(widths.length).toBe(3);
    expect(widths[0]! + widths[1]!).toBeCloseTo((100 * json.energy_after) / json.energy_before, 2);
    expect(widths.reduce((all, width) => all + width, 0)).toBeCloseTo(100, 6);
  });
});
