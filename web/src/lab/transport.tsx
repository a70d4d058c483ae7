// The clock, and the buttons that move it.
import { shown, strings } from '../strings';
import { Icon, IconName } from '../ui/icon';
import { bordered, contactsSoFar, cursor, load, nextContact, outside, pauseAtContact, playing, previousContact, restart, setup, slow, step } from './model';

interface ButtonProps {
  id: string;
  icon: IconName;
  label: string;
  keys: string;
  act: () => void;
  large?: boolean;
}

function TransportButton({ id, icon, label, keys, act, large }: ButtonProps) {
  return (
    <button type="button" id={id} class={large ? 'round large' : 'round'} aria-label={label} aria-keyshortcuts={keys} title={label} onClick={act}>
      <Icon name={icon} />
    </button>
  );
}

function returnDisks(): void {
  if (outside.value) load(setup.value);
}

export function Transport() {
  const words = strings.value;
  return (
    <div class="transport">
      <div class="clock">
        <span id="clock">{shown(cursor.value.time, 2)}</span>
        <span class="contacts">{words.contacts(contactsSoFar.value)}</span>
      </div>
      <div class="buttons">
        <TransportButton id="restart" icon="restart" label={words.restart} keys="R" act={restart} />
        <TransportButton id="previous-contact" icon="previous" label={words.previousContact} keys="B" act={previousContact} />
        <TransportButton id="step-back" icon="back" label={words.stepBack} keys="," act={() => step(-1)} />
        <TransportButton
          id="play"
          icon={playing.value ? 'pause' : 'play'}
          label={playing.value ? words.pause : words.play}
          keys="Space"
          act={() => (playing.value = !playing.value)}
          large
        />
        <TransportButton id="step-forward" icon="forward" label={words.stepForward} keys="." act={() => step(1)} />
        <TransportButton id="next-contact" icon="next" label={words.nextContact} keys="N" act={nextContact} />
      </div>
      <div class="pace">
        <label>
          <input type="checkbox" id="slow" checked={slow.value} onChange={() => (slow.value = !slow.value)} /> {words.slow}
        </label>
        <label>
          <input type="checkbox" id="pause-at-contact" checked={pauseAtContact.value} onChange={() => (pauseAtContact.value = !pauseAtContact.value)} />{' '}
          {words.pauseAtContact}
        </label>
        {!bordered.value && (
          <button type="button" id="return-disks" aria-disabled={!outside.value} onClick={returnDisks}>
            {words.returnDisks}
          </button>
        )}
      </div>
    </div>
  );
}
