// Draws many disks without a graphics library: each a copy of a picture of its size and colour, drawn once.
import type { DiskPainter } from './drawing';
import { shadeColour } from './shades';

const shades = 24;
/** In pixels; larger disks, which are few, are drawn one by one. */
const largestStamp = 100;

/** So that one sees them touch, and yet apart. */
const drawnRadius = (radius: number): number => Math.max(0.5, 0.96 * radius, radius - 1);

/** One picture of each shade, side by side, for disks of one radius. */
interface Stamps {
  canvas: HTMLCanvasElement;
  side: number;
}

function stampsOf(radius: number): Stamps {
  const side = Math.ceil(2 * radius) + 2;
  const canvas = document.createElement('canvas');
  canvas.width = side * (shades + 1);
  canvas.height = side;
  const context = canvas.getContext('2d')!;
  for (let k = 0; k <= shades; ++k) {
    context.fillStyle = shadeColour(k === shades ? -1 : k / (shades - 1));
    context.beginPath();
    context.arc((k + 0.5) * side, side / 2, drawnRadius(radius), 0, 2 * Math.PI);
    context.fill();
  }
  return { canvas, side };
}

export class PlainDisks implements DiskPainter {
  private readonly context: CanvasRenderingContext2D;
  private stamps = new Map<number, Stamps>();
  private stampScale = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly kinds: Float64Array,
  ) {
    this.context = canvas.getContext('2d')!;
  }

  paint(disks: Float32Array, scale: number): void {
    const { context, canvas, kinds } = this;
    if (this.stampScale !== scale) this.stamps.clear();
    this.stampScale = scale;
    context.clearRect(0, 0, canvas.width, canvas.height);
    // Copies at whole pixels need no blending; that of many small disks nobody misses.
    const snap = disks.length > 3 * 3000 ? Math.round : (value: number): number => value;
    for (let k = 0; 3 * k < disks.length; ++k) {
      const shade = disks[3 * k + 2]!;
      const radius = kinds[2 * k]! * scale;
      if (radius > largestStamp) {
        context.fillStyle = shadeColour(shade);
        context.beginPath();
        context.arc(disks[3 * k]! * scale, canvas.height - disks[3 * k + 1]! * scale, drawnRadius(radius), 0, 2 * Math.PI);
        context.fill();
        continue;
      }
      const { canvas: stamp, side } = this.stampsFor(radius);
      const which = shade < 0 ? shades : Math.round(shade * (shades - 1));
      const x = snap(disks[3 * k]! * scale - side / 2);
      const y = snap(canvas.height - disks[3 * k + 1]! * scale - side / 2);
      context.drawImage(stamp, which * side, 0, side, side, x, y, side, side);
    }
  }

  private stampsFor(radius: number): Stamps {
    let stamps = this.stamps.get(radius);
    if (!stamps) this.stamps.set(radius, (stamps = stampsOf(radius)));
    return stamps;
  }

  dispose(): void {
    this.stamps.clear();
  }
}
