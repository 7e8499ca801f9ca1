// Draws a mechanism in any position, by the surfaces and the camera of the player.

import { Camera } from './player/camera.js';
import { Canvas3D } from './player/canvas3d.js';
import { bytesOf, placed } from './player/recording.js';
import { add, norm, poseMatrix, scale, spanMatrix, subtract, turned, unit } from './player/space.js';

const colour = (number, opacity = 1) =>
  [(number >> 16 & 255) / 255, (number >> 8 & 255) / 255, (number & 255) / 255, opacity];

// A four-sided rod of length and width 1 along z.
const ROD = [
  new Float32Array([1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0, 1, 0, 1, 0, 1, 1, -1, 0, 1, 0, -1, 1]),
  new Uint32Array([0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7]),
];

export class MechanismStage {
  constructor(canvas) {
    this.canvas = canvas;
    this.picture = new Canvas3D(canvas);
    this.view = 'iso';
  }

  get works() {
    return Boolean(this.picture.gl);
  }

  show(data) {
    this.data = data;
    this.root = { p: data.root.slice(0, 3), q: data.root.slice(3) };
    const up = norm(data.gravity) > 0 ? unit(scale(data.gravity, -1)) : [0, 0, 1];
    this.up = up;
    this.camera = new Camera(up);
    if (this.works) {
      this.rod = this.picture.mesh(...ROD);
      this.parts = data.parts.map(part => {
        const corners = new Float32Array(bytesOf(part.corners));
        return { ...part, points: corners,
          mesh: this.picture.mesh(corners, new Uint32Array(bytesOf(part.triangles))) };
      });
      this.around = this.boxes();
    }
    this.look(this.view);
  }

  look(view) {
    this.view = view;
    if (this.data) {
      this.camera.look(view);
      this.fitted = 0;
    }
  }

  poses(row) {
    return body => {
      const at = body < 0 ? -1 : this.data.bodies[body].pose;
      return at < 0 ? this.root
        : { p: subtract(row.slice(at, at + 3), this.data.origin), q: row.slice(at + 3, at + 7) };
    };
  }

  // Boxes around the surfaces of each body; planes without ends are left out.
  boxes() {
    const boxes = new Map();
    for (const { body, role, points } of this.parts) {
      if (role === 'SURFACE') {
        continue;
      }
      const box = boxes.get(body) || { least: [1e300, 1e300, 1e300], most: [-1e300, -1e300, -1e300] };
      boxes.set(body, box);
      points.forEach((x, i) => {
        box.least[i % 3] = Math.min(box.least[i % 3], x);
        box.most[i % 3] = Math.max(box.most[i % 3], x);
      });
    }
    return boxes;
  }

  // Keeps all places in sight that the bodies have come to.
  fit(rows) {
    const step = Math.max(1, Math.floor(rows.length / 40));
    const points = [];
    for (let i = 0; i < rows.length; i += step) {
      const poses = this.poses(rows[i]);
      for (const [body, box] of this.around) {
        const pose = poses(body);
        for (let k = 0; k < 8; k++) {
          const corner = [0, 1, 2].map(axis => (k >> axis & 1 ? box.most[axis] : box.least[axis]));
          const place = add(pose.p, turned(pose.q, corner));
          if (place.every(Number.isFinite)) {
            points.push(place);
          }
        }
      }
      for (const link of this.data.links) {
        const ends = [placed(poses, link.from), placed(poses, link.to)];
        points.push(...ends.filter(end => end.every(Number.isFinite)));
      }
    }
    this.camera.fit(points.length ? points : [[0, 0, 0]]);
  }

  draw(row, rows) {
    if (!this.works || !this.data) {
      return;
    }
    const style = getComputedStyle(document.documentElement).getPropertyValue('--scene').trim();
    this.camera.aspect = this.picture.begin(colour(parseInt(style.slice(1), 16)).slice(0, 3));
    const key = `${rows.length} ${this.camera.aspect}`;
    if (this.fitted !== key) {
      this.fitted = key;
      this.fit(rows);
    }
    const light = unit(add(add(this.up, scale(this.camera.right, -0.35)), scale(this.camera.back, 0.3)));
    this.picture.look(this.camera.matrix(), light, this.up, this.camera.axes().z);
    const poses = this.poses(row);
    const draw = part => {
      const pose = poses(part.body);
      this.picture.drawMesh(part.mesh, poseMatrix(pose.p, pose.q), colour(part.colour, part.opacity));
    };
    this.parts.filter(part => part.opacity >= 1).forEach(draw);
    for (const link of this.data.links) {
      const [from, to] = [placed(poses, link.from), placed(poses, link.to)];
      if (norm(subtract(to, from)) > 0) {
        this.picture.drawMesh(
          this.rod, spanMatrix(from, to, 0.012 * this.data.extent), colour(link.colour));
      }
    }
    this.parts.filter(part => part.opacity < 1).forEach(draw);
  }
}
