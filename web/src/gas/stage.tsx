// Where the gas is drawn: pictures are asked for one at a time, as often as the screen shows them.
import { signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { counted, shown, strings } from '../strings';
import { dark } from '../ui/theme';
import { GasDrawing, Ink } from './drawing';
import type { Made, Picture } from './messages';
import { ask, box, colour, frameTimes, measured, onEveryPicture, pace, parameters, running, tagging } from './model';

/** The picture that is on the page; nothing outside the tab. */
export const gasDrawing = signal<GasDrawing | null>(null);

let latestDrawing: GasDrawing | null = null;

/** Milliseconds between two measurements. */
const betweenMeasurements = 250;

function ink(): Ink {
  const style = getComputedStyle(document.documentElement);
  const of = (name: string): string => style.getPropertyValue(name);
  return { ground: of('--ground'), line: of('--ink'), tag: of('--impulse') };
}

/** Asks for pictures and draws them; while one is drawn, the worker is at the next. */
class Pictures {
  private waiting = false;
  private latest: Picture | null = null;
  private last = performance.now();
  private lastMeasured = this.last;
  private asked = { colour: colour.value, tag: tagging.value };
  private sums = { count: 0, since: this.last, work: 0, draw: 0 };
  private frame = 0;

  constructor(private readonly drawing: GasDrawing) {
    onEveryPicture((picture) => {
      this.waiting = false;
      this.latest = picture;
    });
    this.ask(0, false);
    this.frame = requestAnimationFrame(this.tick);
  }

  stop(): void {
    cancelAnimationFrame(this.frame);
    onEveryPicture(() => undefined);
  }

  private readonly tick = (now: number): void => {
    this.frame = requestAnimationFrame(this.tick);
    if (!this.waiting) this.advance(now);
    this.draw();
    this.tellTimes(now);
  };

  private ask(seconds: number, measure: boolean): void {
    this.waiting = true;
    this.asked = { colour: colour.value, tag: tagging.value };
    ask({ kind: 'advance', time: seconds * pace.value, ...this.asked, measure });
  }

  private advance(now: number): void {
    const seconds = Math.min(0.1, (now - this.last) / 1000);
    this.last = now;
    if (!running.value) {
      if (this.asked.colour !== colour.value || this.asked.tag !== tagging.value) this.ask(0, false);
      return;
    }
    const measure = now - this.lastMeasured > betweenMeasurements;
    if (measure) this.lastMeasured = now;
    this.ask(seconds, measure);
  }

  private draw(): void {
    if (!this.latest) return;
    const before = performance.now();
    this.drawing.draw(this.latest);
    this.sums.draw += performance.now() - before;
    this.sums.work += this.latest.work;
    ++this.sums.count;
    this.latest = null;
  }

  /** Twice a second. */
  private tellTimes(now: number): void {
    const { count, work, draw, since } = this.sums;
    if (now - since < 500 || count === 0) return;
    frameTimes.value = { work: work / count, draw: draw / count, perSecond: (1000 * count) / (now - since) };
    this.sums = { count: 0, since: now, work: 0, draw: 0 };
  }
}

/** Shows the gas on the canvases until the function returned is called. */
function showGas(canvas: HTMLCanvasElement, overlay: HTMLCanvasElement, made: Made): () => void {
  const stage = canvas.parentElement!.parentElement!;
  const drawing = new GasDrawing(canvas, overlay, made, ink, made.continues ? latestDrawing : null);
  latestDrawing = drawing;
  const fit = (): void => {
    const { width } = stage.getBoundingClientRect();
    drawing.fit(width, Math.max(260, Math.min(window.innerHeight - 310, width)), Math.min(2, window.devicePixelRatio));
  };
  fit();
  const pictures = new Pictures(drawing);
  const resize = new ResizeObserver(fit);
  resize.observe(stage);
  addEventListener('resize', fit);
  addEventListener('beforeprint', drawing.redraw);
  gasDrawing.value = drawing;
  return () => {
    pictures.stop();
    resize.disconnect();
    removeEventListener('resize', fit);
    removeEventListener('beforeprint', drawing.redraw);
    drawing.dispose();
    gasDrawing.value = null;
  };
}

export function GasStage() {
  const words = strings.value.gas;
  const canvas = useRef<HTMLCanvasElement>(null);
  const overlay = useRef<HTMLCanvasElement>(null);
  useEffect(() => (box.value ? showGas(canvas.current!, overlay.current!, box.value) : undefined), [box.value]);
  useEffect(() => gasDrawing.value?.redraw(), [dark.value]);
  const now = measured.value;
  const label = now ? `${words.picture}. ${words.summaryIs(shown(now.time), counted(now.collisions))}` : words.picture;
  return (
    <div class="gas-stage">
      <div class={parameters.value.boundary === 'periodic' ? 'gas-box' : 'gas-box walled'}>
        <canvas id="gas-picture" ref={canvas} role="img" aria-label={label} />
        <canvas class="gas-lines" ref={overlay} aria-hidden="true" />
      </div>
    </div>
  );
}
