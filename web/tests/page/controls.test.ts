// Property: every control of the tab "Two disks" works by mouse and by keyboard, and its numbers are those of the program.
import type { Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { layers } from '../../src/lab/view';
import { carom } from '../engine';
import { handsOn } from './hands';
import { openedLab } from './lab';

const lab = openedLab();
let page: Page;
beforeEach(() => {
  page = lab.page;
});

const { cell, value, clock, row, collided, drag } = handsOn(lab);

describe('disks and arrows', () => {
  it('are dragged, snap to the grid, and do not overlap', async () => {
    await drag([1.5, 2], [2.33, 3.52]);
    expect(await row(1)).toEqual([1, 0.5, 2.3, 3.5, 1, 0]);
    await drag([2.3, 3.5], [1.1, 1.1], true);
    const [, , x, y] = await row(1);
    expect(Math.abs(x! - 1.1) + Math.abs(y! - 1.1)).toBeLessThan(0.05);
    await drag([x!, y!], [4.45, 2.75]);
    const [, , x2, y2] = await row(1);
    expect(Math.hypot(x2! - 4.5, y2! - 2.8)).toBeGreaterThanOrEqual(1 - 1e-9);
    await drag([x2!, y2!], [-3, 9]);
    expect((await row(1)).slice(2, 4)).toEqual([0.5, 4.5]);
  });
  it('velocities are dragged by their tips', async () => {
    await drag([2.5, 2], [3.21, 2.69]);
    expect((await row(1)).slice(4)).toEqual([1.7, 0.7]);
  });
  it('are moved by keys, with Shift in fine steps', async () => {
    await page.focus('[data-disk="1"]');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('w');
    await page.keyboard.press('Shift+ArrowLeft');
    expect((await row(1)).slice(2, 4)).toEqual([1.59, 2.1]);
    await page.focus('[data-tip="1"]');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Shift+ArrowRight');
    expect((await row(1)).slice(4)).toEqual([1.01, 0.1]);
    expect(await page.textContent('#preset-name')).toBe('Own set-up');
  });
  it('come and go, from 1 to 5', async () => {
    for (let k = 0; k < 5; ++k) await page.click('#add-disk', { force: true });
    expect(await page.locator('tbody tr').count()).toBeGreaterThanOrEqual(5);
    expect(await page.locator('.disk').count()).toBe(5);
    for (let k = 0; k < 6; ++k) await page.click('#remove-disk', { force: true });
    expect(await page.locator('.disk').count()).toBe(1);
    expect(await page.textContent('.residuals, .note')).toBeTruthy();
  });
});

describe('the table', () => {
  it('takes numbers with point or comma, steps, and refuses what cannot be', async () => {
    await cell(1, 5).fill('1,25');
    await page.keyboard.press('Tab');
    await expect.poll(() => value(1, 5)).toBe(1.25);
    await cell(1, 1).focus();
    await page.keyboard.press('ArrowUp');
    await expect.poll(() => value(1, 1)).toBe(1.1);
    await page.keyboard.press('Shift+ArrowDown');
    await expect.poll(() => value(1, 1)).toBe(1.09);
    await cell(2, 1).fill('-3');
    await page.keyboard.press('Enter');
    expect(await cell(2, 1).getAttribute('aria-invalid')).toBe('true');
    expect(await page.textContent('#said')).toContain('Mass of disk 2');
    await page.keyboard.press('Tab');
    await expect.poll(() => value(2, 1)).toBe(1);
    await cell(2, 2).fill('nonsense');
    await page.keyboard.press('Tab');
    await expect.poll(() => value(2, 2)).toBe(0.5);
  });
  it('takes mass, radius, place and velocity of every disk, and they collide as the program says', async () => {
    const typed = [[1.5, 0.4, 1.25, 1.75, 0.85, 0.1], [2.5, 0.6, 4.75, 2.25, -0.35, -0.05]];
    for (const [disk, numbers] of typed.entries()) {
      for (const [what, number] of numbers.entries()) {
        await cell(disk + 1, what + 1).fill(`${number}`);
        await page.keyboard.press('Enter');
        await expect.poll(() => value(disk + 1, what + 1)).toBe(number);
      }
    }
    const json = collided(typed[0]!, typed[1]!);
    await page.click('#next-contact');
    expect(await clock()).toBeCloseTo(json.time_of_contact, 2);
    const [one, two] = [await row(1), await row(2)];
    const shownNow = [...one.slice(2), ...two.slice(2)];
    [...json.position1, ...json.velocity1_after, ...json.position2, ...json.velocity2_after].forEach((number: number, k: number) =>
      expect(shownNow[k]).toBeCloseTo(number, 3),
    );
  });
  it('pushes a disk that grows off the wall', async () => {
    await cell(1, 2).fill('1.8');
    await page.keyboard.press('Enter');
    await expect.poll(() => value(1, 3)).toBeGreaterThanOrEqual(1.8 - 1e-9);
    const [, R, x, y] = await row(1);
    expect(R).toBe(1.8);
    expect(x! - R!).toBeGreaterThanOrEqual(-1e-9);
    expect(y! - R!).toBeGreaterThanOrEqual(-1e-9);
    expect(Math.hypot(x! - 4.5, y! - 2.8)).toBeGreaterThanOrEqual(2.3 - 1e-9);
  });
});

describe('time', () => {
  it('goes by buttons and by keys, contact by contact, and back to the same numbers', async () => {
    const start = [await row(1), await row(2)];
    const json = collided(start[0]!, start[1]!);
    await page.click('#next-contact');
    expect(await clock()).toBeCloseTo(json.time_of_contact, 2);
    const shownNow = [...(await row(1)).slice(4), ...(await row(2)).slice(4)];
    [...json.velocity1_after, ...json.velocity2_after].forEach((v: number, k: number) => expect(shownNow[k]).toBeCloseTo(v, 6));
    expect(await page.textContent('#said')).toContain('Disks 1 and 2 collided');
    await page.keyboard.press('n');
    await page.keyboard.press('n');
    expect(await page.textContent('.contacts')).toContain('3');
    await page.keyboard.press('b');
    await page.keyboard.press('b');
    expect([...(await row(1)).slice(4), ...(await row(2)).slice(4)]).toEqual(shownNow);
    await page.click('#previous-contact');
    expect([await row(1), await row(2)]).toEqual(start);
  });
  it('steps and restarts', async () => {
    await page.click('#step-forward');
    await page.click('#step-forward');
    expect(await clock()).toBeCloseTo(0.2, 6);
    await expect.poll(() => value(1, 3)).toBeCloseTo(1.7, 6);
    await page.click('#step-back');
    expect(await clock()).toBeCloseTo(0.1, 6);
    await page.locator('body').press('.');
    expect(await clock()).toBeCloseTo(0.2, 6);
    await page.keyboard.press(',');
    await page.keyboard.press('r');
    expect(await clock()).toBe(0);
    await page.click('#step-forward');
    await page.click('#restart');
    expect(await clock()).toBe(0);
  });
  it('plays, pauses, stops at the collision, and goes slower', async () => {
    await page.locator('body').press(' ');
    await expect.poll(clock, { timeout: 20000 }).toBeGreaterThan(0.2);
    await page.keyboard.press(' ');
    const held = await clock();
    await page.waitForTimeout(200);
    expect(await clock()).toBe(held);
    await page.click('#play');
    await expect.poll(() => page.textContent('.contacts'), { timeout: 40000 }).toContain('1 contact');
    expect(await clock()).toBeCloseTo(2.4, 6);
    expect(await page.getAttribute('#play', 'aria-label')).toBe('Play');
    await page.check('#slow');
    await page.uncheck('#pause-at-contact');
    await page.keyboard.press('l');
    expect(await page.isChecked('#slow')).toBe(false);
  });
});

describe('slow motion', () => {
  it('shows a fifth as much in the same time', async () => {
    const opened = await lab.browser.newPage();
    await opened.clock.install();
    await opened.goto(lab.address);
    await opened.waitForSelector('html[data-ready]');
    const passed = async (): Promise<number> => {
      await opened.click('#restart');
      await opened.click('#play');
      await opened.clock.runFor(1000);
      await opened.click('#play');
      return Number(await opened.textContent('#clock'));
    };
    const usual = await passed();
    await opened.focus('#slow');
    await opened.keyboard.press(' ');
    const slow = await passed();
    expect(usual).toBeGreaterThan(0.5);
    expect(slow / usual).toBeCloseTo(0.2, 1);
    await opened.close();
  });
});

describe('what is shown', () => {
  it('is chosen by mouse and by keyboard', async () => {
    await page.click('#next-contact');
    for (const layer of layers) {
      const before = await page.isChecked(`#show-${layer}`);
      const picture = await page.innerHTML('#play-area');
      await page.click(`#show-${layer}`);
      expect(await page.isChecked(`#show-${layer}`)).toBe(!before);
      expect(await page.innerHTML('#play-area'), layer).not.toBe(picture);
      await page.focus(`#show-${layer}`);
      await page.keyboard.press(' ');
      expect(await page.isChecked(`#show-${layer}`)).toBe(before);
    }
  });
  it('restitution and border', async () => {
    await page.focus('#restitution');
    await page.keyboard.press('Home');
    expect(await page.inputValue('#restitution-number')).toBe('0');
    await page.fill('#restitution-number', '0.5');
    await page.keyboard.press('Enter');
    const json = collided(await row(1), await row(2), 0.5);
    await page.click('#next-contact');
    await expect.poll(() => value(1, 5)).toBeCloseTo(json.velocity1_after[0], 5);
    await page.click('.residuals summary');
    const energies = await page.locator('[data-residual="K"] td').allTextContents();
    expect(energies.slice(0, 2).map(Number)).toEqual([json.energy_before, json.energy_after]);
    await page.uncheck('#border');
    expect(await page.locator('.wall').count()).toBe(0);
    await page.click('#next-contact');
    expect(await page.textContent('#said')).toContain('No further contact');
    await page.check('#border');
    expect(await page.locator('.wall').count()).toBe(2);
  });
  it('every preset plays to its first contact', async () => {
    const names = await page.locator('#presets input').evaluateAll((inputs) => inputs.map((input) => input.id));
    expect(names.length).toBeGreaterThanOrEqual(10);
    for (const name of names) {
      await page.check(`#${name}`, { force: true });
      await page.locator('body').press('n');
      expect(await page.textContent('.contacts'), name).not.toMatch(/^0 /);
      await page.keyboard.press('r');
    }
  });
  it('presets are chosen by keyboard, and their pictures show them', async () => {
    await page.focus('#preset-oblique');
    await page.keyboard.press('ArrowRight');
    expect(await page.isChecked('#preset-headOn')).toBe(true);
    expect(await page.textContent('#preset-name')).toBe('Head-on');
    expect((await row(2)).slice(4)).toEqual([-0.5, 0]);
    const picture = page.locator('label:has(#preset-headOn) svg');
    expect(await picture.locator('circle').count()).toBe(2);
    expect(await picture.locator('line').count()).toBe(2);
  });
});

describe('the derivation', () => {
  it('steps through the program’s own text, beside its vectors', async () => {
    const disks = [await row(1), await row(2)];
    await page.click('#panel-derivation');
    const words = ([m, R, x, y, vx, vy]: number[]): string => [x, y, vx, vy, m, R].join(',');
    const asked = ['collide', '--disk', words(disks[0]!), '--disk', words(disks[1]!), '--advance', '--explain'];
    const printed = carom([...asked, '--format', 'markdown']);
    const headings = [...printed.matchAll(/^## (.*)$/gm)].map((match) => match[1]!);
    for (const [k, heading] of headings.entries()) {
      expect(await page.textContent('.sheet h2')).toBe(heading);
      expect(await page.textContent('#step-number')).toBe(`Step ${k + 1} of ${headings.length}`);
      expect(await page.locator('#play-area .arrow').count()).toBeGreaterThan(0);
      expect(await page.locator('.katex-error').count()).toBe(0);
      await page.focus('#step-next');
      await page.keyboard.press('Enter');
    }
    await page.click('#step-previous');
    await page.check('#all-steps');
    expect(await page.locator('.sheet h2').count()).toBe(headings.length);
    expect(await page.locator('.katex-error').count()).toBe(0);
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.click('#copy-markdown');
    await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe(printed);
    await page.click('#copy-latex');
    await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toBe(carom([...asked, '--format', 'latex']));
    await page.click('.errata summary');
    expect(await page.locator('.errata li').count()).toBe(7);
  });
});
