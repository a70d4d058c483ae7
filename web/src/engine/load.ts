// Where the engine comes from: the file beside the page.
import url from '../../../build/wasm/web/engine/carom.wasm?url';

export function loadModule(): Promise<WebAssembly.Module> {
  return WebAssembly.compileStreaming(fetch(url));
}
