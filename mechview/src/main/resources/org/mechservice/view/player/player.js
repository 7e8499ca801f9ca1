import { add, cross, dot, norm, poseMatrix, product, scale, spanMatrix, subtract, turned, unit } from './space.js';
import { Motion, bytesOf, placed } from './recording.js';
import { Camera } from './camera.js';
import { Canvas3D } from './canvas3d.js';
import { Curves, short } from './curves.js';

const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];
const SERIES = ['#3b82d0', '#d97b1f', '#2f9e77', '#c2504d', '#8464c4', '#1c97a3', '#9c7a3c'];

const FORCE = [0.85, 0.27, 0.2, 1];
const REACTION = [0.16, 0.45, 0.85, 1];
const SHOWN = [
  ['bodies', 'Bodies', true],
  ['joints', 'Joints', true],
  ['forces', 'Forces', false],
  ['reactions', 'Reactions', false],
  ['traces', 'Traces', false],
  ['frames', 'Body frames', false],
  ['names', 'Names', false],
  ['floor', 'Floor', true],
];

const element = id => document.getElementById(id);

function rgb(number, opacity = 1) {
  return [(number >> 16 & 255) / 255, (number >> 8 & 255) / 255, (number & 255) / 255, opacity];
}

// A surface about the z axis from outlines of [radius, z].
function roundSurface(outline) {
  const around = 16;
  const corners = [];
  const triangles = [];
  outline.forEach(([radius, z], i) => {
    for (let j = 0; j < around; j++) {
      const angle = 2 * Math.PI * j / around;
      corners.push(radius * Math.cos(angle), radius * Math.sin(angle), z);
      if (i > 0) {
        const [a, b] = [(i - 1) * around, i * around];
        const next = (j + 1) % around;
        triangles.push(a + j, a + next, b + next, a + j, b + next, b + j);
      }
    }
  });
  return [new Float32Array(corners), new Uint32Array(triangles)];
}

export class Player {
  constructor(data) {
    this.data = data;
    this.motion = new Motion(data);
    this.time = this.motion.start;
    this.playing = false;
    this.selected = -1;
    this.follow = -2;
    this.shown = Object.fromEntries(SHOWN.map(([id, , on]) => [id, on]));
    this.charts = [];
    this.up = norm(data.gravity) > 0 ? unit(scale(data.gravity, -1)) : [0, 0, 1];
    // models are drawn along axes; a gravity that is a little askew tilts no picture
    const axis = this.up.findIndex(x => Math.abs(x) > 0.9);
    if (axis >= 0) {
      this.up = this.up.map((x, i) => (i === axis ? Math.sign(x) : 0));
    }
    this.camera = new Camera(this.up);
    this.canvas = element('scene');
    this.picture = new Canvas3D(this.canvas);
    this.readColours();
    this.controls();
    if (this.picture.gl) {
      this.build();
      this.pointing();
    } else {
      const problem = element('problem');
      problem.textContent =
        'This browser shows no WebGL 2, so the moving picture is missing; the curves work.';
      problem.hidden = false;
    }
    this.frameTimes = [];
    let before = performance.now();
    const tick = now => {
      this.step((now - before) / 1000);
      before = now;
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  readColours() {
    const style = getComputedStyle(document.documentElement);
    const read = name => style.getPropertyValue(`--${name}`).trim();
    const three = name => rgb(parseInt(read(name).slice(1), 16));
    this.colours = { text: read('soft'), grid: read('line'), accent: read('accent') };
    this.background = three('scene').slice(0, 3);
    // not quite opaque: what is drawn so hides nothing behind it
    this.gridColour = [...three('grid').slice(0, 3), 0.99];
    this.dark = this.background[0] < 0.5;
  }

  // ---- what is drawn ----

  build() {
    this.parts = this.data.parts.map(part => {
      const corners = new Float32Array(bytesOf(part.corners));
      const triangles = new Uint32Array(bytesOf(part.triangles));
      return { ...part, corners, triangles3d: triangles, mesh: this.picture.mesh(corners, triangles) };
    });
    this.rod = this.picture.mesh(...roundSurface([[0, 0], [1, 0], [1, 1], [0, 1]]));
    this.tip = this.picture.mesh(...roundSurface([[0, 0], [1, 0], [0, 1]]));
    this.bounds();
    this.travels = this.farthest() > 6 * this.data.extent;
    this.grid();
    if (this.travels && this.follow < 0 && this.data.bodies.length) {
      // what drives away would be a dot in a picture of the whole way
      this.follow = 0;
      element('follow').value = '0';
    }
    this.arrowScale = this.largestForce();
    this.camera.aspect = this.canvas.clientWidth / this.canvas.clientHeight || 1.6;
    this.fit();
  }

  // Boxes around the surfaces of each body, and everything they pass through.
  bounds() {
    const boxes = new Map();
    for (const part of this.parts) {
      if (part.role === 'SURFACE') {
        continue;
      }
      const box = boxes.get(part.body) || { least: [1e300, 1e300, 1e300], most: [-1e300, -1e300, -1e300] };
      boxes.set(part.body, box);
      for (let i = 0; i < part.corners.length; i++) {
        box.least[i % 3] = Math.min(box.least[i % 3], part.corners[i]);
        box.most[i % 3] = Math.max(box.most[i % 3], part.corners[i]);
      }
    }
    this.path = [];
    const frames = Math.min(this.motion.count, 60);
    for (let k = 0; k < frames; k++) {
      const at = Math.round(k * (this.motion.count - 1) / Math.max(1, frames - 1));
      const frame = { at, next: at, share: 0 };
      for (const [body, box] of boxes) {
        const pose = this.motion.pose(body, frame);
        for (let i = 0; i < 8; i++) {
          const corner = [0, 1, 2].map(a => (i >> a & 1 ? box.most[a] : box.least[a]));
          const place = add(pose.p, turned(pose.q, corner));
          if (place.every(Number.isFinite)) {
            this.path.push({ body, place });
          }
        }
      }
    }
    if (this.path.length === 0) {
      this.path.push({ body: -1, place: [0, 0, 0] });
    }
  }

  // How far a body gets from where it starts, if all of them do.
  farthest() {
    const way = new Map();
    for (const { body, place } of this.path) {
      if (body >= 0) {
        const first = way.get(body)?.first || place;
        const most = Math.max(way.get(body)?.most || 0, norm(subtract(place, first)));
        way.set(body, { first, most });
      }
    }
    return way.size ? Math.min(...[...way.values()].map(one => one.most)) : 0;
  }

  // The floor below everything; its lines are laid anew around what is followed.
  grid() {
    const extent = this.data.extent;
    const size = this.travels ? extent : Math.max(extent, ...this.path.map(point => norm(point.place)));
    this.gridStep = 10 ** Math.round(Math.log10(size / 5));
    this.gridHalf = this.gridStep * Math.ceil(size * (this.travels ? 4 : 1.3) / this.gridStep);
    this.floor = Math.min(...this.path.map(point => dot(point.place, this.up))) - 0.01 * extent;
    const light = this.light();
    // takes every point along the light to the floor: p - l (u·p - h) / (u·l)
    const m = new Float32Array(16);
    const ul = dot(this.up, light);
    for (let column = 0; column < 3; column++) {
      for (let row = 0; row < 3; row++) {
        m[4 * column + row] = (row === column ? 1 : 0) - light[row] * this.up[column] / ul;
      }
    }
    const lift = (this.floor + 1e-3 * this.data.extent) / ul;
    m.set([...scale(light, lift), 1], 12);
    this.shadow = m;
  }

  layGrid() {
    const x = this.camera.right;
    const y = cross(this.up, x);
    const { gridStep: step, gridHalf: half } = this;
    const snap = axis => (this.follow < 0 ? 0 : step * Math.round(dot(this.camera.target, axis) / step));
    const [cx, cy] = [snap(x), snap(y)];
    const key = `${cx} ${cy}`;
    if (this.gridKey === key) {
      return;
    }
    this.gridKey = key;
    const middle = add(scale(this.up, this.floor), add(scale(x, cx), scale(y, cy)));
    const lines = [];
    for (let k = -half; k <= half * 1.001; k += step) {
      for (const [along, across] of [[x, y], [y, x]]) {
        const base = add(middle, scale(across, k));
        lines.push(...add(base, scale(along, -half)), ...add(base, scale(along, half)));
      }
    }
    this.gridLines = this.picture.segments(lines, this.gridLines);
  }

  light() {
    return unit(add(add(this.up, scale(this.camera.right, -0.35)),
      scale(cross(this.camera.right, this.up), 0.3)));
  }

  fit(body = this.follow) {
    const chosen = this.path.filter(point => body < 0 || point.body === body);
    if (body >= 0) {
      const now = this.poses()(body);
      const half = 0.6 * this.data.extent;
      this.camera.fit([0, 1, 2].flatMap(i => [-half, half].map(d =>
        now.p.map((x, k) => (k === i ? x + d : x)))));
    } else {
      this.camera.fit((chosen.length ? chosen : this.path).map(point => point.place));
    }
  }

  look(view) {
    this.camera.look(view);
    this.fit();
    document.querySelectorAll('#views [data-view]').forEach(button =>
      button.setAttribute('aria-pressed', String(button.dataset.view === view)));
  }

  // The length that 95 % of the arrows of a run stay below belongs to a quarter of the extent.
  largestForce() {
    const sizes = [];
    const stride = Math.max(1, Math.floor(this.motion.count / 100));
    for (let at = 0; at < this.motion.count; at += stride) {
      const frame = { at, next: at, share: 0 };
      this.arrows(frame, () => this.motion.root, true, true)
        .forEach(arrow => sizes.push(norm(arrow.force)));
    }
    sizes.sort((a, b) => a - b);
    return sizes.length ? sizes[Math.floor(0.95 * (sizes.length - 1))] : 0;
  }

  // Forces, N, and the points they act at.
  arrows(frame, poses, forces, reactions) {
    const found = [];
    const put = (at, force, colour) => {
      if (force.every(Number.isFinite) && norm(force) > 0) {
        found.push({ at, force, colour });
      }
    };
    if (reactions) {
      for (const joint of this.data.joints) {
        if (joint.reaction >= 0 && joint.type !== 'F') {
          put(placed(poses, joint.at), this.motion.vector(joint.reaction, frame), REACTION);
        }
      }
    }
    if (forces) {
      for (const link of this.data.links) {
        if (link.tension >= 0) {
          const [from, to] = [placed(poses, link.from), placed(poses, link.to)];
          const pull = scale(unit(subtract(to, from)), this.motion.value(link.tension, frame));
          put(from, pull, FORCE);
          put(to, scale(pull, -1), FORCE);
        }
      }
      for (const force of this.data.forces) {
        if (force.kind === 'FORCE' && force.force >= 0) {
          const given = this.motion.vector(force.force, frame);
          const acting = force.inBodyAxes ? turned(poses(force.anchors[0][0]).q, given) : given;
          put(placed(poses, force.anchors[0]), acting, FORCE);
        } else if (force.kind === 'CONTACT' && force.normal >= 0) {
          const centre = placed(poses, force.anchors[0]);
          const normal = turned(poses(force.anchors[1][0]).q, force.direction);
          const push = scale(normal, this.motion.value(force.normal, frame));
          put(subtract(centre, scale(normal, force.radius)), push, FORCE);
        }
      }
    }
    return found;
  }

  poses(frame = this.motion.frame(this.time)) {
    const known = new Map();
    return body => {
      let pose = known.get(body);
      if (!pose) {
        pose = this.motion.pose(body, frame);
        known.set(body, pose);
      }
      return pose;
    };
  }

  draw() {
    const picture = this.picture;
    const frame = this.motion.frame(this.time);
    const poses = this.poses(frame);
    if (this.follow >= 0) {
      const place = poses(this.follow).p;
      if (this.followed) {
        this.camera.target = add(this.camera.target, subtract(place, this.followed));
      }
      this.followed = place;
    }
    this.camera.aspect = picture.begin(this.background);
    const matrix = this.camera.matrix();
    picture.look(matrix, this.light(), this.up, this.camera.axes().z);
    const models = new Map();
    const model = body => {
      if (!models.has(body)) {
        const pose = poses(body);
        models.set(body, poseMatrix(pose.p, pose.q));
      }
      return models.get(body);
    };
    const solid = [];
    for (const part of this.parts) {
      const on = part.role === 'JOINT' ? this.shown.joints : this.shown.bodies;
      if (on && part.opacity >= 1) {
        solid.push([part.mesh, model(part.body), this.colour(part)]);
      }
    }
    this.links(poses, solid);
    const shadows = this.shown.floor && this.camera.eye()
      && dot(this.camera.eye(), this.up) > this.floor;
    if (this.shown.floor) {
      this.layGrid();
      picture.drawLines(this.gridLines, this.gridColour, 1);
    }
    solid.forEach(one => picture.drawMesh(...one));
    if (shadows) {
      const shade = this.dark ? [0, 0, 0, 0.35] : [0.1, 0.15, 0.2, 0.16];
      picture.once(() => solid.forEach(([mesh, at]) =>
        picture.drawMesh(mesh, product(this.shadow, at), shade, 0)));
    }
    this.traces(frame);
    this.axes(poses);
    this.drawArrows(frame, poses);
    for (const part of this.parts) {
      if (part.opacity < 1 && this.shown.bodies) {
        picture.drawMesh(part.mesh, model(part.body), [...this.colour(part).slice(0, 3), part.opacity]);
      }
    }
    this.names(matrix, poses);
  }

  colour(part) {
    const colour = rgb(part.colour);
    if (part.body === this.selected && part.role === 'BODY' && this.selected >= 0) {
      return colour.map((x, i) => (i < 3 ? Math.min(1, x * 0.5 + [0.5, 0.42, 0.05][i]) : x));
    }
    return this.dark && part.role === 'JOINT' ? [0.55, 0.6, 0.66, 1] : colour;
  }

  links(poses, solid) {
    const coils = [];
    for (const link of this.data.links) {
      const [from, to] = [placed(poses, link.from), placed(poses, link.to)];
      if (link.kind === 'SPRING' && this.shown.bodies) {
        this.coil(coils, from, to);
      } else if (this.shown.bodies && norm(subtract(to, from)) > 0) {
        const width = (link.kind === 'ROD' ? 0.01 : 0.015) * this.data.extent;
        solid.push([this.rod, spanMatrix(from, to, width), rgb(link.colour)]);
      }
    }
    this.coils = this.picture.segments(coils, this.coils);
    this.picture.drawLines(this.coils, rgb(0x2f9e77), 2.2);
  }

  coil(lines, from, to) {
    const way = subtract(to, from);
    const length = norm(way);
    const z = unit(way);
    const x = unit(cross(Math.abs(z[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0], z));
    const y = cross(z, x);
    const radius = Math.min(0.025 * this.data.extent, 0.3 * length);
    const point = share => {
      const wide = share > 0.1 && share < 0.9 ? radius : 0;
      const angle = 16 * Math.PI * (share - 0.1) / 0.8;
      return add(add(from, scale(way, share)),
        add(scale(x, wide * Math.cos(angle)), scale(y, wide * Math.sin(angle))));
    };
    for (let i = 0; i < 120; i++) {
      lines.push(...point(i / 120), ...point((i + 1) / 120));
    }
  }

  traces(frame) {
    if (!this.shown.traces) {
      return;
    }
    if (!this.paths) {
      this.paths = this.data.bodies.map((body, index) => {
        const points = [];
        for (let at = 0; at < this.motion.count; at++) {
          const pose = this.motion.pose(index, { at, next: at, share: 0 });
          points.push(add(pose.p, turned(pose.q, body.centre)));
        }
        const lines = points.slice(1).flatMap((point, i) => [...points[i], ...point]);
        return this.picture.segments(lines, this.stalePaths?.[index]);
      });
    }
    this.data.bodies.forEach((body, index) => {
      if (this.selected < 0 || this.selected === index) {
        this.picture.drawLines(this.paths[index], rgb(body.colour, 0.9), 1.6, frame.at);
      }
    });
  }

  axes(poses) {
    if (!this.shown.frames) {
      return;
    }
    const length = 0.08 * this.data.extent;
    this.axisLines = this.axisLines || [];
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, i) => {
      const lines = [];
      for (let body = -1; body < this.data.bodies.length; body++) {
        const pose = poses(body);
        lines.push(...pose.p, ...add(pose.p, turned(pose.q, scale(axis, length))));
      }
      this.axisLines[i] = this.picture.segments(lines, this.axisLines[i]);
      const colour = [[0.85, 0.2, 0.2, 1], [0.15, 0.6, 0.2, 1], [0.25, 0.4, 0.95, 1]][i];
      this.picture.drawLines(this.axisLines[i], colour, 2.2);
    });
  }

  drawArrows(frame, poses) {
    if (!(this.arrowScale > 0)) {
      return;
    }
    const extent = this.data.extent;
    const perNewton = 0.25 * extent * 10 ** Number(element('arrows').value) / this.arrowScale;
    for (const arrow of this.arrows(frame, poses, this.shown.forces, this.shown.reactions)) {
      const length = Math.min(norm(arrow.force) * perNewton, 1.5 * extent);
      if (length < 0.004 * extent) {
        continue;
      }
      const way = unit(arrow.force);
      const head = Math.min(0.05 * extent, 0.4 * length);
      const neck = add(arrow.at, scale(way, length - head));
      this.picture.drawMesh(this.rod, spanMatrix(arrow.at, neck, 0.16 * head), arrow.colour);
      this.picture.drawMesh(
        this.tip, spanMatrix(neck, add(neck, scale(way, head)), 0.4 * head), arrow.colour);
    }
  }

  // Puts names beside bodies; a name that would cover one before it is left out.
  names(matrix, poses) {
    const labels = element('labels');
    labels.hidden = !this.shown.names && this.selected < 0;
    if (labels.hidden) {
      return;
    }
    if (!labels.children.length) {
      this.data.bodies.forEach(body => {
        const label = document.createElement('span');
        label.textContent = body.name;
        labels.append(label);
      });
      this.labelSizes = [...labels.children].map(label => [label.offsetWidth, label.offsetHeight]);
    }
    const taken = [];
    const order = this.data.bodies.map((body, index) => index);
    order.sort((a, b) => (b === this.selected) - (a === this.selected));
    for (const index of order) {
      const label = labels.children[index];
      const pose = poses(index);
      const point = add(pose.p, turned(pose.q, this.data.bodies[index].centre));
      const clip = [0, 1, 3].map(row =>
        matrix[row] * point[0] + matrix[4 + row] * point[1] + matrix[8 + row] * point[2] + matrix[12 + row]);
      const [width, height] = this.labelSizes[index];
      const x = (clip[0] / clip[2] + 1) / 2 * this.canvas.clientWidth + 8;
      const y = (1 - clip[1] / clip[2]) / 2 * this.canvas.clientHeight - height - 2;
      const free = taken.every(([a, b, w, h]) =>
        x > a + w || a > x + width || y > b + h || b > y + height);
      const wanted = this.shown.names || index === this.selected;
      label.hidden = !(wanted && clip[2] > 0 && free);
      if (!label.hidden) {
        taken.push([x, y, width, height]);
        label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      }
    }
  }

  // ---- time ----

  step(seconds) {
    if (this.playing) {
      let time = this.time + seconds * this.speed;
      const { start, end } = this.motion;
      if (time > end) {
        if (element('loop').checked && end > start) {
          time = start + (time - start) % (end - start);
        } else {
          time = end;
          this.play(false);
        }
      }
      this.seek(time);
    }
    const began = performance.now();
    if (this.picture.gl) {
      this.draw();
    }
    this.charts.forEach(chart => chart.draw(this.time, this.colours));
    this.frameTimes.push(performance.now() - began);
    if (this.frameTimes.length > 240) {
      this.frameTimes.shift();
    }
  }

  seek(time) {
    this.time = Math.min(this.motion.end, Math.max(this.motion.start, time));
    element('time').value = String(this.time);
    const clock = `${this.time.toFixed(this.decimals)} s`;
    element('time').setAttribute('aria-valuetext', clock);
    element('clock').textContent = `${clock} of ${this.motion.end.toFixed(this.decimals)} s`;
    this.tell();
  }

  stepFrames(count) {
    this.play(false);
    const frame = this.motion.frame(this.time);
    const nearest = frame.share > 0.999 ? frame.next : frame.at;
    const inside = frame.share > 0.001 && frame.share <= 0.999;
    const at = nearest + (count < 0 && inside ? count + 1 : count);
    this.seek(this.motion.times[Math.min(this.motion.count - 1, Math.max(0, at))]);
  }

  play(on) {
    this.playing = on;
    if (on && this.time >= this.motion.end) {
      this.seek(this.motion.start);
    }
    const button = element('play');
    button.textContent = on ? '❚❚' : '▶';
    button.setAttribute('aria-label', on ? 'Pause' : 'Play');
  }

  setSpeed(index) {
    const at = Math.min(SPEEDS.length - 1, Math.max(0, index));
    this.speed = SPEEDS[at];
    element('speed').value = String(at);
  }

  // ---- numbers ----

  place(name) {
    return this.data.columns.findIndex(column => column[0] === name);
  }

  tell() {
    const frame = this.motion.frame(this.time);
    const lines = [];
    if (this.energy) {
      const [kinetic, potential] = this.energy.map(column => this.motion.value(column, frame));
      lines.push(['energy', `${short(kinetic + potential)} J`]);
      lines.push(this.drift
        ? ['energy drift', `${short(this.drift[frame.at])} J`]
        : ['energy since start', `${short(this.data.change[frame.at])} J`]);
    }
    if (this.residual >= 0) {
      lines.push(['constraint residual', `${short(this.motion.value(this.residual, frame))} m`]);
    }
    if (this.selected >= 0) {
      const pose = this.motion.pose(this.selected, frame);
      const place = pose.p.map((x, i) => short(x + this.data.origin[i]));
      lines.push([this.data.bodies[this.selected].name, `(${place.join(', ')}) m`]);
    }
    const readout = element('readout');
    while (readout.children.length > 2 * lines.length) {
      readout.lastChild.remove();
    }
    lines.forEach((line, i) => line.forEach((text, k) => {
      const at = 2 * i + k;
      if (!readout.children[at]) {
        readout.append(document.createElement(k ? 'dd' : 'dt'));
      }
      if (readout.children[at].textContent !== text) {
        readout.children[at].textContent = text;
      }
    }));
    this.legends?.forEach(({ node, one, unit }) => {
      const text = `${short(this.motion.value(one.column, frame) + one.offset)} ${unit}`;
      node.textContent = text;
    });
  }

  // The columns of each thing that can be chosen.
  groups() {
    const groups = [];
    const columns = this.data.columns.map(([name, unit], column) => ({ name, unit, column, offset: 0 }));
    const put = (label, kind, name, wanted) => {
      const found = columns.filter(one => one.name.startsWith(`${name}.`) && wanted(one.name.slice(name.length + 1)));
      if (found.length) {
        groups.push({ label, kind, name, columns: found });
      }
    };
    put('Energy', 'run', 'energy', () => true);
    put('Constraint residuals', 'run', 'constraint', () => true);
    this.data.bodies.forEach((body, index) => {
      put(`Body ${body.name}`, 'body', body.name, end => /^([xyz]|v[xyz]|w[xyz])$/.test(end));
      if (body.pose >= 0) {
        [0, 1, 2].forEach(i => { columns[body.pose + i].offset = this.data.origin[i]; });
      }
      const last = groups[groups.length - 1];
      if (last?.kind === 'body') {
        last.body = index;
      }
    });
    this.data.joints.forEach(joint =>
      put(`Joint ${joint.name}`, 'joint', joint.name, end => /^([qva](\[\d+\])?|[ft][xyz]|drive.*)$/.test(end)));
    this.data.forces.forEach(force => put(`Force ${force.name}`, 'force', force.name, () => true));
    const used = new Set(groups.flatMap(group => group.columns.map(one => one.column)));
    const others = columns.filter(one => one.column > 0 && !used.has(one.column) && !/\.e[0-3]$/.test(one.name));
    if (others.length) {
      groups.push({ label: 'Other columns', kind: 'run', name: '', columns: others });
    }
    return groups;
  }

  showCurves(index) {
    const section = element('curves');
    section.replaceChildren();
    this.charts = [];
    this.legends = [];
    const group = this.curveGroups[index];
    section.hidden = !group;
    if (!group) {
      return;
    }
    const units = new Map();
    for (const one of group.columns) {
      units.set(one.unit, [...(units.get(one.unit) || []), one]);
    }
    for (const [unit, ones] of [...units].slice(0, 4)) {
      const figure = document.createElement('figure');
      const caption = document.createElement('figcaption');
      const canvas = document.createElement('canvas');
      const shown = ones.slice(0, SERIES.length);
      shown.forEach((one, i) => {
        const label = document.createElement('span');
        const line = document.createElement('i');
        line.style.background = SERIES[i];
        const value = document.createElement('span');
        label.append(line, `${group.name ? one.name.slice(group.name.length + 1) : one.name} `, value);
        caption.append(label);
        this.legends.push({ node: value, one, unit: unit === '1' ? '' : unit });
      });
      canvas.setAttribute('role', 'img');
      canvas.setAttribute('aria-label', `${group.label}: ${shown.map(one => one.name).join(', ')} over time, in ${unit}`);
      figure.append(caption, canvas);
      section.append(figure);
      const chart = new Curves(canvas, time => {
        this.play(false);
        this.seek(time);
      });
      chart.show(this.motion.times, shown.map((one, i) => ({
        values: this.motion.column(one.column), column: one.column, offset: one.offset, colour: SERIES[i],
      })));
      this.charts.push(chart);
    }
    this.tell();
  }

  // Marks the events along the time.
  mark() {
    const duration = this.motion.end - this.motion.start;
    element('marks').replaceChildren(...this.data.events.map(event => {
      const mark = document.createElement('b');
      mark.style.left = `${100 * (event.time - this.motion.start) / (duration || 1)}%`;
      mark.title = event.name;
      return mark;
    }));
  }

  // Shows another motion of the same mechanism: numbers column after column, change of its energy
  // since the start in each frame, and its events.
  replace({ numbers, frames, energy, events }) {
    this.data.numbers = numbers;
    this.data.frames = frames;
    this.data.change = energy;
    this.data.events = events;
    this.motion = new Motion(this.data);
    this.stalePaths = this.paths || this.stalePaths;
    this.paths = undefined;
    element('time').min = String(this.motion.start);
    element('time').max = String(this.motion.end);
    this.mark();
    this.charts.forEach(chart => chart.show(this.motion.times, chart.series.map(one =>
      ({ ...one, values: this.motion.column(one.column) }))));
    this.seek(this.time);
  }

  select(body) {
    this.selected = body;
    const at = this.curveGroups.findIndex(group => group.kind === 'body' && group.body === body);
    if (at >= 0) {
      element('curves-of').value = String(at);
      this.showCurves(at);
    }
    this.tell();
  }

  // ---- controls ----

  controls() {
    const data = this.data;
    const motion = this.motion;
    document.title = `${data.name} – MechService`;
    element('name').textContent = data.name;
    const count = (number, word) => `${number} ${word}${number === 1 ? '' : 's'}`;
    element('summary').textContent = [
      data.bodies.length === 1 ? '1 body' : `${data.bodies.length} bodies`,
      count(data.joints.length, 'joint'),
      count(motion.count, 'frame')].join(', ');
    const duration = motion.end - motion.start;
    this.decimals = duration > 0 ? Math.min(9, Math.max(0, 3 - Math.floor(Math.log10(duration)))) : 3;
    if (data.drift || data.change) {
      this.energy = ['kinetic', 'potential'].map(part => this.place(`energy.${part}`));
      this.drift = data.drift && new Float32Array(bytesOf(data.drift));
    }
    this.residual = this.place('constraint.position');

    const slider = element('time');
    slider.min = String(motion.start);
    slider.max = String(motion.end);
    slider.addEventListener('input', () => {
      this.play(false);
      this.seek(Number(slider.value));
    });
    element('play').addEventListener('click', () => this.play(!this.playing));
    this.mark();
    SPEEDS.forEach((speed, at) => element('speed').append(new Option(`${speed}×`, String(at))));
    element('speed').addEventListener('change', event => this.setSpeed(Number(event.target.value)));
    // a run of a moment lasts two seconds on the screen at least
    let at = SPEEDS.indexOf(1);
    while (at > 0 && duration / SPEEDS[at] < 2) {
      at--;
    }
    this.setSpeed(at);

    for (const [id, label] of SHOWN) {
      if (this.available(id)) {
        const box = document.createElement('input');
        box.type = 'checkbox';
        box.id = `show-${id}`;
        box.checked = this.shown[id];
        box.addEventListener('change', () => { this.shown[id] = box.checked; });
        const text = document.createElement('label');
        text.append(box, ` ${label}`);
        element('toggles').append(text);
      }
    }
    const follow = element('follow');
    follow.append(new Option('nothing', '-2'));
    data.bodies.forEach((body, index) => follow.append(new Option(body.name, String(index))));
    follow.addEventListener('change', () => {
      this.follow = Number(follow.value);
      this.followed = undefined;
      if (this.picture.gl) {
        this.fit();
      }
      this.select(Math.max(-1, this.follow));
    });
    this.curveGroups = this.groups();
    const curves = element('curves-of');
    curves.append(new Option('nothing', '-1'));
    this.curveGroups.forEach((group, index) => curves.append(new Option(group.label, String(index))));
    curves.addEventListener('change', () => this.showCurves(Number(curves.value)));
    const first = this.curveGroups.length ? 0 : -1;
    curves.value = String(first);
    for (const [label, text] of data.facts) {
      const term = document.createElement('dt');
      const value = document.createElement('dd');
      term.textContent = label;
      value.textContent = text;
      element('facts').append(term, value);
    }
    element('about').hidden = data.facts.length === 0;
    document.querySelectorAll('#views [data-view]').forEach(button =>
      button.addEventListener('click', () => this.look(button.dataset.view)));
    element('fit').addEventListener('click', () => this.fit());
    document.addEventListener('keydown', event => this.key(event));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.readColours());
    this.seek(motion.start);
    this.showCurves(first);
    this.play(duration > 0 && !matchMedia('(prefers-reduced-motion: reduce)').matches);
  }

  available(id) {
    if (id === 'reactions') {
      return this.data.joints.some(joint => joint.reaction >= 0 && joint.type !== 'F');
    }
    return id !== 'forces' || this.data.links.some(link => link.tension >= 0)
      || this.data.forces.some(force => force.force >= 0 || force.normal >= 0);
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    const field = event.target.closest?.('select, input, summary, button');
    if (field && field.id !== 'time' && (event.key === ' ' || field.tagName === 'SELECT'
      || field.type === 'range')) {
      return;
    }
    const turn = 0.1;
    const keys = {
      ' ': () => this.play(!this.playing),
      ArrowLeft: () => (event.shiftKey ? this.camera.turn(-turn, 0) : this.stepFrames(-1)),
      ArrowRight: () => (event.shiftKey ? this.camera.turn(turn, 0) : this.stepFrames(1)),
      ArrowUp: () => event.shiftKey && this.camera.turn(0, turn),
      ArrowDown: () => event.shiftKey && this.camera.turn(0, -turn),
      Home: () => this.seek(this.motion.start),
      End: () => this.seek(this.motion.end),
      '+': () => this.setSpeed(SPEEDS.indexOf(this.speed) + 1),
      '-': () => this.setSpeed(SPEEDS.indexOf(this.speed) - 1),
      l: () => { element('loop').checked = !element('loop').checked; },
      f: () => this.fit(),
      PageUp: () => this.camera.zoom(0.85),
      PageDown: () => this.camera.zoom(1 / 0.85),
      1: () => this.look('iso'),
      2: () => this.look('front'),
      3: () => this.look('side'),
      4: () => this.look('top'),
    };
    const act = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (act && (this.picture.gl || !['f', '1', '2', '3', '4'].includes(event.key))) {
      event.preventDefault();
      act();
    }
  }

  // Mouse, pen and fingers on the picture.
  pointing() {
    const canvas = this.canvas;
    const pointers = new Map();
    let moved = 0;
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      moved = 0;
    });
    canvas.addEventListener('pointermove', event => {
      const before = pointers.get(event.pointerId);
      if (!before) {
        return;
      }
      const now = [event.clientX, event.clientY];
      const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
      moved += Math.abs(dx) + Math.abs(dy);
      const other = [...pointers].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        const apart = point => Math.hypot(point[0] - other[0], point[1] - other[1]) || 1;
        this.camera.zoom(apart(before) / apart(now));
        this.camera.pan(dx / 2 / canvas.clientHeight, dy / 2 / canvas.clientHeight);
      } else if (event.shiftKey || event.buttons & 6) {
        this.camera.pan(dx / canvas.clientHeight, dy / canvas.clientHeight);
      } else if (moved > 3) {
        this.camera.turn(dx * 0.008, dy * 0.008);
      }
      pointers.set(event.pointerId, now);
    });
    const end = event => {
      if (pointers.delete(event.pointerId) && moved <= 3 && event.type === 'pointerup') {
        this.pick(event);
      }
    };
    canvas.addEventListener('pointerup', end);
    canvas.addEventListener('pointercancel', end);
    canvas.addEventListener('contextmenu', event => event.preventDefault());
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      this.camera.zoom(Math.exp(Math.sign(event.deltaY) * Math.min(120, Math.abs(event.deltaY)) * 0.0015));
    }, { passive: false });
  }

  // Selects the body under a pointer.
  pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const ray = this.camera.ray(
      2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height);
    const poses = this.poses();
    let nearest = Infinity;
    let found = -1;
    for (const part of this.parts) {
      if (part.role !== 'BODY') {
        continue;
      }
      const { p, q } = poses(part.body);
      const back = [q[0], -q[1], -q[2], -q[3]];
      const from = turned(back, subtract(ray.from, p));
      const along = turned(back, ray.along);
      const hit = nearestHit(part, from, along);
      if (hit < nearest) {
        nearest = hit;
        found = part.body;
      }
    }
    this.select(found);
  }
}

// The distance along a ray to the first triangle of a part that it meets.
function nearestHit(part, from, along) {
  const corner = i => [part.corners[3 * i], part.corners[3 * i + 1], part.corners[3 * i + 2]];
  let nearest = Infinity;
  for (let i = 0; i < part.triangles3d.length; i += 3) {
    const a = corner(part.triangles3d[i]);
    const ab = subtract(corner(part.triangles3d[i + 1]), a);
    const ac = subtract(corner(part.triangles3d[i + 2]), a);
    const normal = cross(along, ac);
    const volume = dot(ab, normal);
    const away = subtract(from, a);
    const u = dot(away, normal) / volume;
    const side = cross(away, ab);
    const v = dot(along, side) / volume;
    const distance = dot(ac, side) / volume;
    if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < nearest) {
      nearest = distance;
    }
  }
  return nearest;
}
