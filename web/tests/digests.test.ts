// Property: the engine compiled to WebAssembly ends with the same bits as the native program, on every scene.
import { describe, expect, it } from 'vitest';
import { carom, startEngine } from './engine';
import { comparedScenes } from './scenes';

describe('digests', async () => {
  const engine = await startEngine();
  for (const scene of comparedScenes()) {
    it(scene.name, () => {
      engine.setInput(scene.text);
      engine.tryCall('gas_open', -1);
      if (scene.until !== undefined) engine.tryCall('gas_run_until', 0, scene.until);
      if (scene.collisions !== undefined) engine.tryCall('gas_run_collisions', 0, scene.collisions);
      engine.tryCall('gas_digest', 0);
      const end = scene.until !== undefined ? ['--until', `${scene.until}`] : ['--collisions', `${scene.collisions}`];
      const native = JSON.parse(carom(['run', '-', ...end, '--json', '--quiet'], scene.text));
      expect(native.collisions).toBeGreaterThan(0);
      expect(engine.text()).toBe(native.digest);
    });
  }
});
