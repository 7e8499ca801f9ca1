// One thing in full: a server, a host, a simulation.

import { drainButton, shutdownButton, stopButton } from "./actions.js";
import { stream } from "./api.js";
import { chart } from "./chart.js";
import { el, fill, liveFacts, meter, setText, showJson } from "./dom.js";
import { age, certificate, clock, codeOf, memory, moment, number, percent, stateKind, statistics } from "./format.js";
import { goesOn, loading, path, serverName, store } from "./store.js";
import { simulationTable } from "./table.js";
import { docLink, limitCard, logCard, serverState } from "./views.js";

const SAMPLES_KEPT = 600;

function heading() {
  const title = el("h1");
  const chip = el("span", { class: "chip" });
  const crumb = el("div", { class: "crumb" });
  const actions = el("div", { class: "actions" });
  let shown = "";
  return {
    node: el("div", { class: "head" }, crumb, title, chip, actions),
    crumb,
    show(name, state, buttons) {
      setText(title, name);
      setText(chip, state);
      chip.className = `chip ${stateKind(state)}`;
      if (shown !== state) fill(actions, buttons());
      shown = state;
    },
  };
}

export function serverView(address) {
  const head = heading();
  const about = liveFacts();
  const table = simulationTable({ title: "Simulations", among: row => row.server === address });
  const node = el("div", {}, head.node, el("section", { class: "card" }, about.node), table.node, limitCard(address, ""), logCard(address, ""));
  fill(head.crumb, el("a", { href: "#/" }, "Overview"), " / server");
  return { node, update };

  function update() {
    const server = store.servers.get(address);
    if (!server) return;
    head.show(server.name || address, serverState(server),
      () => server.answers && [drainButton(address, "", server.draining), shutdownButton(address, server.name)]);
    about.show(server.answers ? [["Address", address], ["Up", age(server.startedAt)], ["Version", `${server.version}, API ${server.apiVersion}`],
      ["Hosts", server.hostCount], ["Sessions", server.sessions], ["Running", server.running], ["Queued", server.queued],
      ...(server.certificateExpires ? [["Certificate", certificate(server.certificateExpires)]] : [])]
      : [["Address", address], ["Problem", server.problem], ["Help", docLink(codeOf(server.problem)) || ""]]);
    table.update();
  }
}

export function hostView(server, name) {
  const head = heading();
  const about = liveFacts();
  const cpu = chart("CPU", { range: [0, 1], show: percent, showTick: percent, showX: time });
  const used = chart("Memory", { zero: true, show: memory, showTick: memory, showX: time });
  const busy = chart("Running", { zero: true, steps: true, show: value => String(value), showX: time });
  const table = simulationTable({ title: "Simulations", among: row => row.host === name && row.server === server });
  const node = el("div", {}, head.node, el("section", { class: "card" }, about.node), el("div", { class: "curves" }, cpu.node, used.node, busy.node),
    table.node, limitCard(server, name), logCard(server, name));
  fill(head.crumb, el("a", { href: "#/" }, "Overview"), " / ", el("a", { href: path("server", server) }, serverName(server)), " / host");
  let samples = [];
  const source = stream("host", { server, host: name }, { opened() { samples = []; }, loads });
  return { node, update, close: source.close };

  function time(millis) {
    return clock(new Date(millis).toISOString());
  }

  function loads(more) {
    samples = samples.concat(more).slice(-SAMPLES_KEPT);
    const at = samples.map(sample => sample.at);
    cpu.draw(at, samples.map(sample => sample.cpuLoad));
    used.draw(at, samples.map(sample => sample.memoryUsed));
    busy.draw(at, samples.map(sample => sample.running));
  }

  function update() {
    const host = store.hosts.get(`${server} ${name}`);
    if (!host) {
      head.show(name, loading() ? "loading" : "unknown", () => []);
      about.show([["Problem", loading() ? "" : "The server does not know this host now."]]);
      return;
    }
    head.show(name, host.state, () => host.reachable && drainButton(server, name, host.draining));
    about.show([["Address", host.address], ["Problem", host.problem], ["Up", age(host.startedAt)], ["Last heard of", `${age(host.lastSeen)} ago`],
      ["Version", host.version], ["Processors", host.cores], ["Memory", `${memory(host.memoryUsed)} of ${memory(host.memoryBytes)}`],
      ["Running", `${host.running} of ${host.capacity}`], ["Queued", host.queued], ["Sessions", host.sessions],
      ...statistics(host.statistics)]);
    table.update();
  }
}

export function simulationView(server, id) {
  const head = heading();
  const bar = meter("progress");
  const about = liveFacts();
  const failure = el("div");
  const curves = {
    stepSize: chart("Step size", { unit: "s", log: true }),
    order: chart("Order", { steps: true, show: value => String(Math.round(value)) }),
    energyDrift: chart("Energy drift", { unit: "J", none: "not put out by this run" }),
    residual: chart("Constraint residual", { log: true, none: "not put out by this run" }),
  };
  const model = el("pre", { tabindex: 0 }, "…");
  const check = section("Check report");
  const report = section("Run report");
  const events = section("Events");
  const node = el("div", {}, head.node, failure, el("section", { class: "card" }, bar.node, about.node),
    el("div", { class: "curves" }, Object.values(curves).map(curve => curve.node)),
    el("details", { class: "card" }, el("summary", {}, "Model"), model), check.node, report.node, events.node);
  fill(head.crumb, el("a", { href: "#/" }, "Overview"), " / ", el("a", { href: path("server", server) }, serverName(server)), " / ",
    el("span", { class: "mono" }, id));
  let explained = false;
  const source = stream("simulation", { server, id }, { detail, failure: lost });
  return { node, update, close: source.close };

  function section(title) {
    const body = el("div", {}, "–");
    return { node: el("details", { class: "card tree" }, el("summary", {}, title), body), body };
  }

  function update() {
    const row = store.simulations.get(id);
    if (row) show(row);
  }

  function show(row) {
    head.show(row.model || "(unnamed)", row.state, () => goesOn(row) && stopButton(row));
    bar.show(row.progress, percent(row.progress), row.state);
    about.show([["Simulated", `${number(row.time)} of ${number(row.endTime)} s`], ["× real time", number(row.realTimeFactor)],
      ["Steps", `${row.steps}, the last ${number(row.stepSize)} s of order ${row.order}`], ["Rows", row.rows],
      ["Queue", row.queuePosition > 0 ? `number ${row.queuePosition}` : ""],
      ["Host", el("a", { href: path("host", row.server, row.host) }, row.host)], ["Owner", row.owner],
      ["Created", `${moment(row.createdAt)}, ${age(row.createdAt)} ago`], ["Ended", row.endedAt === "-" ? "" : moment(row.endedAt)],
      ["Last message", row.state === "failed" ? "" : row.message]]);
    if (row.state === "failed" && !failure.hasChildNodes()) showFailure({ text: row.message, code: codeOf(row.message), lastSteps: [] });
  }

  function detail(said) {
    show(said);
    if (said.modelText !== undefined) setText(model, said.modelText || "not kept");
    if (said.checkReport !== undefined) showJson(check.body, said.checkReport);
    showJson(report.body, said.report);
    showEvents(said.events);
    for (const [name, curve] of Object.entries(curves)) curve.draw(said.curves.time, said.curves[name]);
    if (said.failure && !explained) {
      explained = true;
      showFailure({ ...said.failure, text: `${said.failure.code} ${said.failure.text}` });
    }
  }

  function showEvents(all) {
    const last = all.length ? all[all.length - 1].number : 0;
    if (events.body.last !== last) fill(events.body, eventTable(all));
    events.body.last = last;
  }

  function lost(said) {
    if (store.simulations.get(id)) return;
    fill(failure, el("p", { class: "card" }, said.error));
  }

  function showFailure(record) {
    fill(failure, el("section", { class: "card failure" }, el("h2", {}, "Failed"), el("p", {}, record.text),
      record.part && el("p", {}, `At ${record.part}, t = ${number(record.time)} s, step ${number(record.stepSize)} s, order ${record.order}.`),
      record.advice && el("p", {}, record.advice), el("p", {}, docLink(record.code)),
      record.lastSteps.length > 0 && el("details", {}, el("summary", {}, "The last steps tried"), el("div", { class: "scroll" }, el("table", {},
        el("thead", {}, el("tr", {}, ["Time", "Step size", "Order", "Error ratio"].map(name => el("th", { scope: "col" }, name)))),
        el("tbody", {}, record.lastSteps.map(step => el("tr", {}, [step.time, step.stepSize, step.order, step.errorRatio].map(value => el("td", {}, number(value)))))))))));
  }
}

function eventTable(events) {
  return el("ul", { class: "events" }, events.slice(-100).reverse().flatMap(event => {
    const texts = event.text ? [event.text] : [];
    for (const message of event.messages) texts.push(`${message.code} ${message.text}`);
    return texts.map(text => el("li", {}, el("time", { datetime: event.at }, clock(event.at)), el("span", { class: "kind" }, event.state), el("span", { class: "text" }, text)));
  }));
}
