import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const from = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
  resolve: { alias: { '#load': from('./src/engine/load.ts'), '#worker': from('./tests/no-worker.ts') } },
  test: { include: ['tests/**/*.test.ts'], testTimeout: 120000, hookTimeout: 120000, fileParallelism: false },
});
