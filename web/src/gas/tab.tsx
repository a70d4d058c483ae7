// The tab "Gas".
import { useEffect } from 'preact/hooks';
import { counted, shown, shownSmall, strings } from '../strings';
import { Icon } from '../ui/icon';
import { HChart, PressureChart, SpeedChart } from './charts';
import { GasControls } from './controls';
import { ask, box, colour, frameTimes, history, limited, makeGas, measured, pace, parameters, running, said, wallStands } from './model';
import { shadeColour } from './shades';
import { GasStage } from './stage';
import { collisionRateOf, compressibilityOf } from './theory';

export function GasTab() {
  const words = strings.value;
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
  const now = measured.value;
  return (
    <main class="lab gas" id="main">
      <h1 class="hidden">{words.gas.heading}</h1>
      <section class="stage" aria-label={words.gas.picture}>
        <p class="hidden">{words.gas.summary}</p>
        <GasStage />
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

/** Over the last ten seconds or so, since the box has its size. */
function meanZ(packing: number): number {
  const since = history.value.slice(-40).filter((point) => point.packing === packing);
  const values = since.map(({ compressibility }) => compressibility).filter(Number.isFinite);
  return values.reduce((sum, z) => sum + z, 0) / values.length;
}

function Readings() {
  const words = strings.value.gas;
  const now = measured.value!;
  const { fraction, restitution, temperature } = parameters.value;
  const simple = fraction === 0 && restitution === 1 && !(now.piston && !wallStands.value);
  const z = simple ? compressibilityOf(now.packing) : undefined;
  const rate = simple ? collisionRateOf(now.packing, now.kT || temperature, 1, 1) : undefined;
  const theory = (value: number | undefined) => (value === undefined ? '' : ` (${words.theory} ${shown(value, 3)})`);
  const rows: [string, string, string][] = [
    ['time', words.time, shown(now.time, 2)],
    ['collisions', words.collisions, counted(now.collisions)],
    ['rate', words.rate, shown(now.rate, 3) + theory(rate)],
    ['z', words.compressibility, shown(meanZ(now.packing), 3) + theory(z)],
    ['kT', words.kT, shown(now.kT, 4)],
    ['drift', words.drift, shownSmall(now.drift)],
    ['order', words.order, shown(now.order, 3)],
    ...(now.inHalf === undefined ? [] : [['half', words.inHalf, words.percent(shown(100 * now.inHalf, 1))] as [string, string, string]]),
    ...(now.piston
      ? [
          ['piston', words.pistonMoved, shown(now.piston.moved, 1)] as [string, string, string],
          ['piston-energy', words.pistonEnergy, words.percent(shown(100 * now.piston.energy, 1))] as [string, string, string],
        ]
      : []),
    ['frame', words.frame, words.frameIs(shown(frameTimes.value.work, 1), shown(frameTimes.value.draw, 1), shown(frameTimes.value.perSecond, 0))],
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
