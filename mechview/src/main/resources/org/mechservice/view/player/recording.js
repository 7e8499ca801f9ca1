import { add, between, turned } from './space.js';

export function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) {
    bytes[i] = text.charCodeAt(i);
  }
  return bytes.buffer;
}

// The motion: columns of numbers over the times of the frames, and poses between them.
export class Motion {
  constructor(data) {
    this.data = data;
    this.count = data.frames;
    this.numbers = data.numbers || new Float32Array(bytesOf(data.values));
    this.times = this.column(0);
    this.start = this.times[0];
    this.end = this.times[this.count - 1];
    this.root = { p: data.root.slice(0, 3), q: data.root.slice(3) };
  }

  column(index) {
    return this.numbers.subarray(index * this.count, (index + 1) * this.count);
  }

  // The frame before a time, and how far it is to the next one, 0 to 1.
  frame(time) {
    let low = 0;
    let high = this.count - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= time) {
        low = middle;
      } else {
        high = middle;
      }
    }
    const step = this.times[high] - this.times[low];
    const share = step > 0 ? (time - this.times[low]) / step : 0;
    return { at: low, next: high, share: Math.min(1, Math.max(0, share)) };
  }

  value(column, frame) {
    const values = this.column(column);
    return values[frame.at] + frame.share * (values[frame.next] - values[frame.at]);
  }

  vector(column, frame) {
    return [0, 1, 2].map(i => this.value(column + i, frame));
  }

  pose(body, frame) {
    if (body < 0) {
      return this.root;
    }
    const first = this.data.bodies[body].pose;
    const turn = at => [3, 4, 5, 6].map(i => this.column(first + i)[at]);
    return {
      p: this.vector(first, frame),
      q: between(turn(frame.at), turn(frame.next), frame.share),
    };
  }
}

// Where a point of a body, given as [body, x, y, z], is.
export function placed(poses, anchor) {
  const pose = poses(anchor[0]);
  return add(pose.p, turned(pose.q, anchor.slice(1)));
}
