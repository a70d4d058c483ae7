// Which vectors of the picture a step of the derivation speaks of.
import type { Focus } from '../lab/view';
import type { Step } from './document';

const byHeading: [RegExp, Focus[]][] = [
  [/given/, ['v']],
  [/normal and the tangent$/, ['lines', 'units', 'v']],
  [/velocities along/, ['lines', 'v', 'vn', 'vt']],
  [/approach/, ['lines', 'vn']],
  [/collision along/, ['lines', 'vn', 'vnf']],
  [/tangential parts/, ['lines', 'vt']],
  [/Back to vectors/, ['lines', 'vnf', 'vt', 'vf']],
  [/at once/, ['v', 'vf']],
  [/check/, ['lines', 'J', 'v', 'vf']],
  [/velocities stay/, ['v']],
  [/double precision/, ['v', 'vf']],
];

/** Of a step whose heading is the engine's own. */
export function focusOf(step: Step | undefined): ReadonlySet<Focus> {
  const names = byHeading.find(([pattern]) => step && pattern.test(step.heading))?.[1] ?? ['v'];
  if (!step?.heading.includes('normal and the tangent') || step.heading.includes('along')) return new Set(names);
  return new Set<Focus>(['lines', 'units', 'v']);
}
