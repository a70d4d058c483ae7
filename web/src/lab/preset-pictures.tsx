// What to start with, as small pictures: one of a group of radio buttons each.
import { strings } from '../strings';
import { Setup, engine, load, setup } from './model';
import { presetSetup, presets } from './presets';

const setups = new Map<string, Setup>();

/** As it stands at the start. Made once: some take the engine. */
function setupOfPreset(name: string): Setup {
  let made = setups.get(name);
  if (!made) {
    made = presetSetup(engine(), name)!;
    setups.set(name, made);
  }
  return made;
}

/** The part of the plane in which the disks and where they are going to lie, in the proportions of the pictures. */
function frameOf({ disks, arrow }: Setup): { x: number; y: number; width: number; height: number } {
  const edges = disks.flatMap((d) => [
    { x: d.x - d.radius, y: d.y - d.radius },
    { x: d.x + d.radius, y: d.y + d.radius },
    { x: d.x + d.vx * arrow, y: d.y + d.vy * arrow },
  ]);
  const low = { x: Math.min(...edges.map((e) => e.x)), y: Math.min(...edges.map((e) => e.y)) };
  const high = { x: Math.max(...edges.map((e) => e.x)), y: Math.max(...edges.map((e) => e.y)) };
  const width = 1.1 * Math.max(high.x - low.x, (high.y - low.y) * proportion);
  const height = width / proportion;
  return { x: (low.x + high.x - width) / 2, y: (low.y + high.y - height) / 2, width, height };
}

const proportion = 1.6;

function Picture({ name }: { name: string }) {
  const { disks, arrow } = setupOfPreset(name);
  const frame = frameOf(setupOfPreset(name));
  const up = (y: number): number => 2 * frame.y + frame.height - y;
  return (
    <svg viewBox={`${frame.x} ${frame.y} ${frame.width} ${frame.height}`} aria-hidden="true">
      {disks.map((d, k) => (
        <g key={k} class={`disk-${k % 6}`}>
          <circle cx={d.x} cy={up(d.y)} r={d.radius} />
          {(d.vx !== 0 || d.vy !== 0) && (
            <line x1={d.x} y1={up(d.y)} x2={d.x + d.vx * arrow} y2={up(d.y + d.vy * arrow)} stroke-width={frame.width / 30} />
          )}
        </g>
      ))}
    </svg>
  );
}

export function PresetPictures() {
  const words = strings.value;
  const chosen = setup.value.preset;
  const nameOf = (preset: string): string => words.presets[preset as keyof typeof words.presets] ?? words.custom;
  return (
    <fieldset id="presets">
      <legend>{words.preset}</legend>
      <div class="pictures">
        {presets.map(({ name }) => (
          <label key={name} title={nameOf(name)}>
            <input type="radio" class="hidden" name="preset" id={`preset-${name}`} aria-label={nameOf(name)}
              checked={chosen === name} onChange={() => load(setupOfPreset(name))} />
            <Picture name={name} />
          </label>
        ))}
      </div>
      <p id="preset-name">{nameOf(chosen)}</p>
    </fieldset>
  );
}
