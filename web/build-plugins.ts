// What Vite does not do by itself: the page's security policy, and the page of one file.
import { createHash } from 'node:crypto';
import type { Plugin } from 'vite';

/** Nothing may be loaded from elsewhere, and no code be made from text, but WebAssembly be compiled. */
export function policyOf(scripts: string, styles: string, connections: string, fonts: string): string {
  return [
    "default-src 'none'",
    `script-src ${scripts} 'wasm-unsafe-eval'`,
    `style-src ${styles}`,
    `connect-src ${connections}`,
    `font-src ${fonts}`,
    "img-src 'self' data: blob:",
    "worker-src 'self' blob:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

const withPolicy = (html: string, text: string): string =>
  html.replace('<meta charset="utf-8" />', `<meta charset="utf-8" />\n    <meta http-equiv="Content-Security-Policy" content="${text}" />`);

/** The policy of the page of several files; `carom lab` sends the same as a header. */
export function policy(): Plugin {
  return {
    name: 'policy',
    apply: 'build',
    transformIndexHtml: { order: 'post', handler: (html) => withPolicy(html, policyOf("'self'", "'self'", "'self'", "'self'")) },
  };
}

const hashOf = (text: string): string => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/** Script and style go into the page, whose policy names them by their hashes. */
export function singleFile(): Plugin {
  return {
    name: 'single-file',
    apply: 'build',
    enforce: 'post',
    generateBundle(_, bundle) {
      const page = bundle['index.html'];
      if (page?.type !== 'asset') throw new Error('there is no index.html');
      let html = String(page.source);
      const hashes = { script: '', style: '' };
      for (const [name, part] of Object.entries(bundle)) {
        if (part === page) continue;
        if (part.type === 'chunk') {
          const code = part.code.replaceAll('</script', '<\\/script');
          hashes.script = hashOf(code);
          html = html.replace(/<script type="module"[^>]*><\/script>/, '');
          html = html.replace('</body>', () => `<script type="module">${code}</script>\n  </body>`);
        } else if (name.endsWith('.css')) {
          const style = String(part.source);
          hashes.style = hashOf(style);
          html = html.replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${style}</style>`);
        }
        delete bundle[name];
      }
      page.source = withPolicy(html, policyOf(hashes.script, hashes.style, "'none'", 'data:'));
      page.fileName = 'carom-lab.html';
    },
  };
}

/** Of KaTeX's three formats of every font, the one that all browsers with WebAssembly read. */
export function oneFontFormat(): Plugin {
  return {
    name: 'one-font-format',
    enforce: 'pre',
    transform(code, id) {
      if (!/katex[^/]*\.css$/.test(id)) return null;
      return { code: code.replace(/,url\([^)]*\.(woff|ttf)\) format\("[a-z]+"\)/g, ''), map: null };
    },
  };
}
