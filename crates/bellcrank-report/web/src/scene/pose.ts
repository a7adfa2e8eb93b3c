// Where bodies are in a frame, or between two.

import type { Drawing, Motion, V3 } from "../data";

export type Quaternion = [number, number, number, number];

/** Place of a body's origin, and its turn as unit quaternion w, x, y, z. */
export interface Pose {
  position: V3;
  turn: Quaternion;
}

/** Body poses at `at`, counted in frames; between two frames, bodies move straight and turn evenly. */
export class Frame {
  /** The frame nearest to it. */
  readonly index: number;
  private readonly low: number;
  private readonly share: number;
  private readonly poses: Pose[] = [];

  constructor(
    private readonly motion: Motion,
    private readonly planar: boolean,
    at: number,
  ) {
    const last = motion.rows.length - 1;
    const inside = Math.max(0, Math.min(last, at));
    this.index = Math.round(inside);
    this.low = Math.min(Math.floor(inside), Math.max(0, last - 1));
    this.share = last > 0 ? inside - this.low : 0;
  }

  /** A place on a body (body axes, m) in the world. */
  place(body: number, p: V3): V3 {
    const { position, turn } = this.pose(body);
    const d = turned(turn, p);
    return [position[0] + d[0], position[1] + d[1], position[2] + d[2]];
  }

  /** A direction on a body in world axes. */
  turn(body: number, v: V3): V3 {
    return turned(this.pose(body).turn, v);
  }

  pose(body: number): Pose {
    return (this.poses[body] ??= this.between(body));
  }

  /** World components (N) of an applied force. */
  force(arrow: number): V3 {
    const component = (k: number) => {
      const of = (frame: number) => this.motion.arrows[(frame * this.motion.arrowCount + arrow) * 3 + k];
      return this.share === 0 ? of(this.low) : mixed(of(this.low), of(this.low + 1), this.share);
    };
    return [component(0), component(1), component(2)];
  }

  private between(body: number): Pose {
    const from = this.stored(this.low, body);
    if (this.share === 0) return from;
    const to = this.stored(this.low + 1, body);
    const position = from.position.map((x, k) => mixed(x, to.position[k], this.share)) as V3;
    return { position, turn: slerp(from.turn, to.turn, this.share) };
  }

  private stored(frame: number, body: number): Pose {
    const { poses, bodies } = this.motion;
    const at = (frame * bodies + Math.min(body, bodies - 1)) * (this.planar ? 3 : 7);
    if (this.planar) {
      const half = poses[at + 2] / 2;
      return { position: [poses[at], poses[at + 1], 0], turn: [Math.cos(half), 0, 0, Math.sin(half)] };
    }
    return {
      position: [poses[at], poses[at + 1], poses[at + 2]],
      turn: [poses[at + 3], poses[at + 4], poses[at + 5], poses[at + 6]],
    };
  }
}

function mixed(a: number, b: number, share: number): number {
  return a + (b - a) * share;
}

/** `v` turned by a unit quaternion. */
function turned([w, x, y, z]: Quaternion, v: V3): V3 {
  const t: V3 = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
  return [
    v[0] + w * t[0] + y * t[2] - z * t[1],
    v[1] + w * t[1] + z * t[0] - x * t[2],
    v[2] + w * t[2] + x * t[1] - y * t[0],
  ];
}

/** The shorter way from one turn to another, at even speed. */
function slerp(a: Quaternion, b: Quaternion, share: number): Quaternion {
  const product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const angle = Math.acos(Math.min(1, Math.abs(product)));
  const side = product < 0 ? -1 : 1;
  const sine = Math.sin(angle);
  // Turns this close lie on a straight line to single precision.
  const [left, right] =
    sine < 1e-4 ? [1 - share, share] : [Math.sin((1 - share) * angle) / sine, Math.sin(share * angle) / sine];
  return a.map((x, k) => left * x + side * right * b[k]) as Quaternion;
}

export function frameCount(motion: Motion): number {
  return motion.rows.length;
}

/** Where `row` lies among the frames; rows rise. */
export function frameAt(motion: Motion, row: number): number {
  return placeIn(motion.rows, row);
}

/** Where `value` lies among rising numbers: their index, with a fraction between two. */
export function placeIn(rising: ArrayLike<number>, value: number): number {
  let [low, high] = [0, rising.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (rising[middle] <= value) low = middle;
    else high = middle;
  }
  const width = rising[high] - rising[low];
  return width > 0 ? low + Math.max(0, Math.min(1, (value - rising[low]) / width)) : low;
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
