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
  if (mebi < 1) return bytes < 1024 ? `${bytes} B` : `${Math.round(bytes / 1024)} KiB`;
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

/** A name such as relativeTolerance as words. Names of things, such as driver.angle, stay as they are. */
export const words = name => /^[a-z][A-Za-z]*$/.test(name) ? name.replace(/([a-z])([A-Z])/g, (all, a, b) => `${a} ${b.toLowerCase()}`) : name;

/** A text with a capital letter, unless it is a name. */
export const sentence = text => /^[a-z]+( |$)/.test(text) ? text[0].toUpperCase() + text.slice(1) : text;

/** The end of a certificate; what is left of it in its last 30 days. */
export function certificate(millis) {
  const end = new Date(Number(millis));
  const left = Math.floor((end - Date.now()) / 86400000);
  const day = end.toISOString().slice(0, 10);
  return left < 0 ? `${day} (expired)` : left < 30 ? `${day} (${left} d left)` : day;
}

const STATISTICS = {
  sessionsOpened: ["Sessions since start"], connections: ["Connections"],
  completed: ["Runs completed"], failed: ["Runs failed"], cancelled: ["Runs cancelled"],
  spoolBytes: ["Rows kept", value => memory(Number(value))], freeDisk: ["Disk free", value => memory(Number(value))],
  processLoad: ["CPU of this process", value => percent(Number(value))], userCode: ["Classes of users"],
  certificateExpires: ["Certificate", certificate],
};

/** The figures of a host with their labels, in the order above; those of a later version come last. */
export function statistics(all) {
  const order = Object.keys(STATISTICS);
  const place = name => order.includes(name) ? order.indexOf(name) : order.length;
  return Object.entries(all).sort(([a], [b]) => place(a) - place(b)).map(([name, value]) => {
    const [label, show] = STATISTICS[name] || [sentence(words(name))];
    return [label, show ? show(value) : value];
  });
}

/** The value of a limit in a unit that reads well. */
export function limitValue(limit) {
  if (limit.value === -1) return "unlimited";
  if (limit.unit === "B") return memory(limit.value);
  if (limit.unit === "s") return duration(limit.value);
  return `${limit.value}${limit.unit === "1" ? "" : ` ${limit.unit}`}`;
}

function duration(seconds) {
  if (seconds < 600) return `${seconds} s`;
  if (seconds < 7200) return `${Number((seconds / 60).toPrecision(3))} min`;
  return seconds < 172800 ? `${Number((seconds / 3600).toPrecision(3))} h` : `${Number((seconds / 86400).toPrecision(3))} d`;
}

export const shortId = id => id.slice(0, 8);

const KINDS = {
  up: "good", running: "good", done: "", queued: "cool", created: "cool", paused: "warn", draining: "warn",
  failed: "bad", lost: "bad", "no answer": "bad", connecting: "cool", cancelled: "warn",
};

export const stateKind = state => KINDS[state] ?? "";

/** The code a message begins with, if it does. */
export function codeOf(text) {
  const found = /^([MNS]-\d{3}) /.exec(text || "");
  return found ? found[1] : "";
}
