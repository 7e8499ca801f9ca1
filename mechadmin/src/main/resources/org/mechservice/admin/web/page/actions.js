// Everything that changes something: a button, a dialog that says what will happen and which command line does the
// same, and the call.

import { post } from "./api.js";
import { el, setText } from "./dom.js";
import { store } from "./store.js";

/** A button that asks before it acts. request: makes the request from the dialog's fields. */
export function actionButton(label, { title, note, request, fields = [], danger = false, small = false }) {
  const allowed = store.right === "admin";
  return el("button", {
    type: "button",
    class: `${danger ? "danger" : ""} ${small ? "small" : ""}`,
    disabled: !allowed,
    title: allowed ? undefined : "needs the admin token",
    onclick: () => confirm({ title, note, label, request, fields, danger }),
  }, label);
}

export const stopButton = (simulation, small = false) => actionButton("Stop", {
  title: `Stop ${simulation.model || "simulation"}?`, note: "Its rows so far are kept.", danger: true, small,
  fields: [{ name: "reason", label: "Reason, told to its owner", value: "stopped by the operator" }],
  request: values => ({ server: simulation.server, action: "stop", id: simulation.id, reason: values.reason }),
});

const DRAIN_HOST = "The host accepts no new sessions. Runs that can be saved continue on other hosts that are free; the others finish here.";
const DRAIN_SERVER = "The server accepts no new sessions. Runs in its own process continue on another server if their client knows one; "
  + "the others finish here. Registered hosts keep their runs: drain them by their names.";

export function drainButton(server, host, draining, small = false) {
  const what = host ? `host ${host}` : "the server";
  return actionButton(draining ? "Undrain" : "Drain", {
    title: `${draining ? "Undrain" : "Drain"} ${what}?`, small,
    note: draining ? `The ${host ? "host" : "server"} accepts new sessions again.` : host ? DRAIN_HOST : DRAIN_SERVER,
    request: () => ({ server, action: draining ? "undrain" : "drain", host }),
  });
}

export const shutdownButton = (server, name, small = false) => actionButton("Shut down", {
  title: `Shut down server ${name}?`, note: "The server accepts no new sessions. Runs in its own process that are active when the time is over are stopped; their rows are kept if it has a spool folder.", danger: true, small,
  fields: [{ name: "grace", label: "Time for active runs to finish, s", value: "30", type: "number", min: 0 }],
  request: values => ({ server, action: "shutdown", grace: Number(values.grace) }),
});

export function toast(text) {
  const place = document.getElementById("toast");
  setText(place, text);
  clearTimeout(toast.timer);
  toast.timer = setTimeout(() => setText(place, ""), 5000);
}

/** Asks whether to do something, and does it. */
function confirm({ title, note, label, request, fields, danger }) {
  const summary = el("p", { class: "muted" });
  const command = el("code", { class: "command" }, "…");
  const error = el("p", { class: "error", role: "alert" });
  const inputs = fields.map(field => field.choices
    ? el("select", { name: field.name, onchange: later }, field.choices.map(choice =>
      el("option", { value: choice, selected: choice === field.value }, choice)))
    : el("input", { name: field.name, type: field.type || "text", value: field.value, min: field.min, maxlength: 200, oninput: later }));
  const go = el("button", { type: "submit", class: `primary ${danger ? "danger" : ""}` }, label);
  const dialog = el("dialog", { "aria-labelledby": "ask" },
    el("form", { method: "dialog", onsubmit: act },
      el("h2", { id: "ask" }, title), note && el("p", {}, note),
      fields.map((field, i) => el("label", { class: "field" }, el("span", {}, field.label), inputs[i])),
      summary, command, error,
      el("div", { class: "actions" }, el("button", { type: "button", onclick: () => dialog.close() }, "Cancel"), go)));
  let timer;
  dialog.addEventListener("close", () => { clearTimeout(timer); dialog.remove(); });
  document.body.append(dialog);
  dialog.showModal();
  (inputs[0] || go).focus();
  preview();

  function values() {
    return Object.fromEntries(inputs.map(input => [input.name, input.value]));
  }

  function later() {
    clearTimeout(timer);
    timer = setTimeout(preview, 300);
  }

  async function preview() {
    try {
      const said = await post("preview", request(values()));
      setText(summary, `To ${said.summary}, at ${said.server}, on the command line:`);
      setText(command, said.command);
      setText(error, "");
    } catch (failure) {
      setText(summary, "");
      setText(command, "");
      setText(error, failure.message);
    }
  }

  async function act(event) {
    event.preventDefault();
    go.disabled = true;
    try {
      const said = await post("actions", request(values()));
      dialog.close();
      toast(`Done: ${said.summary}`);
    } catch (failure) {
      setText(error, failure.message);
      go.disabled = false;
    }
  }
}
