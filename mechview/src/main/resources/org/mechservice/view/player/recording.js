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
    // what a result does not place stays where it is at the start
    this.still = [data.root, ...data.bodies.map(body => body.start)].map(pose =>
      ({ p: pose.slice(0, 3), q: pose.slice(3) }));
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
    const first = column * this.count;
    const value = this.numbers[first + frame.at];
    return value + frame.share * (this.numbers[first + frame.next] - value);
  }

  vector(column, frame) {
    return [this.value(column, frame), this.value(column + 1, frame), this.value(column + 2, frame)];
  }

  turn(column, at) {
    const { numbers, count } = this;
    const first = column * count + at;
    return [numbers[first], numbers[first + count], numbers[first + 2 * count], numbers[first + 3 * count]];
  }

  pose(body, frame) {
    const first = body < 0 ? -1 : this.data.bodies[body].pose;
    if (first < 0) {
      return this.still[body + 1];
    }
    return {
      p: this.vector(first, frame),
      q: between(this.turn(first + 3, frame.at), this.turn(first + 3, frame.next), frame.share),
    };
  }

  // The poses at a frame, each formed once.
  poses(frame) {
    const known = [];
    return body => (known[body + 1] ||= this.pose(body, frame));
  }
}

// Where a point of a body, given as [body, x, y, z], is.
export function placed(poses, anchor) {
  const pose = poses(anchor[0]);
  return add(pose.p, turned(pose.q, anchor.slice(1)));
}
