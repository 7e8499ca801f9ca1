// Vectors, unit quaternions [e0, e1, e2, e3] with the scalar first, and 4x4 matrices by columns.

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const norm = a => Math.hypot(a[0], a[1], a[2]);

export const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

export function unit(a) {
  const length = norm(a);
  return length > 0 ? scale(a, 1 / length) : [0, 0, 0];
}

export function turned(q, v) {
  const e = [q[1], q[2], q[3]];
  return add(v, scale(cross(e, add(cross(e, v), scale(v, q[0]))), 2));
}

// The rotation at a share of the way from a to b, at constant angular velocity.
export function between(a, b, share) {
  let cos = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const sign = cos < 0 ? -1 : 1;
  cos = Math.min(1, Math.abs(cos));
  const angle = Math.acos(cos);
  const near = angle < 1e-4;
  const wa = near ? 1 - share : Math.sin((1 - share) * angle) / Math.sin(angle);
  const wb = sign * (near ? share : Math.sin(share * angle) / Math.sin(angle));
  const q = a.map((x, i) => wa * x + wb * b[i]);
  const length = Math.hypot(...q) || 1;
  return q.map(x => x / length);
}

export function poseMatrix(p, q) {
  const x = turned(q, [1, 0, 0]);
  const y = turned(q, [0, 1, 0]);
  const z = turned(q, [0, 0, 1]);
  return new Float32Array([...x, 0, ...y, 0, ...z, 0, ...p, 1]);
}

// Takes the z axis to the way between two points and keeps lengths across it times `width`.
export function spanMatrix(from, to, width) {
  const way = subtract(to, from);
  const z = unit(way);
  const side = Math.abs(z[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
  const x = unit(cross(side, z));
  const y = cross(z, x);
  return new Float32Array([
    ...scale(x, width), 0, ...scale(y, width), 0, ...way, 0, ...from, 1]);
}

export function product(a, b) {
  const m = new Float32Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) {
        sum += a[4 * k + row] * b[4 * column + k];
      }
      m[4 * column + row] = sum;
    }
  }
  return m;
}
