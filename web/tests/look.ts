// Pictures of the page at three widths, to be looked at: out/lab/*.png.
import { mkdirSync } from 'node:fs';
import { launch, open, serve } from './browser';
import { root } from './engine';

const folder = `${root}out/lab`;
mkdirSync(folder, { recursive: true });
const { server, address } = await serve();
const browser = await launch();
const only = process.argv[2];
for (const [width, height, dark] of [[360, 740, false], [1280, 860, false], [1280, 860, true], [1920, 1080, true]] as const) {
  if (only && only !== String(width)) continue;
  const { page, troubles } = await open(browser, address, { width, height, dark });
  const shot = (name: string): Promise<Buffer> => page.screenshot({ path: `${folder}/${name}-${width}${dark ? '-dark' : ''}.png`, fullPage: true });
  await shot('start');
  await page.click('#next-contact');
  await page.check('#show-parts');
  await page.check('#show-impulse');
  await shot('contact');
  await page.uncheck('#show-parts');
  await page.uncheck('#show-impulse');
  await page.click('#panel-derivation');
  await page.click('#step-next');
  await page.click('#step-next');
  await page.waitForTimeout(300);
  await shot('derivation');
  await page.click('#tab-gas');
  await page.waitForTimeout(300);
  await page.click('#gas-play');
  await page.waitForTimeout(2500);
  await shot('gas');
  await page.selectOption('#gas-boundary', 'half');
  await page.check('#gas-tag');
  await page.click('#gas-play');
  await page.waitForTimeout(1000);
  await shot('half');
  await page.click('#gas-remove-wall');
  await page.waitForTimeout(3000);
  await shot('expanded');
  console.log(width, troubles);
}
await browser.close();
server.close();
