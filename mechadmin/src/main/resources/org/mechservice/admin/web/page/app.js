// Which view is shown, and what stands around it.

import { get, takeToken } from "./api.js";
import { hostView, serverView, simulationView } from "./details.js";
import { el, fill, setText } from "./dom.js";
import { follow, store } from "./store.js";
import { audit, eventView, failureList, overview, simulations } from "./views.js";

const main = document.getElementById("main");
const live = document.getElementById("live");
const THEMES = ["auto", "light", "dark"];
const ROUTES = { "": overview, simulations, failures: failureList, events: eventView, audit, server: serverView, host: hostView, sim: simulationView };

let view;

function route() {
  const [name, ...parts] = location.hash.replace(/^#\/?/, "").split("/").map(decodeURIComponent);
  view?.close?.();
  view = (ROUTES[name] || overview)(...parts);
  fill(main, view.node);
  view.update();
  scrollTo(0, 0);
  for (const link of document.querySelectorAll(".bar nav a")) {
    if (link.getAttribute("href") === `#/${name}`) link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  }
}

function theme(name) {
  if (name === "auto") delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = name;
  const button = document.getElementById("theme");
  setText(button, { auto: "◐", light: "☀", dark: "☾" }[name]);
  button.setAttribute("aria-label", `Colours: ${name}`);
  button.title = `Colours: ${name}`;
  button.onclick = () => {
    const next = THEMES[(THEMES.indexOf(name) + 1) % THEMES.length];
    localStorage.setItem("mechadmin-theme", next);
    theme(next);
  };
}

function disconnected(error) {
  live.className = "live";
  setText(live, "not connected");
  if (error.status === 401) refused(error);
}

function refused(error) {
  view?.close?.();
  view = undefined;
  fill(main, el("section", { class: "card" }, el("h1", {}, "This page needs a token"), el("p", {}, error.message),
    el("p", {}, el("a", { href: "/docs/errors/S-132.md" }, "About S-132"))));
}

async function start() {
  theme(localStorage.getItem("mechadmin-theme") || "auto");
  takeToken();
  try {
    const session = await get("session");
    store.right = session.right;
    setText(document.getElementById("right"), session.right);
  } catch (error) {
    disconnected(error);
    if (error.status !== 401) setTimeout(start, 2000);
    return;
  }
  follow(() => view?.update(), () => { live.className = "live on"; setText(live, "live"); }, disconnected);
  addEventListener("hashchange", route);
  route();
  setInterval(() => view?.update(), 1000);
}

// A tab that is given another token begins anew.
addEventListener("hashchange", () => { if (location.hash.startsWith("#token=")) location.reload(); });
start();
