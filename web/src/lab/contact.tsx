// The collision that is taken apart, drawn where it happens: lines, ghosts, parts and impulse.
import type { Vec } from '../engine/playback';
import { Arrow } from './arrow';
import { anatomy, collisionIs, collisionShown, disksAtCollision, disksNow, setup } from './model';
import { arrowOf, arrowOfPart, focus, observer, pictureWidth, scale, show, toPicture, toPictureThen } from './view';

const times = (factor: number, v: Vec): Vec => ({ x: factor * v.x, y: factor * v.y });
const plus = (a: Vec, b: Vec): Vec => ({ x: a.x + b.x, y: a.y + b.y });

/** A place of the collision shown, as the frame of reference sees it at that moment. */
const there = (place: Vec): Vec => toPictureThen(place, disksAtCollision.value);

/** Normal and tangent through the point of contact, right across the picture. */
export function Lines() {
  const collision = collisionShown.value;
  const parts = anatomy.value;
  if (!collision || !parts) return null;
  const wanted = focus.value ? focus.value.has('lines') || focus.value.has('units') : show.value.has('lines');
  if (!wanted) return null;
  const point = there(collision.point);
  const ahead = collisionIs.value === 'ahead' && !focus.value;
  const across = (u: Vec, name: string, which: string) => {
    const by = { x: u.x * 2 * pictureWidth, y: -u.y * 2 * pictureWidth };
    const reach = scale.value * (which === 'normal' ? 2 * setup.value.disks[collision.j]!.radius : 0.95 * setup.value.disks[collision.i]!.radius) + 30;
    const label = { x: point.x + u.x * reach - u.y * 14, y: point.y - u.y * reach - Math.abs(u.x) * 14 };
    return (
      <g class={`line ${which}`} aria-hidden="true">
        <line x1={point.x - by.x} y1={point.y - by.y} x2={point.x + by.x} y2={point.y + by.y} />
        <text class="name" x={label.x} y={label.y} text-anchor="middle">
          {name}
        </text>
      </g>
    );
  };
  return (
    <g class={ahead ? 'ahead' : ''}>
      {across(parts.normal, 'n', 'normal')}
      {across(parts.tangent, 't', 'tangent')}
      <circle class="contact-point" cx={point.x} cy={point.y} r="4" />
    </g>
  );
}

/** Outlines of the two disks at contact, where they are not there now. */
export function Outlines() {
  const collision = collisionShown.value;
  if (!collision || collisionIs.value === 'now') return null;
  if (!show.value.has('ghosts') && !focus.value) return null;
  const outline = (at: Vec, disk: number) => {
    const centre = there(at);
    const radius = setup.value.disks[disk]!.radius * scale.value;
    return <circle class={`outline disk-${disk % 6}`} cx={centre.x} cy={centre.y} r={radius} />;
  };
  return (
    <g aria-hidden="true">
      {outline(collision.positionI, collision.i)}
      {outline(collision.positionJ, collision.j)}
    </g>
  );
}

interface Body {
  number: number;
  centre: Vec;
  which: 0 | 1;
  before: Vec;
  after: Vec;
}

/** The two disks at contact, as the picture draws their vectors: from the contact if we are at it or explain it. */
function bodies(): Body[] {
  const collision = collisionShown.value!;
  const at = (which: 0 | 1): Body => ({
    number: which === 0 ? collision.i : collision.j,
    centre: there(which === 0 ? collision.positionI : collision.positionJ),
    which,
    before: which === 0 ? collision.beforeI : collision.beforeJ,
    after: which === 0 ? collision.afterI : collision.afterJ,
  });
  return [at(0), at(1)];
}

/** Vectors of the step of the derivation that is shown, and nothing else. */
export function FocusedVectors() {
  const parts = anatomy.value;
  if (!focus.value || !parts) return null;
  const has = focus.value;
  const along = (body: Body, which: 'before' | 'after', line: 'n' | 't'): Vec =>
    arrowOfPart(times(parts[which][body.which][line], line === 'n' ? parts.normal : parts.tangent));
  return (
    <g>
      {bodies().map((body) => {
        const name = `${body.which + 1}`;
        return (
          <g key={body.number}>
            {has.has('v') && <Arrow kind="velocity-before" from={body.centre} by={arrowOf(body.before)} name={['v', name]} />}
            {has.has('vt') && (
              <Arrow kind="tangential" from={body.centre} by={along(body, 'before', 't')} name={['v', `${name}t`]} side={-1} />
            )}
            {has.has('vn') && <Arrow kind="normal" from={body.centre} by={along(body, 'before', 'n')} name={['v', `${name}n`]} side={-1} />}
            {has.has('vnf') && (
              <Arrow kind="normal" from={body.centre} by={along(body, 'after', 'n')} name={['v', `${name}nf`]} side={-1} />
            )}
            {has.has('vf') && (
              <Arrow kind="velocity" from={body.centre} by={arrowOf(body.after)} name={['v', `${name}f`]} />
            )}
          </g>
        );
      })}
      {has.has('units') &&
        ([parts.normal, parts.tangent] as const).map((u, k) => (
          <Arrow key={`u${k}`} kind="unit" from={there(collisionShown.value!.point)} by={times(110, { x: u.x, y: -u.y })} name={['u', k === 0 ? 'n' : 't']} />
        ))}
      {has.has('J') && <Impulse />}
    </g>
  );
}

/** What each disk gives the other. */
function Impulse() {
  const collision = collisionShown.value!;
  const parts = anatomy.value!;
  const point = there(collision.point);
  const mean = (setup.value.disks[collision.i]!.mass + setup.value.disks[collision.j]!.mass) / 2;
  const by = arrowOfPart(times(1 / mean, parts.impulse));
  return (
    <g>
      <Arrow kind="impulse" from={point} by={by} name={['J', '']} />
      <Arrow kind="impulse" from={point} by={times(-1, by)} name={['−J', '']} />
    </g>
  );
}

/** At the collision: the velocities before, faint; and, if wanted, parts and impulse. */
export function ContactVectors() {
  const parts = anatomy.value;
  if (focus.value || !parts || !collisionShown.value) return null;
  const now = collisionIs.value === 'now';
  return (
    <g>
      {now && show.value.has('ghosts') && show.value.has('velocity') &&
        bodies().map((body) => (
          <Arrow key={body.number} kind="velocity-before" from={body.centre} by={arrowOf(body.before)} name={['v', `${body.number + 1}`]} side={-1} />
        ))}
      {show.value.has('parts') && <Parts />}
      {show.value.has('impulse') && collisionIs.value !== 'ahead' && <Impulse />}
    </g>
  );
}

/** Normal and tangential parts of the velocities now, on the lines of the collision shown. */
function Parts() {
  const collision = collisionShown.value!;
  const { normal, tangent } = anatomy.value!;
  const later = collisionIs.value === 'ahead' ? '' : 'f';
  return (
    <g>
      {[collision.i, collision.j].map((number) => {
        const disk = disksNow.value[number]!;
        const v = { x: disk.vx - observer.value.vx, y: disk.vy - observer.value.vy };
        const centre = toPicture(disk);
        const along = (u: Vec): Vec => arrowOfPart(times(v.x * u.x + v.y * u.y, u));
        const total = plus(centre, plus(along(normal), along(tangent)));
        return (
          <g key={number}>
            <polyline
              class="parallelogram"
              points={[plus(centre, along(normal)), total, plus(centre, along(tangent))].map(({ x, y }) => `${x},${y}`).join(' ')}
            />
            <Arrow kind="normal" from={centre} by={along(normal)} name={['v', `${number + 1}n${later}`]} side={-1} />
            <Arrow kind="tangential" from={centre} by={along(tangent)} name={['v', `${number + 1}t`]} side={-1} />
          </g>
        );
      })}
    </g>
  );
}
