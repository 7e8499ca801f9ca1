// One curve over time, drawn anew with every sample.

import { draw, el, setText } from "./dom.js";
import { number } from "./format.js";

const HEIGHT = 150;
const LEFT = 58;
const BOTTOM = 20;
const TOP = 6;

/** Width of a stretch of an envelope, px. */
const SPAN = 4;

/** Height of a stretch above which its points are not told apart, px. */
const NOISE = 8;
const PIXELS = { x: x => x, y: y => y };

/**
 * A figure with a curve. options: unit; log: a logarithmic scale; steps: a stair; range: fixed [from, to]; zero: from zero;
 * show: how a value reads; showX: how a place on the horizontal axis reads.
 */
export function chart(title, options = {}) {
  const show = options.show || (value => number(value) + (options.unit ? ` ${options.unit}` : ""));
  const latest = el("span", { class: "muted" }, "–");
  const svg = draw("svg", { role: "img", "aria-label": title });
  const node = el("figure", { class: "card" }, el("figcaption", {}, el("b", {}, title), latest), svg);
  let shown;
  new ResizeObserver(() => shown?.()).observe(svg);
  return {
    node,
    draw(x, y) {
      shown = () => drawCurve(svg, latest, title, x, y, show, options);
      shown();
    },
  };
}

function drawCurve(svg, latest, title, xs, ys, show, options) {
  const usable = value => value !== null && value !== undefined && (!options.log || value > 0);
  const points = [];
  for (let i = 0; i < xs.length; i++) {
    if (xs[i] !== null && usable(ys[i])) points.push([xs[i], options.log ? Math.log10(ys[i]) : ys[i]]);
  }
  svg.replaceChildren();
  const width = Math.max(200, svg.clientWidth || 480);
  svg.setAttribute("viewBox", `0 0 ${width} ${HEIGHT}`);
  if (points.length === 0) {
    svg.append(draw("text", { x: width / 2, y: HEIGHT / 2, "text-anchor": "middle" }, options.none || "no values yet"));
    setText(latest, "–");
    return;
  }
  const value = y => options.log ? 10 ** y : y;
  const scale = scales(points, width, options);
  for (const y of scale.ticks) {
    svg.append(draw("line", { class: "grid", x1: LEFT, x2: width, y1: scale.y(y), y2: scale.y(y) }));
    svg.append(draw("text", { x: LEFT - 8, y: scale.y(y) + 4, "text-anchor": "end" }, options.showTick ? options.showTick(value(y)) : number(value(y))));
  }
  const showX = options.showX || (x => `${number(x)} s`);
  svg.append(draw("text", { x: LEFT, y: HEIGHT - 3 }, showX(points[0][0])));
  svg.append(draw("text", { x: width, y: HEIGHT - 3, "text-anchor": "end" }, showX(points[points.length - 1][0])));
  const spans = points.length > 2 * (width - LEFT) / SPAN ? envelope(points, scale) : [];
  if (isNoise(spans)) {
    svg.append(draw("path", { class: "band", d: band(spans) }));
    svg.append(draw("path", { class: "curve", d: line(spans.map(span => [span.x, span.mean]), PIXELS, false) }));
  } else {
    svg.append(draw("path", { class: "curve", d: line(points, scale, options.steps) }));
  }
  const last = points[points.length - 1];
  svg.append(draw("circle", { class: "dot", cx: scale.x(last[0]), cy: scale.y(last[1]), r: 3 }));
  setText(latest, show(value(last[1])));
  svg.setAttribute("aria-label", `${title}: ${points.length} values, the last ${show(value(last[1]))}`);
}

/** The least, mean and largest height of the points in each stretch of the horizontal axis, px. */
function envelope(points, scale) {
  const spans = [];
  for (const [x, y] of points) {
    const px = scale.x(x);
    const py = scale.y(y);
    const place = Math.floor(px / SPAN);
    let span = spans[spans.length - 1];
    if (!span || span.place !== place) spans.push(span = { place, x: px, top: py, bottom: py, mean: 0, count: 0 });
    span.top = Math.min(span.top, py);
    span.bottom = Math.max(span.bottom, py);
    span.count++;
    span.mean += (py - span.mean) / span.count;
  }
  return spans;
}

/** Whether a line through all points would be a solid area: most stretches hold several points far apart. */
function isNoise(spans) {
  return spans.length > 1 && spans.filter(span => span.count > 2 && span.bottom - span.top > NOISE).length > spans.length / 2;
}

function band(spans) {
  const above = spans.map(span => `${span.x.toFixed(1)} ${span.top.toFixed(1)}`);
  const below = spans.map(span => `${span.x.toFixed(1)} ${span.bottom.toFixed(1)}`).reverse();
  return `M${above.concat(below).join("L")}Z`;
}

function scales(points, width, options) {
  let low = Infinity;
  let high = -Infinity;
  for (const [, y] of points) {
    low = Math.min(low, y);
    high = Math.max(high, y);
  }
  if (options.range) [low, high] = options.range;
  if (options.zero) [low, high] = [0, Math.max(2 * Math.ceil(high / 2), 2)];
  if (high - low < 1e-12 * Math.max(1e-300, Math.abs(high)) || high === low) {
    const half = options.log ? 0.5 : Math.abs(high) / 2 || 1;
    low -= half;
    high += half;
  }
  const from = points[0][0];
  const span = points[points.length - 1][0] - from || 1;
  return {
    ticks: [low, (low + high) / 2, high],
    x: x => LEFT + (x - from) / span * (width - LEFT - 4),
    y: y => TOP + (high - y) / (high - low) * (HEIGHT - TOP - BOTTOM - 4),
  };
}

function line(points, scale, steps) {
  let text = "";
  points.forEach(([x, y], i) => {
    const px = scale.x(x).toFixed(1);
    const py = scale.y(y).toFixed(1);
    text += i === 0 ? `M${px} ${py}` : steps ? `H${px}V${py}` : `L${px} ${py}`;
  });
  return text;
}
