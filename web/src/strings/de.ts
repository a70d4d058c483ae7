import type { Strings } from './index';
import { en } from './en';
export const de: Strings = { ...en, name: 'Deutsch' };
