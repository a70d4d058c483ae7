// A cell for a number: typed with comma or point, stepped with the arrow keys.
import { useLayoutEffect, useRef } from 'preact/hooks';
import { inFull, language, strings, typed } from '../strings';
import { announce } from '../lab/model';

interface Props {
  label: string;
  value: number;
  step: number;
  least?: number;
  most?: number;
  marked?: boolean;
  disabled?: boolean;
  id?: string;
  /** Returns false if the number cannot be had. */
  change: (value: number) => boolean | void;
}

/** Four decimals, or two digits of what is smaller; all digits are in the cell's title. */
function written(value: number): string {
  const tiny = value !== 0 && Math.abs(value) < 1e-3;
  const text = String(tiny ? Number(value.toPrecision(2)) : Math.round(value * 1e4) / 1e4 + 0);
  return (language.value === 'de' ? text.replace('.', ',') : text).replace('-', '−');
}

export function NumberField({ label, value, step, least = -1e6, most = 1e6, marked, disabled, id, change }: Props) {
  const input = useRef<HTMLInputElement>(null);
  const text = written(value);
  useLayoutEffect(() => {
    if (input.current && document.activeElement !== input.current) input.current.value = text;
  }, [text]);
  const set = (next: number): void => {
    const field = input.current!;
    const fits = Number.isFinite(next) && next >= least && next <= most;
    const taken = fits && change(next) !== false;
    field.setAttribute('aria-invalid', String(!taken));
    if (!fits) announce(strings.value.outOfRange(label, written(least), written(most)));
  };
  const commit = (): void => {
    const field = input.current!;
    if (field.value !== written(value)) set(typed(field.value));
  };
  const leave = (): void => {
    const field = input.current!;
    commit();
    field.setAttribute('aria-invalid', 'false');
    // After the state has settled: what is shown is what holds.
    setTimeout(() => (field.value = field.dataset.now ?? field.value));
  };
  const onKey = (event: KeyboardEvent): void => {
    if (event.key === 'Enter') commit();
    if (event.key !== 'ArrowUp' && event.key !== 'ArrowDown') return;
    event.preventDefault();
    const by = (event.key === 'ArrowUp' ? 1 : -1) * (event.shiftKey ? step / 10 : step);
    const next = Math.round((value + by) * 1e9) / 1e9;
    set(next);
    setTimeout(() => (input.current!.value = input.current!.dataset.now ?? ''));
  };
  return (
    <input
      ref={input}
      id={id}
      class={marked ? 'number marked' : 'number'}
      type="text"
      inputMode="decimal"
      autoComplete="off"
      spellcheck={false}
      aria-label={label}
      data-now={text}
      title={inFull(value)}
      defaultValue={text}
      disabled={disabled}
      onBlur={leave}
      onKeyDown={onKey}
      onFocus={(event) => event.currentTarget.select()}
    />
  );
}
