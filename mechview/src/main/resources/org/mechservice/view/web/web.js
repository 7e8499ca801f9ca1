import { get, post, stream, takeToken, address } from './api.js';
import { Curves, short } from './player/curves.js';
import { Completion } from './completion.js';
import { MechanismStage } from './stage.js';

const SERIES = ['#3b82d0', '#d97b1f', '#2f9e77', '#c2504d', '#8464c4', '#1c97a3', '#9c7a3c'];
const FORMATS = [['csv', 'CSV'], ['mat', 'MAT'], ['glb', 'GLB'], ['html', 'Player'], ['jar', 'JAR'],
  ['fmu', 'FMU']];
const LARGEST = 24 * 1024 * 1024;

const element = id => document.getElementById(id);
const make = (tag, text = '', properties = {}) =>
  Object.assign(document.createElement(tag), { textContent: text }, properties);

takeToken();
const text = element('text');
const stage = new MechanismStage(element('scene'));
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

text.addEventListener('input', () => { clean = false; number(); });
text.addEventListener('scroll', () => { element('numbers').scrollTop = text.scrollTop; });

function open(model, called) {
  text.value = model;
  name = called;
  element('messages').replaceChildren();
  element('simulation').replaceChildren();
  number();
  return check();
}

async function openFile(file) {
  if (!file) return;
  if (file.size > LARGEST) throw new Error(`${file.name} has ${file.size} bytes; models have at most ${LARGEST}`);
  await open(await file.text(), file.name);
}

const asked = action => action.catch(say);
element('file').addEventListener('change', event => asked(openFile(event.target.files[0])));
document.addEventListener('dragover', event => {
  event.preventDefault();
  text.closest('section').classList.add('dropping');
});
document.addEventListener('dragleave', () => text.closest('section').classList.remove('dropping'));
document.addEventListener('drop', event => {
  event.preventDefault();
  text.closest('section').classList.remove('dropping');
  asked(openFile(event.dataTransfer.files[0]));
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
  try {
    const answer = await post('check',
      { name: name.toLowerCase(), text: text.value, simulation: element('simulation').value });
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
  const order = { text: text.value, parameters: changed() };
  for (const id of ['simulation', 'formulation', 'integrator', 'relTol', 'absTol', 'tEnd']) order[id] = element(id).value;
  element('run').disabled = true;
  try {
    const { run } = await post('run', order);
    const title = [...Object.entries(order.parameters), ...settings()].map(([key, value]) => `${key} = ${value}`).join(', ');
    const one = { id: run, number: runs.length + 1, title, rows: [], state: 'runs', compared: true,
      colour: SERIES[runs.length % SERIES.length] };
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
  stage.show(run.data);
  const chosen = element('column').value;
  const options = run.data.columns.slice(1).map(([column, unit]) =>
    make('option', unit === '1' ? column : `${column}, ${unit}`, { value: column }));
  element('column').replaceChildren(...options);
  if (run.data.columns.some(([column]) => column === chosen)) element('column').value = chosen;
  curve();
}

function curve() {
  const column = element('column').value;
  const chosen = runs.filter(run => run.data && run.rows.length > 1 && (run === shown || run.compared));
  if (!shown || !chosen.length) return;
  const longest = chosen.reduce((a, b) => (b.rows[b.rows.length - 1][0] > a.rows[a.rows.length - 1][0] ? b : a));
  const times = longest.rows.map(row => row[0]);
  const series = chosen.flatMap(run => {
    const at = run.data.columns.findIndex(([title]) => title === column);
    return at < 0 ? [] : [{ values: onto(times, run.rows, at), offset: 0, colour: run.colour }];
  });
  curves.show(times, series);
}

// Values of a run at the times of another, straight between its rows.
function onto(times, rows, at) {
  let i = 0;
  return times.map(time => {
    while (i < rows.length - 1 && rows[i + 1][0] < time) i++;
    const [a, b] = [rows[i], rows[Math.min(i + 1, rows.length - 1)]];
    if (time > b[0] + 1e-9 || time < a[0] - 1e-9) return NaN;
    const share = b[0] > a[0] ? (time - a[0]) / (b[0] - a[0]) : 0;
    return a[at] + share * (b[at] - a[at]);
  });
}

function list() {
  element('history').replaceChildren(...runs.map(run => {
    const item = make('li');
    const label = make('label');
    const box = make('input', '', { type: 'checkbox', checked: run.compared });
    box.addEventListener('change', () => { run.compared = box.checked; curve(); });
    const swatch = make('span', '', { className: 'swatch' });
    swatch.style.background = run.colour;
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
  ({ report } = await post('measure', { text: text.value }));
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
        const link = make('a', `Report ${element('reports').children.length + 1}: ${stage.data?.name || name}`,
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
    stage.draw(row, rows);
    element('time').min = first;
    element('time').max = last;
    element('time').value = now;
    element('clock').textContent = `${short(now)} s`;
    if (runs.some(run => run.dirty)) {
      runs.forEach(run => { run.dirty = false; });
      curve();
    }
    const style = getComputedStyle(document.documentElement);
    curves.draw(now, { text: style.getPropertyValue('--soft').trim(),
      grid: style.getPropertyValue('--line').trim(), accent: style.getPropertyValue('--accent').trim() });
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
  const view = event.target.dataset.view;
  if (!view) return;
  stage.look(view);
  element('views').querySelectorAll('button').forEach(button =>
    button.setAttribute('aria-pressed', String(button.dataset.view === view)));
});
if (!stage.works) say('This browser shows no WebGL 2, so the moving picture is missing; the curves work.');

try {
  const session = await get('start');
  element('server').textContent = `server ${session.server}`;
  new Completion(text, element('choices'), session.grammar);
  for (const example of session.examples) element('example').append(make('option', example.name));
  element('example').addEventListener('change', event => {
    const chosen = session.examples.find(example => example.name === event.target.value);
    if (chosen) asked(open(chosen.text, `${chosen.name}.xml`));
  });
} catch (error) {
  say(error);
}
requestAnimationFrame(frame);
