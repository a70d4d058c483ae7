// Scenes on which the page's engine and the native program are compared: those shipped, and some made.
import { readFileSync } from 'node:fs';
import { carom, root } from './engine';

export interface Compared {
  name: string;
  text: string;
  until?: number;
  collisions?: number;
}

const shipped = (name: string, end: Partial<Compared>): Compared => ({
  name,
  text: readFileSync(`${root}scenes/${name}`, 'utf8'),
  ...end,
});

const made = (name: string, words: string[], end: Partial<Compared>): Compared => ({
  name,
  text: carom(['make', ...words, '-o', '-']),
  ...end,
});

export function comparedScenes(): Compared[] {
  return [
    shipped('billiard.txt', { until: 20 }),
    shipped('break.toml', { until: 3 }),
    shipped('brownian.toml', { collisions: 20000 }),
    shipped('cradle.toml', { until: 50 }),
    shipped('galperin.toml', { until: 10000 }),
    shipped('gas.toml', { collisions: 20000 }),
    shipped('granular.toml', { collisions: 20000 }),
    shipped('mixture.toml', { collisions: 20000 }),
    shipped('two-disk.toml', { until: 20 }),
    made('dilute gas', ['gas', '--disks', '300', '--packing', '0.01', '--seed', '3'], { collisions: 5000 }),
    made('dense gas', ['gas', '--disks', '1000', '--packing', '0.72', '--seed', '4'], { collisions: 30000 }),
    made('closed box', ['gas', '--disks', '200', '--packing', '0.4', '--boundary', 'reflecting'], { until: 15 }),
  ];
}
