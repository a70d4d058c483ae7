// Every view of the page, to be checked and looked at.
import type { Page } from 'playwright-core';
import { layers } from '../src/lab/view';

/** Goes to one view after the other, and tells its name. */
export async function* views(page: Page): AsyncGenerator<string> {
  yield 'two disks';
  await page.click('#open-keys');
  yield 'keys';
  await page.keyboard.press('Escape');
  await page.click('#open-share');
  yield 'sharing of two disks';
  await page.keyboard.press('Escape');
  const presets = await page.locator('#presets input').evaluateAll((inputs) => inputs.map((input) => input.id));
  for (const preset of presets) {
    await page.check(`#${preset}`, { force: true });
    await page.locator('body').press('n');
    yield preset;
  }
  for (const layer of layers) await page.setChecked(`#show-${layer}`, true);
  await page.click('.residuals summary');
  yield 'all that can be shown';
  await page.uncheck('#border');
  await page.click('#add-disk', { force: true });
  yield 'without a border';
  await page.locator('.table-section input').first().fill('-1');
  await page.keyboard.press('Enter');
  yield 'a number that cannot be';
  await page.keyboard.press('Escape');
  await page.check(`#${presets[0]}`, { force: true });
  await page.locator('body').press('n');
  await page.click('#panel-derivation');
  const steps = Number((await page.textContent('#step-number'))!.match(/\d+/g)!.at(-1));
  for (let step = 1; step < steps; ++step) {
    yield `step ${step} of the derivation`;
    await page.click('#step-next');
  }
  await page.check('#all-steps');
  await page.click('.errata summary');
  yield 'the whole derivation';
  await page.click('#tab-gas');
  await page.fill('#gas-number', '200');
  await page.keyboard.press('Enter');
  await page.click('#gas-mixture');
  await page.check('#gas-tag');
  await page.check('#gas-record');
  for (const boundary of ['periodic', 'reflecting', 'half', 'piston']) {
    await page.selectOption('#gas-boundary', boundary);
    await page.click('#gas-play');
    await page.waitForFunction(() => /[1-9]/.test(document.querySelector('#gas-collisions')?.textContent ?? ''));
    await page.click('#gas-play');
    yield `gas, ${boundary}`;
    if (boundary === 'half' || boundary === 'piston') {
      await page.click('#gas-remove-wall');
      await page.waitForSelector('#gas-remove-wall[aria-disabled="true"]');
      yield `gas, ${boundary}, let go`;
    }
  }
  for (const colour of ['kind', 'order', 'none']) {
    await page.selectOption('#gas-colour', colour);
    yield `gas, coloured by ${colour}`;
  }
  await page.click('#open-share');
  yield 'sharing of a gas';
}
