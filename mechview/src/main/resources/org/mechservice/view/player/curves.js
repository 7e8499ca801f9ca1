// Curves over time in one canvas: axes with units, and a cursor at the present time.

const MARGIN = { left: 58, right: 12, top: 8, bottom: 22 };

// Three to seven round numbers in a range.
export function ticks(least, most) {
  const step = 10 ** Math.floor(Math.log10((most - least) / 3));
  const wide = [1, 2, 5, 10].map(k => k * step).find(s => (most - least) / s <= 6) || step;
  const found = [];
  for (let k = Math.ceil(least / wide); k * wide <= most * (1 + 1e-12) && found.length < 20; k++) {
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
  return digits.replace('-', '−');
}

export class Curves {
  constructor(canvas, seek) {
    this.canvas = canvas;
    this.series = [];
    const pointed = event => {
      if (event.buttons & 1) {
        const box = canvas.getBoundingClientRect();
        const width = box.width - MARGIN.left - MARGIN.right;
        const share = (event.clientX - box.left - MARGIN.left) / width;
        seek(this.from + Math.min(1, Math.max(0, share)) * (this.to - this.from));
      }
    };
    canvas.addEventListener('pointerdown', event => {
      canvas.setPointerCapture(event.pointerId);
      pointed(event);
    });
    canvas.addEventListener('pointermove', pointed);
  }

  // Each of the series has `values`, and `offset` to add to them.
  show(times, series) {
    this.times = times;
    this.series = series;
    this.from = times[0];
    this.to = times[times.length - 1];
    let least = Infinity;
    let most = -Infinity;
    for (const one of series) {
      for (const value of one.values) {
        if (Number.isFinite(value)) {
          least = Math.min(least, value + one.offset);
          most = Math.max(most, value + one.offset);
        }
      }
    }
    if (!(most >= least)) {
      [least, most] = [0, 1];
    }
    const room = Math.max((most - least) * 0.06, Math.abs(most) * 1e-6, 1e-12);
    this.least = least - room;
    this.most = most + room;
    this.picture = undefined;
  }

  draw(time, colours) {
    const canvas = this.canvas;
    const ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth;
    const height = canvas.clientHeight;
    if (width < 80 || height < 40 || !this.times) {
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
      const pen = this.still.getContext('2d');
      pen.scale(ratio, ratio);
      this.axes(pen, width, height, colours);
      this.series.forEach(one => this.curve(pen, width, height, one));
    }
    const pen = canvas.getContext('2d');
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(this.still, 0, 0);
    pen.scale(ratio, ratio);
    const x = this.x(time, width);
    pen.strokeStyle = colours.accent;
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(x, MARGIN.top);
    pen.lineTo(x, height - MARGIN.bottom);
    pen.stroke();
  }

  x(time, width) {
    const span = this.to - this.from || 1;
    return MARGIN.left + (time - this.from) / span * (width - MARGIN.left - MARGIN.right);
  }

  y(value, height) {
    const share = (value - this.least) / (this.most - this.least);
    return height - MARGIN.bottom - share * (height - MARGIN.top - MARGIN.bottom);
  }

  axes(pen, width, height, colours) {
    pen.font = '11px system-ui, sans-serif';
    pen.fillStyle = colours.text;
    pen.strokeStyle = colours.grid;
    pen.lineWidth = 1;
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    for (const value of ticks(this.least, this.most)) {
      const y = Math.round(this.y(value, height)) + 0.5;
      pen.beginPath();
      pen.moveTo(MARGIN.left, y);
      pen.lineTo(width - MARGIN.right, y);
      pen.stroke();
      pen.fillText(short(value), MARGIN.left - 6, y);
    }
    pen.textBaseline = 'top';
    for (const value of ticks(this.from, this.to)) {
      const x = Math.round(this.x(value, width)) + 0.5;
      pen.textAlign = x > width - 30 ? 'right' : 'center';
      pen.fillText(`${short(value)} s`, Math.min(x, width - 2), height - MARGIN.bottom + 5);
    }
  }

  curve(pen, width, height, one) {
    pen.strokeStyle = one.colour;
    pen.lineWidth = 1.6;
    pen.lineJoin = 'round';
    pen.beginPath();
    let drawing = false;
    for (let i = 0; i < one.values.length; i++) {
      const value = one.values[i] + one.offset;
      if (Number.isFinite(value)) {
        const x = this.x(this.times[i], width);
        const y = this.y(value, height);
        if (drawing) {
          pen.lineTo(x, y);
        } else {
          pen.moveTo(x, y);
        }
      }
      drawing = Number.isFinite(value);
    }
    pen.stroke();
  }
}
