// The page's language: its words, and how it writes numbers.
import { computed, signal } from '@preact/signals';
import { de } from './de';
import { en } from './en';

export type Strings = typeof en;
export const languages = { en, de } as const satisfies Record<string, Strings>;
export type Language = keyof typeof languages;

function preferred(): Language {
  const words = typeof navigator === 'undefined' ? ['en'] : navigator.languages;
  return words.find((word) => word.slice(0, 2) in languages)?.slice(0, 2) as Language | undefined ?? 'en';
}

export const language = signal<Language>(preferred());
export const strings = computed<Strings>(() => languages[language.value]);

/** A number with so many decimals, a true minus sign and the language's decimal mark. */
export function shown(value: number, decimals = 2): string {
  if (!Number.isFinite(value)) return '–';
  const formatter = new Intl.NumberFormat(language.value, {
    minimumFractionDigits: decimals,
    maximumFractionDigits: decimals,
    useGrouping: false,
  });
  const text = formatter.format(value).replace('-', '−');
  return /[1-9]/.test(text) ? text : text.replace('−', '');
}

const raised = (exponent: number): string => [...String(exponent)].map((sign) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(sign)]!).join('');

/** A number that may be far below 1: two digits and a power of ten. */
export function shownSmall(value: number): string {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const [digits, exponent] = value.toExponential(1).split('e').map(Number) as [number, number];
  return `${shown(digits, 1)}·10${raised(exponent)}`;
}

/** A count, with groups of three digits. */
export function counted(value: number): string {
  return new Intl.NumberFormat(language.value).format(value);
}

/** A number with the digits that it has, a true minus sign and the language's decimal mark. */
export function inLanguage(value: number): string {
  return new Intl.NumberFormat(language.value, { maximumSignificantDigits: 12, useGrouping: false }).format(value).replace('-', '−');
}

/** All digits that a double holds. */
export function inFull(value: number): string {
  const [digits, exponent] = String(value + 0).split('e') as [string, string?];
  const text = digits.replace('-', '−') + (exponent === undefined ? '' : `·10${raised(Number(exponent))}`);
  return language.value === 'de' ? text.replace('.', ',') : text;
}

/** What was typed, with a comma or a point, an ordinary or a true minus; NaN if it is no number. */
export function typed(text: string): number {
  const plain = text.trim().replace('−', '-').replace(',', '.');
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
}

/** Numbers rounded so that they add up to the rounded total: what is left over goes where rounding erred most. */
export function shownToAddUp(parts: readonly number[], decimals = 2): { parts: number[]; total: number } {
  const unit = 10 ** decimals;
  const scaled = parts.map((part) => part * unit);
  const rounded = scaled.map(Math.round);
  const total = Math.round(scaled.reduce((sum, part) => sum + part, 0));
  let rest = total - rounded.reduce((sum, part) => sum + part, 0);
  while (rest !== 0) {
    const step = Math.sign(rest);
    const gains = scaled.map((part, k) => step * (part - rounded[k]!));
    const most = gains.indexOf(Math.max(...gains));
    rounded[most]! += step;
    rest -= step;
  }
  return { parts: rounded.map((part) => part / unit), total: total / unit };
}
