// Contacts as a table: the columns of the program's own collision log.
import type { Contact } from '../engine/playback';

export const csvHeader = 'time,i,j,x,y,nx,ny,impulse';

export function csvOf(contacts: readonly Contact[]): string {
  const rows = contacts.map((c) => [c.time, c.i, c.j, c.point.x, c.point.y, c.normal.x, c.normal.y, c.impulse].join(','));
  return `${[csvHeader, ...rows].join('\n')}\n`;
}
