// Where the engine comes from in the page of one file: that file.
import data from '../../../build/wasm/web/engine/carom.wasm?url';

export function loadModule(): Promise<WebAssembly.Module> {
  const letters = atob(data.slice(data.indexOf(',') + 1));
  return WebAssembly.compile(Uint8Array.from(letters, (letter) => letter.charCodeAt(0)));
}
