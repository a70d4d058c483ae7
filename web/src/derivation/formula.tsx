// Formulas, set by KaTeX on this page's own fonts.
import katex from 'katex';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { language } from '../strings';

/** KaTeX writes numbers as they stand; where decimals have a comma, it must not be set like one in a list. */
function localized(tex: string): string {
  return language.value === 'de' ? tex.replace(/(\d)\.(\d)/g, '$1{,}$2').replace(/, /g, ';\\, ') : tex;
}

/** Pieces of a formula between top-level relations: a, = b, ≈ c. */
export function membersOf(tex: string): string[] {
  const members: string[] = [];
  let depth = 0;
  let start = 0;
  for (let k = 0; k < tex.length; ++k) {
    if (tex[k] === '{' || tex.startsWith('\\langle', k)) ++depth;
    if (tex[k] === '}' || tex.startsWith('\\rangle', k)) --depth;
    if (depth === 0 && k > start && /^ (=|\\approx) /.test(tex.slice(k, k + 9))) {
      members.push(tex.slice(start, k).trim());
      start = k;
    }
  }
  return [...members, tex.slice(start).trim()];
}

/** Of a row "Disk 1:  m = 1  R = 0.5 …" its label and what stands in it; undefined for all else. */
function rowOf(tex: string): { label: string; items: string[] } | undefined {
  const body = tex.replace(/\\(begin|end)\{aligned\}\n?/g, '').trim();
  const label = /^\\text\{[^}]*:\}/.exec(body)?.[0];
  if (!label) return undefined;
  const items = body.slice(label.length).split(/ ?\\quad (?:& )?| ?\\\\\n(?:& )?/);
  return { label, items: items.map((item) => item.trim()).filter((item) => item !== '') };
}

/** With every member of a chain of equations, or all that stands in a row, on a line of its own. */
export function broken(tex: string): string {
  const row = rowOf(tex);
  if (row) return `\\begin{aligned}\n${row.label} \\quad ${row.items.map((item) => `& ${item}`).join(' \\\\\n')}\n\\end{aligned}`;
  const tag = /\\tag\{[^}]*\}/.exec(tex)?.[0] ?? '';
  const body = tex.replace(tag, '').replace(/\\(begin|end)\{aligned\}/g, '').replace(/ ?\\\\\n/g, ' ').replace(/&/g, '').replace(/\s+/g, ' ');
  const [first, ...others] = membersOf(body.trim());
  if (others.length < 2) return tex;
  const lines = others.map((member, k) => `${k === 0 ? first : ''} &${member}`);
  return `\\begin{aligned}\n${lines.join(' \\\\\n')}\n\\end{aligned} ${tag}`;
}

export function Formula({ tex, display }: { tex: string; display?: boolean }) {
  const place = useRef<HTMLSpanElement>(null);
  const text = localized(tex);
  useLayoutEffect(() => {
    const set = (source: string): void =>
      katex.render(source, place.current!, { displayMode: display, throwOnError: false, output: 'htmlAndMathml', strict: 'ignore' });
    set(text);
    if (!display) return;
    const frame = place.current!.parentElement!;
    const overflows = (): boolean => frame.scrollWidth > frame.clientWidth + 1;
    place.current!.style.fontSize = '';
    if (overflows()) set(broken(text));
    if (overflows()) place.current!.style.fontSize = `${Math.max(0.75, frame.clientWidth / frame.scrollWidth)}em`;
  }, [text, display]);
  return <span ref={place} class={display ? 'formula display' : 'formula'} />;
}
