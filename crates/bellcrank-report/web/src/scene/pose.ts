// Where bodies are in a frame.

import type { Drawing, Motion, V3 } from "../data";

/** Body poses of one frame; places are looked up, not stored. */
export class Frame {
  constructor(
    private readonly motion: Motion,
    private readonly planar: boolean,
    readonly index: number,
  ) {}

  /** A place on a body (body axes, m) in the world. */
  place(body: number, p: V3): V3 {
    const d = this.turn(body, p);
    const at = this.offset(body);
    const [x, y, z] = [this.motion.poses[at], this.motion.poses[at + 1], this.motion.poses[at + 2]];
    return [x + d[0], y + d[1], (this.planar ? 0 : z) + d[2]];
  }

  /** A direction on a body in world axes. */
  turn(body: number, v: V3): V3 {
    const poses = this.motion.poses;
    const at = this.offset(body);
    if (this.planar) {
      const [c, s] = [Math.cos(poses[at + 2]), Math.sin(poses[at + 2])];
      return [c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]];
    }
    const [w, x, y, z] = poses.subarray(at + 3, at + 7);
    const t: V3 = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
    return [
      v[0] + w * t[0] + y * t[2] - z * t[1],
      v[1] + w * t[1] + z * t[0] - x * t[2],
      v[2] + w * t[2] + x * t[1] - y * t[0],
    ];
  }

  /** World components (N) of an applied force. */
  force(arrow: number): V3 {
    const at = (this.index * this.motion.arrowCount + arrow) * 3;
    return [this.motion.arrows[at], this.motion.arrows[at + 1], this.motion.arrows[at + 2]];
  }

  private offset(body: number): number {
    const count = this.motion.bodies;
    return (this.index * count + Math.min(body, count - 1)) * (this.planar ? 3 : 7);
  }
}

export function frameCount(motion: Motion): number {
  return motion.rows.length;
}

/** The frame whose row is nearest to `row`; rows rise. */
export function frameAt(motion: Motion, row: number): number {
  const rows = motion.rows;
  let [low, high] = [0, rows.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (rows[middle] < row) low = middle + 1;
    else high = middle;
  }
  const before = low > 0 && row - rows[low - 1] < rows[low] - row;
  return before ? low - 1 : low;
}

/** A spread of at most `most` frames: enough to know how far things move. */
export function someFrames(motion: Motion, planar: boolean, most: number): Frame[] {
  const count = frameCount(motion);
  const step = Math.max(1, Math.ceil(count / most));
  const frames: Frame[] = [];
  for (let index = 0; index < count; index += step) frames.push(new Frame(motion, planar, index));
  return frames;
}

/** Every place that is drawn: points, joints and arrow feet. */
export function places(drawing: Drawing): [number, V3][] {
  const found: [number, V3][] = [];
  drawing.bodies.forEach((body, index) => body.points.forEach(([, at]) => found.push([index, at])));
  drawing.joints.forEach((joint) => found.push(joint.first, joint.second));
  drawing.arrows.forEach((arrow) => found.push([arrow.body, arrow.at]));
  return found;
}
