// What is kept: momenta tip to tail, energies as bars, and what is left over to the last digit.
import type { Vec } from '../engine/playback';
import { inFull, shown, shownToAddUp, strings } from '../strings';
import { Arrow } from './arrow';
import { anatomy, collisionShown, disksNow, setup } from './model';

const width = 320;
const height = 170;

interface Chain {
  arrows: { from: Vec; by: Vec }[];
  total: Vec;
}

/** Arrows set tip to tail from the origin. */
function chain(momenta: Vec[]): Chain {
  let at = { x: 0, y: 0 };
  const arrows = momenta.map((by) => {
    const from = at;
    at = { x: at.x + by.x, y: at.y + by.y };
    return { from, by };
  });
  return { arrows, total: at };
}

export function MomentumDiagram() {
  const words = strings.value;
  const of = (disks: { mass: number; vx: number; vy: number }[]): Vec[] =>
    disks.map(({ mass, vx, vy }) => ({ x: mass * vx, y: mass * vy }));
  const now = chain(of(disksNow.value));
  const first = chain(of(setup.value.disks));
  const ends = [...now.arrows, ...first.arrows].flatMap(({ from, by }) => [from, { x: from.x + by.x, y: from.y + by.y }]);
  const range = (axis: 'x' | 'y'): [number, number] => [Math.min(0, ...ends.map((p) => p[axis])), Math.max(0, ...ends.map((p) => p[axis]))];
  const [left, right] = range('x');
  const [bottom, top] = range('y');
  const zoom = Math.min((width - 90) / (right - left || 1), (height - 70) / (top - bottom || 1));
  const place = (p: Vec): Vec => ({
    x: width / 2 + (p.x - (left + right) / 2) * zoom,
    y: height / 2 - (p.y - (bottom + top) / 2) * zoom,
  });
  const flipped = (p: Vec): Vec => ({ x: p.x * zoom, y: -p.y * zoom });
  const origin = place({ x: 0, y: 0 });
  return (
    <figure class="diagram">
      <figcaption>{words.momentumDiagram}</figcaption>
      <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-label={words.totalMomentumIs(shown(now.total.x), shown(now.total.y))}>
        <circle class="origin" cx={origin.x} cy={origin.y} r="3" />
        <g class="thin">
          {now.arrows.map(({ from, by }, k) => (
            <Arrow key={k} kind="momentum" from={place(from)} by={flipped(by)} name={['p', `${k + 1}`]} />
          ))}
          <Arrow kind="unit" from={origin} by={flipped(now.total)} name={['Σp', '']} side={-1} />
        </g>
      </svg>
    </figure>
  );
}

export function EnergyBars() {
  const words = strings.value;
  const energyOf = ({ mass, vx, vy }: { mass: number; vx: number; vy: number }): number => 0.5 * mass * (vx * vx + vy * vy);
  const now = disksNow.value.map(energyOf);
  const atStart = setup.value.disks.reduce((sum, disk) => sum + energyOf(disk), 0);
  const most = Math.max(atStart, ...[now.reduce((sum, part) => sum + part, 0)]) || 1;
  const { parts, total } = shownToAddUp(now);
  return (
    <figure class="diagram energy">
      <figcaption>{words.energy}</figcaption>
      <div class="bar" role="img" aria-label={words.energyIs(shown(total), shown(atStart))}>
        {now.map((energy, k) => (
          <span key={k} class={`part disk-${k % 6}`} style={{ width: `${(100 * energy) / most}%` }}>
            {energy / most > 0.07 ? k + 1 : ''}
          </span>
        ))}
        {atStart < most * 1.0001 && total < atStart * 0.9999 && <span class="lost" style={{ width: `${100 * (1 - now.reduce((a, b) => a + b, 0) / most)}%` }} />}
      </div>
      <p class="sum">
        {parts.length <= 6 ? `${parts.map((part) => shown(part)).join(' + ')} = ` : ''}
        <strong>{shown(total)}</strong>
        {total < atStart - 0.005 ? ` ${words.ofAtStart(shown(atStart))}` : ''}
      </p>
    </figure>
  );
}

/** Sums before and after the collision shown, with every digit that a double has. */
export function Residuals() {
  const words = strings.value;
  const parts = anatomy.value;
  const collision = collisionShown.value;
  if (!parts || !collision) return <p class="note">{words.noCollision}</p>;
  const rows: [string, number, number][] = [
    ['Px', parts.momentumBefore.x, parts.momentumAfter.x],
    ['Py', parts.momentumBefore.y, parts.momentumAfter.y],
    ['K', parts.energyBefore, parts.energyAfter],
  ];
  return (
    <details class="residuals">
      <summary>{words.residuals(collision.i + 1, collision.j + 1)}</summary>
      <div class="scroller" tabindex={0} role="group" aria-label={words.residuals(collision.i + 1, collision.j + 1)}>
        <table>
          {rows.map(([name, before, after]) => (
            <tbody key={name} data-residual={name}>
              {([[words.before, before], [words.after, after], [words.difference, Number((after - before).toPrecision(3))]] as const).map(([when, value]) => (
                <tr key={when} class={when === words.difference ? 'difference' : ''}>
                  <th scope="row">
                    {name[0]}
                    <sub>{name[1] ?? ''}</sub> {when}
                  </th>
                  <td>{inFull(value)}</td>
                </tr>
              ))}
            </tbody>
          ))}
        </table>
      </div>
      <p class="note">{setup.value.restitution === 1 ? words.residualNote : words.residualNoteLossy}</p>
    </details>
  );
}
