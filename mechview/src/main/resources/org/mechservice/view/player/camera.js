import { add, cross, dot, norm, product, scale, subtract, unit } from './space.js';

const FIELD = Math.tan(Math.PI / 10);

export const VIEWS = {
  iso: { yaw: 0.6, pitch: 0.4, flat: false },
  front: { yaw: 0, pitch: 0, flat: true },
  side: { yaw: Math.PI / 2, pitch: 0, flat: true },
  top: { yaw: 0, pitch: Math.PI / 2, flat: true },
};

// Looks at a target from a distance; yaw turns about the upward direction.
export class Camera {
  constructor(up) {
    this.up = up;
    this.right = Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    this.back = unit(cross(this.right, up));
    this.right = cross(up, this.back);
    this.target = [0, 0, 0];
    this.distance = 5;
    this.aspect = 1;
    this.look('iso');
  }

  look(view) {
    Object.assign(this, VIEWS[view]);
  }

  axes() {
    const level = add(
      scale(this.right, Math.sin(this.yaw)), scale(this.back, Math.cos(this.yaw)));
    const z = add(scale(level, Math.cos(this.pitch)), scale(this.up, Math.sin(this.pitch)));
    const x = unit(cross(this.up, level));
    return { x, y: cross(z, x), z };
  }

  // Shows all points.
  fit(points) {
    const { x, y, z } = this.axes();
    const range = axis => {
      let least = Infinity;
      let most = -Infinity;
      for (const point of points) {
        const along = dot(point, axis);
        least = Math.min(least, along);
        most = Math.max(most, along);
      }
      return [(least + most) / 2, (most - least) / 2];
    };
    const [cx, hx] = range(x);
    const [cy, hy] = range(y);
    const [cz, hz] = range(z);
    this.target = add(add(scale(x, cx), scale(y, cy)), scale(z, cz));
    const half = Math.max(hx / this.aspect, hy, 1e-9) * 1.15;
    this.distance = half / FIELD + (this.flat ? 0 : hz);
    this.reach = norm([hx, hy, hz]);
  }

  turn(dx, dy) {
    this.flat = false;
    this.yaw -= dx;
    this.pitch = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, this.pitch + dy));
  }

  // Moves across the view by parts of its height.
  pan(dx, dy) {
    const { x, y } = this.axes();
    const height = 2 * FIELD * this.distance;
    this.target = add(this.target, add(scale(x, -dx * height), scale(y, dy * height)));
  }

  zoom(factor) {
    this.distance *= factor;
  }

  eye() {
    return add(this.target, scale(this.axes().z, this.distance));
  }

  matrix() {
    const { x, y, z } = this.axes();
    const eye = this.eye();
    const view = new Float32Array([
      x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0,
      -dot(x, eye), -dot(y, eye), -dot(z, eye), 1]);
    const far = this.distance + 20 * (this.reach || this.distance);
    const near = this.flat ? -far : Math.max(this.distance * 0.01, far * 1e-4);
    const m = new Float32Array(16);
    const height = FIELD * (this.flat ? this.distance : 1);
    m[0] = 1 / (height * this.aspect);
    m[5] = 1 / height;
    if (this.flat) {
      m[10] = -2 / (far - near);
      m[14] = -(far + near) / (far - near);
      m[15] = 1;
    } else {
      m[10] = -(far + near) / (far - near);
      m[11] = -1;
      m[14] = -2 * far * near / (far - near);
    }
    return product(m, view);
  }

  // The line of sight through a place on the picture, both coordinates from -1 to 1.
  ray(sx, sy) {
    const { x, y, z } = this.axes();
    const height = FIELD * this.distance;
    const across = add(scale(x, sx * height * this.aspect), scale(y, sy * height));
    const through = add(this.target, across);
    const eye = this.flat ? add(through, scale(z, 1e3 * this.distance)) : this.eye();
    return { from: eye, along: unit(subtract(through, eye)) };
  }
}
