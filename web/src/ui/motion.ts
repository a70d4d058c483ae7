// Whether the user wants things to move little.
import { signal } from '@preact/signals';

const query = typeof matchMedia === 'undefined' ? undefined : matchMedia('(prefers-reduced-motion: reduce)');

export const reducedMotion = signal(query?.matches ?? false);
query?.addEventListener('change', () => (reducedMotion.value = query.matches));
