// Property: every control that the page has does something, by mouse and by keyboard.
import type { Locator, Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { open } from '../browser';
import { servedLab } from './lab';

const lab = servedLab();

const controls = 'button, input:not([hidden]), select, summary, a[href], [tabindex="0"]';

/** Names of all controls that are to be seen now and that would do something. */
function names(page: Page): Promise<string[]> {
  return page.evaluate((controls) => {
    const shown = [...document.querySelectorAll<HTMLElement>(controls)].filter((one) => one.checkVisibility() && !one.matches('[aria-disabled="true"], [aria-pressed="true"], [aria-current]'));
    const dialog = document.querySelector('dialog[open]');
    return shown
      .filter((one) => !dialog || dialog.contains(one))
      .map((one, k) => {
        one.dataset.control ??= one.id || `${one.tagName}-${one.getAttribute('aria-label') ?? k}`;
        return one.dataset.control;
      });
  }, controls);
}

/** All that can be seen or heard of the page, and what left it. */
class Witness {
  private left = 0;
  constructor(
    private readonly page: Page,
    /** Whether it is something that the focus goes elsewhere. */
    private readonly focus: boolean,
  ) {
    for (const event of ['download', 'filechooser'] as const) page.on(event as 'download', () => void ++this.left);
  }
  async state(): Promise<string> {
    const page = await this.page.evaluate((focus) => {
      const values = [...document.querySelectorAll('input, select')].map((one) => `${(one as HTMLInputElement).value} ${(one as HTMLInputElement).checked}`);
      const at = document.activeElement as HTMLElement | null;
      const place = [...document.querySelectorAll('.scroller')].map((one) => one.scrollLeft);
      return JSON.stringify([document.documentElement.dataset.theme, document.body.innerHTML, values, focus ? at?.dataset.control : '', place]);
    }, this.focus);
    return page + this.left;
  }
  /** Does it, and says whether that made a difference. */
  async sees(work: () => Promise<void>): Promise<boolean> {
    const before = await this.state();
    await work();
    for (let k = 0; k < 40; ++k) {
      if ((await this.state()) !== before) return true;
      await this.page.waitForTimeout(50);
    }
    return false;
  }
}

interface Kind {
  tag: string;
  type: string;
  scrolls: boolean;
  drags: boolean;
}

const kindOf = (control: Locator): Promise<Kind> =>
  control.evaluate((one) => ({
    tag: one.tagName,
    type: (one as HTMLInputElement).type ?? '',
    scrolls: one.classList.contains('scroller') && one.scrollWidth <= one.clientWidth,
    drags: one.hasAttribute('data-disk') || one.hasAttribute('data-tip'),
  }));

/** Keys that work a control; what one does the other may undo, or it may stand at an end. */
function keysFor({ tag, type, drags }: Kind): string[] {
  if (drags || type === 'range' || type === 'radio') return ['ArrowLeft', 'ArrowRight'];
  if (tag === 'SELECT' || type === 'text' || type === 'number') return ['ArrowDown', 'ArrowUp'];
  if (type === 'checkbox') return [' '];
  return tag === 'DIV' ? ['ArrowRight', 'ArrowLeft'] : ['Enter'];
}

async function byMouse(control: Locator, kind: Kind): Promise<void> {
  const page = control.page();
  await control.scrollIntoViewIfNeeded();
  const box = (await control.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  if (kind.drags) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 40, y - 40, { steps: 3 });
    await page.mouse.up();
  } else if (kind.type === 'range') {
    const share = await control.evaluate((one) => {
      const { valueAsNumber, min, max } = one as HTMLInputElement;
      return (valueAsNumber - Number(min)) / (Number(max) - Number(min));
    });
    await page.mouse.click(box.x + box.width * (share > 0.5 ? 0.3 : 0.7), y);
  } else if (kind.tag === 'SELECT') {
    // The list that a click opens is the system's own, which nothing here can point at.
    await control.selectOption({ index: (await control.evaluate((one) => (one as HTMLSelectElement).selectedIndex)) === 0 ? 1 : 0 });
  } else {
    await page.mouse.click(x, y);
  }
}

/** Works every control of a view that opens at an address, each on a fresh page, so that none is in another's way. */
async function everyControl(hash: string, prepare: (page: Page) => Promise<void>, except: RegExp): Promise<string[]> {
  const idle: string[] = [];
  const opened = await open(lab.browser, lab.address + hash);
  await opened.context.grantPermissions(['clipboard-read', 'clipboard-write']);
  await prepare(opened.page);
  const found = await names(opened.page);
  expect(found.length).toBeGreaterThan(2);
  for (const name of found.filter((one) => !except.test(one))) {
    for (const way of ['keyboard', 'mouse']) {
      // What changes all of the page, or leaves it, is undone by a fresh one.
      await opened.page.goto('about:blank');
      await opened.page.goto(lab.address + hash);
      await opened.page.waitForSelector('html[data-ready]');
      await prepare(opened.page);
      await names(opened.page);
      const control = opened.page.locator(`[data-control="${name}"]`);
      const kind = await kindOf(control);
      if (kind.scrolls) continue;
      const witness = new Witness(opened.page, kind.type === 'text' || kind.tag === 'DIV' || kind.tag === 'A');
      let works = false;
      if (way === 'mouse') {
        works = await witness.sees(() => byMouse(control, kind));
      } else {
        await control.focus();
        expect(await opened.page.evaluate(() => (document.activeElement as HTMLElement).dataset.control)).toBe(name);
        for (const key of keysFor(kind)) works ||= await witness.sees(() => opened.page.keyboard.press(key));
      }
      if (!works) idle.push(`${name} by ${way}`);
    }
  }
  expect(opened.troubles).toEqual([]);
  await opened.context.close();
  return idle;
}

// Of many alike, some: cells of the second disk are worked as those of the first.
const alike = /of disk 2|^preset-(?!headOn)/;

describe('every control', () => {
  it('of two disks', async () => {
    expect(await everyControl('', (page) => page.click('#next-contact'), alike)).toEqual([]);
  });
  it('of the derivation', async () => {
    const prepare = async (page: Page): Promise<void> => {
      await page.click('#next-contact');
      await page.click('#panel-derivation');
      await page.click('#step-next');
    };
    expect(await everyControl('', prepare, /^(?!panel|step|all-steps|copy|SUMMARY)/)).toEqual([]);
  });
  it('of the gas', async () => {
    const prepare = async (page: Page): Promise<void> => {
      await page.click('#gas-mixture');
      await page.waitForSelector('#gas-time');
      await page.waitForTimeout(700); // until nothing is drawn any more, and the frame times rest
    };
    expect(await everyControl('#gas&number=50&boundary=piston&seed=1', prepare, /^$/)).toEqual([]);
  });
  for (const [tab, hash] of [['two disks', ''], ['the gas', '#gas&number=50&record=1&seed=1']] as const) {
    it(`of the menu of ${tab}`, async () => {
      const prepare = async (page: Page): Promise<void> => {
        if (hash) await page.waitForSelector('#gas-recorded');
        await page.click('#open-share');
        await page.waitForSelector('#dialog-share[open]');
      };
      expect(await everyControl(hash, prepare, /^$/)).toEqual([]);
    });
  }
});
