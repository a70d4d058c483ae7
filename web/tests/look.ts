// Pictures of every view of the page, at three widths and in both themes, to be looked at: out/lab/WIDTH-THEME/*.png.
import { mkdirSync } from 'node:fs';
import { launch, open, serve } from './browser';
import { root } from './engine';
import { views } from './views';

const { server, address } = await serve();
const browser = await launch();
const only = process.argv[2];
for (const [width, height] of [[360, 740], [1280, 860], [1920, 1080]] as const) {
  if (only && only !== String(width)) continue;
  for (const dark of [false, true]) {
    const folder = `${root}out/lab/${width}-${dark ? 'dark' : 'light'}`;
    mkdirSync(folder, { recursive: true });
    const { page, troubles, context } = await open(browser, address, { width, height, dark, locale: dark ? 'de-DE' : 'en-GB' });
    let number = 0;
    for await (const view of views(page)) {
      await page.waitForTimeout(300);
      await page.screenshot({ path: `${folder}/${String(++number).padStart(2, '0')} ${view}.png`, fullPage: true, timeout: 120000 });
    }
    console.log(folder, troubles);
    await context.close();
  }
}
await browser.close();
server.close();
