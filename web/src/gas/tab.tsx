// The tab "Gas".
import { useEffect, useRef } from 'preact/hooks';
import { counted, shown, strings } from '../strings';
import { Icon } from '../ui/icon';
import { HChart, PressureChart, SpeedChart } from './charts';
import { GasControls } from './controls';
import { GasDrawing, shadeColour } from './draw';
import type { Picture } from './messages';
import { ask, box, colour, frameTimes, history, limited, makeGas, measured, onEveryPicture, pace, parameters, running, said, tagging } from './model';
import { collisionRateOf, compressibilityOf } from './theory';

/** Pictures are asked for one at a time, as often as the screen shows them; numbers four times a second. */
function useGas(canvas: { current: HTMLCanvasElement | null }, stage: { current: HTMLElement | null }): void {
  useEffect(() => {
    if (!box.value) return;
    const ink = (): { path: string; tag: string } => {
      const style = getComputedStyle(document.documentElement);
      return { path: style.getPropertyValue('--ink'), tag: style.getPropertyValue('--impulse') };
    };
    const drawing = new GasDrawing(canvas.current!, box.value, ink);
    const fit = (): void => {
      const { width } = stage.current!.getBoundingClientRect();
      drawing.fit(width, Math.max(260, Math.min(window.innerHeight - 310, width)), Math.min(2, window.devicePixelRatio));
    };
    let waiting = true;
    let last = performance.now();
    let lastMeasured = last;
    let frames = { count: 0, since: last, work: 0, draw: 0 };
    const request = (seconds: number, measure: boolean): void => {
      waiting = true;
      ask({ kind: 'advance', time: seconds * pace.value, colour: colour.value, tag: tagging.value, measure });
    };
    let latest: Picture | null = null;
    onEveryPicture((picture) => {
      waiting = false;
      latest = picture;
    });
    const draw = (): void => {
      if (!latest) return;
      fit();
      const before = performance.now();
      drawing.draw(latest);
      frames.draw += performance.now() - before;
      frames.work += latest.work;
      ++frames.count;
      latest = null;
    };
    // While one picture is drawn, the worker is at the next.
    const advance = (now: number): void => {
      const changed = asked !== colour.value || tagged !== tagging.value;
      if (waiting || (!running.value && !changed)) {
        if (!running.value) last = now;
        return;
      }
      [asked, tagged] = [colour.value, tagging.value];
      const measure = running.value && now - lastMeasured > 250;
      if (measure) lastMeasured = now;
      request(running.value ? Math.min(0.1, (now - last) / 1000) : 0, measure);
      last = now;
    };
    request(0, false);
    let asked = colour.value;
    let tagged = tagging.value;
    let frame = requestAnimationFrame(function tick(now: number) {
      frame = requestAnimationFrame(tick);
      if (now - frames.since > 500 && frames.count > 0) {
        const { count, work, draw, since } = frames;
        frameTimes.value = { work: work / count, draw: draw / count, perSecond: (1000 * count) / (now - since) };
        frames = { count: 0, since: now, work: 0, draw: 0 };
      }
      if (!waiting) advance(now);
      draw();
    });
    const resize = new ResizeObserver(() => {
      if (!waiting) request(0, false);
    });
    resize.observe(stage.current!);
    return () => {
      cancelAnimationFrame(frame);
      resize.disconnect();
      onEveryPicture(() => undefined);
    };
  }, [box.value]);
}

export function GasTab() {
  const words = strings.value;
  const canvas = useRef<HTMLCanvasElement>(null);
  const stage = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (!box.value) makeGas();
    const onKey = (event: KeyboardEvent): void => {
      const elsewhere = event.target instanceof Element && event.target.matches('input, select, button, summary, dialog *');
      if (event.key !== ' ' || elsewhere) return;
      event.preventDefault();
      running.value = !running.value;
    };
    document.addEventListener('keydown', onKey);
    return () => {
      document.removeEventListener('keydown', onKey);
      running.value = false;
    };
  }, []);
  useGas(canvas, stage);
  const now = measured.value;
  return (
    <main class="lab gas" id="main">
      <h1 class="hidden">{words.gas.heading}</h1>
      <section class="stage" aria-label={words.gas.picture}>
        <div class="gas-stage" ref={stage}>
          <canvas
            id="gas-picture"
            ref={canvas}
            class={parameters.value.boundary === 'reflecting' ? 'walled' : ''}
            role="img"
            aria-label={now ? `${words.gas.picture}. ${words.gas.summaryIs(shown(now.time), counted(now.collisions))}` : words.gas.picture}
          />
        </div>
        <GasTransport />
        <p class="said" role="status" aria-live="polite" id="gas-said">
          {said.value}
        </p>
        {colour.value !== 'none' && colour.value !== 'kind' && <Legend />}
        {now && <Readings />}
      </section>
      <section class="side" aria-label={words.controlsRegion}>
        <GasControls />
        {now && (
          <>
            <SpeedChart measured={now} />
            <HChart />
            <PressureChart measured={now} />
          </>
        )}
      </section>
    </main>
  );
}

function GasTransport() {
  const words = strings.value;
  const exponent = Math.log10(pace.value);
  return (
    <div class="transport">
      <div class="buttons">
        <button type="button" class="round" id="gas-new" aria-label={words.restart} title={words.restart} onClick={makeGas}>
          <Icon name="restart" />
        </button>
        <button
          type="button"
          class="round large"
          id="gas-play"
          aria-label={running.value ? words.pause : words.play}
          aria-keyshortcuts="Space"
          title={running.value ? words.pause : words.play}
          onClick={() => (running.value = !running.value)}
        >
          <Icon name={running.value ? 'pause' : 'play'} />
        </button>
        <button type="button" id="gas-reverse" onClick={() => ask({ kind: 'reverse' })}>
          <Icon name="reverse" /> {words.gas.reverse}
        </button>
      </div>
      <div class="pace wide">
        <label for="pace">{words.gas.pace}</label>
        <input
          id="pace"
          type="range"
          min="-2"
          max="3"
          step="0.1"
          value={exponent}
          aria-valuetext={words.gas.paceIs(shown(pace.value, pace.value < 1 ? 2 : 1))}
          onInput={(event) => (pace.value = Math.round(10 ** event.currentTarget.valueAsNumber * 1000) / 1000)}
        />
        <output>{limited.value ? words.gas.limited : words.gas.paceIs(shown(pace.value, pace.value < 1 ? 2 : 1))}</output>
      </div>
    </div>
  );
}

function Legend() {
  const words = strings.value.gas;
  const steps = [0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1];
  return (
    <p class="legend">
      {words.colours[colour.value]} 0
      <span class="ramp" aria-hidden="true">
        {steps.map((shade) => (
          <span key={shade} style={{ backgroundColor: shadeColour(shade) }} />
        ))}
      </span>
      {colour.value === 'speed' ? '3 √(kT/m)' : '1'}
    </p>
  );
}

/** Over the last ten seconds or so. */
function meanZ(): number {
  const values = history.value.slice(-40).map(({ z }) => z).filter(Number.isFinite);
  return values.reduce((sum, z) => sum + z, 0) / values.length;
}

function Readings() {
  const words = strings.value.gas;
  const now = measured.value!;
  const { fraction, restitution, temperature } = parameters.value;
  const simple = fraction === 0 && restitution === 1;
  const z = simple ? compressibilityOf(now.packing) : undefined;
  const rate = simple ? collisionRateOf(now.packing, now.kT || temperature, 1, 1) : undefined;
  const theory = (value: number | undefined) => (value === undefined ? '' : ` (${words.theory} ${shown(value, 3)})`);
  const rows: [string, string, string][] = [
    ['time', words.time, shown(now.time, 2)],
    ['collisions', words.collisions, counted(now.collisions)],
    ['rate', words.rate, shown(now.rate, 3) + theory(rate)],
    ['z', words.compressibility, shown(meanZ(), 3) + theory(z)],
    ['kT', words.kT, shown(now.kT, 4)],
    ['drift', words.drift, now.drift.toExponential(1).replace('-', '−').replace('e-', 'e−')],
    ['order', words.order, shown(now.order, 3)],
    ['frame', words.frame, words.frameIs(shown(frameTimes.value.work + frameTimes.value.draw, 1), shown(frameTimes.value.perSecond, 0))],
  ];
  return (
    <dl class="readings">
      {rows.map(([key, name, value]) => (
        <div key={key}>
          <dt>{name}</dt>
          <dd id={`gas-${key}`}>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
