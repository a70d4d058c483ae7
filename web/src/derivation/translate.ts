// Sentences of the engine's derivation in the page's language. Formulas in them are carried over in their order.
import { strings } from '../strings';

const placeholder = (k: number): string => `{${k}}`;

/** The sentence in the page's language; as it is where there is no translation. */
export function translated(sentence: string): string {
  const formulas: string[] = [];
  const pattern = sentence
    .replace(/\$[^$]*\$|`[^`]*`/g, (formula) => placeholder(formulas.push(formula) - 1))
    .replace(/rounded to \d+ significant/, (words) => `rounded to ${placeholder(formulas.push(/\d+/.exec(words)![0]) - 1)} significant`);
  const found = strings.value.derivation[pattern];
  return found === undefined ? sentence : found.replace(/\{(\d+)\}/g, (_, k: string) => formulas[Number(k)]!);
}
