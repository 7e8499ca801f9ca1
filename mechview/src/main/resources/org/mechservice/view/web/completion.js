// Completion of MechML in a text area: elements that may stand here, their attributes, and listed values.

const MOST_SHOWN = 12;

const words = text => [...text.matchAll(/[A-Za-z_][\w-]*/g)].map(found => found[0]);

// Returns a Map from elements to their { children, attributes }; attributes map to their listed values.
export function grammarOf(dtd) {
  const plain = dtd.replace(/<!--[^]*?-->/g, '');
  const entities = new Map(
    [...plain.matchAll(/<!ENTITY\s+%\s+(\w+)\s+"([^"]*)"\s*>/g)].map(found => [found[1], found[2]]));
  const expanded = plain.replace(/<!ENTITY[^>]*>/g, '')
    .replace(/%(\w+);/g, (whole, name) => entities.get(name) || '');
  const elements = new Map();
  for (const [, name, content] of expanded.matchAll(/<!ELEMENT\s+([\w-]+)\s+([^>]*)>/g)) {
    const children = words(content.replace('#PCDATA', '')).filter(word => word !== 'EMPTY' && word !== 'ANY');
    elements.set(name, { children: [...new Set(children)], attributes: new Map() });
  }
  for (const [, name, list] of expanded.matchAll(/<!ATTLIST\s+([\w-]+)\s+([^>]*)>/g)) {
    for (const one of list.matchAll(/([\w-]+)\s+(CDATA|ID|IDREF|NMTOKEN|\([^)]*\))\s+(?:#\w+|"[^"]*")/g)) {
      elements.get(name)?.attributes.set(one[1], one[2].startsWith('(') ? words(one[2]) : []);
    }
  }
  return elements;
}

// The element that is open at the end of a text; undefined at the top.
function openElement(text) {
  const open = [];
  const plain = text.replace(/<!--[^]*?(-->|$)/g, '');
  for (const [, end, name, rest] of plain.matchAll(/<(\/?)([A-Za-z_][\w-]*)((?:"[^"]*"|'[^']*'|[^<>"'])*)>/g)) {
    if (end) {
      const at = open.lastIndexOf(name);
      open.length = at < 0 ? open.length : at;
    } else if (!rest.endsWith('/')) {
      open.push(name);
    }
  }
  return open[open.length - 1];
}

/**
 * What may stand at the end of a text: { typed, choices }, each choice with the text that it adds in
 * place of what is typed and how far the caret goes back in it.
 */
export function choicesAt(text, elements) {
  const none = { typed: '', choices: [] };
  const start = text.lastIndexOf('<');
  if (start < 0 || text.lastIndexOf('<!--') > text.lastIndexOf('-->')) return none;
  const tag = text.slice(start);
  const fitting = (typed, names, add) => ({ typed, choices: names
    .filter(name => name.startsWith(typed)).slice(0, MOST_SHOWN).map(name => ({ name, ...add(name) })) });
  const opening = /^<(\/?)([\w-]*)$/.exec(tag);
  if (opening) {
    const parent = openElement(text.slice(0, start));
    if (opening[1]) return fitting(opening[2], parent ? [parent] : [], name => ({ text: `${name}>`, back: 0 }));
    const names = parent ? elements.get(parent)?.children || [] : ['MechML'];
    return fitting(opening[2], names, name => ({ text: name, back: 0 }));
  }
  const element = elements.get(/^<([\w-]+)\s/.exec(tag)?.[1]);
  if (!element) return none;
  const value = /\s([\w-]+)="([^"<>]*)$/.exec(tag);
  const complete = tag.replace(/\s[\w-]+="[^"]*"/g, ' ');
  if (value && !complete.endsWith(' ')) {
    return fitting(value[2], element.attributes.get(value[1]) || [], name => ({ text: name, back: 0 }));
  }
  const attribute = /^<[\w-]+(?:\s+[\w-]+="[^"]*")*\s+([\w-]*)$/.exec(tag);
  if (!attribute) return none;
  const given = new Set([...tag.matchAll(/\s([\w-]+)=/g)].map(found => found[1]));
  return fitting(attribute[1], [...element.attributes.keys()].filter(name => !given.has(name)),
    name => ({ text: `${name}=""`, back: 1 }));
}

// Shows what may stand at the caret: arrows choose, Enter or Tab takes, Escape hides.
export class Completion {
  constructor(area, list, dtd) {
    this.area = area;
    this.list = list;
    this.elements = grammarOf(dtd);
    this.found = { typed: '', choices: [] };
    area.addEventListener('input', event => (event.isTrusted ? this.show() : this.hide()));
    area.addEventListener('keydown', event => this.key(event));
    area.addEventListener('scroll', () => this.hide());
    area.addEventListener('blur', () => this.hide());
    area.addEventListener('click', () => this.hide());
    list.addEventListener('pointerdown', event => {
      event.preventDefault();
      const at = [...list.children].indexOf(event.target);
      if (at >= 0) this.take(at);
    });
  }

  get open() {
    return !this.list.hidden;
  }

  show() {
    const { area, list } = this;
    const before = area.value.slice(Math.max(0, area.selectionStart - 200000), area.selectionStart);
    this.found = choicesAt(before, this.elements);
    const { typed, choices } = this.found;
    if (!choices.length || (choices.length === 1 && choices[0].text === typed)) {
      this.hide();
      return;
    }
    list.replaceChildren(...choices.map((choice, i) => Object.assign(
      document.createElement('li'), { textContent: choice.name, role: 'option', id: `choice-${i}` })));
    list.hidden = false;
    const style = getComputedStyle(area);
    const pen = document.createElement('canvas').getContext('2d');
    pen.font = `${style.fontSize} ${style.fontFamily}`;
    const lines = before.split('\n');
    const column = lines[lines.length - 1].length - typed.length;
    const row = area.value.slice(0, area.selectionStart).split('\n').length;
    const high = parseFloat(style.lineHeight);
    const left = area.offsetLeft + parseFloat(style.paddingLeft) + column * pen.measureText('0').width
      - area.scrollLeft;
    const top = area.offsetTop + parseFloat(style.paddingTop) + row * high - area.scrollTop;
    const room = area.offsetTop + area.clientHeight - list.offsetHeight;
    list.style.left = `${Math.max(0, Math.min(left, area.offsetLeft + area.clientWidth - list.offsetWidth))}px`;
    list.style.top = `${top <= room ? top : Math.max(0, top - high - list.offsetHeight)}px`;
    this.choose(0);
  }

  hide() {
    this.list.hidden = true;
    this.area.removeAttribute('aria-activedescendant');
  }

  choose(at) {
    this.chosen = at;
    [...this.list.children].forEach((item, i) => item.setAttribute('aria-selected', String(i === at)));
    this.area.setAttribute('aria-activedescendant', `choice-${at}`);
  }

  take(at) {
    const { typed, choices } = this.found;
    const { text, back } = choices[at];
    const end = this.area.selectionStart;
    this.hide();
    this.area.setRangeText(text, end - typed.length, end, 'end');
    this.area.selectionStart = this.area.selectionEnd = end - typed.length + text.length - back;
    this.area.dispatchEvent(new Event('input'));
  }

  key(event) {
    if (!this.open) return;
    const count = this.found.choices.length;
    const acts = {
      ArrowDown: () => this.choose((this.chosen + 1) % count),
      ArrowUp: () => this.choose((this.chosen + count - 1) % count),
      Enter: () => this.take(this.chosen),
      Tab: () => this.take(this.chosen),
      Escape: () => this.hide(),
    };
    if (acts[event.key]) {
      event.preventDefault();
      acts[event.key]();
    }
  }
}
