// Curves over time in one canvas: axes with units, values at the cursor, and a line at the present time.

const EDGE = { right: 12, top: 20, bottom: 22 };

// Three to seven round numbers in a range.
export function ticks(least, most) {
  const step = 10 ** Math.floor(Math.log10((most - least) / 3));
  const wide = [1, 2, 5, 10].map(k => k * step).find(s => (most - least) / s <= 6) || step;
  const found = [];
  for (let k = Math.ceil(least / wide - 1e-9); k * wide <= most + 1e-9 * wide && found.length < 20; k++) {
    found.push(k * wide);
  }
  return found;
}

export function short(number) {
  const size = Math.abs(number);
  if (!Number.isFinite(number)) {
    return '–';
  }
  const digits = size !== 0 && (size < 1e-3 || size >= 1e5)
    ? number.toExponential(2) : String(Number(number.toPrecision(4)));
  return digits.replaceAll('-', '−');
}

export const unitOf = unit => (unit === '1' ? '' : unit);

// Draws on a canvas.
class CanvasPen {
  constructor(context) {
    this.pen = context;
  }

  line(points, colour, width, dash = []) {
    const { pen } = this;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.lineJoin = 'round';
    pen.setLineDash(dash);
    pen.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
    pen.stroke();
    pen.setLineDash([]);
  }

  box(x, y, width, height, fill, edge) {
    this.pen.fillStyle = fill;
    this.pen.fillRect(x, y, width, height);
    if (edge) {
      this.pen.strokeStyle = edge;
      this.pen.lineWidth = 1;
      this.pen.strokeRect(x + 0.5, y + 0.5, width - 1, height - 1);
    }
  }

  text(text, x, y, colour, align = 'left', base = 'middle') {
    const { pen } = this;
    pen.font = '11px system-ui, sans-serif';
    pen.fillStyle = colour;
    pen.textAlign = align;
    pen.textBaseline = base;
    pen.fillText(text, x, y);
  }
}

// Writes the same as SVG.
class SvgPen {
  constructor() {
    this.parts = [];
  }

  line(points, colour, width, dash = []) {
    const path = points.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(' ');
    const broken = dash.length ? ` stroke-dasharray="${dash.join(' ')}"` : '';
    this.parts.push(`<polyline points="${path}" fill="none" stroke="${colour}" stroke-width="${width}"${broken} stroke-linejoin="round"/>`);
  }

  box(x, y, width, height, fill) {
    this.parts.push(`<rect x="${x}" y="${y}" width="${width}" height="${height}" fill="${fill}"/>`);
  }

  text(text, x, y, colour, align = 'left', base = 'middle') {
    const anchor = { left: 'start', center: 'middle', right: 'end' }[align];
    const shift = { middle: 4, top: 10, bottom: -2 }[base];
    const safe = text.replace(/&/g, '&amp;').replace(/</g, '&lt;');
    this.parts.push(`<text x="${x.toFixed(2)}" y="${(y + shift).toFixed(2)}" fill="${colour}" text-anchor="${anchor}" font-family="system-ui, sans-serif" font-size="11">${safe}</text>`);
  }
}

export class Curves {
  constructor(canvas, seek) {
    this.canvas = canvas;
    this.series = [];
    const timeAt = event => {
      const box = canvas.getBoundingClientRect();
      const width = box.width - this.left - EDGE.right;
      const share = (event.clientX - box.left - this.left) / width;
      return this.from + Math.min(1, Math.max(0, share)) * (this.to - this.from);
    };
    const pointed = event => {
      if (!this.series.length) {
        return;
      }
      this.cursor = timeAt(event);
      if (event.buttons & 1) {
        seek(this.cursor);
      }
    };
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      pointed(event);
    });
    canvas.addEventListener('pointermove', pointed);
    canvas.addEventListener('pointerleave', () => { this.cursor = undefined; });
    this.left = 58;
  }

  // Each of the series has its `times`, `values` and `offset` to add to them, a `name`, a `unit` and a
  // `colour`; `floor` is what counts as zero among values of its unit. A run beside it is `dashed`.
  show(series) {
    this.series = series;
    this.picture = undefined;
    let [from, to, least, most, floor] = [Infinity, -Infinity, Infinity, -Infinity, 0];
    for (const one of series) {
      from = Math.min(from, one.times[0] ?? Infinity);
      to = Math.max(to, one.times[one.times.length - 1] ?? -Infinity);
      floor = Math.max(floor, one.floor || 0);
      for (const value of one.values) {
        if (Number.isFinite(value)) {
          least = Math.min(least, value + one.offset);
          most = Math.max(most, value + one.offset);
        }
      }
    }
    if (!(most >= least)) {
      [least, most] = [0, 0];
    }
    this.from = Number.isFinite(from) ? from : 0;
    this.to = Number.isFinite(to) ? to : 1;
    // a range that rounding alone fills is drawn as the constant that it is
    const size = Math.max(Math.abs(least), Math.abs(most));
    const narrowest = Math.max(floor, 2e-6 * size);
    if (most - least <= narrowest) {
      const middle = size <= floor ? 0 : (least + most) / 2;
      const half = middle === 0 ? Math.max(1, 2 * floor) : 0.5 * Math.abs(middle);
      [least, most] = [middle - half, middle + half];
    }
    const room = (most - least) * 0.06;
    this.least = least - room;
    this.most = most + room;
  }

  // Draws at the present time; colours are those of text, lines, accent and panel.
  draw(time, colours) {
    const { canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth;
    const height = canvas.clientHeight;
    if (width < 80 || height < 40 || !this.series.length) {
      return;
    }
    const key = `${width} ${height} ${ratio} ${colours.text}`;
    if (this.picture !== key) {
      this.picture = key;
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      this.still = document.createElement('canvas');
      this.still.width = canvas.width;
      this.still.height = canvas.height;
      const context = this.still.getContext('2d');
      context.scale(ratio, ratio);
      this.paint(new CanvasPen(context), width, height, colours);
    }
    const context = canvas.getContext('2d');
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(this.still, 0, 0);
    context.scale(ratio, ratio);
    const pen = new CanvasPen(context);
    const upright = (at, colour) => {
      const x = this.x(at, width);
      pen.line([[x, EDGE.top], [x, height - EDGE.bottom]], colour, 1.5);
    };
    upright(time, colours.accent);
    if (this.cursor !== undefined) {
      upright(this.cursor, colours.text);
      this.tip(context, pen, width, colours);
    }
  }

  // The values at the cursor.
  tip(context, pen, width, colours) {
    context.font = '11px system-ui, sans-serif';
    const lines = [[`${short(this.cursor)} s`, colours.text], ...this.series.slice(0, 8).map(one =>
      [`${one.name} ${short(valueAt(one, this.cursor))} ${unitOf(one.unit)}`, one.colour])];
    const wide = Math.max(...lines.map(([text]) => context.measureText(text).width)) + 12;
    const x = this.x(this.cursor, width);
    const left = x + wide + 8 > width ? x - wide - 6 : x + 6;
    pen.box(left, EDGE.top, wide, 15 * lines.length + 4, colours.panel, colours.grid);
    lines.forEach(([text, colour], i) => pen.text(text, left + 6, EDGE.top + 10 + 15 * i, colour));
  }

  x(time, width) {
    const span = this.to - this.from || 1;
    return this.left + (time - this.from) / span * (width - this.left - EDGE.right);
  }

  y(value, height) {
    const share = (value - this.least) / (this.most - this.least);
    return height - EDGE.bottom - share * (height - EDGE.top - EDGE.bottom);
  }

  paint(pen, width, height, colours) {
    const marks = ticks(this.least, this.most);
    const labels = marks.map(short);
    this.left = Math.max(30, 14 + 6.3 * Math.max(...labels.map(label => label.length)));
    marks.forEach((value, i) => {
      const y = Math.round(this.y(value, height)) + 0.5;
      pen.line([[this.left, y], [width - EDGE.right, y]], value === 0 ? colours.border : colours.grid, 1);
      pen.text(labels[i], this.left - 6, y, colours.text, 'right');
    });
    const units = [...new Set(this.series.map(one => unitOf(one.unit)))].filter(Boolean);
    pen.text(units.join(', '), this.left, 9, colours.text);
    for (const value of ticks(this.from, this.to)) {
      const x = this.x(value, width);
      const align = x > width - 34 ? 'right' : x < this.left + 12 ? 'left' : 'center';
      pen.text(`${short(value)} s`, align === 'right' ? width - 2 : x, height - EDGE.bottom + 5, colours.text, align, 'top');
    }
    for (const one of this.series) {
      this.curve(pen, width, height, one);
    }
  }

  // A curve with more points than the picture has pixels keeps the least and the greatest of each.
  curve(pen, width, height, one) {
    const { times, values, offset } = one;
    const per = Math.max(1, Math.floor(values.length / (2 * width)));
    let points = [];
    const end = () => {
      if (points.length > 1) {
        pen.line(points, one.colour, one.dashed ? 1.4 : 1.8, one.dashed ? [5, 3] : []);
      }
      points = [];
    };
    for (let i = 0; i < values.length; i += per) {
      let [low, high] = [i, i];
      for (let k = i; k < Math.min(i + per, values.length); k++) {
        low = values[k] < values[low] ? k : low;
        high = values[k] > values[high] ? k : high;
      }
      for (const k of low === high ? [low] : [Math.min(low, high), Math.max(low, high)]) {
        if (Number.isFinite(values[k])) {
          points.push([this.x(times[k], width), this.y(values[k] + offset, height)]);
        } else {
          end();
        }
      }
    }
    end();
  }

  // The diagram as an SVG file's text.
  svg(colours, width = 900, height = 360) {
    const pen = new SvgPen();
    pen.box(0, 0, width, height, colours.panel);
    this.paint(pen, width, height - 18 * this.legendRows(width), colours);
    this.legend(pen, width, height, colours);
    this.picture = undefined;
    return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}">${pen.parts.join('\n')}</svg>\n`;
  }

  // The diagram on a canvas of its own.
  png(colours, width = 900, height = 360) {
    const sheet = document.createElement('canvas');
    [sheet.width, sheet.height] = [2 * width, 2 * height];
    const context = sheet.getContext('2d');
    context.scale(2, 2);
    const pen = new CanvasPen(context);
    pen.box(0, 0, width, height, colours.panel);
    this.paint(pen, width, height - 18 * this.legendRows(width), colours);
    this.legend(pen, width, height, colours);
    this.picture = undefined;
    return sheet;
  }

  legendPlaces(width) {
    let [x, row] = [10, 0];
    return this.series.map(one => {
      const wide = 34 + 6.6 * one.name.length;
      if (x + wide > width && x > 10) {
        [x, row] = [10, row + 1];
      }
      x += wide;
      return [x - wide, row];
    });
  }

  legendRows(width) {
    return 1 + Math.max(0, ...this.legendPlaces(width).map(([, row]) => row));
  }

  legend(pen, width, height, colours) {
    const rows = this.legendRows(width);
    this.legendPlaces(width).forEach(([x, row], i) => {
      const one = this.series[i];
      const y = height - 18 * (rows - row) + 8;
      pen.line([[x, y], [x + 18, y]], one.colour, 2, one.dashed ? [5, 3] : []);
      pen.text(one.name, x + 23, y, colours.text);
    });
  }

  // The curves as CSV: the times of the first, and the values of all at these times.
  csv() {
    const quoted = name => (/[",\n]/.test(name) ? `"${name.replace(/"/g, '""')}"` : name);
    const rows = [['t', ...this.series.map(one => quoted(one.name))].join(',')];
    for (const time of this.series[0].times) {
      rows.push([time, ...this.series.map(one => valueAt(one, time))].join(','));
    }
    return `${rows.join('\n')}\n`;
  }
}

// The value of a curve at a time, straight between its rows; nothing outside them.
export function valueAt({ times, values, offset }, time) {
  let [low, high] = [0, times.length - 1];
  if (!(time >= times[low] - 1e-9 && time <= times[high] + 1e-9)) {
    return NaN;
  }
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) {
      low = middle;
    } else {
      high = middle;
    }
  }
  const step = times[high] - times[low];
  const share = step > 0 ? Math.min(1, Math.max(0, (time - times[low]) / step)) : 0;
  return values[low] + share * (values[high] - values[low]) + offset;
}
