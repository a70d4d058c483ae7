// Light or dark; on paper always light.
import { effect, signal } from '@preact/signals';

export const dark = signal(typeof matchMedia !== 'undefined' && matchMedia('(prefers-color-scheme: dark)').matches);

const wear = (theme: 'dark' | 'light'): void => void (document.documentElement.dataset.theme = theme);

/** Keeps the page in its theme. Listens to printing before all others: they draw in the colours of the paper. */
export function startTheme(): void {
  effect(() => wear(dark.value ? 'dark' : 'light'));
  addEventListener('beforeprint', () => wear('light'));
  addEventListener('afterprint', () => wear(dark.value ? 'dark' : 'light'));
}
