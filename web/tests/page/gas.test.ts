// Property: the gas runs in its worker, goes Maxwell's way, comes back when turned round, and takes all its controls.
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { inflateSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { open } from '../browser';
import { carom, root } from '../engine';
import { openedLab } from './lab';

const lab = openedLab('#gas&number=200&packing=0.1&seed=3');
let page: Page;
beforeEach(() => {
  page = lab.page;
});

const reading = async (name: string): Promise<number> => {
  const [digits, power] = (await page.textContent(`#gas-${name}`))!.replace(/,/g, '').replace('−', '-').split('·10');
  const exponent = [...(power ?? '⁰')].map((sign) => '-0123456789'['⁻⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(sign)]).join('');
  return parseFloat(digits!) * 10 ** Number(exponent);
};

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
    const theory = Number(/theory ([\d.]+)/.exec((await page.textContent('#gas-rate'))!)![1]);
    const rate = (2 * (await reading('collisions'))) / (200 * (await reading('time')));
    expect(rate / theory).toBeGreaterThan(0.9);
    expect(rate / theory).toBeLessThan(1.1);
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
    // On beyond the start, turned round there, and back at the start once more; turned round twice it goes no way back.
    const met = await reading('time');
    await page.click('#gas-play');
    await expect.poll(() => reading('time'), { timeout: 60000 }).toBeGreaterThan(met + 0.3);
    await page.click('#gas-reverse');
    await page.click('#gas-reverse');
    await page.waitForFunction(() => !document.querySelector('#gas-said')!.textContent!.includes('as at the start'));
    await page.click('#gas-reverse');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('It remembers.'), undefined, { timeout: 60000 });
    expect(await reading('drift')).toBeLessThan(1e-12);
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
    await page.click('#gas-mixture');
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
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('which stands again'), undefined, { timeout: 60000 });
    await expect.poll(() => page.getAttribute('#gas-remove-wall', 'aria-disabled')).toBe('false');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('It remembers.'), undefined, { timeout: 60000 });
    await page.click('#gas-remove-wall');
    await page.click('#open-share');
    await page.click('#copy-link');
    await page.waitForFunction(() => location.hash.includes('boundary=half'));
  });
});

describe('its piston', () => {
  it('is pushed at the cost of the gas’s energy, by keyboard, and comes back with it', async () => {
    await page.fill('#gas-number', '60');
    await page.keyboard.press('Enter');
    await page.focus('#gas-boundary');
    await page.keyboard.press('End');
    expect(await page.inputValue('#gas-boundary')).toBe('piston');
    await page.focus('#gas-pistonMass');
    await page.keyboard.type('0.2');
    await page.keyboard.press('Enter');
    await page.focus('#gas-play');
    await page.keyboard.press('Enter');
    await expect.poll(() => reading('time'), { timeout: 20000 }).toBeGreaterThan(0.5);
    expect(await reading('piston')).toBe(0);
    expect(await reading('kT')).toBe(1);
    await page.focus('#gas-remove-wall');
    await page.keyboard.press('Enter');
    expect(await page.textContent('#gas-said')).toContain('The piston is free');
    await expect.poll(() => reading('piston-energy'), { timeout: 60000 }).toBeGreaterThan(5);
    await page.focus('#gas-play');
    await page.keyboard.press('Enter');
    expect(await reading('piston')).toBeGreaterThan(0);
    // Between walls kT is the gas's energy per disk: what it lost the piston has.
    const left = 1 - (await reading('piston-energy')) / 100;
    expect(await reading('kT')).toBeCloseTo(left, 2);
    expect(Math.abs(await reading('drift'))).toBeLessThan(1e-12);
    await page.click('#gas-reverse');
    await page.click('#gas-play');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('It remembers.'), undefined, { timeout: 60000 });
    expect(await page.getAttribute('#gas-remove-wall', 'aria-disabled')).toBe('false');
    await page.click('#open-share');
    await page.click('#copy-link');
    await page.waitForFunction(() => location.hash.includes('boundary=piston&') && location.hash.includes('pistonMass=0.2'));
  });
});

describe('its controls', () => {
  /** What the address says of the gas. */
  async function address(): Promise<Record<string, string>> {
    await page.click('#open-share');
    await page.click('#copy-link');
    await page.waitForFunction(() => location.hash.startsWith('#gas'));
    return Object.fromEntries(new URL(page.url()).hash.split('&').slice(1).map((part) => part.split('=')));
  }
  it('are worked by keyboard, and the address keeps them', async () => {
    await page.waitForSelector('#gas-time');
    await page.focus('#gas-mixture');
    await page.keyboard.press('Enter');
    for (const [id, typed] of [['number', '150'], ['packing', '0.2'], ['temperature', '2'], ['restitution', '0.9'], ['fraction', '0.4'], ['radiusRatio', '1.5'], ['massRatio', '3'], ['seed', '7']] as const) {
      await page.focus(`#gas-${id}`);
      await page.keyboard.type(typed);
      await page.keyboard.press('Enter');
    }
    await page.keyboard.press('ArrowUp');
    for (const id of ['boundary', 'speeds', 'colour']) {
      await page.focus(`#gas-${id}`);
      await page.keyboard.press('ArrowDown');
    }
    for (const id of ['tag', 'record']) {
      await page.focus(`#gas-${id}`);
      await page.keyboard.press(' ');
    }
    await page.focus('#pace');
    await page.keyboard.press('Home');
    expect(await page.getAttribute('#pace', 'aria-valuetext')).toContain('0.01');
    await expect.poll(() => reading('kT'), { timeout: 20000 }).toBeGreaterThan(1.7);
    const said = { number: '150', packing: '0.2', temperature: '2', boundary: 'reflecting', restitution: '0.9', fraction: '0.4', radiusRatio: '1.5', massRatio: '3', speeds: 'maxwell', seed: '8', pace: '0.01', colour: 'kind', tag: '1', record: '1' };
    expect(await address()).toEqual(said);
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    await page.keyboard.press(' ');
    await expect.poll(() => reading('time'), { timeout: 20000 }).toBeGreaterThan(0);
    await page.focus('#gas-new');
    await page.keyboard.press('Enter');
    await page.focus('#gas-reverse');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('turned round'));
    await page.reload();
    await page.waitForSelector('#gas-time');
    expect(await page.inputValue('#gas-massRatio')).toBe('3');
    expect(await page.inputValue('#gas-colour')).toBe('kind');
    expect(await page.isChecked('#gas-tag')).toBe(true);
  });
  it('are worked by mouse', async () => {
    await page.waitForSelector('#gas-time');
    const track = (await page.locator('#pace').boundingBox())!;
    await page.mouse.click(track.x + track.width - 3, track.y + track.height / 2);
    expect(await page.getAttribute('#pace', 'aria-valuetext')).toContain('1000');
    await page.click('#gas-play');
    await expect.poll(() => reading('time'), { timeout: 20000 }).toBeGreaterThan(1);
    await page.click('#gas-play');
    await page.click('#gas-new');
    await expect.poll(() => reading('time'), { timeout: 20000 }).toBe(0);
    await page.click('#gas-tag');
    expect(await page.isChecked('#gas-tag')).toBe(true);
    await page.click('#gas-mixture');
    await page.fill('#gas-seed', '12');
    await page.click('#gas-play');
    await page.click('#gas-play');
    expect(await address()).toMatchObject({ seed: '12', tag: '1', pace: '1000' });
  });
  it('charts tell the value under the pointer', async () => {
    await page.waitForSelector('.plot canvas');
    await page.locator('.plot').first().hover();
    await expect.poll(() => page.locator('.reading').first().textContent()).toMatch(/^v \d\.\d+, f \d/);
    expect(await page.locator('.plot').first().getAttribute('aria-label')).toContain('Maxwell');
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

describe('its collisions', () => {
  const folder = mkdtempSync(join(tmpdir(), 'carom-collisions-'));
  async function download(work: () => Promise<unknown>): Promise<string> {
    const [download] = await Promise.all([page.waitForEvent('download'), work()]);
    const path = join(folder, download.suggestedFilename());
    await download.saveAs(path);
    return path;
  }
  async function openShare(): Promise<void> {
    await page.focus('#open-share');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#dialog-share[open]');
  }
  const linesOf = (path: string): string[] => readFileSync(path, 'utf8').trim().split('\n');
  /** The program's log of the same scene, with as many rows. */
  function logged(scene: string, like: string[]): string[] {
    const log = join(folder, 'log.csv');
    const until = Number(like.at(-1)!.split(',')[0]) + 1e-3;
    carom(['run', scene, '--until', `${until}`, '--log-collisions', log, '--json', '--quiet']);
    return linesOf(log).slice(0, like.length);
  }
  it('are recorded and saved, by keyboard, as the program logs those of the same scene', async () => {
    await page.waitForSelector('#gas-time');
    await openShare();
    const scene = await download(() => page.press('#save-scene', 'Enter'));
    expect(await page.getAttribute('#save-collisions', 'aria-disabled')).toBe('true');
    expect(await page.textContent('#none-recorded')).toContain('Record collisions');
    await page.keyboard.press('Escape');
    await page.focus('#gas-record');
    await page.keyboard.press(' ');
    await page.waitForSelector('#gas-recorded');
    await page.focus('#gas-play');
    await page.keyboard.press('Enter');
    await expect.poll(() => reading('collisions'), { timeout: 20000 }).toBeGreaterThan(100);
    await page.keyboard.press('Enter');
    await openShare();
    const found = linesOf(await download(() => page.press('#save-collisions', 'Enter')));
    expect(found.length).toBeGreaterThan(100);
    expect(found).toEqual(logged(scene, found));
    await page.click('#close-share');
    expect(await page.textContent('#gas-recorded')).toContain(`${found.length - 1} recorded from time 0.00 on, those at walls too; at most 200,000.`);
  });
  it('are recorded of a scene that was opened, and begin anew with it, by mouse, in German', async () => {
    await page.selectOption('#language', 'de');
    await page.click('#gas-record');
    const scene = `${root}scenes/mixture.toml`;
    await page.setInputFiles('#scene-file', scene);
    await page.waitForFunction(() => document.querySelector('#gas-said')!.textContent!.includes('läuft als Gas'));
    await page.click('#gas-play');
    await expect.poll(() => page.textContent('#gas-recorded'), { timeout: 20000 }).toMatch(/^\d+\.\d{3} aufgezeichnet ab Zeit 0,00/);
    await page.click('#gas-play');
    await page.click('#gas-record');
    await page.click('#gas-play');
    await page.click('#open-share');
    const found = linesOf(await download(() => page.click('#save-collisions')));
    expect(found.length).toBeGreaterThan(1000);
    expect(found).toEqual(logged(scene, found));
  });
});

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
  it('is saved as shapes, and its measurements as a table', async () => {
    await page.check('#gas-tag');
    await page.click('#gas-play');
    await expect.poll(() => page.locator('.plot').nth(1).getAttribute('aria-label'), { timeout: 20000 }).toMatch(/H: −\d/);
    await page.click('#gas-play');
    await page.click('#open-share');
    const text = async (button: string, name: string): Promise<string> => {
      const [download] = await Promise.all([page.waitForEvent('download'), page.click(button)]);
      expect(download.suggestedFilename()).toBe(name);
      await download.saveAs(join(folder, name));
      return readFileSync(join(folder, name), 'utf8');
    };
    const svg = await text('#save-svg', 'gas.svg');
    expect(svg.match(/<circle /g)!.length).toBe(201);
    expect(svg).toMatch(/<path d="M[\d.]+,[\d.]+L/);
    const [header, ...rows] = (await text('#save-csv', 'gas.csv')).trim().split('\n');
    expect(header).toBe('time,collisions,collisions_per_disk_and_time,kT,Z,H,psi6,packing_fraction,energy_drift');
    expect(rows.length).toBeGreaterThan(0);
    for (const row of rows) {
      expect(Number(row.split(',')[3])).toBeCloseTo(1, 2);
      expect(Number(row.split(',')[7])).toBeCloseTo(0.1, 9);
    }
  });
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
