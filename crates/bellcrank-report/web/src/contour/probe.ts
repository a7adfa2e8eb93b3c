// What lies under the pointer: nodes as seen, and the triangle before all others.

import type { V2 } from "../scene/camera";
import { type Field, NO_VALUE, type Part, type Shape } from "./data";

/** A place on the surface: a triangle and shares of its corners. */
export interface Hit {
  triangle: number;
  shares: [number, number, number];
  depth: number;
}

/** Nodes on the canvas: x and y in px, depth growing away from the reader. */
export class Seen {
  readonly spots: Float32Array;

  /** `matrix`: from the part to the clip space, column by column. */
  constructor(
    private readonly part: Part,
    shape: Shape | null,
    factor: number,
    matrix: number[],
    size: V2,
  ) {
    const { places } = part;
    const moves = shape?.displacement ?? places;
    const by = shape ? factor : 0;
    const [m, spots] = [matrix, new Float32Array(places.length)];
    const [wide, tall] = [size[0] / 2, size[1] / 2];
    // Written out: a hundred thousand nodes while the pointer waits.
    for (let k = 0; k < places.length; k += 3) {
      const x = places[k] + by * moves[k];
      const y = places[k + 1] + by * moves[k + 1];
      const z = places[k + 2] + by * moves[k + 2];
      const w = 1 / (m[3] * x + m[7] * y + m[11] * z + m[15]);
      spots[k] = wide * (1 + w * (m[0] * x + m[4] * y + m[8] * z + m[12]));
      spots[k + 1] = tall * (1 - w * (m[1] * x + m[5] * y + m[9] * z + m[13]));
      spots[k + 2] = w * (m[2] * x + m[6] * y + m[10] * z + m[14]);
    }
    this.spots = spots;
  }

  node(node: number): [number, number, number] {
    return [this.spots[3 * node], this.spots[3 * node + 1], this.spots[3 * node + 2]];
  }

  /** Where a hit is seen. */
  place(hit: Hit): [number, number, number] {
    const corners = [0, 1, 2].map((k) => this.node(this.part.triangles[3 * hit.triangle + k]));
    return [0, 1, 2].map((axis) => corners.reduce((sum, corner, k) => sum + hit.shares[k] * corner[axis], 0)) as [number, number, number];
  }

  /** What is seen at `at`. */
  hit([x, y]: V2): Hit | null {
    const { triangles } = this.part;
    const s = this.spots;
    let best: Hit | null = null;
    for (let k = 0; k < triangles.length; k += 3) {
      const a = 3 * triangles[k];
      const b = 3 * triangles[k + 1];
      const c = 3 * triangles[k + 2];
      const ax = s[a];
      const bx = s[b];
      const cx = s[c];
      if ((ax < x && bx < x && cx < x) || (ax > x && bx > x && cx > x)) continue;
      const ay = s[a + 1];
      const by = s[b + 1];
      const cy = s[c + 1];
      if ((ay < y && by < y && cy < y) || (ay > y && by > y && cy > y)) continue;
      const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
      const v = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
      const w = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
      if (!(v >= 0 && w >= 0 && v + w <= 1)) continue;
      const depth = (1 - v - w) * s[a + 2] + v * s[b + 2] + w * s[c + 2];
      if (!best || depth < best.depth) best = { triangle: k / 3, shares: [1 - v - w, v, w], depth };
    }
    return best;
  }
}

export function projected(m: number[], [x, y, z]: number[], size: V2): [number, number, number] {
  const w = m[3] * x + m[7] * y + m[11] * z + m[15];
  const px = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w;
  const py = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
  return [((px + 1) / 2) * size[0], ((1 - py) / 2) * size[1], (m[2] * x + m[6] * y + m[10] * z + m[14]) / w];
}

/** A hit at a node. */
export function atNode(part: Part, node: number): Hit | null {
  const corner = part.triangles.indexOf(node);
  if (corner < 0) return null;
  const shares: Hit["shares"] = [0, 0, 0];
  shares[corner % 3] = 1;
  return { triangle: Math.floor(corner / 3), shares, depth: 0 };
}

/** The node whose share is the largest. */
export function nodeOf(part: Part, hit: Hit): number {
  return part.triangles[3 * hit.triangle + hit.shares.indexOf(Math.max(...hit.shares))];
}

/** The value at a hit, display units; nothing where a corner has none. */
export function valueAt(part: Part, field: Field, hit: Hit): number | null {
  const values = [0, 1, 2].map((k) => field.values[part.triangles[3 * hit.triangle + k]]);
  if (values.some((value) => value <= NO_VALUE)) return null;
  return values.reduce((sum, value, k) => sum + hit.shares[k] * value, 0);
}

/** Where a hit lies in the undeformed part, m. */
export function placeOf(part: Part, hit: Hit): number[] {
  const of = (axis: number) => (sum: number, share: number, k: number) => sum + share * part.places[3 * part.triangles[3 * hit.triangle + k] + axis];
  return [0, 1, 2].map((axis) => hit.shares.reduce(of(axis), 0));
}
