// What is shown, and how the disks collide.
import { NumberField } from '../ui/number-field';
import { strings } from '../strings';
import { bordered, setBorder, setRestitution, setup } from './model';
import { Masses } from './masses';
import { PresetPictures } from './preset-pictures';
import { Layer, layers, show, toggle } from './view';

/** The mark beside a check box: what it switches on. */
function Sample({ layer }: { layer: Layer }) {
  const kinds: Partial<Record<Layer, string>> = {
    velocity: 'velocity',
    momentum: 'momentum',
    parts: 'normal',
    impulse: 'impulse',
    change: 'change',
    ghosts: 'velocity-before',
  };
  const kind = kinds[layer];
  if (!kind) return <svg class="sample" viewBox="0 0 34 16" aria-hidden="true"><SampleShape layer={layer} /></svg>;
  return (
    <svg class="sample" viewBox="0 0 34 16" aria-hidden="true">
      <g class={`arrow ${kind}`}>
        <line class="shaft" x1="2" y1="8" x2="23" y2="8" />
        <polygon points="32,8 21,3 21,13" />
      </g>
    </svg>
  );
}

function SampleShape({ layer }: { layer: Layer }) {
  switch (layer) {
    case 'lines':
      return <path class="sample-lines" d="M2 8H32M17 0V16" />;
    case 'centre':
      return <path class="sample-ink" d="M17 1v14M10 8h14" />;
    case 'centreFrame':
      return <path class="sample-ink" d="M17 4v8M13 8h8M4 2h26v12H4z" />;
    case 'paths':
      return <path class="sample-path" d="M2 14 14 4 32 12" />;
    case 'wholePaths':
      return <path class="sample-path" d="M2 3 8 13 14 4 20 13 26 4 32 12" />;
    case 'scale':
      return <path class="sample-ink" d="M3 3v10M3 8h28M31 3v10" />;
    case 'grid':
      return <path class="sample-grid" d="M2 4H32M2 12H32M8 0V16M18 0V16M28 0V16" />;
    default:
      return (
        <text class="sample-text" x="17" y="12" text-anchor="middle">
          1.0
        </text>
      );
  }
}

export function Controls() {
  const words = strings.value;
  return (
    <div class="controls">
      <PresetPictures />
      <fieldset class="layers">
        <legend>{words.show}</legend>
        {layers.map((layer) => (
          <label key={layer}>
            <input type="checkbox" id={`show-${layer}`} checked={show.value.has(layer)} onChange={() => toggle(layer)} />
            <span>{words.layers[layer]}</span>
            <Sample layer={layer} />
          </label>
        ))}
      </fieldset>
      <fieldset>
        <legend>{words.howTheyCollide}</legend>
        <div class="row">
          <label for="restitution">{words.restitution}</label>
          <input id="restitution" type="range" min="0" max="1" step="0.01" value={setup.value.restitution}
            aria-valuetext={words.restitutionIs(Math.round(setup.value.restitution * 100))}
            onInput={(event) => setRestitution(event.currentTarget.valueAsNumber)} />
          <NumberField id="restitution-number" label={words.restitutionNumber} value={setup.value.restitution} step={0.1} least={0} most={1} change={setRestitution} />
        </div>
        <label>
          <input type="checkbox" id="border" checked={bordered.value} onChange={() => setBorder(!bordered.value)} />
          <span>{words.border}</span>
        </label>
      </fieldset>
      <Masses />
    </div>
  );
}
