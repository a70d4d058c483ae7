// Property: the collisions that the page's gas records are, row by row and digit by digit, those of the program's log.
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { carom, root, startEngine } from './engine';

const engine = await startEngine();
const folder = mkdtempSync(join(tmpdir(), 'carom-recording-'));

function logged(scene: string, until: number): string[] {
  const log = join(folder, 'collisions.csv');
  carom(['run', '-', '--until', `${until}`, '--log-collisions', log, '--json', '--quiet'], scene);
  return readFileSync(log, 'utf8').trim().split('\n').slice(1);
}

function open(scene: string): void {
  engine.setInput(scene);
  engine.tryCall('gas_open', -1);
}
const record = (on: boolean): number => engine.tryCall('gas_record', 0, on ? 1 : 0);
const runUntil = (time: number): number => engine.tryCall('gas_run_until', 0, time);
const recorded = (): [number, number, number] => [...engine.numbers('gas_recorded', 3)] as [number, number, number];

function rows(): string[] {
  const found: string[] = [];
  for (let count = -1; count !== 0; ) {
    count = engine.tryCall('gas_recorded_rows', -1, found.length);
    if (count > 0) found.push(...engine.text().trim().split('\n'));
  }
  expect(recorded()[0]).toBe(found.length);
  return found;
}
const timeOf = (row: string): number => Number(row.split(',')[0]);
const shipped = (name: string): string => readFileSync(`${root}scenes/${name}`, 'utf8');

describe('collisions recorded', () => {
  for (const name of ['mixture.toml', 'granular.toml', 'break.toml', 'brownian.toml']) {
    it(`from the start on, stopped in the middle of a window: ${name}`, () => {
      open(shipped(name));
      record(true);
      for (const time of [0.1, 0.37, 0.37, 1.13]) runUntil(time);
      const native = logged(shipped(name), 1.13);
      expect(native.length).toBeGreaterThan(5);
      expect(rows()).toEqual(native);
    });
  }
  it('from any time on, off and on again, and the gas goes on as if nobody had looked', () => {
    const scene = carom(['make', 'gas', '--disks', '300', '--packing', '0.4', '--boundary', 'reflecting', '-o', '-']);
    const native = logged(scene, 3.3);
    open(scene);
    runUntil(0.7);
    expect(recorded()[0]).toBe(0);
    record(true);
    runUntil(2.1);
    expect(recorded()[2]).toBe(0.7);
    record(false);
    const kept = native.filter((row) => timeOf(row) >= 0.7 && timeOf(row) < 2.1);
    expect(rows()).toEqual(kept);
    runUntil(2.2);
    expect(rows()).toEqual(kept);
    // Again, twice within a window: each row is kept once.
    record(true);
    record(false);
    record(true);
    runUntil(3.3);
    expect(rows()).toEqual(native.filter((row) => timeOf(row) >= 2.2));
    expect(rows().length).toBeGreaterThan(100);
    engine.tryCall('gas_digest', 0);
    expect(engine.text()).toBe(JSON.parse(carom(['run', '-', '--until', '3.3', '--json', '--quiet'], scene)).digest);
  });
  it('through a reversal: all of the way there, and the same pairs on the way back', () => {
    const scene = carom(['make', 'gas', '--disks', '50', '--packing', '0.1', '-o', '-']);
    open(scene);
    record(true);
    runUntil(2.9);
    const there = rows();
    expect(there).toEqual(logged(scene, 2.9));
    engine.tryCall('gas_reverse', 0);
    runUntil(5.8);
    const all = rows();
    expect(all.slice(0, there.length)).toEqual(there);
    const pair = (row: string): string => row.split(',').slice(1, 3).join();
    expect(all.slice(there.length).map(pair)).toEqual(there.map(pair).reverse());
    expect(all.map(timeOf)).toEqual(all.map(timeOf).sort((a, b) => a - b));
  });
  it('no more than memory has room for, and those are the first ones', () => {
    const scene = carom(['make', 'gas', '--disks', '2000', '--packing', '0.6', '-o', '-']);
    open(scene);
    record(true);
    const most = recorded()[1];
    engine.tryCall('gas_run_collisions', 0, 1.2 * most);
    expect(recorded()[0]).toBe(most);
    const found = rows();
    expect(found.length).toBe(most);
    const native = logged(scene, timeOf(found.at(-1)!) + 0.01);
    expect(found.join('\n') === native.slice(0, most).join('\n')).toBe(true);
  });
});
