// Frame times of the gas in Chromium, without a graphics card; printed, not asserted. Wants a machine that is idle.
import { launch, open, serve } from './browser';

const { server, address } = await serve();
const browser = await launch();
for (const number of [2000, 5000, 20000]) {
  const { page, context } = await open(browser, `${address}#gas&number=${number}&packing=0.3&seed=1`, { width: 1280, height: 900 });
  await page.waitForSelector('#gas-time');
  await page.click('#gas-play');
  await page.waitForTimeout(2000);
  const intervals = await page.evaluate(
    () =>
      new Promise<number[]>((resolve) => {
        const times: number[] = [];
        const tick = (now: number): void => {
          times.push(now);
          if (times.length < 240) requestAnimationFrame(tick);
          else resolve(times.slice(1).map((time, k) => time - times[k]!));
        };
        requestAnimationFrame(tick);
      }),
  );
  const pictures: number[] = [];
  for (let k = 0; k < 12; ++k) {
    pictures.push(parseFloat((await page.textContent('#gas-frame'))!));
    await page.waitForTimeout(500);
  }
  intervals.sort((a, b) => a - b);
  const at = (share: number): string => intervals[Math.floor(share * (intervals.length - 1))]!.toFixed(1);
  console.log(`${number} disks: frames ${at(0.5)} ms (median), ${at(0.95)} ms (95 %); engine and drawing ${Math.min(...pictures)} ms a picture at best`);
  await context.close();
}
await browser.close();
server.close();
