import { add, cross, dot, norm, scale, subtract, turned, turnedBack, unit } from './space.js';
import { Motion, bytesOf, placed } from './recording.js';
import { ropeLines } from './rope.js';
import { ARROWS, MechanismScene } from './scene.js';
import { Curves, short, unitOf, valueAt } from './curves.js';

const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];
const SERIES = 8;

const SHOWN = [
  ['bodies', 'Bodies', true],
  ['joints', 'Joints', true],
  ['forces', 'Forces', false],
  ['reactions', 'Reactions', false],
  ['traces', 'Traces', false],
  ['frames', 'Body frames', false],
  ['inertia', 'Boxes of inertia', false],
  ['names', 'Names', false],
  ['floor', 'Floor', true],
];

const element = id => document.getElementById(id);
const make = (tag, text = '', properties = {}) =>
  Object.assign(document.createElement(tag), { textContent: text, ...properties });

// Gives the reader a file of the page's own making.
function save(name, content, type) {
  const link = make('a', '', { download: name });
  link.href = content instanceof Blob ? URL.createObjectURL(content)
    : URL.createObjectURL(new Blob([content], { type }));
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

export class Player {
  constructor(data) {
    this.data = data;
    this.motion = new Motion(data);
    this.time = this.motion.start;
    this.playing = false;
    this.selected = -2;
    this.follow = -2;
    this.shown = Object.fromEntries(SHOWN.map(([id, , on]) => [id, on]));
    this.charts = [];
    this.measures = [];
    this.picked = [];
    this.scene = new MechanismScene(element('scene'));
    this.scene.show(data);
    this.readColours();
    this.controls();
    if (this.scene.works) {
      this.learn();
      this.arrowScale = this.largestForce();
      this.look('iso');
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
    this.colours = { text: read('soft'), grid: read('line'), border: read('border'),
      accent: read('accent'), panel: read('panel'), sky: read('sky'), scene: read('scene') };
    this.seriesColours = Array.from({ length: SERIES }, (_, i) => read(`series-${i + 1}`));
    const dark = matchMedia('(prefers-color-scheme: dark)').matches;
    this.scene.colours({ sheet: read('sheet'), line: read('grid'), dark });
    this.charts.forEach(chart => this.fill(chart));
  }

  // ---- the picture ----

  // The mechanism's positions in some frames tell what the picture has to hold.
  learn() {
    const frames = Math.min(this.motion.count, 60);
    const positions = Array.from({ length: frames }, (_, k) => {
      const at = Math.round(k * (this.motion.count - 1) / Math.max(1, frames - 1));
      return this.motion.poses({ at, next: at, share: 0 });
    });
    this.scene.learn(positions);
    if (this.scene.travels && this.follow < 0 && this.data.bodies.length) {
      // what drives away would be a dot in a picture of the whole way
      const masses = this.data.bodies.map(body => body.mass);
      this.follow = masses.indexOf(Math.max(...masses));
      element('follow').value = String(this.follow);
    }
  }

  poses() {
    return this.motion.poses(this.motion.frame(this.time));
  }

  fit() {
    this.scene.fit(this.poses(), this.follow);
  }

  look(view) {
    this.scene.look(view);
    this.fit();
    this.pressView(view);
  }

  pressView(view) {
    document.querySelectorAll('#views [data-view]').forEach(button =>
      button.setAttribute('aria-pressed', String(button.dataset.view === view)));
  }

  // The length that 95 % of the arrows of a run stay below belongs to a quarter of the extent.
  largestForce() {
    const sizes = [];
    const stride = Math.max(1, Math.floor(this.motion.count / 100));
    for (let at = 0; at < this.motion.count; at += stride) {
      const frame = { at, next: at, share: 0 };
      this.forces(frame, this.motion.poses(frame), true, true)
        .forEach(arrow => sizes.push(norm(arrow.force)));
    }
    sizes.sort((a, b) => a - b);
    return sizes.length ? sizes[Math.floor(0.95 * (sizes.length - 1))] : 0;
  }

  // Forces, N, and the points they act at.
  forces(frame, poses, forces, reactions) {
    const found = [];
    const put = (at, force, kind) => {
      if (force.every(Number.isFinite) && norm(force) > 0) {
        found.push({ at, force, kind });
      }
    };
    if (reactions) {
      for (const joint of this.data.joints) {
        if (joint.reaction >= 0 && joint.type !== 'F') {
          put(placed(poses, joint.at), this.motion.vector(joint.reaction, frame), 'reaction');
        }
      }
    }
    if (forces) {
      const pulled = new Set();
      for (const link of this.data.links) {
        if (link.tension >= 0 && !(link.kind === 'DAMPER' && pulled.has(link.name))) {
          pulled.add(link.name);
          const [from, to] = [placed(poses, link.from), placed(poses, link.to)];
          const pull = scale(unit(subtract(to, from)), this.motion.value(link.tension, frame));
          put(from, pull, 'force');
          put(to, scale(pull, -1), 'force');
        }
      }
      for (const rope of this.data.ropes) {
        for (const line of rope.tension < 0 ? [] : ropeLines(rope, poses)) {
          const tension = this.motion.value(rope.tension, frame);
          const last = line.length - 1;
          put(line[0], scale(unit(subtract(line[1], line[0])), tension), 'force');
          put(line[last], scale(unit(subtract(line[last - 1], line[last])), tension), 'force');
        }
      }
      for (const force of this.data.forces) {
        if (force.kind === 'FORCE' && force.force >= 0) {
          const given = this.motion.vector(force.force, frame);
          const acting = force.inBodyAxes ? turned(poses(force.anchors[0][0]).q, given) : given;
          put(placed(poses, force.anchors[0]), acting, 'force');
        } else if (force.kind === 'CONTACT' && force.normal >= 0) {
          const { at, normal } = this.touch(force, poses);
          put(at, scale(normal, this.motion.value(force.normal, frame)), 'contact');
        }
      }
    }
    return found;
  }

  // Where a contact touches, and in which direction its surface pushes.
  touch(force, poses) {
    const centre = placed(poses, force.anchors[0]);
    let normal = turned(poses(force.anchors[1][0]).q, force.direction);
    if (norm(normal) === 0) {
      normal = unit(subtract(centre, placed(poses, force.anchors[1])));
    }
    let down = normal;
    if (norm(force.axle) > 0) {
      const axle = turned(poses(force.anchors[0][0]).q, force.axle);
      down = unit(subtract(normal, scale(axle, dot(axle, normal))));
    }
    return { at: subtract(centre, scale(down, force.radius)), normal };
  }

  // Draws anew, unless everything is as it was.
  draw() {
    const key = `${this.time} ${this.arrowKey} ${JSON.stringify(this.shown)} ${this.measures.length} ${this.picked.length}`;
    if (key === this.drawnKey && !this.scene.changed) {
      return;
    }
    this.drawnKey = key;
    const frame = this.motion.frame(this.time);
    const poses = this.motion.poses(frame);
    this.scene.place(poses, this.follow);
    this.drawArrows(frame, poses);
    this.traces(frame);
    if (this.shown.frames || this.framesDrawn) {
      this.scene.drawAxes(this.shown.frames);
      this.framesDrawn = this.shown.frames;
    }
    this.scene.render(this.shown.floor);
    this.names(poses);
  }

  perNewton() {
    const extent = this.data.extent;
    return 0.25 * extent * 10 ** Number(element('arrows').value) / this.arrowScale;
  }

  drawArrows(frame, poses) {
    const arrows = this.arrows(frame, poses);
    if (arrows || this.arrowsDrawn) {
      this.arrowsDrawn = Boolean(arrows);
      this.scene.drawArrows(arrows || []);
    }
  }

  // The arrows that are shown, if any are asked for.
  arrows(frame, poses) {
    if (this.arrowScale <= 0 || !(this.shown.forces || this.shown.reactions)) {
      return undefined;
    }
    const longest = 0.8 * this.data.extent;
    return this.forces(frame, poses, this.shown.forces, this.shown.reactions).map(({ at, force, kind }) => {
      const length = norm(force) * this.perNewton();
      return { at, kind, along: scale(force, Math.min(length, longest) / norm(force)) };
    });
  }

  // What the colours of the arrows mean, and how long they are.
  legend() {
    const kinds = [];
    if (this.shown.forces) {
      kinds.push('force');
      if (this.data.forces.some(force => force.kind === 'CONTACT' && force.normal >= 0)) {
        kinds.push('contact');
      }
    }
    if (this.shown.reactions) {
      kinds.push('reaction');
    }
    const lines = kinds.map(kind => {
      const item = make('li', ARROWS[kind].label);
      const swatch = make('i');
      swatch.style.background = `#${ARROWS[kind].colour.toString(16).padStart(6, '0')}`;
      item.append(swatch);
      return item;
    });
    if (lines.length && this.arrowScale > 0) {
      const newtons = 0.1 * this.data.extent / this.perNewton();
      lines.push(make('li', `${short(0.1 * this.data.extent)} m of arrow: ${short(newtons)} N`));
    }
    element('legend').replaceChildren(...lines);
  }

  traces(frame) {
    if (!this.shown.traces) {
      if (this.traced) {
        this.traced.forEach(key => this.scene.dropLine(key));
        this.traced = undefined;
      }
      return;
    }
    if (!this.traced) {
      this.traced = this.data.bodies.map((body, index) => {
        const points = [];
        for (let at = 0; at < this.motion.count; at++) {
          const pose = this.motion.pose(index, { at, next: at, share: 0 });
          points.push(add(pose.p, turned(pose.q, body.centre)));
        }
        const key = `trace ${index}`;
        this.scene.dropLine(key);
        this.scene.line(key, points.slice(1).map((point, i) => [points[i], point]), body.colour, 2);
        return key;
      });
    }
    this.traced.forEach((key, index) => {
      const on = this.selected < 0 || this.selected === index;
      this.scene.line(key, undefined, 0, 2, on ? frame.at : 0);
    });
  }

  // Puts names beside bodies; a name that would cover one before it is left out. Draws measures.
  names(poses) {
    const labels = element('labels');
    if (!this.tags) {
      this.tags = this.data.bodies.map(body => make('span', body.name, { hidden: true }));
      labels.replaceChildren(...this.tags);
    }
    this.drawMeasures(poses);
    if (!this.shown.names && this.selected < 0 && !this.named) {
      return;
    }
    this.named = this.shown.names || this.selected >= 0;
    const taken = [];
    const order = this.data.bodies.map((body, index) => index);
    order.sort((a, b) => (b === this.selected) - (a === this.selected));
    for (const index of order) {
      const tag = this.tags[index];
      const wanted = this.shown.names || index === this.selected;
      const pose = wanted && poses(index);
      const place = pose && this.scene.project(add(pose.p, turned(pose.q, this.data.bodies[index].centre)));
      if (!place) {
        tag.hidden = true;
        continue;
      }
      tag.hidden = false;
      tag.size ??= [tag.offsetWidth, tag.offsetHeight];
      const [width, height] = tag.size;
      const x = place[0] + 8;
      const y = place[1] - height - 2;
      tag.hidden = !taken.every(([a, b, w, h]) => x > a + w || a > x + width || y > b + h || b > y + height);
      if (!tag.hidden) {
        taken.push([x, y, width, height]);
        tag.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      }
    }
  }

  // ---- measures ----

  measureMode(mode) {
    this.mode = this.mode === mode ? undefined : mode;
    this.picked = [];
    for (const id of ['distance', 'angle']) {
      element(id).setAttribute('aria-pressed', String(this.mode === id));
    }
    element('stage').classList.toggle('measures', Boolean(this.mode));
  }

  // A point that the reader has pointed at, in axes of its body.
  pickPoint({ body, point }) {
    const { p, q } = this.poses()(body);
    this.picked.push([body, ...turnedBack(q, subtract(point, p))]);
    if (this.picked.length === (this.mode === 'angle' ? 3 : 2)) {
      this.addMeasure(this.mode, this.picked);
      this.measureMode(this.mode);
    }
  }

  addMeasure(kind, points) {
    const number = this.measures.length + 1;
    const name = kind === 'angle' ? `angle ${number}` : `distance ${number}`;
    const times = this.motion.times;
    const values = Float32Array.from(times, (_, at) =>
      this.measured(kind, points, this.motion.poses({ at, next: at, share: 0 })));
    const measure = { kind, points, name, unit: kind === 'angle' ? '°' : 'm', times, values, offset: 0 };
    this.measures.push(measure);
    const item = make('li', `${name}: ${points.map(([body]) => this.bodyName(body)).join(' – ')} `);
    const value = make('b');
    const gone = make('button', 'Remove', { type: 'button', className: 'quiet' });
    gone.addEventListener('click', () => {
      this.measures.splice(this.measures.indexOf(measure), 1);
      item.remove();
      this.charts.forEach(chart => this.setColumns(chart, chart.columns.filter(one => one !== measure)));
    });
    item.append(value, gone);
    element('measures').append(item);
    measure.shown = value;
    this.addChart([measure]);
  }

  bodyName(body) {
    return body < 0 ? this.data.rootName : this.data.bodies[body].name;
  }

  measured(kind, points, poses) {
    const places = points.map(point => placed(poses, point));
    if (kind === 'distance') {
      return norm(subtract(places[0], places[1]));
    }
    const [a, b] = [subtract(places[0], places[1]), subtract(places[2], places[1])];
    return Math.atan2(norm(cross(a, b)), dot(a, b)) * 180 / Math.PI;
  }

  drawMeasures(poses) {
    const wanted = [...this.measures.map(one => one.points), ...(this.picked.length ? [this.picked] : [])];
    if (!wanted.length) {
      this.sheet?.remove();
      this.sheet = undefined;
      return;
    }
    if (!this.sheet) {
      this.sheet = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
      element('labels').prepend(this.sheet);
    }
    const drawn = wanted.flatMap(points => {
      const places = points.map(point => this.scene.project(placed(poses, point))).filter(Boolean);
      const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
      path.setAttribute('d', places.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`).join(''));
      return [path, ...places.map(([x, y]) => {
        const spot = document.createElementNS('http://www.w3.org/2000/svg', 'circle');
        spot.setAttribute('cx', x.toFixed(1));
        spot.setAttribute('cy', y.toFixed(1));
        spot.setAttribute('r', '4');
        return spot;
      })];
    });
    this.sheet.replaceChildren(...drawn);
    this.measures.forEach(one => {
      one.shown.textContent = `${short(this.measured(one.kind, one.points, poses))} ${one.unit}`;
    });
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
    if (this.scene.works && !this.filming) {
      this.draw();
    }
    this.charts.forEach(chart => chart.curves.draw(this.time, this.colours));
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

  // Kinetic energy of a body, J, if the run has its velocities.
  kinetic(index, frame) {
    const body = this.data.bodies[index];
    if (!(body.mass > 0) || body.speed < 0) {
      return undefined;
    }
    const { q } = this.motion.pose(index, frame);
    const turning = this.motion.vector(body.speed + 3, frame);
    const centre = add(this.motion.vector(body.speed, frame), cross(turning, turned(q, body.centre)));
    const [x, y, z] = turnedBack(q, turning);
    const [xx, yy, zz, xy, xz, yz] = body.inertia;
    return body.mass * dot(centre, centre) / 2
      + (xx * x * x + yy * y * y + zz * z * z) / 2 + xy * x * y + xz * x * z + yz * y * z;
  }

  tell() {
    const frame = this.motion.frame(this.time);
    const lines = [];
    if (this.selected >= 0) {
      const body = this.data.bodies[this.selected];
      const pose = this.motion.pose(this.selected, frame);
      const place = pose.p.map((x, i) => short(x + this.data.origin[i]));
      lines.push([body.name, body.mass > 0 ? `${short(body.mass)} kg` : 'without mass']);
      lines.push(['at', `(${place.join(', ')}) m`]);
      const angle = 2 * Math.atan2(norm(pose.q.slice(1)), Math.abs(pose.q[0])) * 180 / Math.PI;
      lines.push(['turned by', `${short(angle)}° about (${unit(scale(pose.q.slice(1), Math.sign(pose.q[0]) || 1)).map(short).join(', ')})`]);
      const kinetic = this.kinetic(this.selected, frame);
      if (kinetic !== undefined) {
        lines.push(['kinetic energy', `${short(kinetic)} J`]);
      }
    }
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
    for (const chart of this.charts) {
      chart.values.forEach(({ node, one }) => {
        node.textContent = `${short(valueAt(one, this.time))} ${unitOf(one.unit)}`;
      });
    }
  }

  // ---- curves ----

  // The columns of each thing that has some.
  groups() {
    const groups = [];
    const largest = new Map();
    this.columns = this.data.columns.map(([name, unit], column) => ({ name, unit, column, offset: 0 }));
    for (const one of this.columns) {
      const values = this.motion.column(one.column);
      let most = 0;
      for (let i = 0; i < values.length; i += 1 + (values.length >> 9)) {
        most = Math.max(most, Math.abs(values[i]) || 0);
      }
      largest.set(one.unit, Math.max(largest.get(one.unit) || 0, most));
    }
    // what is so small beside the largest value of its unit in this run is a zero
    this.zero = unit => 1e-9 * (largest.get(unit) || 0);
    const owned = new Map();
    for (const one of this.columns) {
      const owner = one.name.slice(0, Math.max(0, one.name.lastIndexOf('.')));
      owned.set(owner, [...(owned.get(owner) || []), one]);
    }
    const put = (label, kind, name, wanted) => {
      const found = (owned.get(name) || []).filter(one => wanted(one.name.slice(name.length + 1)));
      if (found.length) {
        groups.push({ label, kind, name, columns: found });
      }
    };
    put('Energy', 'run', 'energy', () => true);
    put('Constraint residuals', 'run', 'constraint', () => true);
    this.data.bodies.forEach((body, index) => {
      put(`Body ${body.name}`, 'body', body.name, end => /^([xyz]|v[xyz]|w[xyz])$/.test(end));
      if (body.pose >= 0) {
        [0, 1, 2].forEach(i => { this.columns[body.pose + i].offset = this.data.origin[i]; });
      }
      const last = groups[groups.length - 1];
      if (last?.kind === 'body' && last.name === body.name) {
        last.body = index;
      }
    });
    this.data.joints.forEach(joint =>
      put(`Joint ${joint.name}`, 'joint', joint.name, end => /^([qva](\[\d+\])?|[ft][xyz]|drive.*)$/.test(end)));
    this.data.forces.forEach(force => put(`Force ${force.name}`, 'force', force.name, () => true));
    const used = new Set(groups.flatMap(group => group.columns.map(one => one.column)));
    const others = this.columns.filter(one => one.column > 0 && !used.has(one.column) && !/\.e[0-3]$/.test(one.name));
    if (others.length) {
      groups.push({ label: 'Other columns', kind: 'run', name: '', columns: others });
    }
    return groups;
  }

  series(column) {
    return column.values ? column
      : { ...column, times: this.motion.times, values: this.motion.column(column.column), floor: this.zero(column.unit) };
  }

  addChart(columns) {
    const figure = make('figure');
    const caption = make('figcaption');
    const canvas = make('canvas');
    canvas.setAttribute('role', 'img');
    figure.append(caption, canvas);
    element('curves').append(figure);
    element('curves').hidden = false;
    const curves = new Curves(canvas, time => {
      this.play(false);
      this.seek(time);
    });
    const chart = { figure, caption, canvas, curves, columns, values: [] };
    figure.addEventListener('pointerdown', () => this.activate(chart));
    this.charts.push(chart);
    this.activate(chart);
    this.fill(chart);
    this.tickTree();
    return chart;
  }

  activate(chart) {
    this.active = chart;
    this.charts.forEach(one => one.figure.classList.toggle('active', one === chart));
    this.tickTree();
  }

  dropChart(chart) {
    chart.figure.remove();
    this.charts.splice(this.charts.indexOf(chart), 1);
    this.active = this.charts[this.charts.length - 1];
    this.charts.forEach(one => one.figure.classList.toggle('active', one === this.active));
    element('curves').hidden = this.charts.length === 0;
    this.tickTree();
  }

  setColumns(chart, columns) {
    chart.columns = columns;
    if (columns.length) {
      this.fill(chart);
    } else {
      this.dropChart(chart);
    }
    this.tickTree();
  }

  // Draws the curves of a diagram anew, those of another run dashed beside them.
  fill(chart) {
    const series = [];
    chart.values = [];
    const common = commonStart(chart.columns.map(column => column.name));
    chart.caption.replaceChildren();
    chart.columns.forEach((column, i) => {
      const colour = this.seriesColours[i % SERIES];
      const one = { ...this.series(column), colour };
      series.push(one);
      const label = make('span');
      const line = make('i');
      line.style.background = colour;
      const node = make('span');
      label.append(line, `${i ? column.name.slice(common.length) : column.name} `, node);
      label.title = column.name;
      chart.caption.append(label);
      chart.values.push({ node, one });
      const other = this.other?.columns.get(column.name);
      if (other) {
        series.push({ ...one, name: `${column.name} (${this.other.name})`, times: this.other.times,
          values: other, offset: 0, dashed: true });
      }
    });
    const saves = make('span', '', { className: 'saves' });
    const file = `${this.data.name}-${chart.columns[0].name}`.replace(/[^\w.-]+/g, '_');
    const button = (text, label, act) => {
      const one = make('button', text, { type: 'button', className: 'quiet' });
      one.setAttribute('aria-label', label);
      one.addEventListener('click', act);
      saves.append(one);
    };
    const names = chart.columns.map(column => column.name).join(', ');
    button('SVG', `Save ${names} as SVG`, () => save(`${file}.svg`, chart.curves.svg(this.colours), 'image/svg+xml'));
    button('PNG', `Save ${names} as PNG`, () => chart.curves.png(this.colours).toBlob(blob => save(`${file}.png`, blob)));
    button('CSV', `Save ${names} as CSV`, () => save(`${file}.csv`, chart.curves.csv(), 'text/csv'));
    button('×', `Remove the diagram of ${names}`, () => this.dropChart(chart));
    chart.caption.append(saves);
    const units = [...new Set(chart.columns.map(column => column.unit))].join(', ');
    chart.canvas.setAttribute('aria-label', `${names} over time, in ${units}`);
    chart.curves.show(series);
    this.tell();
  }

  // Shows the columns of one thing, those of one unit in one diagram.
  showCurves(index) {
    [...this.charts].forEach(chart => this.dropChart(chart));
    const group = this.curveGroups[index];
    if (group) {
      const units = new Map();
      for (const one of group.columns) {
        units.set(one.unit, [...(units.get(one.unit) || []), one]);
      }
      [...units.values()].slice(0, 4).forEach(ones => this.addChart(ones.slice(0, SERIES)));
      this.activate(this.charts[0]);
    }
  }

  // All columns, those of a joint, body or force together; each can be put into the chosen diagram.
  makeTree() {
    const box = element('columns');
    const kinds = { joint: 'Joints', body: 'Bodies', force: 'Forces', run: 'The run' };
    this.ticks = [];
    const branch = (title, inner, open = false) => {
      const details = make('details', '', { open });
      details.append(make('summary', title), ...inner);
      return details;
    };
    for (const [kind, title] of Object.entries(kinds)) {
      const groups = this.curveGroups.filter(group => group.kind === kind);
      if (groups.length) {
        box.append(branch(title, groups.map(group => branch(group.name || group.label, group.columns.map(column => {
          const label = make('label');
          const tick = make('input', '', { type: 'checkbox' });
          tick.addEventListener('change', () => this.toggleColumn(column, tick.checked));
          this.ticks.push({ tick, column, label });
          const end = group.name ? column.name.slice(group.name.length + 1) : column.name;
          label.append(tick, make('span', end), make('small', unitOf(column.unit)));
          tick.setAttribute('aria-label', column.name);
          return label;
        }))), true));
      }
    }
    const more = make('button', 'New diagram', { type: 'button' });
    more.addEventListener('click', () => {
      this.active = undefined;
      this.charts.forEach(chart => chart.figure.classList.remove('active'));
      this.tickTree();
    });
    element('tree').insertBefore(more, box);
    element('find').addEventListener('input', () => {
      const wanted = element('find').value.toLowerCase();
      this.ticks.forEach(({ label, column }) => { label.hidden = !column.name.toLowerCase().includes(wanted); });
      box.querySelectorAll('details details').forEach(details => {
        details.hidden = !details.querySelector('label:not([hidden])');
        details.open = wanted !== '' && !details.hidden;
      });
    });
  }

  toggleColumn(column, on) {
    if (on && !this.active) {
      this.addChart([column]);
    } else if (on) {
      this.setColumns(this.active, [...this.active.columns, column]);
    } else if (this.active) {
      this.setColumns(this.active, this.active.columns.filter(one => one !== column));
    }
  }

  tickTree() {
    this.ticks?.forEach(({ tick, column }) => { tick.checked = Boolean(this.active?.columns.includes(column)); });
  }

  // Another run's columns, drawn dashed over those of this one.
  compare(name, times, columns) {
    this.other = { name, times, columns };
    this.charts.forEach(chart => this.fill(chart));
  }

  async openOther(file) {
    const said = element('other-said');
    const [head, ...lines] = (await file.text()).split(/\r?\n/).filter(Boolean);
    const names = head.match(/("([^"]|"")*"|[^,]*)(,|$)/g).map(name =>
      name.replace(/,$/, '').replace(/^"|"$/g, '').replace(/""/g, '"'));
    const rows = lines.map(line => line.split(',').map(Number));
    if (names[0] !== 't' || !rows.length) {
      said.textContent = `${file.name} is no result file: its first column must be t, and it needs a row.`;
      return;
    }
    const columns = new Map(names.map((name, i) => [name, rows.map(row => row[i])]));
    const shared = this.columns.filter(one => one.column > 0 && columns.has(one.name)).length;
    said.textContent = shared ? `${file.name}: ${rows.length} rows, ${shared} columns of this run.`
      : `${file.name} has no column of this run.`;
    this.compare(file.name, columns.get('t'), columns);
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
    this.traced?.forEach(key => this.scene.dropLine(key));
    this.traced = undefined;
    this.drawnKey = undefined;
    element('time').min = String(this.motion.start);
    element('time').max = String(this.motion.end);
    this.mark();
    for (const one of this.measures) {
      one.times = this.motion.times;
      one.values = Float32Array.from(one.times, (_, at) =>
        this.measured(one.kind, one.points, this.motion.poses({ at, next: at, share: 0 })));
    }
    this.charts.forEach(chart => this.fill(chart));
    this.seek(this.time);
  }

  // ---- bodies ----

  select(body, curves = true) {
    this.selected = body;
    this.scene.select(body);
    element('body').value = String(body);
    element('acts').hidden = body < 0;
    if (curves) {
      const at = this.curveGroups.findIndex(group => group.kind === 'body' && group.body === body);
      if (at >= 0) {
        element('curves-of').value = String(at);
        this.showCurves(at);
      }
    }
    this.pressActs();
    this.tell();
  }

  pressActs() {
    const style = this.scene.styles.get(this.selected);
    element('acts').querySelectorAll('button').forEach(button => {
      const { act } = button.dataset;
      const on = act === 'hide' ? style === 'hidden' : act === 'ghost' ? style === 'ghost'
        : act === 'follow' ? this.follow === this.selected : this.alone === this.selected;
      button.setAttribute('aria-pressed', String(on));
    });
  }

  act(what) {
    const body = this.selected;
    if (what === 'all') {
      this.scene.showAll();
      this.alone = undefined;
    } else if (body < 0) {
      return;
    } else if (what === 'follow') {
      this.setFollow(this.follow === body ? -2 : body);
    } else if (what === 'alone') {
      if (this.alone === body) {
        this.act('all');
        return;
      }
      this.scene.isolate(body);
      this.alone = body;
    } else {
      const style = what === 'hide' ? 'hidden' : 'ghost';
      this.scene.style(body, this.scene.styles.get(body) === style ? 'shown' : style);
      this.alone = undefined;
    }
    this.pressActs();
  }

  setFollow(body) {
    this.follow = body;
    element('follow').value = String(body);
    if (this.scene.works) {
      this.scene.followed = undefined;
      this.fit();
    }
  }

  // ---- controls ----

  controls() {
    const data = this.data;
    const motion = this.motion;
    document.title = `${data.name} – MechService`;
    element('name').textContent = data.name;
    const count = (number, word, words = `${word}s`) => `${number} ${number === 1 ? word : words}`;
    element('summary').textContent = [
      count(data.bodies.length, 'body', 'bodies'),
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
        const box = make('input', '', { type: 'checkbox', id: `show-${id}`, checked: this.shown[id] });
        box.addEventListener('change', () => this.show(id, box.checked));
        const text = make('label');
        text.append(box, ` ${label}`);
        element('toggles').append(text);
      }
    }
    element('arrow-size').hidden = !this.available('forces') && !this.available('reactions');
    element('arrows').addEventListener('input', () => {
      this.arrowKey = element('arrows').value;
      this.legend();
    });
    const body = element('body');
    body.append(new Option('none', '-2'));
    const follow = element('follow');
    follow.append(new Option('nothing', '-2'));
    data.bodies.forEach(({ name }, index) => {
      body.append(new Option(name, String(index)));
      follow.append(new Option(name, String(index)));
    });
    body.addEventListener('change', () => this.select(Number(body.value)));
    follow.addEventListener('change', () => {
      this.setFollow(Number(follow.value));
      this.select(this.follow);
    });
    element('acts').addEventListener('click', event => this.act(event.target.dataset.act));
    element('all').addEventListener('click', () => this.act('all'));
    for (const id of ['distance', 'angle']) {
      element(id).addEventListener('click', () => this.measureMode(id));
    }
    this.curveGroups = this.groups();
    this.makeTree();
    const curves = element('curves-of');
    curves.append(new Option('nothing', '-1'));
    this.curveGroups.forEach((group, index) => curves.append(new Option(group.label, String(index))));
    curves.addEventListener('change', () => this.showCurves(Number(curves.value)));
    const first = this.curveGroups.length ? 0 : -1;
    curves.value = String(first);
    element('other').addEventListener('change', event => {
      const [file] = event.target.files;
      if (file) {
        this.openOther(file);
      }
    });
    element('png').addEventListener('click', () => this.savePicture());
    for (const [label, text] of data.facts) {
      element('facts').append(make('dt', label), make('dd', text));
    }
    element('about').hidden = data.facts.length === 0;
    document.querySelectorAll('#views [data-view]').forEach(button =>
      button.addEventListener('click', () => this.look(button.dataset.view)));
    element('fit').addEventListener('click', () => this.fit());
    const panel = element('panel');
    panel.addEventListener('click', () => {
      const hidden = document.querySelector('main').classList.toggle('wide');
      panel.setAttribute('aria-expanded', String(!hidden));
    });
    document.addEventListener('keydown', event => this.key(event));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.readColours());
    this.seek(motion.start);
    this.showCurves(first);
    this.play(duration > 0 && !matchMedia('(prefers-reduced-motion: reduce)').matches);
  }

  show(id, on) {
    this.shown[id] = on;
    const role = { bodies: 'BODY', joints: 'JOINT', inertia: 'INERTIA' }[id];
    if (role) {
      this.scene.showRole(role, on);
    }
    this.legend();
  }

  available(id) {
    if (id === 'reactions') {
      return this.data.joints.some(joint => joint.reaction >= 0 && joint.type !== 'F');
    }
    if (id === 'inertia') {
      return this.data.parts.some(part => part.role === 'INERTIA');
    }
    return id !== 'forces' || [...this.data.links, ...this.data.ropes].some(link => link.tension >= 0)
      || this.data.forces.some(force => force.force >= 0 || force.normal >= 0);
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    const field = event.target.closest?.('select, input, summary, button, textarea');
    if (field && field.id !== 'time' && (event.key === ' ' || field.tagName === 'SELECT'
      || (field.tagName === 'INPUT' && field.type !== 'checkbox'))) {
      return;
    }
    const turn = 0.1;
    const { scene } = this;
    const choose = step => {
      const many = this.data.bodies.length;
      this.select(this.selected < 0 ? (step > 0 ? 0 : many - 1) : (this.selected + step + many) % many, false);
    };
    const keys = {
      ' ': () => this.play(!this.playing),
      ArrowLeft: () => (event.shiftKey ? scene.turn(-turn, 0) : this.stepFrames(-1)),
      ArrowRight: () => (event.shiftKey ? scene.turn(turn, 0) : this.stepFrames(1)),
      ArrowUp: () => event.shiftKey && scene.turn(0, turn),
      ArrowDown: () => event.shiftKey && scene.turn(0, -turn),
      Home: () => this.seek(this.motion.start),
      End: () => this.seek(this.motion.end),
      '+': () => this.setSpeed(SPEEDS.indexOf(this.speed) + 1),
      '-': () => this.setSpeed(SPEEDS.indexOf(this.speed) - 1),
      l: () => { element('loop').checked = !element('loop').checked; },
      f: () => this.fit(),
      n: () => choose(1),
      p: () => choose(-1),
      h: () => this.act('hide'),
      g: () => this.act('ghost'),
      i: () => this.act('alone'),
      a: () => this.act('all'),
      Escape: () => { this.measureMode(undefined); this.select(-2, false); },
      PageUp: () => scene.zoom(0.85),
      PageDown: () => scene.zoom(1 / 0.85),
      1: () => this.look('iso'),
      2: () => this.look('front'),
      3: () => this.look('side'),
      4: () => this.look('top'),
    };
    const act = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    const seen = ['f', '1', '2', '3', '4', 'PageUp', 'PageDown'].includes(event.key) || event.shiftKey;
    if (act && (scene.works || !seen)) {
      event.preventDefault();
      act();
    }
  }

  // A click on a body chooses it; the camera's own controls turn, move and zoom.
  pointing() {
    const canvas = element('scene');
    let down;
    canvas.addEventListener('pointerdown', event => { down = [event.clientX, event.clientY]; });
    canvas.addEventListener('pointerup', event => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) {
        this.pressView(undefined);
        return;
      }
      const box = canvas.getBoundingClientRect();
      const hit = this.scene.pick(event.clientX - box.left, event.clientY - box.top);
      if (this.mode && hit) {
        this.pickPoint(hit);
      } else if (!this.mode) {
        this.select(hit && hit.body >= 0 ? hit.body : -2);
      }
    });
    canvas.addEventListener('contextmenu', event => event.preventDefault());
  }

  // ---- pictures out of the page ----

  // Makes the stage as large as the pictures to come, so that the camera fits them.
  prepare(width, height, view, show = []) {
    show.forEach(id => this.show(id, true));
    this.filming = true;
    this.play(false);
    const canvas = element('scene');
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    this.scene.room();
    this.seek(this.motion.start);
    this.look(view);
    this.scene.place(this.poses(), this.follow);
  }

  // Fits the camera to the mechanism at a time, for a picture of it alone. Traces are seen whole.
  aim(time) {
    this.seek(time);
    if (!this.shown.traces) {
      const arrows = this.arrows(this.motion.frame(time), this.poses()) || [];
      this.scene.fitNow(this.poses(), arrows.map(({ at, along }) => add(at, along)));
    }
  }

  // The picture at a time, in a size, as PNG or JPEG in Base64.
  still(time, width, height, type = 'image/png') {
    this.play(false);
    this.seek(time);
    this.scene.place(this.poses(), this.follow);
    this.drawArrows(this.motion.frame(this.time), this.poses());
    this.traces(this.motion.frame(this.time));
    this.scene.drawAxes(this.shown.frames);
    return this.scene.picture(width, height, this.colours, this.shown.floor).toDataURL(type, 0.95);
  }

  savePicture() {
    const [width, height] = ['wide', 'tall'].map(id =>
      Math.min(8192, Math.max(16, Math.round(Number(element(id).value)) || 16)));
    this.scene.picture(width, height, this.colours, this.shown.floor).toBlob(blob =>
      save(`${this.data.name.replace(/[^\w.-]+/g, '_')}-${this.time.toFixed(this.decimals)}s.png`, blob));
  }

  // What other programs ask the page.
  api() {
    return {
      frameTimes: () => this.frameTimes.slice(),
      prepare: (...how) => this.prepare(...how),
      aim: time => this.aim(time),
      still: (...how) => this.still(...how),
      look: view => this.look(view),
      room: () => this.scene.room(),
      last: name => this.motion.column(this.place(name))[this.motion.count - 1],
      charts: () => this.charts.map(chart => chart.columns.map(column => column.name)),
      ranges: () => this.charts.map(chart => [chart.curves.least, chart.curves.most]),
      ropeLength: name => ropeLines(this.data.ropes.find(rope => rope.name === name), this.poses())
        .map(line => line.slice(1).reduce((sum, point, i) => sum + norm(subtract(point, line[i])), 0)),
      value: name => this.motion.value(this.place(name), this.motion.frame(this.time)),
      seek: time => this.seek(time),
      drawn: () => ({ ...this.scene.renderer.info.render }),
      project: body => this.scene.project(this.poses()(body).p),
      selected: () => this.selected,
      measures: () => this.measures.map(one => one.values[this.motion.frame(this.time).at]),
      addMeasure: (kind, points) => this.addMeasure(kind, points),
    };
  }
}

// What names have in common up to a full stop.
function commonStart(names) {
  const first = names[0]?.slice(0, names[0].lastIndexOf('.') + 1) || '';
  return names.length > 1 && names.every(name => name.startsWith(first)) ? first : '';
}
