// Property: axe-core finds nothing, at any width, theme and language; the page loads little and asks nobody else.
import { gzipSync } from 'node:zlib';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { open } from '../browser';
import { views } from '../views';
import { servedLab } from './lab';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const lab = servedLab();

interface Violation {
  id: string;
  nodes: { html: string; failureSummary: string }[];
}

/** The page's policy forbids strange scripts; the browser's debugger may run them all the same. */
async function violations(page: Page): Promise<string[]> {
  await page.evaluate(axe);
  const found = (await page.evaluate('axe.run(document, { resultTypes: ["violations"] })')) as { violations: Violation[] };
  return found.violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => `${node.html} ${node.failureSummary}`).join(' | ')}`);
}

describe('access', () => {
  for (const [width, dark, locale] of [
    [360, false, 'de-DE'],
    [360, true, 'en-GB'],
    [1280, true, 'de-DE'],
    [1920, false, 'en-GB'],
  ] as const) {
    it(`every view, ${width} wide, ${dark ? 'dark' : 'light'}, ${locale}`, async () => {
      const { page, troubles, context } = await open(lab.browser, lab.address, { width, dark, locale });
      expect(await page.getAttribute('html', 'lang')).toBe(locale.slice(0, 2));
      const found: Record<string, string[]> = {};
      let seen = 0;
      for await (const view of views(page)) {
        ++seen;
        const wrong = await violations(page);
        if ((await page.evaluate(() => document.documentElement.scrollWidth)) > width) wrong.push('wider than the screen');
        if (wrong.length > 0) found[view] = wrong;
      }
      expect(found).toEqual({});
      expect(seen).toBeGreaterThan(30);
      expect(troubles).toEqual([]);
      await context.close();
    });
  }

  it('the decimal mark is the language’s', async () => {
    const { page, context } = await open(lab.browser, lab.address, { locale: 'de-DE' });
    expect(await page.textContent('#clock')).toBe('0,00');
    await page.selectOption('#language', 'en');
    expect(await page.textContent('#clock')).toBe('0.00');
    await context.close();
  });

  it('all is reached by Tab, with a visible focus', async () => {
    const { page, context } = await open(lab.browser, lab.address);
    const reached = new Set<string>();
    for (let k = 0; k < 80; ++k) {
      await page.keyboard.press('Tab');
      const { name, visible } = await page.evaluate(() => {
        const at = document.activeElement!;
        const ring = at.querySelector('.focus-ring');
        const style = getComputedStyle(ring ?? at);
        return { name: at.id || at.getAttribute('data-disk') || at.getAttribute('data-tip') || at.tagName, visible: ring ? style.stroke !== 'none' : style.outlineStyle !== 'none' };
      });
      if (name === 'BODY') break; // past the last one
      expect(visible, name).toBe(true);
      reached.add(name);
    }
    for (const id of ['tab-gas', 'open-share', 'theme', 'language', 'restart', 'play', 'next-contact', 'slow', 'add-disk', 'panel-derivation', 'preset-oblique', 'show-parts', 'restitution', 'border']) {
      expect([...reached]).toContain(id);
    }
    await context.close();
  });
});

describe('loading', () => {
  it('takes less than 700 kB compressed, the derivation with its fonts included', async () => {
    const context = await lab.browser.newContext();
    const page = await context.newPage();
    const sizes = new Map<string, number>();
    page.on('response', (response) => {
      void response.body().then((body) => sizes.set(response.url(), response.url().endsWith('woff2') ? body.length : gzipSync(body, { level: 9 }).length)).catch(() => undefined);
    });
    const start = Date.now();
    await page.goto(lab.address);
    await page.waitForSelector('html[data-ready]');
    console.log(`interactive after ${Date.now() - start} ms`);
    await page.click('#panel-derivation');
    await page.waitForSelector('.katex');
    await page.waitForTimeout(500);
    const total = [...sizes.values()].reduce((sum, size) => sum + size, 0);
    console.log(`loaded ${Math.round(total / 1000)} kB compressed in ${sizes.size} files`);
    expect(sizes.size).toBeGreaterThan(3);
    expect(total).toBeLessThan(700_000);
    await context.close();
  });
});
