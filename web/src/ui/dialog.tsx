// A dialog above the page; Escape closes it and gives the focus back.
import { signal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { strings } from '../strings';

/** The dialog that is open. */
export const dialog = signal<'keys' | 'share' | null>(null);

interface Props {
  name: 'keys' | 'share';
  heading: string;
  children: ComponentChildren;
}

export function Dialog({ name, heading, children }: Props) {
  const element = useRef<HTMLDialogElement>(null);
  const open = dialog.value === name;
  useLayoutEffect(() => {
    if (open && !element.current!.open) element.current!.showModal();
    if (!open && element.current!.open) element.current!.close();
  }, [open]);
  const closed = (): void => {
    if (dialog.value === name) dialog.value = null;
  };
  return (
    <dialog ref={element} id={`dialog-${name}`} aria-labelledby={`heading-${name}`} onClose={closed}>
      <h2 id={`heading-${name}`}>{heading}</h2>
      {children}
      <form method="dialog">
        <button id={`close-${name}`}>{strings.value.close}</button>
      </form>
    </dialog>
  );
}
