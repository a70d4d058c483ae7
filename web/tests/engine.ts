// The engine in Node, and the native program beside it.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Engine } from '../src/engine/module';

export const root = fileURLToPath(new URL('../..', import.meta.url));
export const wasmFile = process.env.CAROM_WASM ?? `${root}build/wasm/web/engine/carom.wasm`;
export const program = process.env.CAROM_PROGRAM ?? `${root}build/release/apps/carom/carom`;

export function startEngine(): Promise<Engine> {
  return Engine.start(new WebAssembly.Module(readFileSync(wasmFile)));
}

/** What the native program prints. */
export function carom(words: string[], input?: string): string {
  return execFileSync(program, words, { encoding: 'utf8', input, maxBuffer: 1 << 26, stdio: ['pipe', 'pipe', 'pipe'] });
}
