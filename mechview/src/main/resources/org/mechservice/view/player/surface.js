import { THREE } from './three.js';
import { bytesOf } from './recording.js';
import { cross, dot, norm, subtract, unit } from './space.js';

// Edges sharper than this stay edges in the shading.
const CREASE = Math.cos(40 * Math.PI / 180);

// A surface of triangles, smooth where faces meet in a flat angle.
export function surface({ corners, triangles }) {
  const geometry = new THREE.BufferGeometry();
  const [places, normals] =
    shaded(new Float32Array(bytesOf(corners)), new Uint32Array(bytesOf(triangles)));
  geometry.setAttribute('position', new THREE.BufferAttribute(places, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(normals, 3));
  geometry.computeBoundingBox();
  geometry.computeBoundingSphere();
  return geometry;
}

// Corners and normals of triangles that share no corner.
function shaded(corners, triangles) {
  const count = triangles.length / 3;
  const faces = [];
  const around = Array.from({ length: corners.length / 3 }, () => []);
  const corner = i => [corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]];
  for (let face = 0; face < count; face++) {
    const [a, b, c] = [0, 1, 2].map(i => corner(triangles[3 * face + i]));
    faces.push(cross(subtract(b, a), subtract(c, a)));
    for (let i = 0; i < 3; i++) {
      around[triangles[3 * face + i]].push(face);
    }
  }
  const sizes = faces.map(norm);
  const places = new Float32Array(9 * count);
  const normals = new Float32Array(9 * count);
  for (let face = 0; face < count; face++) {
    for (let i = 0; i < 3; i++) {
      const index = triangles[3 * face + i];
      const sum = [0, 0, 0];
      for (const other of around[index]) {
        if (dot(faces[face], faces[other]) >= CREASE * sizes[face] * sizes[other]) {
          sum[0] += faces[other][0];
          sum[1] += faces[other][1];
          sum[2] += faces[other][2];
        }
      }
      places.set(corner(index), 9 * face + 3 * i);
      normals.set(unit(sum), 9 * face + 3 * i);
    }
  }
  return [places, normals];
}

// A helical spring along z, from 0 to 1: turned wire between two straight ends. Its length follows
// by `stretch`, which keeps the wire round.
export class Coil {
  constructor(radius, wire, turns) {
    const along = 22 * turns;
    const around = 8;
    const places = [];
    const normals = [];
    const triangles = [];
    this.middles = [];
    const middle = share => {
      const wide = radius * Math.min(1, Math.min(share, 1 - share) / 0.06, 1);
      const angle = 2 * Math.PI * turns * share;
      const z = Math.min(1, Math.max(0, (share - 0.02) / 0.96));
      return [wide * Math.cos(angle), wide * Math.sin(angle), z];
    };
    for (let i = 0; i <= along; i++) {
      const share = i / along;
      const [x, y, z] = middle(share);
      const angle = 2 * Math.PI * turns * share;
      for (let j = 0; j < around; j++) {
        const turn = 2 * Math.PI * j / around;
        const [out, up] = [Math.cos(turn), Math.sin(turn)];
        const normal = [out * Math.cos(angle), out * Math.sin(angle), up];
        normals.push(...normal);
        places.push(x + wire * normal[0], y + wire * normal[1], z + wire * normal[2]);
        this.middles.push(z, wire * normal[2]);
        if (i > 0) {
          const [a, b] = [(i - 1) * around, i * around];
          const next = (j + 1) % around;
          triangles.push(a + j, b + next, a + next, a + j, b + j, b + next);
        }
      }
    }
    this.geometry = new THREE.BufferGeometry();
    this.places = new THREE.Float32BufferAttribute(places, 3);
    this.places.setUsage(THREE.DynamicDrawUsage);
    this.geometry.setAttribute('position', this.places);
    this.geometry.setAttribute('normal', new THREE.Float32BufferAttribute(normals, 3));
    this.geometry.setIndex(triangles);
  }

  stretch(length) {
    const { array } = this.places;
    for (let i = 0, k = 2; i < this.middles.length; i += 2, k += 3) {
      array[k] = this.middles[i] * length + this.middles[i + 1];
    }
    this.places.needsUpdate = true;
  }
}

// A tube through points, round at every one of them; `lead` takes it along others.
export class Tube {
  constructor(count, radius) {
    this.radius = radius;
    this.around = 10;
    const { around } = this;
    const triangles = [];
    for (let i = 1; i < count; i++) {
      for (let j = 0; j < around; j++) {
        const next = (j + 1) % around;
        const [a, b] = [(i - 1) * around, i * around];
        triangles.push(a + j, a + next, b + next, a + j, b + next, b + j);
      }
    }
    this.geometry = new THREE.BufferGeometry();
    this.places = new THREE.BufferAttribute(new Float32Array(3 * count * around), 3);
    this.normals = new THREE.BufferAttribute(new Float32Array(3 * count * around), 3);
    this.geometry.setAttribute('position', this.places.setUsage(THREE.DynamicDrawUsage));
    this.geometry.setAttribute('normal', this.normals.setUsage(THREE.DynamicDrawUsage));
    this.geometry.setIndex(triangles);
  }

  lead(points) {
    const { around, radius } = this;
    let side = [0, 0, 0];
    let tangent = [0, 0, 1];
    points.forEach((point, i) => {
      const before = points[Math.max(0, i - 1)];
      const behind = points[Math.min(points.length - 1, i + 1)];
      const [came, goes] = [unit(subtract(point, before)), unit(subtract(behind, point))];
      const way = unit([0, 1, 2].map(k => came[k] + goes[k]));
      tangent = norm(way) > 0 ? way : tangent;
      side = unit(subtract(side, tangent.map(x => x * dot(side, tangent))));
      if (norm(side) === 0) {
        side = unit(cross(tangent, Math.abs(tangent[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0]));
      }
      const other = cross(tangent, side);
      for (let j = 0; j < around; j++) {
        const angle = 2 * Math.PI * j / around;
        for (let k = 0; k < 3; k++) {
          const out = Math.cos(angle) * side[k] + Math.sin(angle) * other[k];
          this.normals.array[3 * (i * around + j) + k] = out;
          this.places.array[3 * (i * around + j) + k] = point[k] + radius * out;
        }
      }
    });
    this.places.needsUpdate = true;
    this.normals.needsUpdate = true;
  }
}
