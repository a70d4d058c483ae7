// Tints that show density: where sizes stay when masses change, the denser disk is darker.
import type { Disk } from '../engine/scene';
import { constantSize } from './model';

export interface Tint {
  denser: boolean;
  /** From 0 to 1. */
  amount: number;
}

/** Nothing where the disk is about as dense as all are on average (by their ratios). */
export function densityTint(disk: Disk, disks: readonly Disk[]): Tint | undefined {
  const power = ({ mass, radius }: Disk): number => Math.log10(mass / (radius * radius));
  const mean = disks.reduce((sum, one) => sum + power(one), 0) / disks.length;
  const more = power(disk) - mean;
  return Math.abs(more) < 0.02 ? undefined : { denser: more > 0, amount: Math.min(0.6, 0.6 * Math.abs(more)) };
}

export const tintOf = (disk: Disk, disks: readonly Disk[]): Tint | undefined =>
  constantSize.value ? densityTint(disk, disks) : undefined;
