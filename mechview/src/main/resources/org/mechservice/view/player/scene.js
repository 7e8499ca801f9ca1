// A mechanism in space: the one picture of the player, of pages that simulate, and of the users' page.

import { THREE, OrbitControls, RoomEnvironment } from './three.js';
import { placed } from './recording.js';
import { ropeLines } from './rope.js';
import { add, cross, dot, norm, scale, subtract, turned, unit } from './space.js';
import { Coil, Tube, surface } from './surface.js';

// Views: directions from which the mechanism is seen, as turn about the upward direction and height.
const VIEWS = {
  iso: { yaw: 0.6, pitch: 0.36, field: 28 },
  front: { yaw: 0, pitch: 0, field: 1.5 },
  side: { yaw: Math.PI / 2, pitch: 0, field: 1.5 },
  top: { yaw: 0, pitch: Math.PI / 2 - 1e-4, field: 1.5 },
};

export const ARROWS = {
  force: { label: 'Force', colour: 0xd8452f },
  contact: { label: 'Contact force', colour: 0xe08a00 },
  reaction: { label: 'Reaction', colour: 0x2f73d8 },
  moment: { label: 'Moment', colour: 0x8a4fc4 },
};

const AXES = [0xd83c3c, 0x2e9e48, 0x3c6be0];
const OUTLINE = 0xffa51f;
const GHOST = 0.16;

// Roles of what bodies run and lie on.
const GROUNDS = ['SURFACE', 'ROAD'];

const FLOOR_VERTEX = `
varying vec2 place;
void main() {
  place = position.xy;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Lines one step apart, every fifth stronger, all fading out with the distance from the middle.
const FLOOR_FRAGMENT = `
uniform vec3 sheet, line;
uniform float tile, radius, strength;
uniform vec2 offset;
varying vec2 place;
float lines(float wide) {
  vec2 at = (place + offset) / wide;
  vec2 width = fwidth(at);
  vec2 away = abs(fract(at - 0.5) - 0.5) / max(width, vec2(1e-6));
  vec2 seen = 1.0 - smoothstep(vec2(0.0), vec2(1.2), away);
  seen *= 1.0 - smoothstep(vec2(0.15), vec2(0.5), width);
  return max(seen.x, seen.y);
}
void main() {
  float fade = 1.0 - smoothstep(0.15, 1.0, length(place) / radius);
  float drawn = max(0.45 * lines(tile), lines(5.0 * tile)) * strength;
  gl_FragColor = vec4(mix(sheet, line, drawn), fade * mix(0.55, 0.9, drawn));
  #include <colorspace_fragment>
}`;

// Segments as wide as a number of pixels, whatever the distance.
const LINE_VERTEX = `
uniform vec2 size;
uniform float width;
attribute vec3 from, to;
void main() {
  mat4 camera = projectionMatrix * modelViewMatrix;
  vec4 a = camera * vec4(from, 1.0), b = camera * vec4(to, 1.0);
  float inA = a.z + a.w, inB = b.z + b.w;
  if (inA < 0.0 && inB > 0.0) a = mix(a, b, inA / (inA - inB));
  if (inB < 0.0 && inA > 0.0) b = mix(b, a, inB / (inB - inA));
  vec2 way = (b.xy / b.w - a.xy / a.w) * size;
  float square = dot(way, way);
  vec2 along = square > 0.0 ? way * inversesqrt(square) : vec2(1.0, 0.0);
  vec4 end = position.x < 0.0 ? a : b;
  vec2 shift = (vec2(-along.y, along.x) * position.y + along * position.x * 0.5) * width / size;
  gl_Position = end + vec4(shift * end.w, 0.0, 0.0);
}`;

const LINE_FRAGMENT = `
uniform vec3 colour;
uniform float opacity;
void main() {
  gl_FragColor = vec4(colour, opacity);
  #include <colorspace_fragment>
}`;

const SCREEN_VERTEX = `
varying vec2 place;
void main() {
  place = position.xy * 0.5 + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

// The border of what is white in a picture.
const OUTLINE_FRAGMENT = `
uniform sampler2D mask;
uniform vec2 pixel;
uniform vec3 colour;
varying vec2 place;
void main() {
  float inside = texture2D(mask, place).r;
  float near = 0.0;
  for (int i = 0; i < 16; i++) {
    float turn = 6.2831853 * float(i) / 16.0;
    near += texture2D(mask, place + vec2(cos(turn), sin(turn)) * pixel).r;
  }
  gl_FragColor = vec4(colour, clamp(near / 5.0, 0.0, 1.0) * (1.0 - inside));
  #include <colorspace_fragment>
}`;

// The least and the greatest of many numbers.
const range = numbers => numbers.reduce(
  ([least, most], x) => [Math.min(least, x), Math.max(most, x)], [Infinity, -Infinity]);

const vector = a => new THREE.Vector3(a[0], a[1], a[2]);
const quaternion = q => new THREE.Quaternion(q[1], q[2], q[3], q[0]);

export class MechanismScene {
  constructor(canvas) {
    this.canvas = canvas;
    this.styles = new Map();
    this.selected = -2;
    this.changes = 0;
    this.slow = 0;
    this.roles = { BODY: true, JOINT: true, SURFACE: true, ROAD: true, INERTIA: false };
    try {
      this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    } catch {
      return;
    }
    const { renderer } = this;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    renderer.toneMapping = THREE.NeutralToneMapping;
    renderer.setClearAlpha(0);
    renderer.info.autoReset = false;
    this.scene = new THREE.Scene();
    this.scene.environmentIntensity = 0.5;
    // without a graphics processor the room's light takes half a minute to compute
    this.sky = new THREE.HemisphereLight(0xffffff, 0x8f98a3, 2.6);
    this.scene.add(this.sky);
    if (!this.drawnByProcessor()) {
      this.room();
    }
    this.camera = new THREE.PerspectiveCamera(VIEWS.iso.field, 1, 0.1, 100);
    this.sun = new THREE.DirectionalLight(0xfff6ea, 2.1);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 5;
    this.scene.add(this.sun, this.sun.target);
    this.makeOutline();
  }

  // Whether the pictures are painted by the processor itself.
  drawnByProcessor() {
    const gl = this.renderer.getContext();
    const told = gl.getExtension('WEBGL_debug_renderer_info');
    return /swiftshader|llvmpipe|software/i.test(told ? gl.getParameter(told.UNMASKED_RENDERER_WEBGL) : '');
  }

  // Light of a room with lamps, in place of that of an even sky.
  room() {
    if (!this.scene.environment) {
      const rooms = new THREE.PMREMGenerator(this.renderer);
      this.scene.environment = rooms.fromScene(new RoomEnvironment(), 0.04, 0.1, 100, { size: 128 }).texture;
      rooms.dispose();
      this.sky.removeFromParent();
      this.changes++;
    }
  }

  get works() {
    return Boolean(this.renderer);
  }

  // ---- what there is ----

  // Takes the description of a mechanism.
  show(data) {
    this.data = data;
    this.up = norm(data.gravity) > 0 ? unit(scale(data.gravity, -1)) : [0, 0, 1];
    // models are drawn along axes; a gravity that is a little askew tilts no picture
    const axis = this.up.findIndex(x => Math.abs(x) > 0.9);
    if (axis >= 0) {
      this.up = this.up.map((x, i) => (i === axis ? Math.sign(x) : 0));
    }
    this.right = Math.abs(this.up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    this.back = unit(cross(this.right, this.up));
    this.right = cross(this.up, this.back);
    this.styles.clear();
    this.selected = -2;
    if (!this.works) {
      return;
    }
    this.world?.traverse(one => one.geometry?.dispose());
    this.world?.removeFromParent();
    this.world = new THREE.Group();
    this.scene.add(this.world);
    const turn = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), vector(this.up));
    this.scene.environmentRotation.setFromQuaternion(turn);
    this.controls?.dispose();
    this.camera.up.set(...this.up);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener('change', () => { this.changes++; });
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.surfaces = data.meshes.map(surface);
    this.items = data.parts.map(part => this.item(part));
    this.bodies = data.bodies.length;
    this.matrices = new Float32Array(16 * (this.bodies + 1));
    this.boxes = this.bodyBoxes();
    this.makeFloor();
    this.makeLinks();
    this.makeRopes();
    this.makeArrows();
    this.batch();
    this.paths = new Map();
    this.axes = undefined;
  }

  item(part) {
    const [x, y, z, ...q] = part.at;
    const local = new THREE.Matrix4().compose(
      new THREE.Vector3(x, y, z), quaternion(q), vector(part.scale));
    return { part, local, colour: new THREE.Color(part.colour) };
  }

  material(opacity, dull = false) {
    return new THREE.MeshPhysicalMaterial({
      roughness: dull ? 0.9 : 0.42, metalness: 0, clearcoat: dull ? 0 : 0.35,
      clearcoatRoughness: 0.35, side: THREE.DoubleSide,
      transparent: opacity < 1, opacity, depthWrite: opacity >= 1,
    });
  }

  styleOf(item) {
    const style = this.styles.get(item.part.body) || 'shown';
    return GROUNDS.includes(item.part.role) ? 'shown' : style;
  }

  // Draws all that has one surface and one material at once, however many bodies there are.
  batch() {
    this.changes++;
    this.batches?.forEach(batch => {
      batch.mesh.removeFromParent();
      batch.mesh.material.dispose();
      batch.mesh.dispose();
    });
    const groups = new Map();
    for (const item of this.items) {
      const style = this.styleOf(item);
      if (style === 'hidden' || item.part === this.groundPart || !this.roles[item.part.role]) {
        continue;
      }
      const opacity = Math.min(item.part.opacity, style === 'ghost' ? GHOST : 1);
      const key = `${item.part.mesh} ${opacity} ${item.part.finish}`;
      if (!groups.has(key)) {
        groups.set(key, { opacity, items: [] });
      }
      groups.get(key).items.push(item);
    }
    this.batches = [...groups.values()].map(({ opacity, items }) => {
      const { part } = items[0];
      const mesh = new THREE.InstancedMesh(
        this.surfaces[part.mesh], this.material(opacity, part.finish === 'DULL'), items.length);
      mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
      mesh.frustumCulled = false;
      mesh.castShadow = opacity >= 1 && !GROUNDS.includes(part.role);
      mesh.receiveShadow = true;
      mesh.renderOrder = opacity < 1 ? 3 : 0;
      items.forEach((item, i) => mesh.setColorAt(i, item.colour));
      this.world.add(mesh);
      return { mesh, items };
    });
    this.makeMask();
    this.links?.forEach(link => this.styleLink(link, [link.link.from[0], link.link.to[0]]));
    this.ropes?.forEach(rope => this.styleLink(rope, rope.rope.stops.map(stop => stop.at?.[0])));
  }

  // Links whose length changes: rods and ropes as cylinders, dampers as tubes, springs as coils.
  makeLinks() {
    const { extent } = this.data;
    const cylinder = new THREE.CylinderGeometry(1, 1, 1, 20).rotateX(Math.PI / 2).translate(0, 0, 0.5);
    this.links = this.data.links.map(link => {
      const material = this.material(1);
      material.color.set(link.colour);
      const add = (geometry, width) => {
        const mesh = new THREE.Mesh(geometry, material);
        mesh.castShadow = true;
        mesh.receiveShadow = true;
        mesh.frustumCulled = false;
        mesh.userData.width = width;
        this.world.add(mesh);
        return mesh;
      };
      const w = link.width * extent;
      if (link.kind === 'SPRING') {
        const coil = new Coil(2.6 * w, 0.55 * w, 9);
        return { link, material, coil, meshes: [add(coil.geometry, 0)] };
      }
      if (link.kind === 'DAMPER') {
        material.metalness = 0.3;
        return { link, material, meshes: [add(cylinder, w), add(cylinder, 0.5 * w)] };
      }
      return { link, material, meshes: [add(cylinder, w)] };
    });
  }

  // Where a body is at the start.
  start(body) {
    const pose = body < 0 ? this.data.root : this.data.bodies[body].start;
    return { p: pose.slice(0, 3), q: pose.slice(3) };
  }

  // Ropes, cables and muscles, each line of them a tube through points.
  makeRopes() {
    this.ropes = this.data.ropes.map(rope => {
      const material = this.material(1, true);
      material.color.set(rope.colour);
      const tubes = ropeLines(rope, body => this.start(body))
        .map(line => new Tube(line.length, rope.width * this.data.extent));
      const meshes = tubes.map(tube => {
        const mesh = new THREE.Mesh(tube.geometry, material);
        mesh.castShadow = true;
        mesh.receiveShadow = true;
        mesh.frustumCulled = false;
        this.world.add(mesh);
        return mesh;
      });
      return { rope, material, meshes, tubes };
    });
  }

  styleLink(link, bodies) {
    const ends = bodies.map(body => this.styles.get(body) || 'shown');
    const hidden = ends.includes('hidden') || !this.roles.BODY;
    const ghost = ends.includes('ghost');
    link.meshes.forEach(mesh => { mesh.visible = !hidden; });
    Object.assign(link.material, {
      transparent: ghost, opacity: ghost ? GHOST : 1, depthWrite: !ghost, needsUpdate: true });
  }

  makeArrows() {
    // over everything: most arrows begin inside of a body
    const shape = new THREE.MeshStandardMaterial({ roughness: 0.5, depthTest: false, transparent: true });
    const shaft = new THREE.CylinderGeometry(1, 1, 1, 12).rotateX(Math.PI / 2).translate(0, 0, 0.5);
    const tip = new THREE.ConeGeometry(1, 1, 16).rotateX(Math.PI / 2).translate(0, 0, 0.5);
    const most = Math.max(16, 3 * (this.data.joints.length + this.data.links.length + this.data.forces.length));
    this.shafts = new THREE.InstancedMesh(shaft, shape, most);
    this.tips = new THREE.InstancedMesh(tip, shape, most);
    // where bodies touch
    this.touches = new THREE.InstancedMesh(new THREE.SphereGeometry(1, 20, 12), shape, most);
    for (const mesh of [this.shafts, this.tips, this.touches]) {
      mesh.frustumCulled = false;
      mesh.renderOrder = 5;
      mesh.count = 0;
      // made at once, so that the shader knows of the colours
      mesh.setColorAt(0, new THREE.Color());
      this.world.add(mesh);
    }
  }

  // Places on each body between which it lies: some of its own, or the corners of its boxes where
  // there are many bodies.
  bodyBoxes() {
    const all = new Map();
    const few = this.items.length <= 150;
    const place = new THREE.Vector3();
    for (const { part, local } of this.items) {
      if (GROUNDS.includes(part.role) || part.role === 'INERTIA') {
        continue;
      }
      const corners = all.get(part.body) || [];
      all.set(part.body, corners);
      const { boundingBox: { min, max }, attributes: { position } } = this.surfaces[part.mesh];
      const count = few ? Math.min(24, position.count) : 8;
      for (let i = 0; i < count; i++) {
        if (few) {
          place.fromBufferAttribute(position, Math.floor(i * position.count / count));
        } else {
          place.set(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z);
        }
        corners.push(place.applyMatrix4(local).toArray());
      }
    }
    return [...all].map(([body, corners]) => ({ body, corners }));
  }

  // Corners of all bodies in a position, and ends of links.
  places(poses, body = -2) {
    const places = [];
    for (const box of this.boxes) {
      if (body < 0 || box.body === body) {
        const pose = poses(box.body);
        box.corners.forEach(corner => places.push({ body: box.body, place: add(pose.p, turned(pose.q, corner)) }));
      }
    }
    const eyes = this.data.ropes.flatMap(({ stops }) =>
      stops.filter(({ kind }) => kind === 'eye').map(({ at }) => at));
    const ends = this.data.links.filter(({ kind }) => kind !== 'GUIDE').flatMap(({ from, to }) => [from, to]);
    for (const end of [...ends, ...eyes]) {
      if (body < 0 || end[0] === body) {
        places.push({ body: end[0], place: placed(poses, end) });
      }
    }
    return places.filter(({ place }) => place.every(Number.isFinite));
  }

  // Learns what the mechanism sweeps from some of its positions. What flies away from it does not
  // make the picture small, and what drives away as a whole is followed.
  learn(positions) {
    if (!this.works) {
      return;
    }
    const first = this.places(positions[0]);
    const extent = this.data.extent;
    const middle = scale(first.reduce((sum, { place }) => add(sum, place), [0, 0, 0]), 1 / (first.length || 1));
    const reach = Math.max(extent / 2, range(first.map(({ place }) => norm(subtract(place, middle))))[1]);
    const ways = new Map();
    this.path = [];
    let lowest = first.length ? range(first.map(({ place }) => dot(place, this.up)))[0] : 0;
    for (const poses of positions) {
      for (const box of this.boxes) {
        if (box.body >= 0) {
          const place = poses(box.body).p;
          const way = ways.get(box.body) || { from: place, most: 0 };
          way.most = Math.max(way.most, norm(subtract(place, way.from)) || 0);
          ways.set(box.body, way);
        }
      }
      for (const one of this.places(poses)) {
        if (norm(subtract(one.place, middle)) <= 2.2 * reach) {
          this.path.push(one);
          lowest = Math.min(lowest, dot(one.place, this.up));
        }
      }
    }
    if (this.path.length === 0) {
      this.path = first.length ? first : [{ body: -1, place: [0, 0, 0] }];
    }
    this.travels = ways.size > 0 && range([...ways.values()].map(way => way.most))[0] > 2.5 * reach;
    this.reach = reach;
    const ground = this.data.parts.find(part => part.role === 'SURFACE' && part.body < 0
      && Math.abs(dot(turned(part.at.slice(3), [0, 0, 1]), this.up)) > 0.999);
    if (ground !== this.groundPart) {
      // the floor is the ground, and needs no sheet in it
      this.groundPart = ground;
      this.batch();
    }
    // what rests on its foot does not stand in the air, though some of it may go below
    const [foot, others] = [true, false].map(rests => range(first.filter(({ body }) => (body < 0) === rests)
      .map(({ place }) => dot(place, this.up)))[0]);
    const lowestOfAll = foot < others + 0.01 * extent ? foot : lowest - 0.01 * extent;
    const flat = ground ? dot(ground.at.slice(0, 3), this.up) : lowestOfAll;
    this.floor = Math.min(flat, ...this.items.filter(({ part }) => part.role === 'ROAD' && part.body < 0)
      .map(item => this.lowest(item) - 0.002 * extent));
    this.layFloor();
  }

  // The height of the lowest point of a part that rests.
  lowest({ part, local }) {
    const { position } = this.surfaces[part.mesh].attributes;
    const place = new THREE.Vector3();
    const { p, q } = this.start(-1);
    let least = Infinity;
    for (let i = 0; i < position.count; i++) {
      place.fromBufferAttribute(position, i).applyMatrix4(local);
      least = Math.min(least, dot(add(p, turned(q, place.toArray())), this.up));
    }
    return least;
  }

  // ---- floor, light and colours ----

  makeFloor() {
    this.floorMaterial = new THREE.ShaderMaterial({
      vertexShader: FLOOR_VERTEX, fragmentShader: FLOOR_FRAGMENT, transparent: true, depthWrite: false,
      side: THREE.DoubleSide,
      uniforms: {
        sheet: { value: new THREE.Color() }, line: { value: new THREE.Color() },
        tile: { value: 1 }, radius: { value: 1 }, offset: { value: new THREE.Vector2() },
        strength: { value: 1 },
      },
    });
    this.shadowMaterial = new THREE.ShadowMaterial({ opacity: 0.25, depthWrite: false });
    const disc = new THREE.CircleGeometry(1, 96);
    this.ground = new THREE.Group();
    const basis = new THREE.Matrix4().makeBasis(vector(this.right), vector(scale(this.back, -1)), vector(this.up));
    this.ground.quaternion.setFromRotationMatrix(basis);
    this.sheet = new THREE.Mesh(disc, this.floorMaterial);
    this.sheet.renderOrder = 1;
    this.shade = new THREE.Mesh(disc, this.shadowMaterial);
    this.shade.receiveShadow = true;
    this.shade.renderOrder = 2;
    this.ground.add(this.sheet, this.shade);
    this.world.add(this.ground);
    this.colours(this.wanted || {});
  }

  layFloor() {
    const reach = this.travels ? 3 * this.reach : Math.max(this.reach, range(this.path.map(({ place }) =>
      norm(subtract(place, this.path[0].place))))[1]);
    const tile = this.reach / 4;
    const power = 10 ** Math.floor(Math.log10(tile));
    this.tile = [1, 2, 5, 10].map(k => k * power).find(k => k >= tile) || tile;
    const radius = 7 * reach;
    // the plane's own coordinates are metres
    this.sheet.geometry.dispose();
    this.sheet.geometry = new THREE.CircleGeometry(radius, 96);
    this.shade.geometry = this.sheet.geometry;
    this.floorMaterial.uniforms.tile.value = this.tile;
    this.floorMaterial.uniforms.radius.value = radius;
    this.floorRadius = radius;
    const { camera } = this.sun.shadow;
    this.shadowReach = 1.15 * reach;
    Object.assign(camera, {
      left: -this.shadowReach, right: this.shadowReach, top: this.shadowReach, bottom: -this.shadowReach,
      near: 0.1 * this.shadowReach, far: 8 * this.shadowReach });
    camera.updateProjectionMatrix();
    this.sun.shadow.normalBias = 0.008 * this.shadowReach;
    this.sun.shadow.bias = -0.0004;
    this.centre = this.middle(this.path);
  }

  middle(places) {
    const least = [1e300, 1e300, 1e300];
    const most = [-1e300, -1e300, -1e300];
    for (const { place } of places) {
      place.forEach((x, i) => {
        least[i] = Math.min(least[i], x);
        most[i] = Math.max(most[i], x);
      });
    }
    return least.map((x, i) => (x + most[i]) / 2);
  }

  // Takes the colours of the page: sheet and lines of the floor as CSS colours, and whether it is dark.
  colours({ sheet = '#ffffff', line = '#c3ccd6', dark = false }) {
    this.wanted = { sheet, line, dark };
    this.changes++;
    if (!this.works || !this.floorMaterial) {
      return;
    }
    this.floorMaterial.uniforms.sheet.value.set(sheet);
    this.floorMaterial.uniforms.line.value.set(line);
    this.shadowMaterial.opacity = dark ? 0.5 : 0.26;
    this.renderer.toneMappingExposure = dark ? 0.92 : 1;
  }

  // ---- camera ----

  // Looks from one of the four sides.
  look(view) {
    const { yaw, pitch, field } = VIEWS[view];
    this.camera.fov = field;
    const level = add(scale(this.right, Math.sin(yaw)), scale(this.back, Math.cos(yaw)));
    this.direction = add(scale(level, Math.cos(pitch)), scale(this.up, Math.sin(pitch)));
  }

  direct() {
    const way = new THREE.Vector3().subVectors(this.camera.position, this.controls.target);
    return way.lengthSq() > 0 && !this.direction ? unit(way.toArray()) : this.direction || [0, 0, 1];
  }

  // Shows all these places from the present direction.
  fitPlaces(places) {
    const z = this.direct();
    this.direction = undefined;
    const x = unit(cross(this.up, z));
    const y = cross(z, x);
    const tall = Math.tan(this.camera.fov * Math.PI / 360);
    const wide = tall * this.camera.aspect;
    const seen = places.map(place => [dot(place, x), dot(place, y), dot(place, z)]);
    const middle = axis => {
      const [least, most] = range(seen.map(one => one[axis]));
      return (least + most) / 2;
    };
    const [cx, cy, cz] = [0, 1, 2].map(middle);
    let distance = 1e-9 + 0.4 * this.data.extent * 0.1 / tall;
    for (const [px, py, pz] of seen) {
      distance = Math.max(distance,
        pz - cz + 1.06 * Math.abs(px - cx) / wide, pz - cz + 1.1 * Math.abs(py - cy) / tall);
    }
    const target = add(add(scale(x, cx), scale(y, cy)), scale(z, cz));
    this.controls.target.set(...target);
    this.camera.position.set(...add(target, scale(z, distance)));
    this.controls.update();
  }

  // Shows the mechanism as it is now, with some further places; what travels is shown already.
  fitNow(poses, further) {
    if (this.works && !this.travels) {
      this.size();
      this.fitPlaces([...this.places(poses).map(({ place }) => place), ...further]);
      this.changes++;
    }
  }

  // Shows what the mechanism sweeps, or a body.
  fit(poses, body = -2) {
    if (!this.works) {
      return;
    }
    this.size();
    let places;
    if (body >= 0 || this.travels) {
      places = this.places(poses, body >= 0 && !this.travels ? body : -2).map(({ place }) => place);
      const near = poses(Math.max(0, body)).p;
      const wide = 0.5 * this.data.extent;
      places = places.filter(place => norm(subtract(place, near)) < 4 * this.reach);
      if (body >= 0 && !this.travels) {
        for (const axis of [[1, 0, 0], [0, 1, 0], [0, 0, 1]]) {
          places.push(add(near, scale(axis, wide)), add(near, scale(axis, -wide)));
        }
      }
    } else {
      places = this.path.map(({ place }) => place);
    }
    this.fitPlaces(places.length ? places : [[0, 0, 0]]);
    this.followed = undefined;
    this.changes++;
  }

  // Turns about the target, up by the second angle, rad.
  turn(yaw, pitch) {
    const way = new THREE.Vector3().subVectors(this.camera.position, this.controls.target);
    const upright = new THREE.Quaternion().setFromUnitVectors(vector(this.up), new THREE.Vector3(0, 1, 0));
    const sphere = new THREE.Spherical().setFromVector3(way.applyQuaternion(upright));
    sphere.theta -= yaw;
    sphere.phi = Math.min(Math.PI - 1e-3, Math.max(1e-3, sphere.phi - pitch));
    way.setFromSpherical(sphere).applyQuaternion(upright.invert());
    this.camera.position.addVectors(this.controls.target, way);
    this.controls.update();
    this.changes++;
  }

  zoom(factor) {
    this.changes++;
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
  }

  // ---- a position ----

  // Places everything. The camera goes with the body that is followed.
  place(poses, follow = -2) {
    if (!this.works) {
      return;
    }
    this.poses = poses;
    if (follow >= 0) {
      const { p } = poses(follow);
      if (this.followed && p.every(Number.isFinite)) {
        const way = vector(subtract(p, this.followed));
        this.camera.position.add(way);
        this.controls.target.add(way);
      }
      this.followed = p;
    }
    this.placeBodies(poses);
    this.placeLinks(poses);
    for (const { rope, tubes } of this.ropes) {
      ropeLines(rope, poses).forEach((line, i) => tubes[i].lead(line));
    }
  }

  placeBodies(poses) {
    const matrix = new THREE.Matrix4();
    const one = new THREE.Vector3(1, 1, 1);
    const position = new THREE.Vector3();
    const turn = new THREE.Quaternion();
    for (let body = -1; body < this.bodies; body++) {
      const { p, q } = poses(body);
      position.set(p[0], p[1], p[2]);
      turn.set(q[1], q[2], q[3], q[0]);
      matrix.compose(position, turn, one).toArray(this.matrices, 16 * (body + 1));
    }
    for (const { mesh, items } of this.batches) {
      const { array } = mesh.instanceMatrix;
      for (let i = 0; i < items.length; i++) {
        multiply(array, 16 * i, this.matrices, 16 * (items[i].part.body + 1), items[i].local.elements);
      }
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  placeLinks(poses) {
    const z = new THREE.Vector3(0, 0, 1);
    for (const { link, meshes, coil } of this.links) {
      const from = placed(poses, link.from);
      const way = subtract(placed(poses, link.to), from);
      const length = norm(way);
      const turn = new THREE.Quaternion().setFromUnitVectors(z, vector(length > 0 ? scale(way, 1 / length) : [0, 0, 1]));
      meshes.forEach((mesh, i) => {
        mesh.position.set(...from);
        mesh.quaternion.copy(turn);
        const { width } = mesh.userData;
        if (coil) {
          coil.stretch(length);
        } else if (link.kind === 'DAMPER') {
          // the cylinder keeps its length, and the piston's rod goes out of it
          link.tube ??= 0.55 * length;
          const tube = Math.min(link.tube, 0.98 * length);
          mesh.scale.set(width, width, Math.max(1e-9, i === 0 ? tube : length));
        } else {
          mesh.scale.set(width, width, Math.max(1e-9, length));
        }
      });
    }
  }

  // Draws arrows: each has a point `at`, a way `along` it, m, and a kind.
  drawArrows(arrows) {
    if (!this.works) {
      return;
    }
    const extent = this.data.extent;
    const matrix = new THREE.Matrix4();
    const z = new THREE.Vector3(0, 0, 1);
    const colour = new THREE.Color();
    let count = 0;
    let touches = 0;
    for (const { at, along, kind } of arrows) {
      const length = norm(along);
      if (kind === 'contact' && length > 0 && touches < this.touches.instanceMatrix.count) {
        const r = 0.012 * extent;
        matrix.makeScale(r, r, r).setPosition(...at);
        this.touches.setMatrixAt(touches, matrix);
        this.touches.setColorAt(touches, colour.set(ARROWS.contact.colour));
        touches++;
      }
      if (length < 0.004 * extent || count >= this.shafts.instanceMatrix.count) {
        continue;
      }
      const way = scale(along, 1 / length);
      const turn = new THREE.Quaternion().setFromUnitVectors(z, vector(way));
      const head = Math.min(0.055 * extent, 0.45 * length);
      const thick = Math.min(0.008 * extent, 0.16 * head);
      matrix.compose(vector(at), turn, new THREE.Vector3(thick, thick, length - head));
      this.shafts.setMatrixAt(count, matrix);
      const wide = Math.min(0.022 * extent, 0.42 * head);
      matrix.compose(vector(add(at, scale(way, length - head))), turn, new THREE.Vector3(wide, wide, head));
      this.tips.setMatrixAt(count, matrix);
      colour.set(ARROWS[kind].colour);
      this.shafts.setColorAt(count, colour);
      this.tips.setColorAt(count, colour);
      count++;
    }
    for (const [mesh, drawn] of [[this.shafts, count], [this.tips, count], [this.touches, touches]]) {
      mesh.count = drawn;
      mesh.visible = drawn > 0;
      mesh.instanceMatrix.needsUpdate = true;
      mesh.instanceColor.needsUpdate = true;
    }
  }

  // Lines through points, as wide as so many pixels, of which `shown` segments are drawn.
  line(key, points, colour, width, shown = points?.length) {
    let line = this.paths.get(key);
    if (points && !line) {
      const geometry = new THREE.InstancedBufferGeometry();
      geometry.setAttribute('position', new THREE.Float32BufferAttribute(
        [-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0], 3));
      geometry.setIndex([0, 1, 2, 2, 1, 3]);
      const values = new Float32Array(points.flatMap(([a, b]) => [...a, ...b]));
      const both = new THREE.InstancedInterleavedBuffer(values, 6);
      geometry.setAttribute('from', new THREE.InterleavedBufferAttribute(both, 3, 0));
      geometry.setAttribute('to', new THREE.InterleavedBufferAttribute(both, 3, 3));
      const material = new THREE.ShaderMaterial({
        vertexShader: LINE_VERTEX, fragmentShader: LINE_FRAGMENT, transparent: true, side: THREE.DoubleSide,
        uniforms: {
          size: { value: new THREE.Vector2(1, 1) }, width: { value: width },
          colour: { value: new THREE.Color(colour) }, opacity: { value: 0.9 },
        },
      });
      const mesh = new THREE.Mesh(geometry, material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 4;
      line = { mesh, both, width };
      this.paths.set(key, line);
      this.world.add(mesh);
    } else if (points) {
      line.both.array.set(points.flatMap(([a, b]) => [...a, ...b]));
      line.both.needsUpdate = true;
    }
    if (line) {
      line.mesh.visible = shown > 0;
      line.mesh.geometry.instanceCount = Math.max(0, shown);
    }
  }

  dropLine(key) {
    const line = this.paths.get(key);
    if (line) {
      line.mesh.removeFromParent();
      line.mesh.geometry.dispose();
      line.mesh.material.dispose();
      this.paths.delete(key);
    }
  }

  // Axes of all bodies, red, green and blue.
  drawAxes(on) {
    AXES.forEach((colour, i) => {
      if (!on) {
        this.line(`axis ${i}`, undefined, colour, 2.2, 0);
        return;
      }
      const length = 0.08 * this.data.extent;
      const direction = [0, 1, 2].map(k => (k === i ? length : 0));
      const lines = [];
      for (let body = -1; body < this.bodies; body++) {
        const { p, q } = this.poses(body);
        lines.push([p, add(p, turned(q, direction))]);
      }
      this.line(`axis ${i}`, lines, colour, 2.2);
    });
  }

  // ---- selection ----

  makeOutline() {
    this.maskScene = new THREE.Scene();
    this.maskMaterial = new THREE.MeshBasicMaterial({ color: 0xffffff, side: THREE.DoubleSide });
    this.mask = new THREE.WebGLRenderTarget(1, 1);
    this.outlineMaterial = new THREE.ShaderMaterial({
      vertexShader: SCREEN_VERTEX, fragmentShader: OUTLINE_FRAGMENT, transparent: true, depthTest: false,
      depthWrite: false,
      uniforms: {
        mask: { value: this.mask.texture }, pixel: { value: new THREE.Vector2() },
        colour: { value: new THREE.Color(OUTLINE) },
      },
    });
    this.screen = new THREE.Scene();
    const sheet = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), this.outlineMaterial);
    sheet.frustumCulled = false;
    this.screen.add(sheet);
  }

  // Puts an outline around a body; −2 for none.
  select(body) {
    this.selected = body;
    this.changes++;
    if (this.works && this.data) {
      this.makeMask();
    }
  }

  makeMask() {
    this.maskScene.clear();
    this.masked = [];
    for (const item of this.items) {
      if (item.part.body === this.selected && item.part.role === 'BODY') {
        const mesh = new THREE.Mesh(this.surfaces[item.part.mesh], this.maskMaterial);
        mesh.matrixAutoUpdate = false;
        mesh.frustumCulled = false;
        this.maskScene.add(mesh);
        this.masked.push({ mesh, item });
      }
    }
  }

  // Shows a body, as a ghost, or not at all.
  style(body, style) {
    if (style === 'shown') {
      this.styles.delete(body);
    } else {
      this.styles.set(body, style);
    }
    this.batch();
  }

  // Shows one body alone, the others as ghosts.
  isolate(body) {
    this.styles.clear();
    for (let other = -1; other < this.bodies; other++) {
      if (other !== body) {
        this.styles.set(other, 'ghost');
      }
    }
    this.batch();
  }

  showAll() {
    this.styles.clear();
    this.batch();
  }

  showRole(role, on) {
    if (this.roles[role] !== on) {
      this.roles[role] = on;
      if (this.items) {
        this.batch();
      }
    }
  }

  // The body under a place of the canvas, px, and where the surface is hit; or nothing.
  pick(x, y) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2(
      2 * x / this.canvas.clientWidth - 1, 1 - 2 * y / this.canvas.clientHeight), this.camera);
    let nearest;
    for (const { mesh, items } of this.batches) {
      mesh.boundingSphere = null;
      for (const hit of ray.intersectObject(mesh, false)) {
        const { part } = items[hit.instanceId];
        if (part.role === 'BODY' && (!nearest || hit.distance < nearest.distance)) {
          nearest = { body: part.body, point: hit.point.toArray(), distance: hit.distance };
        }
      }
    }
    return nearest;
  }

  // Where a point is on the canvas, px; nothing if it is behind the camera.
  project(point) {
    const seen = vector(point).project(this.camera);
    return Math.abs(seen.z) > 1 ? undefined
      : [(seen.x + 1) / 2 * this.canvas.clientWidth, (1 - seen.y) / 2 * this.canvas.clientHeight];
  }

  // ---- the picture ----

  size() {
    const { canvas, renderer } = this;
    const ratio = this.hurry === 2 ? 0.6 : this.hurry ? 1 : Math.min(2, window.devicePixelRatio || 1);
    const [width, height] = [Math.max(1, canvas.clientWidth), Math.max(1, canvas.clientHeight)];
    if (!this.sized || this.sized[0] !== width || this.sized[1] !== height || this.sized[2] !== ratio) {
      this.sized = [width, height, ratio];
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
    }
  }

  render(floor = true) {
    if (!this.works || !this.data) {
      return;
    }
    this.size();
    this.compose(floor, this.canvas.clientWidth, this.canvas.clientHeight);
    this.haste();
  }

  // Without a graphics processor pictures take long: shadows are then left out, and small pictures
  // drawn larger.
  haste() {
    const now = performance.now();
    const late = this.drawn === undefined ? 0 : now - this.drawn;
    this.drawn = now;
    this.slow = late > 90 && late < 2000 ? this.slow + 1 : Math.max(0, this.slow - 1);
    if (this.slow > 6) {
      this.slow = 0;
      this.hurry = Math.min(2, (this.hurry || 0) + 1);
      this.sun.castShadow = false;
      this.sized = undefined;
    }
  }

  // Whether what render() shows is out of date, other than by time.
  get changed() {
    const { clientWidth, clientHeight } = this.canvas;
    const [width, height] = this.sized || [];
    return this.changes !== this.rendered || clientWidth !== width || clientHeight !== height;
  }

  compose(floor, width, height) {
    this.rendered = this.changes;
    const { camera, renderer } = this;
    const { target } = this.controls;
    const distance = camera.position.distanceTo(target);
    const beyond = 2 * this.floorRadius;
    camera.near = Math.max(distance * 0.01, distance - 12 * this.reach - 2 * this.floorRadius);
    camera.far = distance + beyond + 4 * this.reach;
    camera.updateProjectionMatrix();
    this.lightUp(target.toArray());
    const above = dot(camera.position.toArray(), this.up) > this.floor;
    this.ground.visible = floor;
    this.shade.visible = above;
    this.floorMaterial.uniforms.strength.value = camera.fov > 5 ? 1 : 0.6;
    for (const { mesh, width: wide } of this.paths.values()) {
      mesh.material.uniforms.size.value.set(width, height);
      mesh.material.uniforms.width.value = wide;
    }
    renderer.info.reset();
    renderer.setRenderTarget(null);
    renderer.autoClear = true;
    renderer.render(this.scene, camera);
    if (this.masked?.length) {
      this.outline();
    }
  }

  lightUp(target) {
    const { up, right, back } = this;
    const centre = this.travels ? target : this.centre;
    const away = unit(add(add(up, scale(right, -0.42)), scale(back, 0.5)));
    this.sun.target.position.set(...centre);
    this.sun.position.set(...add(centre, scale(away, 4 * this.shadowReach)));
    // the floor goes with what is looked at; its lines stay where they are
    const height = this.floor - dot(centre, up);
    this.ground.position.set(...add(centre, scale(up, height)));
    const across = scale(back, -1);
    this.floorMaterial.uniforms.offset.value.set(
      dot(centre, right) % (5 * this.tile), dot(centre, across) % (5 * this.tile));
  }

  outline() {
    const { renderer } = this;
    const size = renderer.getDrawingBufferSize(new THREE.Vector2());
    this.mask.setSize(size.x, size.y);
    const matrix = new THREE.Matrix4();
    for (const { mesh, item } of this.masked) {
      matrix.fromArray(this.matrices, 16 * (item.part.body + 1));
      mesh.matrix.multiplyMatrices(matrix, item.local);
    }
    renderer.setRenderTarget(this.mask);
    renderer.render(this.maskScene, this.camera);
    renderer.setRenderTarget(null);
    renderer.autoClear = false;
    const wide = 2.2 * renderer.getPixelRatio();
    this.outlineMaterial.uniforms.pixel.value.set(wide / size.x, wide / size.y);
    renderer.render(this.screen, this.camera);
    renderer.autoClear = true;
  }

  // The present picture at any size, px, on a canvas of its own, over the colours of the page.
  picture(width, height, { sky, scene }, floor = true) {
    const { renderer, camera } = this;
    const { castShadow } = this.sun;
    this.sun.castShadow = true;
    renderer.setPixelRatio(1);
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    this.compose(floor, width, height);
    const sheet = document.createElement('canvas');
    sheet.width = width;
    sheet.height = height;
    const pen = sheet.getContext('2d');
    const back = pen.createRadialGradient(width / 2, 0, 0, width / 2, 0, 1.2 * Math.max(width, height) / 2 + height / 2);
    back.addColorStop(0, sky);
    back.addColorStop(0.85, scene);
    pen.fillStyle = back;
    pen.fillRect(0, 0, width, height);
    pen.drawImage(this.canvas, 0, 0);
    this.sized = undefined;
    this.sun.castShadow = castShadow;
    this.changes++;
    return sheet;
  }
}

// Writes the product of a pose, which has no scale, and a matrix, both by columns.
function multiply(out, o, a, i, b) {
  for (let column = 0; column < 4; column++) {
    const k = 4 * column;
    const [x, y, z, w] = [b[k], b[k + 1], b[k + 2], b[k + 3]];
    out[o + k] = a[i] * x + a[i + 4] * y + a[i + 8] * z + a[i + 12] * w;
    out[o + k + 1] = a[i + 1] * x + a[i + 5] * y + a[i + 9] * z + a[i + 13] * w;
    out[o + k + 2] = a[i + 2] * x + a[i + 6] * y + a[i + 10] * z + a[i + 14] * w;
    out[o + k + 3] = w;
  }
}
