// Which panel stands beside the picture.
import { signal } from '@preact/signals';

export const panel = signal<'controls' | 'derivation'>('controls');
