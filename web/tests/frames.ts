// Frame times of the gas in Chromium, without a graphics card, with WebGL and without; printed, not asserted.
// Wants a machine that is idle.
import type { Browser, Page } from 'playwright-core';
import { launch, open, serve } from './browser';

const frames = 120;

/** Milliseconds between pictures, in ascending order. */
function intervals(page: Page): Promise<number[]> {
  return page.evaluate(
    (frames) =>
      new Promise<number[]>((resolve) => {
        const times: number[] = [];
        const tick = (now: number): void => {
          times.push(now);
          if (times.length <= frames) requestAnimationFrame(tick);
          else resolve(times.slice(1).map((time, k) => time - times[k]!).sort((a, b) => a - b));
        };
        requestAnimationFrame(tick);
      }),
    frames,
  );
}

interface Times {
  frames: number[];
  /** Processor time of the page's thread per frame, all that it does included (ms). */
  page: number;
  /** Of the worker and of drawing, per picture, as the page itself shows them (ms). */
  worker: number;
  draw: number;
}

async function timed(page: Page): Promise<Times> {
  await page.waitForSelector('#gas-time');
  await page.click('#gas-play');
  await page.waitForTimeout(2500);
  const metrics = await page.context().newCDPSession(page);
  await metrics.send('Performance.enable');
  const busy = async (): Promise<number> => (await metrics.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'ThreadTime')!.value;
  const before = await busy();
  const found = await intervals(page);
  const spent = (1000 * ((await busy()) - before)) / frames;
  const [worker, draw] = (await page.textContent('#gas-frame'))!.split('+').map(parseFloat);
  return { frames: found, page: spent, worker: worker!, draw: draw! };
}

async function measure(browser: Browser, address: string, number: number, webgl: boolean): Promise<void> {
  const { page, context } = await open(browser, `${address}#gas&number=${number}&packing=0.3&seed=1`, { width: 1280, height: 900, webgl });
  const times = await timed(page);
  const at = (share: number): string => times.frames[Math.floor(share * (times.frames.length - 1))]!.toFixed(1);
  console.log(
    `${String(number).padStart(5)} disks, ${webgl ? 'WebGL' : 'plain'}: frames ${at(0.5)} ms (median), ${at(0.95)} ms (95 %); ` +
      `page ${times.page.toFixed(1)} ms a frame, of it drawing ${times.draw}; worker ${times.worker} ms a picture`,
  );
  await context.close();
}

const { server, address } = await serve();
const browser = await launch();
for (const number of [1000, 5000, 20000]) {
  for (const webgl of [true, false]) await measure(browser, address, number, webgl);
}
await browser.close();
server.close();
