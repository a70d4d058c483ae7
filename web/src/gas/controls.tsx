// What the gas is made of, and what is done with it.
import { useEffect } from 'preact/hooks';
import { counted, shown, strings } from '../strings';
import { NumberField } from '../ui/number-field';
import type { Colour, GasParameters } from './messages';
import { ask, change, colour, limits, parameters, recorded, recording, running, said, setRecording, tagging, wallStands } from './model';

interface RowProps {
  name: keyof typeof limits;
  step: number;
  whole?: boolean;
}

function Row({ name, step, whole }: RowProps) {
  const [least, most] = limits[name];
  const words = strings.value.gas;
  const set = (value: number): void => change({ [name]: whole ? Math.round(value) : value } as Partial<GasParameters>);
  return (
    <div class="row">
      <label for={`gas-${name}`}>{words[name]}</label>
      <NumberField id={`gas-${name}`} label={words[name]} value={parameters.value[name]} least={least} most={most} step={step} change={set} />
    </div>
  );
}

interface ChoiceProps<T extends string> {
  id: string;
  label: string;
  value: T;
  names: Record<T, string>;
  choose: (value: T) => void;
}

function Choice<T extends string>({ id, label, value, names, choose }: ChoiceProps<T>) {
  return (
    <div class="row">
      <label for={id}>{label}</label>
      <select id={id} value={value} onChange={(event) => choose(event.currentTarget.value as T)}>
        {(Object.keys(names) as T[]).map((name) => (
          <option key={name} value={name}>
            {names[name]}
          </option>
        ))}
      </select>
    </div>
  );
}

export function GasControls() {
  const words = strings.value.gas;
  const p = parameters.value;
  return (
    <div class="controls">
      <fieldset>
        <legend>{words.start}</legend>
        <Row name="number" step={100} whole />
        <Row name="packing" step={0.05} />
        <Row name="temperature" step={0.1} />
        <Choice id="gas-boundary" label={words.boundary} value={p.boundary} names={words.boundaries} choose={(boundary) => change({ boundary })} />
        {p.boundary === 'piston' && <Row name="pistonMass" step={0.1} />}
        <Choice id="gas-speeds" label={words.speeds} value={p.speeds} names={words.startSpeeds} choose={(speeds) => change({ speeds })} />
        <Row name="restitution" step={0.05} />
        <details>
          <summary id="gas-mixture">{words.mixture}</summary>
          <Row name="fraction" step={0.1} />
          <Row name="radiusRatio" step={0.1} />
          <Row name="massRatio" step={0.5} />
          <Row name="seed" step={1} whole />
        </details>
      </fieldset>
      <fieldset>
        <legend>{strings.value.show}</legend>
        <Choice id="gas-colour" label={words.colour} value={colour.value} names={words.colours} choose={(next: Colour) => (colour.value = next)} />
        <label>
          <input type="checkbox" id="gas-tag" checked={tagging.value} onChange={() => (tagging.value = !tagging.value)} />
          <span>{words.tag}</span>
        </label>
        <RecordingSwitch />
        {(p.boundary === 'half' || p.boundary === 'piston') && (
          <button type="button" id="gas-remove-wall" aria-disabled={!wallStands.value} onClick={removeWall}>
            {p.boundary === 'half' ? words.removeWall : words.freePiston}
          </button>
        )}
      </fieldset>
    </div>
  );
}

function RecordingSwitch() {
  const words = strings.value.gas;
  const kept = recorded.value;
  // While the gas runs they are counted when it is measured.
  useEffect(() => {
    if (recording.value && !running.value) ask({ kind: 'countRecorded' });
  }, [running.value]);
  return (
    <>
      <label>
        <input type="checkbox" id="gas-record" checked={recording.value} onChange={() => setRecording(!recording.value)} />
        <span>{words.record}</span>
      </label>
      {kept && (
        <p class="note" id="gas-recorded">
          {words.recordedIs(counted(kept.count), shown(kept.from), counted(kept.most))}
        </p>
      )}
    </>
  );
}

function removeWall(): void {
  if (!wallStands.value) return;
  ask({ kind: 'removeWall' });
  const words = strings.value.gas;
  said.value = parameters.value.boundary === 'half' ? words.expanded : words.pistonFree;
}
