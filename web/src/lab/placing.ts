// Where a disk can stand: inside the walls, and not on top of another.
import { Boundary, Disk } from '../engine/scene';

interface Room {
  width: number;
  height: number;
  boundary: [Boundary, Boundary];
  /** Places are tried on a grid of this width. */
  grid: number;
}

/** Touching is fine; this share of the radius is not an overlap. */
const tolerance = 1e-10;

export function fits(disk: Disk, others: readonly Disk[], room: Room): boolean {
  const inside = (x: number, size: number, boundary: Boundary): boolean =>
    boundary === 'open' || (x >= disk.radius * (1 - tolerance) && x <= size - disk.radius * (1 - tolerance));
  if (!inside(disk.x, room.width, room.boundary[0]) || !inside(disk.y, room.height, room.boundary[1])) return false;
  return others.every(
    (other) => Math.hypot(other.x - disk.x, other.y - disk.y) >= (other.radius + disk.radius) * (1 - tolerance),
  );
}

const rounded = (value: number): number => Math.round(value * 1e9) / 1e9;

/** The disk at its place, or at the nearest one on the grid where it fits; nothing if there is none. */
export function placed(disk: Disk, others: readonly Disk[], room: Room): Disk | undefined {
  if (fits(disk, others, room)) return disk;
  const { grid, width, height } = room;
  const column = Math.round(disk.x / grid);
  const row = Math.round(disk.y / grid);
  const rings = Math.ceil((Math.max(width, height) / grid) * 1.5);
  let best: Disk | undefined;
  let bestDistance = Infinity;
  for (let ring = 0; ring <= rings && ring * grid <= bestDistance + grid; ++ring) {
    for (let a = -ring; a <= ring; ++a) {
      for (let b = -ring; b <= ring; b += Math.abs(a) === ring ? 1 : Math.max(1, 2 * ring)) {
        const there = { ...disk, x: rounded((column + a) * grid), y: rounded((row + b) * grid) };
        const distance = Math.hypot(there.x - disk.x, there.y - disk.y);
        if (distance < bestDistance && fits(there, others, room)) {
          best = there;
          bestDistance = distance;
        }
      }
    }
  }
  return best;
}
