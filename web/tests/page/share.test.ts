// Property: a state comes back from its address, its file and its table; bad files are refused with line and column.
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Download, Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { open } from '../browser';
import { carom, root } from '../engine';
import { openedLab } from './lab';

const lab = openedLab();
let page: Page;
const folder = mkdtempSync(join(tmpdir(), 'carom-lab-'));
beforeEach(() => {
  page = lab.page;
});

async function saved(button: string): Promise<string> {
  const [download] = (await Promise.all([page.waitForEvent('download'), page.click(button)])) as [Download, void];
  const path = join(folder, download.suggestedFilename());
  await download.saveAs(path);
  return path;
}
const cells = (): Promise<string[]> => page.locator('tbody input').evaluateAll((inputs) => inputs.map((input) => (input as HTMLInputElement).value));

describe('sharing', () => {
  it('the address holds the state', async () => {
    await page.check('#preset-heavyOnLight', { force: true });
    await page.check('#show-paths');
    const before = await cells();
    await page.click('#open-share');
    await page.click('#copy-link');
    await page.waitForFunction(() => location.hash.length > 10);
    const second = await open(lab.browser, page.url());
    page = second.page;
    expect(await cells()).toEqual(before);
    expect(await page.isChecked('#show-paths')).toBe(true);
    await second.context.close();
  });
  it('scenes, pictures and tables are saved, and the program reads them', async () => {
    await page.click('#open-share');
    const start = await saved('#save-scene');
    const log = join(folder, 'log.csv');
    carom(['run', start, '--until', '20', '--log-collisions', log, '--json', '--quiet']);
    await page.click('#close-share');
    for (let k = 0; k < 6; ++k) await page.click('#next-contact');
    await page.click('#open-share');
    const scene = await saved('#save-scene');
    carom(['check', scene]);
    const svg = readFileSync(await saved('#save-svg'), 'utf8');
    expect(svg).toMatch(/^<svg .*<circle/s);
    expect(readFileSync(await saved('#save-png')).subarray(1, 4).toString()).toBe('PNG');
    // The same doubles, though not always with as many digits.
    const rowsOf = (path: string): (string | number)[][] => {
      const [head, ...rows] = readFileSync(path, 'utf8').trim().split('\n');
      expect(head).toBe('time,i,j,x,y,nx,ny,impulse');
      return rows.map((row) => row.split(',').map((one) => (Number.isNaN(Number(one)) ? one : Number(one))));
    };
    const rows = rowsOf(await saved('#save-csv'));
    expect(rows.length).toBe(6);
    expect(rows).toEqual(rowsOf(log).slice(0, 6));
    await page.click('#close-share');
    const before = await cells();
    await page.check('#preset-five', { force: true });
    await page.setInputFiles('#scene-file', scene);
    await expect.poll(cells).toEqual(before);
  });
  it('scenes of many disks run as a gas', async () => {
    await page.setInputFiles('#scene-file', `${root}scenes/gas.toml`);
    await page.waitForSelector('#gas-picture');
    await page.waitForSelector('#gas-time');
    await page.click('#open-share');
    carom(['check', await saved('#save-scene')]);
  });
  it('scenes are taken where they are dropped', async () => {
    const text = readFileSync(`${root}scenes/two-disk.toml`, 'utf8');
    await page.evaluate((text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], 'two-disk.toml'));
      const over = new DragEvent('dragover', { dataTransfer, bubbles: true, cancelable: true });
      document.body.dispatchEvent(over);
      if (!over.defaultPrevented) throw new Error('nothing may be dropped here');
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    }, text);
    await expect.poll(() => page.textContent('#said')).toContain('two-disk.toml');
    expect(await page.textContent('#preset-name')).toBe('Own set-up');
  });
  it('the whole menu, language and theme are worked by keyboard', async () => {
    const chooser = page.waitForEvent('filechooser'); // told to the browser long before the key
    await page.focus('#open-share');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#dialog-share[open]');
    for (const button of ['#save-scene', '#save-png', '#save-svg', '#save-csv']) {
      await page.focus(button);
      await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
    }
    await page.focus('#open-scene');
    await Promise.all([chooser, page.keyboard.press('Enter')]);
    await page.focus('#copy-link');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => location.hash.startsWith('#lab') && !document.querySelector('dialog[open]'));
    await page.focus('#theme');
    await page.keyboard.press('Enter');
    expect(await page.getAttribute('html', 'data-theme')).toBe('dark');
    await page.focus('#language');
    await page.keyboard.press('ArrowDown');
    expect(await page.getAttribute('html', 'lang')).toBe('de');
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    await page.keyboard.press('?');
    await page.waitForSelector('#dialog-keys[open]');
    await page.keyboard.press('Escape');
    await page.waitForSelector('#dialog-keys', { state: 'hidden' });
    await page.focus('#tab-gas');
    await page.keyboard.press('Enter');
    await page.waitForSelector('#gas-picture');
  });
  it('an address that cannot be is refused, with the reason', async () => {
    const opened = await open(lab.browser, `${lab.address}#lab&box=8,5,rr&e=1&disks=1,1,0,0,1,0.5;1.2,1,0,0,1,0.5`);
    expect(await opened.page.textContent('#said')).toContain('overlap');
    expect(await opened.page.isChecked('#preset-oblique')).toBe(true);
    expect(opened.troubles).toEqual([]);
    await opened.context.close();
  });
  it('what is wrong with a file is said', async () => {
    const file = join(folder, 'bad.toml');
    writeFileSync(file, '[box]\nsize = [8, 5]\n\n[[disk]]\npositon = [1, 1]\n');
    await page.setInputFiles('#scene-file', file);
    await expect.poll(() => page.textContent('#said')).toContain('5:1');
  });
  it('files made to do harm are refused in few words, and the page goes on', async () => {
    const hostile: [string, string][] = [
      ['a' + '.b'.repeat(200000) + ' = 1', 'a key of more than 256 parts'],
      // Deeper than the engine's stack.
      ['a = ' + `{ b${'.b'.repeat(62)} = `.repeat(250) + '1' + ' }'.repeat(250), 'cannot be read'],
      ['a = ' + '['.repeat(200000), 'not valid TOML'],
      ['\0'.repeat(1000), 'not valid TOML'],
      ['[box]\nsize = [9, 9]\n[[gas]]\ncount = 2000000000\nradius = 0.5\n', 'too many'],
      [Array.from({ length: 1000 }, (_, k) => `k${k} = 1`).join('\n'), '… and 98 more'],
      ['#'.repeat(20000001), 'too large'],
      ['[box]\nsize = [8, 5]\n[[disk]]\nposition = [1, 1]\nvelocity = [1e300, nan]\nradius = 0.5\n', '5:'],
      ['title = "<img src=x onerror=alert(1)>"\n<img src=x>\n', 'not valid TOML'],
    ];
    const before = await cells();
    for (const [k, [text, reason]] of hostile.entries()) {
      const file = join(folder, `hostile-${k}.toml`);
      writeFileSync(file, text);
      await page.setInputFiles('#scene-file', file);
      await expect.poll(() => page.textContent('#said'), { timeout: 20000 }).toMatch(new RegExp(`hostile-${k}.toml: .*${reason}`, 's'));
      expect((await page.textContent('#said'))!.length).toBeLessThan(1000);
      expect(await cells()).toEqual(before);
    }
    await page.click('#next-contact');
    expect(await page.textContent('#said')).toContain('collided');
  });
  it('scenes too fast to be followed do not stop the page', async () => {
    const disk = (k: number): string => `[[disk]]\nposition = [${1 + (k % 6)}, ${1 + Math.floor(k / 6)}]\nvelocity = [${k === 0 ? '1e60, 1e59' : '0.0, 0.0'}]\nradius = 0.3\n`;
    const scene = (count: number): string => `[box]\nsize = [8, 6]\nboundary = "reflecting"\n${Array.from({ length: count }, (_, k) => disk(k)).join('')}`;
    const file = join(folder, 'fast.toml');
    writeFileSync(file, scene(2));
    await page.setInputFiles('#scene-file', file);
    await expect.poll(() => page.textContent('#said')).toContain('Opened');
    await page.click('#step-forward');
    await page.click('#restart');
    expect(await page.textContent('#clock')).toBe('0.00');
    writeFileSync(file, scene(24));
    await page.setInputFiles('#scene-file', file);
    await page.waitForSelector('#gas-time');
    await page.click('#gas-play');
    await page.waitForTimeout(5000); // the worker is at it for ever; a new gas has another one
    await page.fill('#gas-number', '50');
    await page.keyboard.press('Enter');
    await expect.poll(() => page.textContent('#gas-collisions'), { timeout: 20000 }).toMatch(/[1-9]/);
  });
});
