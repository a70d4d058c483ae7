// What a contact did, in words.
import { Contact, Vec } from '../engine/playback';
import { Strings, shown } from '../strings';

/** One of eight directions, counted from the right against the clock. */
export function direction(v: Vec): number {
  return (Math.round((4 * Math.atan2(v.y, v.x)) / Math.PI) + 8) % 8;
}

export function motion(disk: number, v: Vec, words: Strings): string {
  const speed = Math.hypot(v.x, v.y);
  if (speed < 0.005) return words.nowRests(disk + 1);
  return words.nowMoves(disk + 1, words.directions[direction(v)]!, shown(speed));
}

export function sentence(contact: Contact, words: Strings): string {
  const { i, j, time } = contact;
  if (typeof j === 'string') {
    return `${words.metWall(i + 1, words.walls[j], shown(time))} ${motion(i, contact.afterI, words)}`;
  }
  const both = `${motion(i, contact.afterI, words)} ${motion(j, contact.afterJ, words)}`;
  return `${words.met(i + 1, j + 1, shown(time))} ${both}`;
}
