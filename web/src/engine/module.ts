// The engine: carom's own C++ compiled to WebAssembly, and how numbers and text go in and out.

type Exports = Record<string, (...numbers: number[]) => number> & { memory: WebAssembly.Memory };

/** What the engine refuses, with its reasons, one per line. */
export class EngineError extends Error {}

/** One instance of the engine. Not shared between threads. */
export class Engine {
  private readonly decoder = new TextDecoder();
  private readonly encoder = new TextEncoder();

  private constructor(
    private readonly module: WebAssembly.Module,
    private readonly exports: Exports,
  ) {}

  static async start(module: WebAssembly.Module): Promise<Engine> {
    let memory: WebAssembly.Memory | undefined;
    const instance = await WebAssembly.instantiate(module, imports(() => memory!));
    const exports = instance.exports as unknown as Exports;
    memory = exports.memory;
    exports._initialize!();
    return new Engine(module, exports);
  }

  /** One more, with a memory of its own. */
  another(): Promise<Engine> {
    return Engine.start(this.module);
  }

  /** Calls carom_NAME. */
  call(name: string, ...numbers: number[]): number {
    return this.exports[`carom_${name}`]!(...numbers);
  }

  /** The same for functions that answer 0 (or −1, see `failed`) where something is wrong. */
  tryCall(name: string, failed: number, ...numbers: number[]): number {
    const result = this.call(name, ...numbers);
    if (result === failed) throw new EngineError(this.text());
    return result;
  }

  /** A copy of `count` numbers that the engine answered with. */
  numbers(name: string, count: number, ...args: number[]): Float64Array {
    return this.view(this.tryCall(name, 0, ...args), count).slice();
  }

  /** Numbers in the engine's memory; valid until it is called again. */
  view(address: number, count: number): Float64Array {
    return new Float64Array(this.exports.memory.buffer, address, count);
  }

  integers(address: number, count: number): BigInt64Array {
    return new BigInt64Array(this.exports.memory.buffer, address, count);
  }

  setInput(text: string): void {
    const bytes = this.encoder.encode(text);
    const address = this.call('input', bytes.length);
    new Uint8Array(this.exports.memory.buffer, address, bytes.length).set(bytes);
  }

  text(): string {
    const address = this.call('text');
    return this.decoder.decode(new Uint8Array(this.exports.memory.buffer, address, this.call('text_size')));
  }
}

/** The few functions of the system that the engine asks for: a clock for its timings, and an empty environment. */
function imports(memory: () => WebAssembly.Memory): WebAssembly.Imports {
  const setWord = (address: number, value: number): void => {
    new DataView(memory().buffer).setUint32(address, value, true);
  };
  return {
    env: { emscripten_notify_memory_growth: () => undefined },
    wasi_snapshot_preview1: {
      proc_exit: (code: number) => {
        throw new EngineError(`the engine stopped (${code})`);
      },
      environ_sizes_get: (count: number, size: number) => (setWord(count, 0), setWord(size, 0), 0),
      environ_get: () => 0,
      clock_time_get: (_clock: number, _precision: bigint, address: number) => {
        new DataView(memory().buffer).setBigUint64(address, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
    },
  };
}
