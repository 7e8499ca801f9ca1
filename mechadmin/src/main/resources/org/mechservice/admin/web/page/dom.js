// The only ways things come onto the page. Text is always text: no name can become markup.

import { sentence, words } from "./format.js";

/** Makes an element; a property "class", an "on..." listener, or else an attribute; children are nodes or text. */
export function el(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === null || value === false) continue;
    if (name === "class") element.className = value;
    else if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  add(element, children);
  return element;
}

/** Makes an element of a drawing. */
export function draw(tag, properties = {}, text = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(properties)) element.setAttribute(name, String(value));
  if (text) element.textContent = text;
  return element;
}

function add(element, children) {
  for (const child of children.flat(Infinity)) {
    if (child === undefined || child === null || child === false) continue;
    element.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
}

/** Puts other children in place of those of an element. */
export function fill(element, ...children) {
  element.replaceChildren();
  add(element, children);
  return element;
}

/** Sets a text only if it is another one, so that a selection survives. */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

const told = pairs => pairs.filter(([, value]) => value !== undefined && value !== "");

/** A list of names and values; a value is text or a node. */
export function facts(pairs) {
  return el("dl", { class: "facts" }, told(pairs).map(([name, value]) => [el("dt", {}, name), el("dd", {}, value)]));
}

/** The same, to be shown again and again: what has not changed stays, with its focus and selection. */
export function liveFacts() {
  const node = el("dl", { class: "facts" });
  const shown = new Map();
  return { node, show };

  function show(pairs) {
    const now = told(pairs);
    if (now.map(([name]) => name).join() !== [...shown.keys()].join()) {
      shown.clear();
      fill(node, now.map(([name]) => {
        shown.set(name, el("dd"));
        return [el("dt", {}, name), shown.get(name)];
      }));
    }
    for (const [name, value] of now) {
      const text = value instanceof Node ? value.textContent : String(value);
      if (shown.get(name).textContent !== text) fill(shown.get(name), value);
    }
  }
}

/** Puts JSON into a place in readable form, unless it is there already. */
export function showJson(place, value) {
  const text = JSON.stringify(value);
  if (place.shown !== text) fill(place, tree(value));
  place.shown = text;
}

/** A bar from 0 to 1 with its words. */
export function meter(name) {
  const bar = el("div", { class: "fill" });
  const words = el("span");
  const track = el("div", { class: "track", role: "progressbar", "aria-label": name, "aria-valuemin": 0, "aria-valuemax": 100 }, bar);
  return {
    node: el("div", { class: "meter" }, track, words),
    show(share, text, kind = "") {
      const percent = Math.round(100 * Math.max(0, Math.min(1, share || 0)));
      if (bar.style.width !== `${percent}%`) bar.style.width = `${percent}%`;
      track.setAttribute("aria-valuenow", String(percent));
      bar.className = `fill ${kind}`;
      setText(words, text);
    },
  };
}

/** Any JSON as nested lists. */
function tree(value) {
  if (value === null || value === undefined) return "–";
  if (Array.isArray(value)) return value.length ? el("ul", {}, value.map(item => el("li", {}, tree(item)))) : "none";
  if (typeof value === "object") return facts(Object.entries(value).map(([name, member]) => [sentence(words(name)), tree(member)]));
  return String(value);
}
