// Property: the engine has the native program's bits in Chromium too, and `carom lab` serves the page and nothing else.
import { ChildProcess, spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { request } from 'node:http';
import { transformWithEsbuild } from 'vite';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { launch, open, pageFolder } from '../browser';
import { carom, program, root, wasmFile } from '../engine';
import { comparedScenes } from '../scenes';

let browser: Browser;
let lab: ChildProcess;
let address: string;

beforeAll(async () => {
  browser = await launch();
  lab = spawn(program, ['lab', '--no-open', '--port', '0', '--page', pageFolder], { stdio: ['ignore', 'pipe', 'inherit'] });
  address = await new Promise<string>((resolve, reject) => {
    lab.stdout!.once('data', (data: Buffer) => resolve(data.toString().split('\n')[0]!));
    lab.once('exit', (code) => reject(new Error(`carom lab ended with code ${code}`)));
  });
});
afterAll(async () => {
  await browser.close();
  lab.kill('SIGKILL');
});

describe('Chromium', () => {
  it('ends every scene with the digest of the native program', async () => {
    const source = await transformWithEsbuild(readFileSync(`${root}web/src/engine/module.ts`, 'utf8'), 'module.ts', { format: 'esm' });
    const page = await browser.newPage();
    await page.addScriptTag({ content: `${source.code.replace(/export /g, '').replace(/^\{.*\};?$/m, '')}\nwindow.Engine = Engine;` });
    const scenes = comparedScenes();
    const digests = (await page.evaluate(
      async ([wasm, given]) => {
        const bytes = Uint8Array.from(atob(wasm), (letter) => letter.charCodeAt(0));
        // eslint-disable-next-line @typescript-eslint/no-explicit-any
        const engine = await (window as any).Engine.start(await WebAssembly.compile(bytes));
        return given.map((scene) => {
          engine.setInput(scene.text);
          engine.tryCall('gas_open', -1);
          if (scene.until !== undefined) engine.tryCall('gas_run_until', 0, scene.until);
          if (scene.collisions !== undefined) engine.tryCall('gas_run_collisions', 0, scene.collisions);
          engine.tryCall('gas_digest', 0);
          return engine.text() as string;
        });
      },
      [readFileSync(wasmFile).toString('base64'), scenes] as const,
    )) as string[];
    const native = scenes.map((scene) => {
      const end = scene.until !== undefined ? ['--until', `${scene.until}`] : ['--collisions', `${scene.collisions}`];
      return JSON.parse(carom(['run', '-', ...end, '--json', '--quiet'], scene.text)).digest as string;
    });
    expect(digests).toEqual(native);
  });
});

/** Status and policy of what is served under a path that is sent as it stands. */
function ask(path: string, host?: string): Promise<{ status: number; policy: string }> {
  const { port } = new URL(address);
  return new Promise((resolve, reject) => {
    const sent = request({ host: '127.0.0.1', port, path, headers: host ? { host } : {} }, (response) => {
      response.resume();
      resolve({ status: response.statusCode!, policy: String(response.headers['content-security-policy']) });
    });
    sent.on('error', reject).end();
  });
}

describe('the page in one file', () => {
  it('works from a disk, with its gas, and asks for nothing', async () => {
    const { page, troubles, context } = await open(browser, `file://${root}web/dist/single/carom-lab.html`);
    await page.click('#next-contact');
    expect(await page.textContent('#said')).toContain('Disks 1 and 2 collided');
    await page.click('#panel-derivation');
    await page.waitForSelector('.katex');
    await page.click('#tab-gas');
    await page.click('#gas-play');
    await page.waitForFunction(() => /[1-9]/.test(document.querySelector('#gas-collisions')?.textContent ?? ''));
    const policy = (await page.getAttribute('meta[http-equiv]', 'content'))!;
    expect(policy).toContain("default-src 'none'");
    expect(policy).not.toContain('unsafe-inline');
    expect(troubles).toEqual([]);
    await context.close();
  });
});

describe('carom lab', () => {
  it('serves the page, under its strict policy', async () => {
    const { page, troubles, context } = await open(browser, address);
    await page.click('#panel-derivation');
    await page.waitForSelector('.katex');
    await page.click('#tab-gas');
    await page.click('#gas-play');
    await page.waitForSelector('#gas-collisions');
    expect(troubles).toEqual([]);
    await context.close();
    expect((await ask('/')).policy).toContain("default-src 'none'");
  });
  it('serves nothing else, and nobody else', async () => {
    for (const path of ['/../../package.json', '/..%2f..%2fpackage.json', '/%2e%2e/%2e%2e/package.json', '//etc/passwd', '/assets/', '/nothing']) {
      expect((await ask(path)).status, path).toBe(404);
    }
    expect((await ask('/', 'example.org')).status).toBe(403);
  });
  it('ends cleanly on Ctrl-C', async () => {
    const ended = new Promise((resolve) => lab.once('exit', (code) => resolve(code)));
    lab.kill('SIGINT');
    expect(await ended).toBe(0);
  });
});
