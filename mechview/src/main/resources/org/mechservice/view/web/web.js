import { get, post, stream, takeToken, address } from './api.js';
import { Curves, short } from './player/curves.js';
import { MechanismScene } from './player/scene.js';
import { Completion } from './completion.js';

const SERIES = 8;
const FORMATS = [['csv', 'CSV'], ['mat', 'MAT'], ['glb', 'GLB'], ['html', 'Player'], ['jar', 'JAR'],
  ['fmu', 'FMU']];
const LARGEST = 24 * 1024 * 1024;

const element = id => document.getElementById(id);
const make = (tag, text = '', properties = {}) =>
  Object.assign(document.createElement(tag), { textContent: text }, properties);

takeToken();
const text = element('text');
const scene = new MechanismScene(element('scene'));
const curves = new Curves(element('curves'), time => { play(false); now = time; });
const runs = [];
let name = 'model.xml';
let shown;
let now = 0;
let playing = true;
let clean = true;

function say(problem) {
  element('problem').textContent = problem ? problem.message || String(problem) : '';
  element('problem').hidden = !problem;
}

// Does what a button stands for, and tells what went wrong.
const acts = (id, action) => element(id).addEventListener('click', async () => {
  say();
  try {
    await action();
  } catch (error) {
    say(error);
  }
});

// ---- the model ----

function number() {
  const lines = text.value.split('\n').length;
  const wanted = Math.min(lines, 20000);
  if (numbered !== wanted) {
    numbered = wanted;
    element('numbers').textContent = Array.from({ length: wanted }, (_, i) => i + 1).join('\n');
  }
  element('numbers').scrollTop = text.scrollTop;
}
let numbered = 1;

text.addEventListener('input', () => {
  if (clean) forget('The text has changed since it was checked.');
  clean = false;
  number();
});

// What was said of another text than the one that is shown is taken away.
function forget(why) {
  element('messages').replaceChildren(...(why && element('messages').children.length ? [make('li', why)] : []));
  element('verdict').hidden = true;
  element('drawing').hidden = true;
}
text.addEventListener('scroll', () => { element('numbers').scrollTop = text.scrollTop; });

function open(model, called) {
  text.value = model;
  name = called;
  forget();
  element('simulation').replaceChildren();
  number();
  return check();
}

// ---- files: the model, and what lies beside it ----

const MODELS = /\.(xml|mechml|urdf|sdf|mjcf)$/i;
const attached = new Map();

// Takes a model with the tables, surfaces and parts that it names: the model is the one that is not
// a part of another, in the uppermost folder.
async function openFiles(all) {
  const size = all.reduce((sum, { file }) => sum + file.size, 0);
  if (size > LARGEST) throw new Error(`these files have ${size} bytes; a model and what it names have at most ${LARGEST}`);
  const depth = path => path.split('/').length;
  const models = all.filter(({ path }) => MODELS.test(path)).sort((a, b) => depth(a.path) - depth(b.path));
  const texts = await Promise.all(models.map(({ file }) => file.text()));
  const at = Math.max(0, texts.findIndex(one => !/<subsystem[\s>]/.test(one)));
  const model = models[at];
  const base = model?.path.includes('/') ? model.path.slice(0, model.path.lastIndexOf('/') + 1) : '';
  const [top] = all.map(({ path }) => (path.includes('/') ? path.slice(0, path.indexOf('/') + 1) : ''));
  if (model) attached.clear();
  for (const { path, file } of all) {
    const under = model ? base : top;
    if (file !== model?.file) attached.set(path.startsWith(under) ? path.slice(under.length) : path, file);
  }
  tellAttached();
  if (model) await open(texts[at], model.path.slice(base.length));
  else await check();
}

function tellAttached() {
  element('attached').hidden = attached.size === 0;
  element('attached').replaceChildren(...[...attached.keys()].map(path => {
    const item = make('li', `${path} `);
    const gone = make('button', 'Remove', { type: 'button', className: 'quiet' });
    gone.setAttribute('aria-label', `Remove ${path}`);
    gone.addEventListener('click', () => {
      attached.delete(path);
      tellAttached();
      clean = false;
    });
    item.append(gone);
    return item;
  }));
}

async function base64(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let binary = '';
  for (let i = 0; i < bytes.length; i += 8192) binary += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(binary);
}

// The files beside the model as a request has them.
async function filesBeside() {
  const entries = await Promise.all([...attached].map(async ([path, file]) => [path, await base64(file)]));
  return Object.fromEntries(entries);
}

// The files of a drop, those in folders with their paths.
async function dropped(transfer) {
  const entries = [...transfer.items].map(item => item.webkitGetAsEntry?.()).filter(Boolean);
  if (!entries.some(entry => entry.isDirectory)) {
    return [...transfer.files].map(file => ({ path: file.name, file }));
  }
  const found = [];
  const walk = async (entry, path) => {
    if (entry.isFile) {
      found.push({ path: path + entry.name, file: await new Promise((done, failed) => { entry.file(done, failed); }) });
      return;
    }
    const reader = entry.createReader();
    for (;;) {
      const some = await new Promise((done, failed) => { reader.readEntries(done, failed); });
      if (!some.length) return;
      for (const one of some) await walk(one, `${path}${entry.name}/`);
    }
  };
  for (const entry of entries) await walk(entry, '');
  return found;
}

const asked = action => action.catch(say);
element('file').addEventListener('change', event =>
  asked(openFiles([...event.target.files].map(file => ({ path: file.name, file })))));
document.addEventListener('dragover', event => {
  event.preventDefault();
  text.closest('section').classList.add('dropping');
});
document.addEventListener('dragleave', () => text.closest('section').classList.remove('dropping'));
document.addEventListener('drop', event => {
  event.preventDefault();
  text.closest('section').classList.remove('dropping');
  asked(dropped(event.dataTransfer).then(openFiles));
});

function goTo(line, column) {
  const lines = text.value.split('\n');
  const start = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
  text.focus();
  text.setSelectionRange(start + Math.max(0, column - 1), start + (lines[line - 1] || '').length);
  text.scrollTop = Math.max(0, (line - 5) * parseFloat(getComputedStyle(text).lineHeight));
}

async function check() {
  say();
  element('check').disabled = true;
  const checked = text.value;
  try {
    const answer = await post('check', { name: name.toLowerCase(), text: checked,
      simulation: element('simulation').value, files: await filesBeside() });
    // the text may have changed while its messages were under way
    if (text.value !== checked) return false;
    if (answer.translated) {
      text.value = answer.translated;
      name = 'model.xml';
      number();
    }
    clean = true;
    tell(answer);
    return answer.ok;
  } finally {
    element('check').disabled = false;
  }
}

function tell(answer) {
  const messages = answer.messages.map(message => {
    const button = make('button', (message.line > 0 ? `Line ${message.line}: ` : '') + message.text,
      { type: 'button', className: message.severity });
    button.addEventListener('click', () => message.line > 0 && goTo(message.line, message.column));
    const item = make('li');
    item.append(button);
    return item;
  });
  if (answer.ok && messages.length === 0) messages.push(make('li', 'The model can be used.'));
  element('messages').replaceChildren(...messages);
  element('report').textContent = answer.report;
  element('verdict').hidden = !answer.report;
  const picture = element('drawing');
  URL.revokeObjectURL(picture.src);
  picture.hidden = !answer.drawing;
  if (answer.drawing) {
    picture.src = URL.createObjectURL(new Blob([answer.drawing], { type: 'image/svg+xml' }));
    picture.alt = `Drawing of ${answer.name} in its initial position`;
  }
  parameters(answer.parameters || []);
  simulations(answer.simulations || []);
}

function simulations(all) {
  const chosen = element('simulation').value;
  element('simulation').replaceChildren(...all.map((one, i) =>
    make('option', `${i + 1} ${one}`, { value: String(i + 1) })));
  element('simulation').value = chosen && Number(chosen) <= all.length ? chosen : all.length ? '1' : '';
  element('simulations').hidden = all.length < 2;
}

function parameters(all) {
  const box = element('parameters');
  box.replaceChildren(box.firstElementChild, ...all.map(one => {
    const line = make('div', '', { className: 'parameter' });
    const size = Math.abs(one.value) || 1;
    const low = one.value > 0 ? 0 : one.value - size;
    const common = { min: low, max: one.value + size, step: 'any', value: one.value };
    const slider = make('input', '', { type: 'range', ...common });
    const field = make('input', '', { type: 'number', step: 'any', value: one.value });
    slider.setAttribute('aria-label', `${one.name}, slider`);
    field.setAttribute('aria-label', one.name);
    field.dataset.name = one.name;
    field.dataset.file = String(one.value);
    slider.addEventListener('input', () => { field.value = Number(Number(slider.value).toPrecision(4)); });
    field.addEventListener('input', () => { slider.value = field.value; });
    line.append(make('span', one.unit === '1' ? one.name : `${one.name}, ${one.unit}`), slider, field);
    return line;
  }));
  box.hidden = all.length === 0;
}

function changed() {
  const values = {};
  for (const field of element('parameters').querySelectorAll('[data-name]')) {
    if (field.value !== '' && field.value !== field.dataset.file) values[field.dataset.name] = field.value;
  }
  return values;
}

// ---- runs ----

// What is not as in the file, by the words of its field.
const settings = () => ['formulation', 'integrator', 'relTol', 'absTol', 'tEnd']
  .filter(id => element(id).value)
  .map(id => [element(id).closest('label').firstChild.textContent.trim().toLowerCase(), element(id).value]);

async function start() {
  if (!clean && !await check()) return;
  const order = { text: text.value, parameters: changed(), files: await filesBeside() };
  for (const id of ['simulation', 'formulation', 'integrator', 'relTol', 'absTol', 'tEnd']) order[id] = element(id).value;
  element('run').disabled = true;
  try {
    const title = [...Object.entries(order.parameters), ...settings()].map(([key, value]) => `${key} = ${value}`).join(', ');
    const { run } = await post('run', { ...order, title });
    const one = { id: run, number: runs.length + 1, title, rows: [], state: 'runs', compared: true,
      colour: runs.length % SERIES };
    runs.push(one);
    shown = one;
    play(true);
    watch(one);
    list();
  } finally {
    element('run').disabled = false;
  }
}

function watch(run) {
  const live = stream('watch', { run: run.id }, {
    begin: data => {
      run.data = data;
      run.rows = [];
      run.name = data.name;
      if (shown === run) display(run);
      list();
    },
    rows: rows => {
      run.rows.push(...rows.map(row => row.map(x => (x === null ? NaN : x))));
      run.dirty = true;
    },
    end: end => {
      live.close();
      run.state = end.outcome;
      run.message = end.message || '';
      if (shown === run) now = run.rows.length ? run.rows[0][0] : 0;
      list();
    },
    lost: error => {
      if (error.status === 404) {
        live.close();
        run.state = 'failed';
      }
      run.message = `${error.message}; trying again`;
      list();
    },
  });
}

function play(on) {
  playing = on;
  element('play').textContent = on ? 'Pause' : 'Play';
}

function display(run) {
  shown = run;
  now = run.rows.length ? run.rows[0][0] : 0;
  if (!run.data) return;
  scene.show(run.data);
  colours();
  learned = 0;
  scene.look(view);
  const chosen = [...element('column').selectedOptions].map(option => option.value);
  const options = run.data.columns.slice(1).map(([column, unit]) =>
    make('option', unit === '1' ? column : `${column}, ${unit}`, { value: column, selected: chosen.includes(column) }));
  element('column').replaceChildren(...options);
  if (!element('column').selectedOptions.length && options.length) options[0].selected = true;
  curve();
}

// The chosen columns of the shown run, and dashed those of the runs that are compared with it.
function curve() {
  const columns = [...element('column').selectedOptions].map(option => option.value);
  const chosen = runs.filter(run => run.data && run.rows.length > 1 && (run === shown || run.compared));
  if (!shown || !chosen.length) return;
  const several = columns.length > 1;
  const series = chosen.flatMap(run => {
    const times = run.rows.map(row => row[0]);
    return columns.slice(0, SERIES).flatMap((column, i) => {
      const at = run.data.columns.findIndex(([title]) => title === column);
      return at < 0 ? [] : [{ times, values: run.rows.map(row => row[at]), offset: 0,
        name: chosen.length > 1 ? `${column} (run ${run.number})` : column, unit: run.data.columns[at][1],
        colour: seriesColour(several ? i : run.colour), dashed: several && run !== shown,
        floor: floorOf(run, run.data.columns[at][1]) }];
    });
  });
  curves.show(series);
  element('curves').setAttribute('aria-label', `${columns.join(', ')} of the chosen runs over time`);
}

// What is so small beside the largest value of its unit in the run is a zero.
function floorOf(run, unit) {
  const row = run.rows[run.rows.length - 1];
  const sizes = run.data.columns.map(([, other], i) => (other === unit ? Math.abs(row[i]) || 0 : 0));
  return 1e-9 * Math.max(...sizes);
}

function list() {
  element('history').replaceChildren(...runs.map(run => {
    const item = make('li');
    const label = make('label');
    const box = make('input', '', { type: 'checkbox', checked: run.compared });
    box.addEventListener('change', () => { run.compared = box.checked; curve(); });
    const swatch = make('span', '', { className: 'swatch' });
    swatch.style.background = seriesColour(run.colour);
    label.append(box, ' ', swatch, ` ${run.name || 'model'}${run.title ? ` (${run.title})` : ''}: ${run.state} `);
    const watchIt = make('button', 'Show', { type: 'button' });
    watchIt.setAttribute('aria-label', `Show run ${run.number}`);
    watchIt.addEventListener('click', () => { display(run); list(); });
    item.append(label, watchIt);
    if (run.state !== 'runs') {
      for (const [format, title] of FORMATS) {
        const button = make('button', title, { type: 'button' });
        button.setAttribute('aria-label', `Download run ${run.number} as ${title}`);
        button.addEventListener('click', () => asked(download(run, format)));
        item.append(' ', button);
      }
    }
    return item;
  }));
  choices();
  const going = shown?.state === 'runs';
  element('cancel').disabled = !going;
  if (shown) {
    element('state').textContent = `Run ${shown.number}: ${shown.state}.${shown.message ? ` ${shown.message}` : ''}`;
  }
}

async function download(run, format) {
  say();
  const response = await fetch(address('result', { run: run.id, format }),
    { headers: { Authorization: `Bearer ${sessionStorage.getItem('mechservice-token') || ''}` } });
  if (!response.ok) throw new Error((await response.json()).error);
  const link = make('a', '', { href: URL.createObjectURL(await response.blob()) });
  link.download = `${(run.name || 'model').replace(/[^\w-]/g, '_')}-${run.number}.${format}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

// ---- what differs between two runs ----

const called = run => `Run ${run.number}${run.title ? ` (${run.title})` : ''}`;

// The two latest runs that have ended are compared, unless others are chosen.
function choices() {
  const ended = runs.filter(run => run.state !== 'runs' && run.rows.length);
  element('comparing').hidden = ended.length < 2;
  ['first', 'second'].forEach((id, i) => {
    const select = element(id);
    if (select.children.length === ended.length) return;
    select.replaceChildren(...ended.map(run => make('option', String(run.number), { value: run.id })));
    select.value = ended[Math.max(0, ended.length - 2 + i)]?.id || '';
  });
}

async function compare() {
  const [one, other] = ['first', 'second'].map(id => runs.find(run => run.id === element(id).value));
  element('compare').disabled = true;
  try {
    const found = await get('differences',
      { first: one.id, second: other.id, name: called(one), other: called(other) });
    element('difference').textContent = `${found.title} by more than ${found.tolerance} of their size.`;
    element('differences').replaceChildren(...found.notes.map(note => make('li', note)));
    const picture = element('differing');
    URL.revokeObjectURL(picture.src);
    picture.src = URL.createObjectURL(new Blob([found.picture], { type: 'image/svg+xml' }));
    picture.alt = `Curves of the signals that differ most between ${called(one)} and ${called(other)}`;
    picture.dataset.file = `difference-${one.number}-${other.number}.svg`;
    picture.hidden = false;
    element('save').hidden = false;
  } finally {
    element('compare').disabled = false;
  }
}

// ---- error against run time ----

const PAUSE = 500;
let report;

async function measure() {
  if (!clean && !await check()) return;
  ({ report } = await post('measure', { text: text.value, files: await filesBeside() }));
  measuring(true);
  try {
    for (let asks = true; asks;) {
      const at = await get('report', { report });
      asks = at.state === 'runs';
      element('measured').value = at.done;
      element('measuring').textContent = asks
        ? `${Math.round(100 * at.done)} %, ${at.what}${at.secondsLeft ? `, ${Math.ceil(at.secondsLeft)} s left` : ''}`
        : at.state === 'done' ? 'Measured.' : at.message || 'Cancelled.';
      if (at.state === 'done') {
        const link = make('a', `Report ${element('reports').children.length + 1}: ${shown?.name || name}`,
          { href: `/report/${report}/${at.page}`, target: '_blank', rel: 'noopener' });
        const item = make('li');
        item.append(link);
        element('reports').append(item);
      }
      if (asks) await new Promise(resolve => setTimeout(resolve, PAUSE));
    }
  } finally {
    measuring(false);
  }
}

function measuring(on) {
  element('measure').disabled = on;
  element('unmeasure').disabled = !on;
  element('measured').hidden = !on;
}

// ---- the picture ----

let palette = {};
let view = 'iso';
let learned = 0;

const property = name => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
function seriesColour(index) {
  return property(`series-${index % SERIES + 1}`);
}

function colours() {
  palette = { text: property('soft'), grid: property('line'), border: property('border'),
    accent: property('accent'), panel: property('panel') };
  const dark = matchMedia('(prefers-color-scheme: dark)').matches;
  scene.colours({ sheet: property('sheet'), line: property('grid'), dark });
}
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { colours(); curve(); });
colours();

// The poses of a row; positions are counted from the root.
function poses(row) {
  const { data } = shown;
  return body => {
    const at = body < 0 ? -1 : data.bodies[body].pose;
    const still = body < 0 ? data.root : data.bodies[body].start;
    return at < 0 ? { p: still.slice(0, 3), q: still.slice(3) } : { p: [0, 1, 2].map(i => row[at + i] - data.origin[i]), q: row.slice(at + 3, at + 7) };
  };
}

function picture(row, rows) {
  if (!scene.works || !shown.data || scene.data !== shown.data) return;
  if (rows.length >= 1.5 * learned) {
    // what the bodies have come to, as the rows come
    learned = rows.length;
    const step = Math.max(1, Math.floor(rows.length / 40));
    scene.learn(rows.filter((_, i) => i % step === 0).map(poses));
    heaviest = scene.travels ? shown.data.bodies.findIndex(body =>
      body.mass === Math.max(...shown.data.bodies.map(one => one.mass))) : -2;
    if (!turned) scene.fit(poses(row), heaviest);
  }
  if (row === placedRow && !scene.changed) return;
  placedRow = row;
  scene.place(poses(row), heaviest);
  scene.render();
}
let heaviest = -2;
let placedRow;
let turned = false;
element('scene').addEventListener('pointerdown', () => { turned = true; });
element('scene').addEventListener('wheel', () => { turned = true; }, { passive: true });

let before = performance.now();
function frame(at) {
  const passed = (at - before) / 1000;
  before = at;
  const rows = shown?.rows;
  if (rows?.length) {
    const [first, last] = [rows[0][0], rows[rows.length - 1][0]];
    if (shown.state === 'runs') {
      now = last;
    } else if (playing && last > first) {
      now += passed;
      if (now > last) now = first;
    }
    let [low, high] = [0, rows.length - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (rows[middle][0] <= now) low = middle; else high = middle;
    }
    const row = now >= rows[high][0] ? rows[high] : rows[low];
    picture(row, rows);
    element('time').min = first;
    element('time').max = last;
    element('time').value = now;
    element('clock').textContent = `${short(now)} s`;
    if (runs.some(run => run.dirty)) {
      runs.forEach(run => { run.dirty = false; });
      curve();
    }
    curves.draw(now, palette);
  }
  requestAnimationFrame(frame);
}

acts('check', check);
acts('run', start);
acts('compare', compare);
acts('save', () => make('a', '', { href: element('differing').src, download: element('differing').dataset.file }).click());
acts('measure', measure);
acts('unmeasure', () => report && post('unmeasure', { report }));
acts('cancel', () => shown && post('cancel', { run: shown.id }));
element('play').addEventListener('click', () => play(!playing));
element('time').addEventListener('input', event => {
  play(false);
  now = Number(event.target.value);
});
element('column').addEventListener('change', curve);
element('simulation').addEventListener('change', () => asked(check()));
element('views').addEventListener('click', event => {
  if (!event.target.dataset.view) return;
  view = event.target.dataset.view;
  turned = false;
  learned = 0;
  if (shown?.data) scene.look(view);
  element('views').querySelectorAll('button').forEach(button =>
    button.setAttribute('aria-pressed', String(button.dataset.view === view)));
});
if (!scene.works) say('This browser shows no WebGL 2, so the moving picture is missing; the curves work.');

try {
  const session = await get('start');
  element('server').textContent = `server ${session.server}`;
  new Completion(text, element('choices'), session.grammar);
  for (const example of session.examples) element('example').append(make('option', example.name));
  element('example').addEventListener('change', event => {
    const chosen = session.examples.find(example => example.name === event.target.value);
    if (chosen) asked(open(chosen.text, `${chosen.name}.xml`));
  });
  // runs outlast the page: those of before are there again
  for (const { run, title } of (await get('runs')).runs) {
    const one = { id: run, number: runs.length + 1, title, rows: [], state: 'runs', compared: false,
      colour: runs.length % SERIES };
    runs.push(one);
    shown = one;
    watch(one);
  }
  list();
} catch (error) {
  say(error);
}
requestAnimationFrame(frame);
