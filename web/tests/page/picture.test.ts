// Property: what the picture adds to the numbers says the same as they do, by mouse, by keyboard and from an address.
import type { Locator, Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { open } from '../browser';
import { handsOn } from './hands';
import { openedLab } from './lab';

const lab = openedLab();
const { value, row, collided, take } = handsOn(lab);
let page: Page;
beforeEach(() => {
  page = lab.page;
});

/** Pixels of the picture per length. */
const scale = 1000 / 8;

const numbers = async (place: Locator, ...names: string[]): Promise<number[]> =>
  Promise.all(names.map(async (name) => Number(await place.getAttribute(name))));

/** An arrow of the picture, as a vector of the scene. */
async function vectorOf(arrow: Locator): Promise<[number, number]> {
  const [x, y] = await numbers(arrow.locator('.shaft'), 'x1', 'y1');
  const [tipX, tipY] = (await arrow.locator('polygon').getAttribute('points'))!.split(' ')[0]!.split(',').map(Number);
  return [(tipX! - x!) / scale, (y! - tipY!) / scale];
}

/** The same page opened from the address that it gives. */
async function fromAddress(): Promise<{ close: () => Promise<void> }> {
  await page.click('#open-share');
  await page.click('#copy-link');
  await page.waitForFunction(() => location.hash.length > 10);
  const opened = await open(lab.browser, page.url());
  lab.page = page = opened.page;
  expect(opened.troubles).toEqual([]);
  return { close: () => opened.context.close() };
}

describe('masses', () => {
  it('go by slider; sizes stay and tints tell the denser disk', async () => {
    await page.locator('#mass-2').scrollIntoViewIfNeeded();
    const track = (await page.locator('#mass-2').boundingBox())!;
    await page.mouse.click(track.x + track.width - 2, track.y + track.height / 2);
    await expect.poll(() => value(2, 1)).toBeCloseTo(10, 0);
    await page.focus('#mass-1');
    for (let k = 0; k < 10; ++k) await page.keyboard.press('ArrowRight');
    await expect.poll(() => value(1, 1)).toBe(3.2);
    await expect.poll(() => page.getAttribute('#mass-1', 'aria-valuetext')).toBe('3.20');
    await page.keyboard.press('Home');
    await expect.poll(() => value(1, 1)).toBe(0.1);
    expect([await value(1, 2), await value(2, 2)]).toEqual([0.5, 0.5]);
    expect(await page.locator('[data-disk="2"] .tint.denser').count()).toBe(1);
    expect(await page.locator('[data-disk="1"] .tint:not(.denser)').count()).toBe(1);
    const json = collided(await row(1), await row(2));
    await page.click('#next-contact');
    await expect.poll(() => value(1, 5)).toBeCloseTo(json.velocity1_after[0], 4);
  });
  it('or sizes follow, and disks are pushed off each other', async () => {
    await page.focus('#constant-size');
    await page.keyboard.press(' ');
    await page.focus('#mass-2');
    for (let k = 0; k < 12; ++k) await page.keyboard.press('ArrowRight');
    await expect.poll(() => value(2, 1)).toBe(4);
    await expect.poll(() => value(2, 2)).toBeCloseTo(1, 4);
    expect(await page.locator('.tint').count()).toBe(0);
    await page.keyboard.press('End');
    await expect.poll(() => value(2, 2)).toBeCloseTo(0.5 * Math.sqrt(10), 3);
    const [one, two] = [await row(1), await row(2)];
    expect(Math.hypot(one[2]! - two[2]!, one[3]! - two[3]!)).toBeGreaterThanOrEqual(one[1]! + two[1]! - 1e-3);
    const { close } = await fromAddress();
    expect(await page.isChecked('#constant-size')).toBe(false);
    await expect.poll(() => value(2, 1)).toBe(10);
    await page.click('#constant-size');
    expect(await page.locator('.tint').count()).toBe(0);
    await close();
  });
});

describe('change in momentum', () => {
  const arrows = () => page.locator('#play-area .arrow.change');
  it('is drawn as the program computes it, tied to the disks, and fades', async () => {
    await page.focus('#show-change');
    await page.keyboard.press(' ');
    const json = collided(await row(1), await row(2));
    expect(await arrows().count()).toBe(0);
    await page.click('#next-contact');
    const changes = [await vectorOf(arrows().nth(0)), await vectorOf(arrows().nth(1))];
    for (const axis of [0, 1] as const) {
      expect(changes[1]![axis]).toBeCloseTo(json.impulse[axis], 3);
      expect(changes[0]![axis]).toBeCloseTo(-json.impulse[axis], 3);
    }
    for (let k = 0; k < 7; ++k) await page.keyboard.press('.');
    const opacity = await page.locator('[data-change="1"]').evaluate((element) => Number(getComputedStyle(element.parentElement!).opacity));
    expect(opacity).toBeCloseTo(0.6, 6);
    const [x1, y1, x2, y2] = await numbers(page.locator('[data-change="1"] .tie'), 'x1', 'y1', 'x2', 'y2');
    const [, , , , vx, vy] = await row(1);
    expect((x2! - x1!) / scale).toBeCloseTo(0.7 * vx!, 3);
    expect((y1! - y2!) / scale).toBeCloseTo(0.7 * vy!, 3);
    for (let k = 0; k < 4; ++k) await page.keyboard.press('.');
    expect(await arrows().count()).toBe(0);
    await page.click('#previous-contact');
    expect(await arrows().count()).toBe(2);
    const { close } = await fromAddress();
    expect(await page.textContent('#clock')).toBe('2.40');
    expect(await arrows().count()).toBe(2);
    await close();
  });
  it('does not fade where motion is unwanted: it stays until the next step', async () => {
    const opened = await open(lab.browser, lab.address, { reducedMotion: true });
    lab.page = page = opened.page;
    await page.check('#show-change');
    await page.click('#next-contact');
    expect(await arrows().count()).toBe(2);
    await page.keyboard.press('.');
    expect(await arrows().count()).toBe(0);
    await opened.context.close();
  });
});

describe('lines that lead to the numbers', () => {
  const words = async (): Promise<string> => (await page.locator('.leaders text').allTextContents()).join('; ');
  it('are there while a disk or a tip is held by the mouse', async () => {
    await take([1.5, 2], [2.33, 3.52]);
    expect(await words()).toBe('x = 2.30; y = 3.50');
    await page.mouse.up();
    expect(await page.locator('.leaders').count()).toBe(0);
    await take([3.3, 3.5], [3.01, 4.18]);
    expect(await words()).toBe('vx = 0.70; vy = 0.70');
    await page.mouse.up();
  });
  it('and while they have the keyboard', async () => {
    await page.focus('[data-disk="1"]');
    await page.keyboard.press('ArrowRight');
    expect(await words()).toBe('x = 1.60; y = 2.00');
    await page.focus('[data-tip="1"]');
    await page.keyboard.press('Shift+ArrowUp');
    expect(await words()).toBe('vx = 1.00; vy = 0.01');
    await page.focus('#play');
    expect(await page.locator('.leaders').count()).toBe(0);
  });
});

describe('disks that left', () => {
  it('return by button', async () => {
    const start = [await row(1), await row(2)];
    expect(await page.locator('#return-disks').count()).toBe(0);
    await page.uncheck('#border');
    const button = page.locator('#return-disks');
    const off = (): Promise<string | null> => button.getAttribute('aria-disabled');
    expect(await off()).toBe('true');
    for (const press of [(): Promise<void> => button.press('Enter'), (): Promise<void> => button.click()]) {
      await page.click('#next-contact');
      for (let k = 0; k < 70; ++k) await page.keyboard.press('.');
      expect(await off()).toBe('false');
      await press();
      expect([await row(1), await row(2)]).toEqual(start);
      expect(await off()).toBe('true');
    }
  });
});

describe('paths', () => {
  /** Where the path of a body begins (x of the scene), and how strongly its pieces are drawn, the latest first. */
  async function path(body: string): Promise<{ from: number; strengths: number[] }> {
    const pieces = await page.locator(`.paths .${body}`).evaluateAll((lines) =>
      lines.map((line) => ({ x: Number(line.getAttribute('points')!.split(/[ ,]/)[0]), strength: Number(getComputedStyle(line).opacity) })),
    );
    return { from: pieces.at(-1)!.x / scale, strengths: pieces.map(({ strength }) => strength) };
  }
  it('fade over three seconds, that of the centre of mass too', async () => {
    await page.focus('#show-paths');
    await page.keyboard.press(' ');
    await page.check('#show-centre');
    await page.click('#next-contact');
    expect((await path('disk-0')).from).toBeCloseTo(1.5, 2);
    for (let k = 0; k < 16; ++k) await page.keyboard.press('.'); // t = 4
    const { from, strengths } = await path('disk-0');
    expect(from).toBeCloseTo(2.5, 2);
    expect(strengths.every((strength, k) => k === 0 || strength < strengths[k - 1]!)).toBe(true);
    expect((await path('of-centre')).from).toBeCloseTo((2.5 + 4.5) / 2, 2);
    await page.check('#show-wholePaths');
    expect((await path('disk-0')).from).toBeCloseTo(1.5, 2);
    expect((await path('disk-0')).strengths.length).toBe(1);
    const { close } = await fromAddress();
    expect(await page.textContent('#clock')).toBe('4.00');
    expect((await path('disk-0')).from).toBeCloseTo(1.5, 2);
    await close();
  });
  it('are straight as seen from the centre of mass, between contacts', async () => {
    await page.check('#show-wholePaths');
    await page.check('#show-centreFrame');
    await page.click('#next-contact');
    const points = (await page.getAttribute('.paths .disk-0', 'points'))!.split(' ').map((point) => point.split(',').map(Number));
    const x = await value(1, 3);
    // Disk 1 came from 1.5 − 3 = −1.5 of the centre of mass, which the frame puts into the middle of the picture.
    expect(points[0]![0]! / scale).toBeCloseTo(4 - 1.5, 2);
    expect(points.at(-1)![0]! / scale).toBeCloseTo(4 + x - (1.5 + 4.5 + 2.4) / 2, 2);
  });
});

describe('the scale', () => {
  it('is as long as it says, and can be hidden', async () => {
    expect(await page.textContent('.scale text')).toBe('1 unit of length');
    expect(await page.getAttribute('.scale path', 'd')).toContain(`h${scale}`);
    await page.focus('#show-scale');
    await page.keyboard.press(' ');
    expect(await page.locator('.scale').count()).toBe(0);
    await page.selectOption('#language', 'de');
    await page.click('#show-scale');
    expect(await page.textContent('.scale text')).toBe('1 Längeneinheit');
  });
});
