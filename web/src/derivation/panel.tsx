// The derivation of the collision shown, one step at a time, each beside its vectors in the picture.
import { computed, signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { explain, Format } from '../engine/collision';
import { strings } from '../strings';
import { collisionIs, collisionShown, engine, goToContact, announce, setup } from '../lab/model';
import { focus } from '../lab/view';
import { copyText } from '../share/clipboard';
import { Block, Step, stepsOf } from './document';
import { focusOf } from './focus';
import { Formula } from './formula';
import { translated } from './translate';

export const stepShown = signal(0);
export const allSteps = signal(false);

export function derivationText(format: Format): string {
  const collision = collisionShown.value;
  return collision ? explain(engine(), collision, setup.value.disks, format) : '';
}

const steps = computed<Step[]>(() => (collisionShown.value ? stepsOf(derivationText('markdown')) : []));

export function Derivation() {
  const words = strings.value;
  const collision = collisionShown.value;
  const last = steps.value.length - 1;
  const k = Math.max(0, Math.min(stepShown.value, last));
  const wanted = focusOf(steps.value[k]);
  useEffect(() => {
    focus.value = wanted;
  }, [k, collision]);
  useEffect(() => () => void (focus.value = null), []);
  useEffect(() => {
    // What is derived is what is seen.
    if (collision && collisionIs.value !== 'now') goToContact(collision.index);
  }, []);

  if (!collision) return <p class="note">{words.noCollision}</p>;
  const go = (to: number): void => {
    stepShown.value = Math.max(0, Math.min(to, last));
  };
  return (
    <div class="derivation">
      <p class="which">{words.derivationOf(collision.i + 1, collision.j + 1, collision.index + 1)}</p>
      <div class="row stepper">
        <button type="button" id="step-previous" aria-disabled={k === 0} onClick={() => go(k - 1)}>
          {words.previousStep}
        </button>
        <output id="step-number">{words.stepOf(k + 1, last + 1)}</output>
        <button type="button" id="step-next" aria-disabled={k === last} onClick={() => go(k + 1)}>
          {words.nextStep}
        </button>
      </div>
      <div class="sheet">
        {allSteps.value
          ? steps.value.map((step, number) => <StepText key={number} step={step} number={number} />)
          : steps.value[k] && <StepText key={k} step={steps.value[k]!} number={k} />}
      </div>
      <div class="row copies">
        <label>
          <input type="checkbox" id="all-steps" checked={allSteps.value} onChange={() => (allSteps.value = !allSteps.value)} /> {words.allSteps}
        </label>
        <button type="button" id="copy-latex" onClick={() => copy('latex')}>
          {words.copyLatex}
        </button>
        <button type="button" id="copy-markdown" onClick={() => copy('markdown')}>
          {words.copyMarkdown}
        </button>
      </div>
      <details class="errata">
        <summary>{words.errata}</summary>
        <ul>
          {words.slips.map((slip) => (
            <li key={slip}>
              <Mixed text={slip} />
            </li>
          ))}
        </ul>
      </details>
    </div>
  );
}

async function copy(format: Format): Promise<void> {
  announce((await copyText(derivationText(format))) ? strings.value.copied : strings.value.notCopied);
}

function StepText({ step, number }: { step: Step; number: number }) {
  return (
    <article>
      <h2>
        {number + 1}. {translated(step.heading)}
      </h2>
      {step.blocks.map((block, k) => (
        <BlockText key={k} block={block} />
      ))}
    </article>
  );
}

function BlockText({ block }: { block: Block }) {
  if (block.kind === 'listing') {
    return (
      <pre tabindex={0}>{block.text}</pre>
    );
  }
  if (block.kind === 'formula') {
    return (
      <div class="scroller" tabindex={0} role="group" aria-label={strings.value.equation}>
        <Formula tex={block.tex.replaceAll('\\text{Disk ', `\\text{${strings.value.disk} `)} display />
      </div>
    );
  }
  const source = block.runs.map((run) => (run.kind === 'words' ? run.text : run.kind === 'code' ? `\`${run.text}\`` : `$${run.text}$`)).join('');
  return (
    <p>
      <Mixed text={translated(source)} />
    </p>
  );
}

/** Words with $formulas$ and `code` in them. */
function Mixed({ text }: { text: string }) {
  return (
    <>
      {text.split(/(\$[^$]*\$|`[^`]*`)/).map((run, k) => {
        if (run.startsWith('$')) return <Formula key={k} tex={run.slice(1, -1)} />;
        return run.startsWith('`') ? <code key={k}>{run.slice(1, -1)}</code> : run;
      })}
    </>
  );
}
