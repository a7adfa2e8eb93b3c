// Lists of numbers as the Rust side packs them (src/html/data/integers.rs).

import type { V3 } from "./data";

/** Lists of differences, byte by byte from low to high, read one after the other. */
export class Integers {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  next(count: number, width: number): Uint32Array {
    const { bytes, at } = this;
    const numbers = new Uint32Array(count);
    const mask = width === 4 ? -1 : (1 << (8 * width)) - 1;
    let before = 0;
    for (let k = 0; k < count; k++) {
      let step = 0;
      for (let plane = 0; plane < width; plane++) step |= bytes[at + plane * count + k] << (8 * plane);
      before = (before + ((step >>> 1) ^ -(step & 1))) & mask;
      numbers[k] = before;
    }
    this.at += count * width;
    return numbers;
  }

  /** Signed steps of that size; the middle of what the bytes hold is zero. */
  signed(count: number, width: number, size: number): Float32Array {
    const zero = 2 ** (8 * width - 1);
    return Float32Array.from(this.next(count, width), (step) => (step - zero) * size);
  }

  /** Numbers that were left as they are. */
  floats(count: number): Float32Array {
    return new Float32Array(this.next(count, 4).buffer);
  }

  /** Places in the box from `low` to `high`, x, y, z node by node. */
  places(nodes: number, low: V3, high: V3): Float32Array {
    return threefold(nodes, (k) => {
      const per = (high[k] - low[k]) / 1_048_575;
      return Float32Array.from(this.next(nodes, 3), (step) => low[k] + step * per);
    });
  }
}

/** Three lists, one after the other, as x, y, z of each node. */
export function threefold(nodes: number, list: (axis: number) => Float32Array): Float32Array {
  const all = new Float32Array(3 * nodes);
  for (let axis = 0; axis < 3; axis++) {
    let at = axis;
    for (const x of list(axis)) {
      all[at] = x;
      at += 3;
    }
  }
  return all;
}
