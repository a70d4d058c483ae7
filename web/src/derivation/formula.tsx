// Formulas, set by KaTeX on this page's own fonts.
import katex from 'katex';
import { useEffect, useRef } from 'preact/hooks';
import { language } from '../strings';

/** KaTeX writes numbers as they stand; where decimals have a comma, it must not be set like one in a list. */
function localized(tex: string): string {
  return language.value === 'de' ? tex.replace(/(\d)\.(\d)/g, '$1{,}$2').replace(/, /g, ';\\, ') : tex;
}

export function Formula({ tex, display }: { tex: string; display?: boolean }) {
  const place = useRef<HTMLSpanElement>(null);
  const text = localized(tex);
  useEffect(() => {
    katex.render(text, place.current!, { displayMode: display, throwOnError: false, output: 'htmlAndMathml', strict: 'ignore' });
  }, [text, display]);
  return <span ref={place} class={display ? 'formula display' : 'formula'} />;
}
