// Which vectors of the picture a step of the derivation speaks of.
import type { Focus } from '../lab/view';
import type { Step } from './document';

/** By the engine's own headings; the first that matches counts. */
const byHeading: [RegExp, Focus[]][] = [
  [/given/, ['v']],
  [/velocities along/, ['lines', 'v', 'vn', 'vt']],
  [/normal and the tangent/, ['lines', 'units', 'v']],
  [/approach/, ['lines', 'vn']],
  [/collision along/, ['lines', 'vn', 'vnf']],
  [/tangential parts/, ['lines', 'vt']],
  [/Back to vectors/, ['lines', 'vnf', 'vt', 'vf']],
  [/at once/, ['v', 'vf']],
  [/check/, ['lines', 'J', 'v', 'vf']],
  [/velocities stay/, ['v']],
  [/double precision/, ['v', 'vf']],
];

export function focusOf(step: Step | undefined): ReadonlySet<Focus> {
  return new Set(byHeading.find(([pattern]) => step && pattern.test(step.heading))?.[1] ?? ['v']);
}
