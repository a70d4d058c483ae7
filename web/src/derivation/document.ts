// The derivation as the engine writes it in Markdown, taken into steps and blocks for the page.

export type Run = { kind: 'words' | 'code' | 'formula'; text: string };
export type Block = { kind: 'paragraph'; runs: Run[] } | { kind: 'formula'; tex: string } | { kind: 'listing'; text: string };

export interface Step {
  heading: string;
  blocks: Block[];
}

/** Words, `code` and $formulas$ of one line. */
export function runsOf(line: string): Run[] {
  const runs: Run[] = [];
  for (const [, code, formula, words] of line.matchAll(/`([^`]*)`|\$([^$]*)\$|([^`$]+)/g)) {
    if (code !== undefined) runs.push({ kind: 'code', text: code });
    else if (formula !== undefined) runs.push({ kind: 'formula', text: formula });
    else runs.push({ kind: 'words', text: words! });
  }
  return runs;
}

/** Sections, paragraphs, displayed formulas and listings: all that a derivation has. */
export function stepsOf(markdown: string): Step[] {
  const steps: Step[] = [];
  const lines = markdown.split('\n');
  for (let k = 0; k < lines.length; ++k) {
    const line = lines[k]!;
    const upTo = (end: string): string => {
      const from = k + 1;
      k = lines.indexOf(end, from);
      return lines.slice(from, k).join('\n');
    };
    if (line.startsWith('## ')) {
      steps.push({ heading: line.replace(/^## \d+\. /, ''), blocks: [] });
    } else if (steps.length > 0 && line !== '') {
      const blocks = steps[steps.length - 1]!.blocks;
      if (line === '$$') blocks.push({ kind: 'formula', tex: upTo('$$') });
      else if (line.startsWith('```')) blocks.push({ kind: 'listing', text: upTo('```') });
      else blocks.push({ kind: 'paragraph', runs: runsOf(line) });
    }
  }
  return steps;
}
