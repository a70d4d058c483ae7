// What a test does on the tab "Two disks" as a user does, and what it reads there.
import type { Locator } from 'playwright-core';
import { carom } from '../engine';
import type { Lab } from './lab';

interface Point {
  x: number;
  y: number;
}

/** What the program says of two disks given by their rows of the table. */
function collided(one: number[], two: number[], restitution = 1) {
  const disk = ([m, R, x, y, vx, vy]: number[]): string => [x, y, vx, vy, m, R].join(',');
  return JSON.parse(carom(['collide', '--disk', disk(one), '--disk', disk(two), '--advance', '--restitution', `${restitution}`, '--json']));
}

export function handsOn(lab: Lab) {
  /** Shown in a cell: m, R, x, y, vx or vy of a disk, all counted from 1. */
  const cell = (disk: number, what: number): Locator =>
    lab.page.locator(`.table-section tbody tr:nth-child(${disk}) td:nth-of-type(${what}) input`).first();
  const value = async (disk: number, what: number): Promise<number> => Number((await cell(disk, what).inputValue()).replace('−', '-'));
  const row = (disk: number): Promise<number[]> => Promise.all([1, 2, 3, 4, 5, 6].map((what) => value(disk, what)));
  const clock = async (): Promise<number> => Number(await lab.page.textContent('#clock'));

  /** From places of the box, 8 wide and 5 high, to the screen. */
  async function onScreen(x: number, y: number): Promise<Point> {
    const box = (await lab.page.locator('#play-area').boundingBox())!;
    const scale = Math.min(box.width / 8, box.height / 5);
    const left = box.x + (box.width - 8 * scale) / 2;
    return { x: left + x * scale, y: box.y + box.height - (box.height - 5 * scale) / 2 - y * scale };
  }

  /** Takes what is there and moves it, and holds it still. */
  async function take(from: [number, number], to: [number, number]): Promise<void> {
    const a = await onScreen(...from);
    const b = await onScreen(...to);
    await lab.page.mouse.move(a.x, a.y);
    await lab.page.mouse.down();
    await lab.page.mouse.move((a.x + b.x) / 2, (a.y + b.y) / 2);
    await lab.page.mouse.move(b.x, b.y);
  }

  async function drag(from: [number, number], to: [number, number], shift = false): Promise<void> {
    if (shift) await lab.page.keyboard.down('Shift');
    await take(from, to);
    await lab.page.mouse.up();
    if (shift) await lab.page.keyboard.up('Shift');
  }

  return { cell, value, row, clock, collided, take, drag };
}
