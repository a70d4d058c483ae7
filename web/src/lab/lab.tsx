// The tab "Two disks".
import { useEffect } from 'preact/hooks';
import { Derivation } from '../derivation/panel';
import { strings } from '../strings';
import { PlayArea } from './area';
import { EnergyBars, MomentumDiagram, Residuals } from './balance';
import { Controls } from './controls';
import { labShortcut } from './keys';
import { playFor, playing, announcement } from './model';
import { panel } from './panel';
import { DiskTable } from './table';
import { Transport } from './transport';

/** Moves the clock while it plays; longer pauses of the browser are not made up for. */
function useClock(): void {
  useEffect(() => {
    if (!playing.value) return;
    let last = performance.now();
    let request = requestAnimationFrame(function tick(now: number) {
      if (!playing.value) return;
      playFor(Math.min(0.1, Math.max(0, now - last) / 1000));
      last = now;
      request = requestAnimationFrame(tick);
    });
    return () => cancelAnimationFrame(request);
  }, [playing.value]);
}

function useShortcuts(): void {
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => {
      if (labShortcut(event)) event.preventDefault();
    };
    document.addEventListener('keydown', onKey);
    return () => document.removeEventListener('keydown', onKey);
  }, []);
}

export function Lab() {
  const words = strings.value;
  useClock();
  useShortcuts();
  return (
    <main class={`lab panel-${panel.value}`} id="main">
      <h1 class="hidden">{words.twoDisks}</h1>
      <section class="stage" aria-label={words.playRegion}>
        <p class="hidden">{words.summary}</p>
        <PlayArea />
        <Transport />
        <p class="said" id="said" role="status" aria-live="polite">
          {announcement.value || words.hint}
        </p>
        <DiskTable />
      </section>
      <section class="side" aria-label={words.controlsRegion}>
        <div class="switch" role="group" aria-label={words.sidePanel}>
          {(['controls', 'derivation'] as const).map((name) => (
            <button key={name} type="button" id={`panel-${name}`} aria-pressed={panel.value === name} onClick={() => (panel.value = name)}>
              {words.panels[name]}
            </button>
          ))}
        </div>
        {panel.value === 'controls' ? (
          <>
            <Controls />
            <MomentumDiagram />
            <EnergyBars />
            <Residuals />
          </>
        ) : (
          <Derivation />
        )}
      </section>
    </main>
  );
}
