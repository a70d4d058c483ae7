// Tables: contacts with the columns of the program's own collision log, and what was measured of a gas.
import type { Contact } from '../engine/playback';
import type { Measured } from '../gas/messages';

export const csvHeader = 'time,i,j,x,y,nx,ny,impulse';

const table = (header: string, rows: (string | number)[][]): string => `${[header, ...rows.map((row) => row.join(','))].join('\n')}\n`;

export function csvOf(contacts: readonly Contact[]): string {
  return table(
    csvHeader,
    contacts.map((c) => [c.time, c.i, c.j, c.point.x, c.point.y, c.normal.x, c.normal.y, c.impulse]),
  );
}

/** Cells of what there is not stay empty. */
export function csvOfGas(measured: readonly Measured[]): string {
  const columns = ['time', 'collisions', 'rate', 'kT', 'compressibility', 'h', 'order', 'packing', 'drift'] as const;
  const head = 'time,collisions,collisions_per_disk_and_time,kT,Z,H,psi6,packing_fraction,energy_drift';
  const rows = measured.map((one) => columns.map((name) => (Number.isFinite(one[name]) ? one[name] : '')));
  if (!measured.some(({ piston }) => piston)) return table(head, rows);
  const withPiston = rows.map((row, k) => [...row, measured[k]!.piston?.moved ?? '', measured[k]!.piston?.energy ?? '']);
  return table(`${head},piston_moved,piston_energy_share`, withPiston);
}
