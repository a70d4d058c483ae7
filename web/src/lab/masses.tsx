// The masses, to be changed by sliders, and what that does to the sizes.
import { shown, strings } from '../strings';
import { changeMass, constantSize, disksNow, mostDisks } from './model';

/** Powers of ten at the sliders' ends. */
const [least, most] = [-1, 1];

/** A mass of two digits. */
export const massAt = (power: number): number => Number((10 ** power).toPrecision(2));

function MassSlider({ number, mass }: { number: number; mass: number }) {
  const words = strings.value;
  return (
    <div class="row mass">
      <span class={`badge disk-${number % 6}`} aria-hidden="true">
        {number + 1}
      </span>
      <input
        id={`mass-${number + 1}`}
        type="range"
        min={least}
        max={most}
        step="0.05"
        value={Math.log10(mass)}
        aria-label={words.cell(words.mass, number + 1)}
        aria-valuetext={shown(mass)}
        onInput={(event) => changeMass(number, massAt(event.currentTarget.valueAsNumber))}
      />
      <output for={`mass-${number + 1}`}>{shown(mass)}</output>
    </div>
  );
}

export function Masses() {
  const words = strings.value;
  if (disksNow.value.length > mostDisks) return null;
  return (
    <fieldset>
      <legend>{words.masses}</legend>
      {disksNow.value.map(({ mass }, k) => (
        <MassSlider key={k} number={k} mass={mass} />
      ))}
      <label>
        <input type="checkbox" id="constant-size" checked={constantSize.value} aria-describedby="constant-size-note" onChange={() => (constantSize.value = !constantSize.value)} />
        <span>{words.constantSize}</span>
      </label>
      <p class="note" id="constant-size-note">
        {constantSize.value ? words.tintNote : words.sizeNote}
      </p>
    </fieldset>
  );
}
