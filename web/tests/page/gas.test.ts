// Property: the gas runs in its worker, goes Maxwell's way, comes back when turned round, and takes all its controls.
import type { Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { openedLab } from './lab';

const lab = openedLab('#gas&number=200&packing=0.1&seed=3');
let page: Page;
beforeEach(() => {
  page = lab.page;
});

const reading = async (name: string): Promise<number> =>
  parseFloat((await page.textContent(`#gas-${name}`))!.replace(/,/g, '').replace('−', '-').replace('e−', 'e-'));

describe('gas', () => {
  it('runs, keeps its energy, and collides at the rate that theory says', async () => {
    await page.waitForSelector('#gas-time');
    await page.focus('#pace');
    for (let k = 0; k < 10; ++k) await page.keyboard.press('ArrowRight');
    await page.focus('#gas-play');
    await page.keyboard.press('Enter');
    await expect.poll(() => reading('time'), { timeout: 60000 }).toBeGreaterThan(30);
    await page.click('#gas-play');
    expect(Math.abs(await reading('drift'))).toBeLessThan(1e-12);
    expect(await reading('kT')).toBeCloseTo(1, 2);
    // Kolafa and Rottner: Z = 1.236 at this density; over ten seconds of 200 disks it scatters by some per cent.
    expect(await reading('z')).toBeGreaterThan(1.1);
    expect(await reading('z')).toBeLessThan(1.4);
  });
  it('comes back to its start when turned round', async () => {
    await page.click('#gas-play');
    await expect.poll(() => reading('time'), { timeout: 60000 }).toBeGreaterThan(0.5);
    await page.click('#gas-play');
    await page.click('#gas-reverse');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('turned round'));
    await page.click('#gas-play');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('should stand'), undefined, { timeout: 60000 });
    expect(await page.textContent('#gas-said')).toContain('It remembers.');
  });
  it('takes every parameter, and says what cannot be', async () => {
    await page.fill('#gas-number', '50');
    await page.keyboard.press('Enter');
    await page.selectOption('#gas-boundary', 'reflecting');
    await page.selectOption('#gas-speeds', 'maxwell');
    await page.selectOption('#gas-colour', 'order');
    await page.check('#gas-tag');
    await page.click('#gas-play');
    await expect.poll(() => reading('collisions'), { timeout: 60000 }).toBeGreaterThan(0);
    const before = (await page.locator('#gas-picture').boundingBox())!;
    await page.click('#gas-remove-wall');
    await expect.poll(async () => {
      const now = (await page.locator('#gas-picture').boundingBox())!;
      return now.width / now.height;
    }, { timeout: 20000 }).toBeCloseTo((2 * before.width) / before.height, 1);
    await page.fill('#gas-packing', '0.8');
    await page.keyboard.press('Enter');
    await page.click('summary');
    await page.fill('#gas-fraction', '0.5');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('packing fraction'), undefined, { timeout: 20000 });
  });
});
