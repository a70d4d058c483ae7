import { defineConfig, UserConfig } from 'vite';
import { fileURLToPath } from 'node:url';
import { oneFontFormat, policy, singleFile } from './build-plugins';

const from = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** Mode "single" makes carom-lab.html, the whole page in one file. */
export default defineConfig(({ mode }): UserConfig => {
  const single = mode === 'single';
  const way = single ? '-inline' : '';
  return {
    base: './',
    publicDir: false,
    esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
    resolve: {
      alias: { '#load': from(`./src/engine/load${way}.ts`), '#worker': from(`./src/gas/start-worker${way}.ts`) },
    },
    server: { fs: { allow: ['..'] } },
    worker: { format: single ? 'iife' : 'es' },
    build: {
      target: 'es2022',
      outDir: single ? 'dist/single' : 'dist/page',
      assetsInlineLimit: single ? () => true : 0,
      cssCodeSplit: !single,
      modulePreload: false,
      chunkSizeWarningLimit: 1000,
      rollupOptions: single ? { output: { inlineDynamicImports: true } } : {},
    },
    plugins: [oneFontFormat(), single ? singleFile() : policy()],
  };
});
