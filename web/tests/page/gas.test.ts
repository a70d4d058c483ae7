// Property: the gas runs in its worker, goes Maxwell's way, comes back when turned round, and takes all its controls.
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { inflateSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { open } from '../browser';
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
    await page.fill('#gas-packing', '0.8');
    await page.keyboard.press('Enter');
    await page.click('summary');
    await page.fill('#gas-fraction', '0.5');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('packing fraction'), undefined, { timeout: 20000 });
  });
  it('expands freely when the wall is taken away, and is back behind it when turned round', async () => {
    await page.fill('#gas-number', '60');
    await page.keyboard.press('Enter');
    await page.selectOption('#gas-boundary', 'half');
    await page.click('#gas-play');
    await expect.poll(() => reading('half'), { timeout: 20000 }).toBe(100);
    await page.focus('#gas-remove-wall');
    await page.keyboard.press('Enter');
    expect(await page.textContent('#gas-said')).toContain('expands freely');
    await expect.poll(() => reading('half'), { timeout: 60000 }).toBeLessThan(90);
    expect(await page.getAttribute('#gas-remove-wall', 'aria-disabled')).toBe('true');
    await page.click('#gas-reverse');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('back in the left half'), undefined, { timeout: 60000 });
    await expect.poll(() => page.getAttribute('#gas-remove-wall', 'aria-disabled')).toBe('false');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('It remembers.'), undefined, { timeout: 60000 });
    await page.click('#gas-remove-wall');
    await page.click('#open-share');
    await page.click('#copy-link');
    await page.waitForFunction(() => location.hash.includes('boundary=half'));
  });
});

/** How many of a picture's dots are of a disk, on paper or a canvas. */
async function coloured(png: Buffer): Promise<number> {
  return page.evaluate(async (bytes) => {
    const image = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d')!;
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    let count = 0;
    for (let k = 0; k < data.length; k += 4) {
      const dot = [data[k]!, data[k + 1]!, data[k + 2]!];
      if (Math.max(...dot) - Math.min(...dot) > 40) ++count;
    }
    return count / (image.width * image.height);
  }, [...png]);
}

/** Red, green and blue of every dot of the pictures in a PDF. */
function imagesOf(pdf: Buffer): number[][][] {
  const found: number[][][] = [];
  const text = pdf.toString('latin1');
  for (const { 0: head, index } of text.matchAll(/<<[^>]*\/Subtype \/Image[^>]*\/ICCBased[^>]*>>\s*stream\r?\n/g)) {
    const start = index + head.length;
    const bytes = inflateSync(pdf.subarray(start, text.indexOf('endstream', start)));
    found.push(Array.from({ length: Math.floor(bytes.length / 3) }, (_, k) => [bytes[3 * k]!, bytes[3 * k + 1]!, bytes[3 * k + 2]!]));
  }
  return found;
}

describe('its picture', () => {
  const folder = mkdtempSync(join(tmpdir(), 'carom-gas-'));
  async function savedPicture(): Promise<Buffer> {
    await page.waitForSelector('#gas-time');
    await page.waitForTimeout(300);
    await page.click('#open-share');
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save-png')]);
    await download.saveAs(join(folder, 'gas.png'));
    await page.click('#close-share');
    return readFileSync(join(folder, 'gas.png'));
  }
  for (const webgl of [true, false]) {
    it(`shows as much of disks as there is, ${webgl ? 'with' : 'without'} WebGL, on screen and in a file`, async () => {
      const opened = await open(lab.browser, `${lab.address}#gas&number=200&packing=0.3&seed=3`, { webgl });
      page = opened.page;
      const saved = await coloured(await savedPicture());
      const seen = await coloured(await page.locator('.gas-box').screenshot());
      for (const share of [saved, seen]) {
        expect(share).toBeGreaterThan(0.25);
        expect(share).toBeLessThan(0.32);
      }
      expect(opened.troubles).toEqual([]);
      await opened.context.close();
    });
  }
  it('is printed, in a dark theme too', async () => {
    const opened = await open(lab.browser, `${lab.address}#gas&number=200&packing=0.3&seed=3`, { dark: true });
    page = opened.page;
    await page.waitForSelector('#gas-time');
    await page.waitForTimeout(300);
    const pictures = imagesOf(await page.pdf({ printBackground: true, format: 'A4' }));
    const shares = pictures.map((dots) => dots.filter(([r, g, b]) => Math.max(r!, g!, b!) - Math.min(r!, g!, b!) > 40).length / dots.length);
    expect(Math.max(...shares)).toBeGreaterThan(0.2);
    expect(await page.getAttribute('html', 'data-theme')).toBe('dark');
    await opened.context.close();
  });
});
