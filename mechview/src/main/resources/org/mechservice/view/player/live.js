import { bytesOf } from './recording.js';
import { short } from './curves.js';
import { Player } from './player.js';

// The model as a WebAssembly module in the page: numbers in, rows of a run out.
class LiveModel {
  static async of(data) {
    const bytes = bytesOf(data.live.module);
    let module;
    try {
      // at once: the page is not loaded before its first run is drawn
      module = new WebAssembly.Module(bytes);
    } catch {
      // some browsers compile large modules in the background alone
      module = await WebAssembly.compile(bytes);
    }
    return new LiveModel(data, new WebAssembly.Instance(module).exports);
  }

  constructor(data, exports) {
    this.data = data;
    this.live = data.live;
    this.model = exports;
    this.reset();
  }

  reset() {
    this.model.mech_reset_values();
  }

  set(kind, index, value) {
    const { memory, mech_parameters, mech_starts, mech_set } = this.model;
    const at = kind === 'parameter' ? mech_parameters() : mech_starts();
    new DataView(memory.buffer).setFloat64(at + 8 * index, value, true);
    if (kind === 'start') {
      new Uint8Array(memory.buffer)[mech_set() + index] = 1;
    }
  }

  // Integrates; returns the number of frames, the numbers column after column, and how long it took.
  run() {
    const began = performance.now();
    const { from, to, step, rtol } = this.live;
    const frames = this.model.mech_run(from, to, step, rtol);
    const took = performance.now() - began;
    const width = this.data.columns.length;
    const rows = new Float64Array(this.model.memory.buffer, this.model.mech_rows(), frames * width);
    const numbers = new Float32Array(frames * width);
    const energy = new Float32Array(frames);
    const shift = new Float64Array(width);
    for (const body of this.data.bodies) {
      [0, 1, 2].forEach(i => { shift[body.pose + i] = this.data.origin[i]; });
    }
    for (let frame = 0; frame < frames; frame++) {
      for (let column = 0; column < width; column++) {
        numbers[column * frames + frame] = rows[frame * width + column] - shift[column];
      }
      // in doubles: floats do not keep the digits that the difference consists of
      energy[frame] = this.energy(rows, frame * width) - this.energy(rows, 0);
    }
    return { frames, numbers, took, energy, events: this.events(), message: this.message() };
  }

  energy(rows, at) {
    return this.live.energies.reduce((sum, column) => sum + rows[at + column], 0);
  }

  // Events of the last run: times, s, and names.
  events() {
    const { memory, mech_event_count, mech_event_times, mech_event_numbers } = this.model;
    const count = mech_event_count();
    const times = new Float64Array(memory.buffer, mech_event_times(), count);
    const numbers = new Int32Array(memory.buffer, mech_event_numbers(), count);
    return Array.from(times, (time, i) => ({ time, name: this.live.events[numbers[i]] }));
  }

  message() {
    const bytes = new Uint8Array(this.model.memory.buffer, this.model.mech_message(), 512);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }
}

// Sliders for parameters and start values; each move runs the model again.
class LiveControls {
  constructor(model, player, first) {
    this.model = model;
    this.player = player;
    this.sliders = [];
    this.times = [];
    const box = document.createElement('section');
    box.id = 'live';
    box.setAttribute('aria-label', 'Parameters and start values');
    const { parameters, starts } = model.live;
    this.group(box, 'Parameters', 'parameter', parameters, true);
    this.group(box, 'Start values', 'start', starts, parameters.length === 0);
    const reset = document.createElement('button');
    reset.type = 'button';
    reset.textContent = 'As in the file';
    reset.addEventListener('click', () => this.reset());
    const keep = document.createElement('button');
    keep.type = 'button';
    keep.textContent = 'Keep for comparison';
    keep.addEventListener('click', () => this.keep());
    this.said = document.createElement('p');
    this.said.setAttribute('role', 'status');
    box.append(reset, keep, this.said);
    document.querySelector('aside').prepend(box);
    this.tell(first);
  }

  group(box, title, kind, values, open) {
    if (values.length === 0) {
      return;
    }
    const details = document.createElement('details');
    details.open = open;
    const summary = document.createElement('summary');
    summary.textContent = title;
    details.append(summary);
    for (const value of values) {
      details.append(this.slider(kind, value));
    }
    box.append(details);
  }

  slider(kind, { name, unit, index, value, least, most }) {
    const label = document.createElement('label');
    label.className = 'field';
    const text = document.createElement('span');
    const shown = document.createElement('output');
    const input = document.createElement('input');
    input.type = 'range';
    input.min = String(least);
    input.max = String(most);
    input.step = 'any';
    input.value = String(value);
    input.dataset.name = name;
    const tell = () => {
      shown.textContent = `${short(Number(input.value))} ${unit === '1' ? '' : unit}`;
      input.setAttribute('aria-valuetext', shown.textContent);
    };
    tell();
    input.addEventListener('input', () => {
      tell();
      this.model.set(kind, index, Number(input.value));
      this.run();
    });
    text.append(`${name} `, shown);
    label.append(text, input);
    this.sliders.push({ input, value, tell });
    return label;
  }

  reset() {
    this.model.reset();
    for (const { input, value, tell } of this.sliders) {
      input.value = String(value);
      tell();
    }
    this.run();
  }

  run() {
    const run = this.model.run();
    this.times.push(run.took);
    if (run.frames > 1) {
      this.player.replace(run);
    }
    this.tell(run);
  }

  // Leaves the curves of this run dashed beside those of the runs to come.
  keep() {
    const { motion } = this.player;
    const columns = new Map(this.player.columns.map(({ name, column, offset }) =>
      [name, Array.from(motion.column(column), x => x + offset)]));
    this.player.compare('kept', Array.from(motion.times), columns);
  }

  tell(run) {
    const { step, from, to } = this.model.live;
    const last = run.events[run.events.length - 1];
    const happened = run.events.length === 1 ? ', 1 event' : `, ${run.events.length} events`;
    const what = `${run.frames} rows${last ? happened : ''} in ${run.took.toFixed(1)} ms`;
    const ended = last && run.frames <= (to - from) / step * (1 - 1e-12);
    this.said.textContent = run.message
      ? `${run.frames > 1 ? 'The run ends early' : 'No run with these values'}: ${run.message}`
      : `${what}${ended ? `; ended by ${last.name} at ${short(last.time)} s` : ''}`;
    this.said.classList.toggle('bad', run.message !== '');
  }
}

const data = JSON.parse(document.getElementById('data').textContent);
const model = await LiveModel.of(data);
const first = model.run();
if (first.frames > 0) {
  data.numbers = first.numbers;
  data.frames = first.frames;
  data.events = first.events;
  data.change = first.energy;
}
const player = new Player(data);
const controls = new LiveControls(model, player, first);
globalThis.mechPlayer = { ...player.api(), runTimes: () => controls.times.slice() };
