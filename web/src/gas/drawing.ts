// The picture of the gas: its disks on one canvas, and on another above it what is drawn with lines.
import { PlainDisks } from './disks-plain';
import { WebglDisks } from './disks-webgl';
import type { Made, Picture } from './messages';
import { shadeColour } from './shades';

/** Paints all disks anew: x, y and shade of each; `scale` is in pixels per length. */
export interface DiskPainter {
  paint(disks: Float32Array, scale: number): void;
  dispose(): void;
}

interface Vec {
  x: number;
  y: number;
}

export interface Ink {
  ground: string;
  line: string;
  tag: string;
}

/** Points kept of the tagged disk's path, at most. */
const longestPath = 4000;

export class GasDrawing {
  private readonly painter: DiskPainter;
  private readonly lines: CanvasRenderingContext2D;
  private scale = 1;
  private path: Vec[];
  private last: Picture | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly overlay: HTMLCanvasElement,
    private readonly box: Made,
    private readonly ink: () => Ink,
    /** Of the same gas in a box of another size. */
    before: GasDrawing | null,
  ) {
    this.path = before?.path ?? [];
    this.painter = WebglDisks.on(canvas, box.kinds, { width: box.room, height: box.height }) ?? new PlainDisks(canvas, box.kinds);
    this.lines = overlay.getContext('2d')!;
    canvas.addEventListener('webglcontextrestored', this.redraw);
  }

  dispose(): void {
    this.canvas.removeEventListener('webglcontextrestored', this.redraw);
    this.painter.dispose();
  }

  /** Fits the room into so many pixels of the page. */
  fit(width: number, height: number, density: number): void {
    const scale = Math.min(width / this.box.room, height / this.box.height) * density;
    const [w, h] = [Math.round(this.box.room * scale), Math.round(this.box.height * scale)];
    if (this.canvas.width === w && this.canvas.height === h && this.scale === scale) return;
    for (const canvas of [this.canvas, this.overlay]) {
      canvas.width = w;
      canvas.height = h;
      canvas.style.width = `${w / density}px`;
      canvas.style.height = `${h / density}px`;
    }
    this.scale = scale;
    this.redraw();
  }

  draw(picture: Picture): void {
    const hadLines = this.last === null || this.last.tagged !== null;
    if (picture.tagged) this.path.push(picture.tagged);
    else this.path = [];
    if (this.path.length > longestPath) this.path.splice(0, longestPath / 4);
    this.last = picture;
    this.painter.paint(picture.disks, this.scale);
    if (hadLines || picture.tagged || this.box.piston) this.drawLines();
  }

  /** The last picture once more: what a canvas shows is not kept for printing and saving. */
  readonly redraw = (): void => {
    if (!this.last) return;
    this.painter.paint(this.last.disks, this.scale);
    this.drawLines();
  };

  /** All of it on a canvas of its own, on the page's ground. */
  copy(): HTMLCanvasElement {
    this.redraw();
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [this.canvas.width, this.canvas.height];
    const context = copy.getContext('2d')!;
    context.fillStyle = this.ink().ground;
    context.fillRect(0, 0, copy.width, copy.height);
    context.drawImage(this.canvas, 0, 0);
    context.drawImage(this.overlay, 0, 0);
    return copy;
  }

  /** The disks as shapes; lengths are the scene's. */
  svg(): string {
    const { room, height, width, kinds } = this.box;
    const { ground, line, tag } = this.ink();
    const disks = this.last?.disks ?? new Float32Array();
    const parts = [`<rect width="${room}" height="${height}" fill="${ground}" stroke="${line}" stroke-width="0.2"/>`];
    const circle = (x: number, y: number, radius: number, fill: string): void =>
      void parts.push(`<circle cx="${x.toFixed(3)}" cy="${(height - y).toFixed(3)}" r="${radius}" fill="${fill}"/>`);
    for (let k = 0; 3 * k < disks.length; ++k) {
      circle(disks[3 * k]!, disks[3 * k + 1]!, kinds[2 * k]!, shadeColour(disks[3 * k + 2]!));
    }
    if (width < room) parts.push(`<path d="M${width},0V${height}" stroke="${line}" stroke-width="0.4"/>`);
    const piston = this.piston();
    if (piston) parts.push(`<circle cx="${piston.x.toFixed(3)}" cy="${(height - piston.y).toFixed(3)}" r="${piston.radius}" fill="none" stroke="${line}" stroke-width="0.4"/>`);
    if (this.last?.tagged) {
      const inScene = (pixels: number): string => (pixels / this.scale).toFixed(3);
      const path = [...this.pathInBox()].map(({ x, y, jumps }) => `${jumps ? 'M' : 'L'}${inScene(x)},${inScene(y)}`);
      parts.push(`<path d="${path.join('')}" fill="none" stroke="${line}" stroke-width="0.2"/>`);
      const { x, y } = this.folded(this.last.tagged);
      circle(x / this.scale, height - y / this.scale, kinds[0]!, tag);
    }
    const size = `width="${this.canvas.width}" height="${this.canvas.height}" viewBox="0 0 ${room} ${height}"`;
    return `<svg xmlns="http://www.w3.org/2000/svg" ${size}>\n${parts.join('\n')}\n</svg>\n`;
  }

  private drawLines(): void {
    const { lines, overlay, scale, box } = this;
    const { line, tag } = this.ink();
    lines.clearRect(0, 0, overlay.width, overlay.height);
    lines.strokeStyle = line;
    if (box.width < box.room) {
      lines.lineWidth = 4;
      lines.strokeRect(box.width * scale, -4, overlay.width, overlay.height + 8);
    }
    const piston = this.piston();
    if (piston) this.outline(piston);
    const at = this.last?.tagged;
    if (!at) return;
    const radius = box.kinds[0]! * scale;
    lines.lineWidth = Math.max(1.5, radius * 0.25);
    this.drawPath();
    const { x, y } = this.folded(at);
    lines.fillStyle = tag;
    lines.beginPath();
    lines.arc(x, y, Math.max(3, radius), 0, 2 * Math.PI);
    lines.fill();
    lines.stroke();
  }

  /** Behind its wall, or among the disks as the last of them. */
  private piston(): Made['waiting'] {
    const { box, last } = this;
    if (!box.piston || !last) return box.waiting;
    const [x, y] = last.disks.subarray(-3);
    return { x: x!, y: y!, radius: box.kinds.at(-2)! };
  }

  private outline({ x, y, radius }: NonNullable<Made['waiting']>): void {
    const { lines, overlay, scale } = this;
    lines.lineWidth = 2;
    lines.beginPath();
    lines.arc(x * scale, overlay.height - y * scale, radius * scale, 0, 2 * Math.PI);
    lines.stroke();
  }

  /** The path is kept unfolded, and drawn in every copy of the box that it passes through. */
  private drawPath(): void {
    const { lines } = this;
    lines.beginPath();
    for (const { x, y, jumps } of this.pathInBox()) {
      if (jumps) lines.moveTo(x, y);
      else lines.lineTo(x, y);
    }
    lines.stroke();
  }

  private *pathInBox(): Generator<Vec & { jumps: boolean }> {
    let last: Vec | null = null;
    for (const point of this.path) {
      const { x, y, turn } = this.folded(point);
      yield { x, y, jumps: !last || last.x !== turn.x || last.y !== turn.y };
      last = turn;
    }
  }

  /** In pixels, in the box, and how often it crossed the box on the way there. */
  private folded(point: Vec): Vec & { turn: Vec } {
    const { box, scale } = this;
    const turn = { x: Math.floor(point.x / box.width), y: Math.floor(point.y / box.height) };
    const x = (point.x - turn.x * box.width) * scale;
    return { x, y: this.overlay.height - (point.y - turn.y * box.height) * scale, turn };
  }
}
