// The page as its tests find it: built, served, open in a browser of its own.
import type { Server } from 'node:http';
import type { Browser, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, expect } from 'vitest';
import { launch, open, serve } from '../browser';

export interface Lab {
  browser: Browser;
  address: string;
  page: Page; // of the test that runs
}

/** One browser and one server for all tests of a file. */
export function servedLab(): Lab {
  const lab = {} as Lab;
  let server: Server;
  beforeAll(async () => {
    lab.browser = await launch();
    ({ server, address: lab.address } = await serve());
  });
  afterAll(async () => {
    await lab.browser.close();
    server.close();
  });
  return lab;
}

/** And a fresh page in `state` for each test, in which nothing may go wrong. */
export function openedLab(state = ''): Lab {
  const lab = servedLab();
  let troubles: string[];
  let close: () => Promise<void>;
  beforeEach(async () => {
    const opened = await open(lab.browser, lab.address + state);
    ({ page: lab.page, troubles } = opened);
    close = () => opened.context.close();
  });
  afterEach(async () => {
    expect(troubles).toEqual([]);
    await close();
  });
  return lab;
}
