// Displacement and stress of a flexible body between two frames: sums over its coordinates.

import type { Quaternion } from "../scene/pose";
import type { FlexibleBody } from "./data";

/** Present displacement and stress of every node, written anew for each picture. */
export class Sums {
  /** x, y, z node by node, m. */
  readonly move: Float32Array;
  /** Von Mises stress by node, Pa. */
  readonly stress: Float32Array;
  private readonly components: Float32Array;

  constructor(private readonly body: FlexibleBody) {
    const nodes = body.places.length / 3;
    this.move = new Float32Array(3 * nodes);
    this.stress = new Float32Array(nodes);
    this.components = new Float32Array(6 * nodes);
  }

  /** `at` counts frames; between two, coordinates change evenly. */
  moveTo(at: number): void {
    this.move.fill(0);
    for (const { move, coordinate } of this.body.columns) if (move) add(this.move, move, between(coordinate, at));
  }

  stressAt(at: number): void {
    this.components.fill(0);
    for (const { stress, coordinate } of this.body.columns) if (stress) add(this.components, stress, between(coordinate, at));
    vonMises(this.components, this.stress);
  }

  /** Place and turn of the floating frame. */
  pose(at: number): { position: number[]; turn: Quaternion } {
    const all = this.body.poses.map((list) => between(list, at));
    const low = this.body.poses.slice(3).map((list) => list[Math.floor(at)]);
    const high = this.body.poses.slice(3).map((list) => list[Math.min(list.length - 1, Math.floor(at) + 1)]);
    // A turn and its opposite are the same.
    const apart = low.reduce((sum, q, k) => sum + q * high[k], 0) < 0;
    const turn = apart ? low : all.slice(3);
    const size = Math.hypot(...turn) || 1;
    return { position: all.slice(0, 3), turn: turn.map((q) => q / size) as Quaternion };
  }
}

/** A number between two frames. */
export function between(list: ArrayLike<number>, at: number): number {
  const low = Math.max(0, Math.min(list.length - 1, Math.floor(at)));
  const share = at - low;
  return share > 0 && low + 1 < list.length ? list[low] + share * (list[low + 1] - list[low]) : list[low];
}

function add(sum: Float32Array, column: Float32Array, by: number): void {
  if (by === 0) return;
  for (let k = 0; k < sum.length; k++) sum[k] += by * column[k];
}

function vonMises(components: Float32Array, stress: Float32Array): void {
  const n = stress.length;
  for (let k = 0; k < n; k++) {
    const xx = components[k];
    const yy = components[n + k];
    const zz = components[2 * n + k];
    const xy = components[3 * n + k];
    const yz = components[4 * n + k];
    const zx = components[5 * n + k];
    const normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2;
    stress[k] = Math.sqrt(0.5 * normal + 3 * (xy * xy + yz * yz + zx * zx));
  }
}
