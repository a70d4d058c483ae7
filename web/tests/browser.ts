// Chromium with the built page, and what went wrong in it.
import { createServer, Server } from 'node:http';
import { existsSync, readFileSync } from 'node:fs';
import { extname, join, normalize } from 'node:path';
import { Browser, Page, chromium } from 'playwright-core';
import { root } from './engine';

const types: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.woff2': 'font/woff2',
};

export const pageFolder = `${root}web/dist/page`;

export function serve(folder = pageFolder): Promise<{ server: Server; address: string }> {
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url!, 'http://localhost').pathname);
    const file = join(folder, path === '/' ? 'index.html' : path);
    if (!existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream' }).end(readFileSync(file));
  });
  return new Promise((resolve) =>
    server.listen(0, '127.0.0.1', () => {
      const at = server.address() as { port: number };
      resolve({ server, address: `http://127.0.0.1:${at.port}/` });
    }),
  );
}

export function launch(): Promise<Browser> {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  const args = ['--no-sandbox', '--disable-gpu', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
  return chromium.launch({ executablePath, args, headless: true });
}

/** For browsers that have no WebGL. */
const withoutWebgl = `
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind.startsWith('webgl') ? null : getContext.call(this, kind, ...rest);
  };`;

/** A page that notes every error and every request that leaves it. */
export async function open(browser: Browser, address: string, options: { width?: number; height?: number; locale?: string; dark?: boolean; webgl?: boolean; reducedMotion?: boolean } = {}) {
  const context = await browser.newContext({
    viewport: { width: options.width ?? 1280, height: options.height ?? 900 },
    locale: options.locale ?? 'en-GB',
    colorScheme: options.dark ? 'dark' : 'light',
    reducedMotion: options.reducedMotion ? 'reduce' : 'no-preference',
    acceptDownloads: true,
  });
  if (options.webgl === false) await context.addInitScript(withoutWebgl);
  const page = await context.newPage();
  const troubles: string[] = [];
  page.on('console', (message) => {
    // Without a graphics card the browser reads WebGL's pictures back itself, and complains of it.
    const itsOwn = message.text().includes('GL Driver Message');
    if ((message.type() === 'error' || message.type() === 'warning') && !itsOwn) troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(String(error)));
  page.on('request', (request) => {
    if (!request.url().startsWith(address.split('#')[0]!.replace(/[^/]*$/, '')) && !/^(data|blob):/.test(request.url())) troubles.push(`request: ${request.url()}`);
  });
  await page.goto(address);
  await page.waitForSelector('html[data-ready]', { timeout: 20000 });
  return { page, troubles, context };
}

export type Opened = { page: Page; troubles: string[] };
