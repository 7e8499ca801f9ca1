// Simulations as a table: sorted, filtered, in pages. Only the rows of the page shown exist, and of those only the
// cells that changed are touched, however many simulations there are.

import { stopButton } from "./actions.js";
import { el, fill, meter, setText } from "./dom.js";
import { age, number, percent, shortId, stateKind } from "./format.js";
import { goesOn, loading, path, store } from "./store.js";

const PAGE = 50;
const STATES = ["all", "going on", "queued", "running", "paused", "done", "failed", "cancelled"];

const COLUMNS = [
  { title: "Model", key: row => row.model },
  { title: "State", key: row => row.state },
  { title: "Progress", key: row => row.progress ?? 0 },
  { title: "× real time", key: row => row.realTimeFactor ?? 0, number: true },
  { title: "Step", key: row => row.stepSize ?? 0, number: true },
  { title: "Host", key: row => row.host },
  { title: "Owner", key: row => row.owner },
  { title: "Age", key: row => row.createdAt, number: true },
  { title: "Last message", key: row => row.message },
];

const AGE = 7;

/** A table. among: which simulations it is about; state: the first filter; filters: whether there are any. */
export function simulationTable({ title, among = () => true, state = "all", filters = true }) {
  const view = { state, words: "", sort: AGE, descending: true, page: 0 };
  const rows = new Map();
  const heads = COLUMNS.map((column, i) => el("th", { scope: "col", class: column.number ? "number" : "" },
    el("button", { type: "button", onclick: () => sortBy(i) }, column.title)));
  const body = el("tbody");
  const count = el("span");
  const back = el("button", { type: "button", class: "small", onclick: () => turn(-1) }, "Back");
  const next = el("button", { type: "button", class: "small", onclick: () => turn(1) }, "Next");
  const search = el("input", { type: "search", class: "grow", placeholder: "Model, owner, host, id, message", "aria-label": "Filter",
    oninput: () => { view.words = search.value.toLowerCase(); view.page = 0; update(); } });
  const states = el("select", { "aria-label": "State", onchange: () => { view.state = states.value; view.page = 0; update(); } },
    STATES.map(name => el("option", { value: name, selected: name === state }, name)));
  const none = el("p", { class: "empty" }, "None.");
  const node = el("section", { class: "card flush simulations", "aria-label": title },
    el("div", { class: "tools" }, el("h2", {}, title), filters && search, filters && states),
    el("div", { class: "scroll" }, el("table", { class: "stack" }, el("thead", {}, el("tr", {}, heads, el("th", { scope: "col" }, ""))), body)),
    none, el("div", { class: "pager" }, count, back, next));
  return { node, update };

  function sortBy(i) {
    view.descending = view.sort === i ? !view.descending : i >= 2 && i <= 4;
    view.sort = i;
    view.page = 0;
    update();
  }

  function turn(by) {
    view.page += by;
    update();
  }

  function chosen() {
    const key = COLUMNS[view.sort].key;
    const sign = view.descending ? -1 : 1;
    return [...store.simulations.values()].filter(row => among(row) && fits(row)).sort((a, b) => {
      const x = key(a);
      const y = key(b);
      return sign * (typeof x === "number" ? x - y : String(x).localeCompare(String(y))) || a.id.localeCompare(b.id);
    });
  }

  function fits(row) {
    const state = view.state === "all" || (view.state === "going on" ? goesOn(row) : row.state === view.state);
    return state && (view.words === ""
      || [row.model, row.owner, row.host, row.id, row.message].some(text => text.toLowerCase().includes(view.words)));
  }

  function update() {
    const all = chosen();
    const pages = Math.max(1, Math.ceil(all.length / PAGE));
    view.page = Math.max(0, Math.min(view.page, pages - 1));
    const shown = all.slice(view.page * PAGE, (view.page + 1) * PAGE);
    const keep = new Set(shown.map(row => row.id));
    for (const [id, row] of rows) {
      if (!keep.has(id)) { row.node.remove(); rows.delete(id); }
    }
    let place = body.firstChild;
    for (const data of shown) {
      let row = rows.get(data.id);
      if (!row) rows.set(data.id, row = makeRow(data));
      row.show(data);
      if (row.node === place) place = place.nextSibling;
      else body.insertBefore(row.node, place);
    }
    heads.forEach((head, i) => head.setAttribute("aria-sort", i !== view.sort ? "none" : view.descending ? "descending" : "ascending"));
    none.hidden = all.length > 0;
    setText(none, loading() ? "Loading …" : "None.");
    setText(count, pages > 1 ? `${view.page * PAGE + 1}–${view.page * PAGE + shown.length} of ${all.length}` : `${all.length} in all`);
    back.disabled = view.page === 0;
    next.disabled = view.page >= pages - 1;
    back.hidden = next.hidden = pages < 2;
  }
}

function makeRow(data) {
  const link = el("a", { href: path("sim", data.server, data.id) });
  const sub = el("span", { class: "sub mono" }, shortId(data.id));
  const chip = el("span", { class: "chip" });
  const bar = meter("progress");
  const cells = COLUMNS.map(column => el("td", { class: column.number ? "number" : "", "data-label": column.number || ["Host", "Owner"].includes(column.title) ? column.title : "" }));
  fill(cells[0], link, sub);
  cells[0].className = "name";
  fill(cells[1], chip);
  fill(cells[2], bar.node);
  cells[2].className = "wide";
  const host = el("a", { href: path("host", data.server, data.host) }, data.host);
  fill(cells[5], host);
  cells[8].className = "message";
  const act = el("td", { class: "act" });
  return { node: el("tr", {}, cells, act), show };

  function show(row) {
    setText(link, row.model || "(unnamed)");
    link.title = row.model;
    setText(chip, row.queuePosition > 0 ? `${row.state}, ${row.queuePosition}.` : row.state);
    chip.className = `chip ${stateKind(row.state)}`;
    bar.show(row.progress, percent(row.progress), row.state);
    setText(cells[3], goesOn(row) && row.steps > 0 ? number(row.realTimeFactor) : "");
    setText(cells[4], goesOn(row) && row.steps > 0 ? `${number(row.stepSize)} s` : "");
    setText(cells[6], row.owner);
    setText(cells[7], age(row.createdAt));
    // That it is running is said already.
    const message = row.message === row.state ? "" : row.message;
    setText(cells[8], message);
    cells[8].title = message;
    if (goesOn(row) !== act.hasChildNodes()) fill(act, goesOn(row) && stopButton(row, true));
  }
}
