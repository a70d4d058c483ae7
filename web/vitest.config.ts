import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const from = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
  resolve: { alias: { '#load': from('./src/engine/load.ts'), '#worker': from('./tests/no-worker.ts') } },
  // Once more where a browser without a graphics card got no processor for half a minute.
  test: { include: ['tests/**/*.test.ts'], testTimeout: 120000, hookTimeout: 120000, fileParallelism: false, retry: 1 },
});
