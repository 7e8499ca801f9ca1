// Numbers, times and states as people read them.

export function number(value) {
  if (value === null || value === undefined) return "–";
  const size = Math.abs(value);
  if (value !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(2).replace("e+", "e");
  return String(Number(value.toPrecision(4)));
}

export function percent(share) {
  return share === null || share === undefined ? "–" : `${Math.round(100 * share)} %`;
}

export function memory(bytes) {
  const mebi = bytes / 1048576;
  return mebi >= 1024 ? `${(mebi / 1024).toFixed(1)} GiB` : `${Math.round(mebi)} MiB`;
}

export function age(iso) {
  if (!iso || iso === "-") return "–";
  const seconds = Math.max(0, Math.floor((Date.now() - Date.parse(iso)) / 1000));
  if (seconds < 60) return `${seconds} s`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return `${minutes} min`;
  const hours = Math.floor(minutes / 60);
  if (hours < 24) return `${hours} h ${minutes % 60} min`;
  return `${Math.floor(hours / 24)} d ${hours % 24} h`;
}

export function clock(iso) {
  return iso && iso !== "-" ? new Date(iso).toLocaleTimeString([], { hour12: false }) : "–";
}

export function moment(iso) {
  return iso && iso !== "-" ? new Date(iso).toLocaleString([], { hour12: false }) : "–";
}

export const shortId = id => id.slice(0, 8);

const KINDS = {
  up: "good", running: "good", done: "", queued: "cool", created: "cool", paused: "warn", draining: "warn",
  failed: "bad", lost: "bad", "no answer": "bad", cancelled: "warn",
};

export const stateKind = state => KINDS[state] ?? "";

/** The code a message begins with, if it does. */
export function codeOf(text) {
  const found = /^([MNS]-\d{3}) /.exec(text || "");
  return found ? found[1] : "";
}
