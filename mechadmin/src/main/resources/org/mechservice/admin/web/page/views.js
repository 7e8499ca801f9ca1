// The lists: overview, simulations, failures, events, audit. A view is made once and brought up to date by update().

import { actionButton, drainButton, shutdownButton } from "./actions.js";
import { get } from "./api.js";
import { el, fill, meter, setText } from "./dom.js";
import { age, clock, codeOf, limitValue, memory, moment, percent, sentence, shortId, stateKind } from "./format.js";
import { failures, goesOn, hostsOf, loading, path, serverName, store } from "./store.js";
import { simulationTable } from "./table.js";

/** The documentation of a message, or nothing if it has no code. */
export const docLink = code => code && el("a", { href: `/docs/errors/${code}.md`, target: "_blank" }, `About ${code}`);

export function overview() {
  const tiles = [tile("#/", "servers up"), tile("#/", "hosts up"), tile("#/simulations", "running"), tile("#/simulations", "queued"),
    tile("#/simulations", "done"), tile("#/failures", "failed, 24 h")];
  const servers = el("div");
  const cards = new Map();
  const running = simulationTable({ title: "Going on", among: goesOn, filters: false });
  const events = eventList(8);
  const node = el("div", {}, el("h1", { class: "skip" }, "Overview"), el("div", { class: "tiles" }, tiles.map(one => one.node)), servers, running.node,
    el("section", { class: "card flush" }, el("div", { class: "tools" }, el("h2", {}, "Lately")), events.node));
  return { node, update };

  function update() {
    const all = [...store.simulations.values()];
    const up = [...store.servers.values()].filter(server => server.answers).length;
    const hosts = [...store.hosts.values()];
    const lost = hosts.filter(host => !host.reachable).length;
    const count = state => all.filter(row => row.state === state).length;
    const complete = !loading();
    const known = value => complete ? value : value || "…";
    const failed = newFailures(failures());
    const shown = [[known(up && `${up} of ${store.servers.size}`) || `0 of ${store.servers.size}`, complete && up < store.servers.size],
      [known(lost ? `${hosts.length - lost} of ${hosts.length}` : hosts.length), lost > 0],
      [known(count("running") + count("paused"))], [known(count("queued"))], [known(count("done"))],
      [known(failed.length), failed.some(isOfService)]];
    shown.forEach(([value, alarm], i) => tiles[i].show(value, alarm));
    for (const [address] of cards) if (!store.servers.has(address)) { cards.get(address).node.remove(); cards.delete(address); }
    for (const server of store.servers.values()) {
      if (!cards.has(server.address)) {
        cards.set(server.address, serverCard());
        servers.append(cards.get(server.address).node);
      }
      cards.get(server.address).show(server);
    }
    running.update();
    events.update();
  }
}

function tile(href, name) {
  const number = el("b");
  const node = el("a", { class: "tile", href }, number, el("span", {}, name));
  return { node, show(value, alarm = false) { setText(number, String(value)); node.classList.toggle("alarm", alarm); } };
}

function serverCard() {
  const link = el("a");
  const chip = el("span", { class: "chip" });
  const about = el("span", { class: "muted" });
  const actions = el("div", { class: "actions" });
  const problem = el("p", { class: "problem" });
  const body = el("tbody");
  const rows = new Map();
  const table = el("div", { class: "scroll" }, el("table", { class: "stack hosts" },
    el("thead", {}, el("tr", {}, ["Host", "State", "CPU", "Memory", "Running", "Queued", ""].map((name, i) =>
      el("th", { scope: "col", class: i === 4 || i === 5 ? "number" : "" }, name)))), body));
  const node = el("section", { class: "card server", "aria-label": "Server" },
    el("div", { class: "top" }, el("h2", {}, link), chip, about, actions), problem, table);
  let shown = "";
  return { node, show };

  function show(server) {
    const state = serverState(server);
    setText(link, server.name || server.address);
    link.href = path("server", server.address);
    setText(chip, state);
    chip.className = `chip ${stateKind(state)}`;
    setText(about, server.answers
      ? `${server.address} · up ${age(server.startedAt)} · version ${server.version}` : server.address);
    setText(problem, server.problem || "");
    problem.hidden = !server.problem;
    if (shown !== state) {
      fill(actions, server.answers && [drainButton(server.address, "", server.draining, true), shutdownButton(server.address, server.name, true)]);
      shown = state;
    }
    const hosts = server.answers ? hostsOf(server.address) : [];
    table.hidden = hosts.length === 0;
    const keep = new Set(hosts.map(host => host.key));
    for (const [key, row] of rows) if (!keep.has(key)) { row.node.remove(); rows.delete(key); }
    for (const host of hosts) {
      if (!rows.has(host.key)) rows.set(host.key, hostRow(host));
      const row = rows.get(host.key);
      row.show(host);
      if (row.node.parentNode !== body) body.append(row.node);
    }
  }
}

function hostRow(first) {
  const chip = el("span", { class: "chip" });
  const cpu = meter("processor load");
  const used = meter("memory");
  const cells = ["", "", "CPU", "Memory", "Running", "Queued", ""].map((label, i) =>
    el("td", { class: i === 4 || i === 5 ? "number" : i === 2 || i === 3 ? "wide" : "", "data-label": label }));
  fill(cells[0], el("a", { href: path("host", first.server, first.name) }, first.name));
  cells[0].className = "name";
  fill(cells[1], chip);
  fill(cells[2], cpu.node);
  fill(cells[3], used.node);
  let shown = "";
  return { node: el("tr", {}, cells), show };

  function show(host) {
    setText(chip, host.state);
    chip.title = host.problem;
    chip.className = `chip ${stateKind(host.state)}`;
    const alive = host.reachable;
    cpu.show(alive ? host.cpuLoad : 0, alive ? percent(host.cpuLoad) : "–", host.cpuLoad > 0.9 ? "high" : "");
    used.show(alive ? host.memoryUsed / host.memoryBytes : 0, alive ? memory(host.memoryUsed) : "–");
    setText(cells[4], `${alive ? host.running : 0} of ${host.capacity}`);
    setText(cells[5], alive ? String(host.queued) : "–");
    if (shown !== host.state) {
      fill(cells[6], alive && drainButton(host.server, host.name, host.draining, true));
      shown = host.state;
    }
  }
}

export function simulations() {
  const table = simulationTable({ title: "Simulations" });
  return { node: el("div", {}, table.node), update: table.update };
}

const DAY = 24 * 3600 * 1000;
const ACKNOWLEDGED = "mechadmin-acknowledged";
const acknowledgedAt = () => Number(localStorage.getItem(ACKNOWLEDGED) || 0);

/** The failures that count: of the last 24 hours, and after the last acknowledgement in this browser. */
const newFailures = all => all.filter(row => Date.parse(row.endedAt) > Math.max(Date.now() - DAY, acknowledgedAt()));

/** Whether a host or server caused the failure, not the model. */
const isOfService = row => codeOf(row.message).startsWith("S");

export function failureList() {
  const view = { earlier: false };
  const about = el("span", { class: "muted" });
  const acknowledge = el("button", { type: "button", title: "Removes these failures from the count on the overview, in this browser", onclick: () => {
    localStorage.setItem(ACKNOWLEDGED, String(Date.now()));
    update();
  } }, "Acknowledge all");
  const earlier = el("button", { type: "button", onclick: () => { view.earlier = !view.earlier; update(); } });
  const list = el("div");
  const node = el("div", {}, el("div", { class: "head" }, el("h1", {}, "Failures"), about, el("div", { class: "actions" }, earlier, acknowledge)), list);
  let known;
  return { node, update };

  function update() {
    const all = failures();
    const recent = newFailures(all);
    const shown = view.earlier ? all : recent;
    const now = `${view.earlier} ${recent.length} ${loading()} ${shown.map(row => row.id).join()}`;
    if (now === known) return;
    known = now;
    setText(about, `${recent.length} in the last 24 h, ${all.length - recent.length} older or acknowledged`);
    acknowledge.disabled = recent.length === 0;
    setText(earlier, view.earlier ? "Hide older and acknowledged" : "Show older and acknowledged");
    earlier.hidden = all.length === recent.length;
    fill(list, shown.length === 0 && el("p", { class: "card empty" }, loading() ? "Loading …" : "No new failures."),
      group("Failures of hosts and servers", shown.filter(isOfService)),
      group("Failures of models", shown.filter(row => !isOfService(row))));
  }

  function group(title, rows) {
    const byCode = new Map();
    for (const row of rows) {
      const code = codeOf(row.message);
      byCode.set(code, [...(byCode.get(code) || []), row]);
    }
    return rows.length > 0 && [el("h2", {}, `${title}: ${rows.length}`),
      [...byCode.values()].sort((a, b) => b.length - a.length).map(failureCard)];
  }
}

const FAILURES_SHOWN = 100;

/** The failures with one message code, the newest in full and the others as a list. */
function failureCard([newest, ...others]) {
  return el("article", { class: "card failure" },
    el("h3", {}, failedRun(newest), others.length > 0 && [" ", el("span", { class: "chip bad" }, `${others.length + 1} times`)]),
    el("p", {}, newest.message),
    el("p", { class: "meta" }, failurePlace(newest), " ", docLink(codeOf(newest.message))),
    others.length > 0 && el("details", {}, el("summary", {}, `${others.length} earlier`),
      el("ul", {}, others.slice(0, FAILURES_SHOWN).map(row => el("li", {}, failedRun(row), " ", el("span", { class: "muted" }, failurePlace(row))))),
      others.length > FAILURES_SHOWN && el("p", {}, `and ${others.length - FAILURES_SHOWN} more: `, el("a", { href: "#/simulations" }, "all simulations"))));
}

const failedRun = row => [el("a", { href: path("sim", row.server, row.id) }, row.model || "(unnamed)"), " ",
  el("span", { class: "muted mono" }, shortId(row.id))];

const failurePlace = row => [`${moment(row.endedAt)} · host `, el("a", { href: path("host", row.server, row.host) }, row.host), ` · ${row.owner}`];

/** The latest events, the newest first. */
function eventList(most) {
  const node = el("ul", { class: "events" });
  let known = -1;
  return { node, update };

  function update() {
    const last = store.events.length ? store.events[store.events.length - 1].seen : 0;
    if (last === known) return;
    known = last;
    const events = store.events.slice(-most).reverse();
    fill(node, events.length === 0 && el("li", {}, el("span", { class: "text" }, "Nothing has happened yet.")), events.map(event =>
      el("li", { class: event.level }, el("time", { datetime: event.at }, clock(event.at)), el("span", { class: "kind" }, event.kind),
        el("span", { class: "text" }, eventText(event)))));
  }
}

function eventText(event) {
  const link = event.simulation && store.simulations.has(event.simulation);
  return [event.code && [docLink(event.code), " "], event.text, " ",
    link && el("a", { href: path("sim", event.server, event.simulation), class: "mono" }, shortId(event.simulation)),
    el("span", { class: "muted" }, ` ${[event.host, serverName(event.server)].filter(Boolean).join(" · ")}`)].flat(2);
}

export function eventView() {
  const events = eventList(300);
  const node = el("div", {}, el("div", { class: "head" }, el("h1", {}, "Events")), el("section", { class: "card flush" }, events.node));
  return { node, update: events.update };
}

export function audit() {
  const list = el("ul", { class: "events" });
  const node = el("div", {}, el("div", { class: "head" }, el("h1", {}, "Audit"), el("span", { class: "muted" }, "what was done on this page, and what was refused")),
    el("section", { class: "card flush" }, list));
  load();
  return { node, update() {} };

  async function load() {
    try {
      const { entries } = await get("audit");
      fill(list, entries.length === 0 && el("li", {}, el("span", { class: "text" }, "Nothing yet.")), entries.reverse().map(entry =>
        el("li", { class: entry.result === "done" ? "info" : "error" }, el("time", { datetime: entry.at }, clock(entry.at)), el("span", { class: "kind" }, `${entry.right}, ${entry.from}`),
          el("span", { class: "text" }, entry.server ? `${entry.action}, at ${entry.server}: ` : `${entry.action}: `, entry.result))));
    } catch (failure) {
      fill(list, el("li", { class: "error" }, el("span", { class: "text" }, failure.message)));
    }
  }
}

/** The state of a server in one word. */
export function serverState(server) {
  if (server.connecting) return "connecting";
  if (!server.answers) return "no answer";
  return server.draining ? "draining" : "up";
}

/** The limits of a place, to be changed. */
export function limitCard(server, host) {
  const body = el("tbody");
  const placement = el("div", { class: "actions" });
  const node = el("details", { class: "card limits" }, el("summary", {}, "Limits"), placement,
    el("div", { class: "scroll" }, el("table", {}, body)));
  let loaded = false;
  node.addEventListener("toggle", () => { if (node.open && !loaded) load(); });
  return node;

  async function load() {
    try {
      const said = await get("limits", { server, host });
      loaded = true;
      fill(body, said.limits.map(limit => el("tr", {}, el("td", {}, sentence(limit.text), el("span", { class: "sub mono" }, limit.name)),
        el("td", { class: "number" }, limitValue(limit)),
        el("td", {}, limitButton(limit)))));
      fill(placement, said.placement && [el("span", {}, `Choice of hosts: ${said.placement}`), placementButton(said.placement)]);
    } catch (failure) {
      fill(placement, el("p", { class: "muted" }, failure.message));
    }
  }

  function limitButton(limit) {
    return withReload(actionButton("Change", {
      title: `Change the limit ${limit.name}`, small: true,
      note: host ? "For this host." : "For this server, all its hosts, and hosts that register later.",
      fields: [{ name: "value", label: `${sentence(limit.text)}${limit.unit === "1" ? "" : `, ${limit.unit}`}; or “unlimited”`,
        value: limit.value === -1 ? "unlimited" : String(limit.value) }],
      request: values => ({ server, action: "limits", host, limits: { [limit.name]: values.value.trim() === "unlimited" ? -1 : values.value.trim() } }),
    }));
  }

  function placementButton(policy) {
    return withReload(actionButton("Change", {
      title: "Change the choice of hosts", small: true,
      note: "least-loaded: the host with most free places. order: one host after the other. pinned: a client stays on its host.",
      fields: [{ name: "policy", label: "Choice of a host for a new session", value: policy, choices: ["least-loaded", "order", "pinned"] }],
      request: values => ({ server, action: "placement", host, policy: values.policy }),
    }));
  }

  /** What was changed is read again when its dialog has gone. */
  function withReload(button) {
    button.addEventListener("click", () =>
      document.querySelector("dialog")?.addEventListener("close", () => { loaded = false; load(); }));
    return button;
  }
}

/** The latest log lines of a place. */
export function logCard(server, host) {
  const text = el("pre", { tabindex: 0 }, "…");
  const node = el("details", { class: "card" }, el("summary", {}, "Log"), text);
  node.addEventListener("toggle", () => { if (node.open) load(); });
  return node;

  async function load() {
    try {
      const { lines } = await get("logs", { server, host });
      setText(text, lines.map(line => `${clock(line.at)} ${line.level.padEnd(5)} ${line.text}`).join("\n") || "nothing yet");
      text.scrollTop = text.scrollHeight;
    } catch (failure) {
      setText(text, failure.message);
    }
  }
}
