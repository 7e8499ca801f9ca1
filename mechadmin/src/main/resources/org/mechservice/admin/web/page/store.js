// What is known of servers, hosts, simulations and events; tells its listener when something changes.

import { stream } from "./api.js";

const EVENTS_KEPT = 500;

/** heard: whether the console has sent its first update. */
export const store = { servers: new Map(), hosts: new Map(), simulations: new Map(), events: [], right: "", heard: false };

/** Follows the console; changed is called at most once per picture. */
export function follow(changed, opened, lost) {
  let waiting = false;
  let fresh = true;
  const soon = () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => { waiting = false; changed(); });
  };
  return stream("updates", {}, {
    opened() { fresh = true; opened(); },
    lost,
    update(update) {
      if (fresh) {
        for (const map of [store.servers, store.hosts, store.simulations]) map.clear();
        store.events = [];
        fresh = false;
      }
      apply(store.servers, update.servers, row => row.address);
      apply(store.hosts, update.hosts, row => row.key);
      apply(store.simulations, update.simulations, row => row.id);
      store.heard = true;
      store.events = store.events.concat(update.events).slice(-EVENTS_KEPT);
      soon();
    },
  });
}

function apply(map, update, key) {
  for (const gone of update.gone) map.delete(gone);
  for (const row of update.changed) map.set(key(row), row);
}

export const goesOn = simulation => !["done", "failed", "cancelled"].includes(simulation.state);

export const serverName = address => store.servers.get(address)?.name || address;

export const hostsOf = server =>
  [...store.hosts.values()].filter(host => host.server === server).sort((a, b) => a.name.localeCompare(b.name));

/** Whether a server has not given its first answer yet, so that counts are incomplete. */
export const loading = () => !store.heard || [...store.servers.values()].some(server => server.connecting);

export const failures = () => [...store.simulations.values()].filter(simulation => simulation.state === "failed")
  .sort((a, b) => b.endedAt.localeCompare(a.endedAt));

export const path = (...parts) => "#/" + parts.map(encodeURIComponent).join("/");
