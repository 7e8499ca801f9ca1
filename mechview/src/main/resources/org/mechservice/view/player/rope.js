// The way of a rope, as `RopeWay` has it for the position at the start: straight parts, and arcs on
// pulleys, spheres and cylinders. The number of points does not depend on the position.

import { placed } from './recording.js';
import { add, cross, dot, norm, scale, subtract, turned, turnedBack, unit } from './space.js';

const PARTS = 16;
const STEPS = Array.from({ length: PARTS + 1 }, (_, i) => i);

// Lines in world axes, one more than the rope has branches.
export function ropeLines(rope, poses) {
  const lines = [];
  let section = [];
  for (const stop of rope.stops) {
    if (stop.kind === 'branch') {
      section = [];
      continue;
    }
    section.push(stop);
    if (stop.kind === 'eye') {
      const at = placed(poses, stop.at);
      if (section.length === 1) {
        lines.push([at]);
      } else {
        lines[lines.length - 1].push(...passedBy(rope, section, poses), at);
        section = [stop];
      }
    }
  }
  return lines;
}

// The points between the eyes at both ends of a section.
function passedBy(rope, section, poses) {
  if (section.length < 3) {
    return [];
  }
  const from = placed(poses, section[0].at);
  const to = placed(poses, section[section.length - 1].at);
  return section[1].kind === 'around'
    ? wayAround(from, section[1], to, poses) : wayOverPulleys(rope.plane, section, poses);
}

const onStraight = (from, to) =>
  STEPS.map(i => add(from, scale(subtract(to, from), (i + 1) / (PARTS + 2))));

function wayAround(from, shape, to, poses) {
  const r = shape.radius;
  const centre = placed(poses, shape.at);
  const axis = turned(poses(shape.at[0]).q, shape.axis);
  const [ha, hb] = [from, to].map(end => dot(subtract(end, centre), axis));
  const a = subtract(subtract(from, centre), scale(axis, ha));
  const b = subtract(subtract(to, centre), scale(axis, hb));
  const normal = cross(a, b);
  const psi = Math.atan2(norm(normal), dot(a, b));
  const [ta, tb] = [a, b].map(end => Math.sqrt(Math.max(0, dot(end, end) - r * r)));
  const [betaA, betaB] = [Math.atan2(ta, r), Math.atan2(tb, r)];
  const short = psi - betaA - betaB;
  const outside = norm(a) >= r && norm(b) >= r;
  const first = unit(a);
  let second = unit(cross(normal, first));
  if (norm(second) === 0) {
    second = unit(cross(first, Math.abs(first[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0]));
  }
  const radial = angle => add(scale(first, r * Math.cos(angle)), scale(second, r * Math.sin(angle)));
  if (shape.inside) {
    if (!outside || short > 0) {
      return onStraight(from, to);
    }
    const touch = radial(touchingAngle(norm(a), norm(b), psi, r));
    const [la, lb] = [norm(subtract(touch, a)), norm(subtract(touch, b))];
    const at = add(add(centre, touch), scale(axis, ha + (hb - ha) * la / (la + lb)));
    return STEPS.map(() => at);
  }
  const long = shape.sides.some(side => isOpposite(subtract(placed(poses, side), centre), a, b));
  if (!outside || (!long && short < 0)) {
    return onStraight(from, to);
  }
  const begin = long ? -betaA : betaA;
  const arc = long ? -(2 * Math.PI - psi - betaA - betaB) : short;
  const whole = ta + tb + r * Math.abs(arc);
  return STEPS.map(i => {
    const done = arc * i / PARTS;
    const height = ha + (hb - ha) * (ta + r * Math.abs(done)) / whole;
    return add(add(centre, radial(begin + done)), scale(axis, height));
  });
}

// Whether a side lies opposite the angle between a and b.
function isOpposite(side, a, b) {
  const size = 1e-12 * norm(side);
  const [aa, bb, ab] = [dot(a, a), dot(b, b), dot(a, b)];
  const alongA = dot(side, a) * bb - dot(side, b) * ab + size * norm(a) * bb;
  const alongB = dot(side, b) * aa - dot(side, a) * ab + size * norm(b) * aa;
  return Math.max(alongA, alongB) <= 0;
}

// The angle from the first end to where a string in a ring touches it: `TouchingPoint`.
function touchingAngle(l1, l2, psi, radius) {
  const [a, b] = [radius / l1, radius / l2];
  let u = Math.PI / 2;
  for (let i = 0; i < 100; i++) {
    const [sine, cosine] = [Math.sin(u), Math.cos(u)];
    const f = psi - 2 * u + Math.asin(a * sine) + Math.asin(b * sine);
    const slope = -2 + a * cosine / Math.sqrt(1 - (a * sine) ** 2)
      + b * cosine / Math.sqrt(1 - (b * sine) ** 2);
    const next = u - f / slope;
    if (Math.abs(f) <= 1e-9 || !(next < u)) {
      break;
    }
    u = next;
  }
  return u - Math.asin(a * Math.sin(u));
}

// Arcs on the pulleys that are touched, in the axes of their plane.
function wayOverPulleys(plane, section, poses) {
  const body = poses(plane.body);
  const origin = add(body.p, turned(body.q, plane.at.slice(0, 3)));
  const inPlane = point => turnedBack(plane.at.slice(3), turnedBack(body.q, subtract(point, origin)));
  const inWorld = point => add(origin, turned(body.q, turned(plane.at.slice(3), point)));
  const centres = section.map(stop => inPlane(placed(poses, stop.at)));
  const signed = section.map(stop => (stop.kind === 'pulley' ? (stop.left ? 1 : -1) * stop.radius : 0));
  const along = (i, j) => {
    const [dx, dy] = subtract(centres[j], centres[i]);
    const delta = signed[j] - signed[i];
    const tangent = Math.sqrt(Math.max(1e-30, dx * dx + dy * dy - delta * delta));
    return unit([tangent * dx + delta * dy, tangent * dy - delta * dx, 0]);
  };
  let passed = section.map((_, i) => i);
  const angle = k => {
    const [u, w] = [along(passed[k - 1], passed[k]), along(passed[k], passed[k + 1])];
    return Math.PI / 2
      + Math.atan2(-dot(u, w), Math.sign(signed[passed[k]]) * cross(u, w)[2]);
  };
  for (let k = 1; k < passed.length - 1; k++) {
    if (!section[passed[k]].held && angle(k) < 0) {
      // the rope has left it; what it touches is sought anew
      passed = passed.filter((_, i) => i !== k);
      k = 0;
    }
  }
  const points = [];
  for (let k = 1; k < passed.length - 1; k++) {
    const radius = signed[passed[k]];
    const u = along(passed[k - 1], passed[k]);
    const begin = Math.atan2(-radius * u[0], radius * u[1]);
    const turn = Math.sign(radius) * angle(k);
    for (const i of STEPS) {
      const at = begin + turn * i / PARTS;
      points.push(inWorld(add(centres[passed[k]],
        scale([Math.cos(at), Math.sin(at), 0], Math.abs(radius)))));
    }
  }
  while (points.length < (section.length - 2) * (PARTS + 1)) {
    // pulleys that are left have their points at the end
    points.push(inWorld(centres[centres.length - 1]));
  }
  return points;
}
