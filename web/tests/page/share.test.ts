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
    await page.click('#next-contact');
    await page.click('#next-contact');
    await page.click('#open-share');
    const scene = await saved('#save-scene');
    carom(['check', scene]);
    const svg = readFileSync(await saved('#save-svg'), 'utf8');
    expect(svg).toMatch(/^<svg .*<circle/s);
    expect(readFileSync(await saved('#save-png')).subarray(1, 4).toString()).toBe('PNG');
    const rows = readFileSync(await saved('#save-csv'), 'utf8').trim().split('\n');
    expect(rows[0]).toBe('time,i,j,x,y,nx,ny,impulse');
    expect(rows.length).toBe(3);
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
    await page.focus('#open-share');
    await page.keyboard.press('Enter');
    for (const button of ['#save-scene', '#save-png', '#save-svg', '#save-csv']) {
      await page.focus(button);
      await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
    }
    await page.focus('#open-scene');
    await Promise.all([page.waitForEvent('filechooser'), page.keyboard.press('Enter')]);
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
});
