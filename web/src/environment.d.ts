/// <reference types="vite/client" />

declare module '#load' {
  export function loadModule(): Promise<WebAssembly.Module>;
}
declare module '#worker' {
  export function startWorker(): Worker;
}
