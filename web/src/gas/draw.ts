// Draws many disks: each a copy of a picture of its size and colour, drawn once.
import type { Made, Picture } from './messages';

const shades = 24;

/** Dark blue to yellow by way of green: even steps of lightness, told apart by all (after the map "viridis"). */
const stops = [
  [68, 1, 84],
  [59, 82, 139],
  [33, 145, 140],
  [94, 201, 98],
  [253, 231, 37],
] as const;

export function shadeColour(shade: number): string {
  if (shade < 0) return '#4a7fb5';
  const at = Math.min(0.9999, shade) * (stops.length - 1);
  const [a, b] = [stops[Math.floor(at)]!, stops[Math.floor(at) + 1]!];
  const part = at % 1;
  return `rgb(${[0, 1, 2].map((k) => Math.round(a[k]! + part * (b[k]! - a[k]!))).join(',')})`;
}

/** One picture of each shade, side by side, for disks of one radius. */
interface Stamps {
  canvas: HTMLCanvasElement;
  side: number;
  radius: number;
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
    context.arc((k + 0.5) * side, side / 2, Math.max(0.5, radius * 0.96), 0, 2 * Math.PI);
    context.fill();
  }
  return { canvas, side, radius };
}

export class GasDrawing {
  private readonly context: CanvasRenderingContext2D;
  private stamps = new Map<number, Stamps>();
  private scale = 1;
  private path: { x: number; y: number }[] = [];

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly box: Made,
    private readonly ink: () => { path: string; tag: string },
  ) {
    this.context = canvas.getContext('2d')!;
  }

  /** Fits the box into so many pixels of the page. */
  fit(width: number, height: number, density: number): void {
    const scale = Math.min(width / this.box.width, height / this.box.height) * density;
    const [w, h] = [Math.round(this.box.width * scale), Math.round(this.box.height * scale)];
    if (this.canvas.width === w && this.canvas.height === h && this.scale === scale) return;
    this.canvas.width = w;
    this.canvas.height = h;
    this.canvas.style.width = `${w / density}px`;
    this.canvas.style.height = `${h / density}px`;
    this.scale = scale;
    this.stamps.clear();
  }

  forgetPath(): void {
    this.path = [];
  }

  draw({ disks, tagged }: Picture): void {
    const { context, canvas, scale, box } = this;
    context.clearRect(0, 0, canvas.width, canvas.height);
    // Copies at whole pixels need no blending; that of many small disks nobody misses.
    const snap = disks.length > 3 * 3000 ? Math.round : (value: number): number => value;
    for (let k = 0; 3 * k < disks.length; ++k) {
      const stamps = this.stampsFor(box.kinds[2 * k]! * scale);
      const shade = disks[3 * k + 2]!;
      const which = shade < 0 ? shades : Math.round(shade * (shades - 1));
      const { side } = stamps;
      const x = snap(disks[3 * k]! * scale - side / 2);
      const y = snap(canvas.height - disks[3 * k + 1]! * scale - side / 2);
      context.drawImage(stamps.canvas, which * side, 0, side, side, x, y, side, side);
    }
    if (tagged) this.drawTagged(tagged, box.kinds[0]! * scale);
    else this.path = [];
  }

  private stampsFor(radius: number): Stamps {
    let stamps = this.stamps.get(radius);
    if (!stamps) this.stamps.set(radius, (stamps = stampsOf(radius)));
    return stamps;
  }

  /** The path is kept unfolded, and drawn in every copy of the box that it passes through. */
  private drawTagged(at: { x: number; y: number }, radius: number): void {
    const { context, canvas, scale, box } = this;
    this.path.push(at);
    if (this.path.length > 4000) this.path.splice(0, 1000);
    const { path, tag } = this.ink();
    context.strokeStyle = path;
    context.lineWidth = Math.max(1.5, radius * 0.25);
    context.beginPath();
    let last: { x: number; y: number } | null = null;
    for (const point of this.path) {
      const turn = { x: Math.floor(point.x / box.width), y: Math.floor(point.y / box.height) };
      const x = (point.x - turn.x * box.width) * scale;
      const y = canvas.height - (point.y - turn.y * box.height) * scale;
      if (last && last.x === turn.x && last.y === turn.y) context.lineTo(x, y);
      else context.moveTo(x, y);
      last = turn;
    }
    context.stroke();
    const x = (at.x - Math.floor(at.x / box.width) * box.width) * scale;
    const y = canvas.height - (at.y - Math.floor(at.y / box.height) * box.height) * scale;
    context.fillStyle = tag;
    context.beginPath();
    context.arc(x, y, Math.max(3, radius), 0, 2 * Math.PI);
    context.fill();
    context.strokeStyle = path;
    context.stroke();
  }
}
