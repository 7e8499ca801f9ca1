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
