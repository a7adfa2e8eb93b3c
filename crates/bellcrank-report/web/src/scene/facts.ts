// What flat and solid drawings need to know of a whole motion.

import { type Drawing, type Motion, signal, type Study, type V3 } from "../data";
import { type Frame, someFrames } from "./pose";

/** A point that moves, with its path. */
export interface Trail {
  name: string;
  path: V3[];
  length: number;
}

export class Facts {
  readonly trails: Trail[];
  readonly appliedPeak: number;
  readonly reactionPeak: number;

  constructor(
    readonly drawing: Drawing,
    readonly motion: Motion,
    private readonly study: Study,
  ) {
    const frames = someFrames(motion, drawing.planar, 80);
    this.trails = trails(drawing, motion);
    this.appliedPeak = peak(frames.flatMap((frame) => drawing.arrows.map((_, index) => frame.force(index))));
    this.reactionPeak = peak(frames.flatMap((frame) => drawing.joints.map((j) => this.reaction(j.name, frame))));
  }

  /** What the first body puts on the second, world axes; zero where the study has no such signal. */
  reaction(joint: string, frame: Frame): V3 {
    const row = this.motion.rows[frame.index];
    const component = (k: string) => signal(this.study, `joint.${joint}.reaction.${k}`)?.values[row] ?? 0;
    return ["fx", "fy", "fz"].map((k) => component(k) || 0) as V3;
  }

  /** The path of the load where there is one, else the longest. */
  usualTrail(): string {
    const loaded = this.loadedPoints();
    const chosen = this.trails.filter(({ name }) => loaded.includes(name));
    const candidates = chosen.length > 0 ? chosen : this.trails;
    return candidates.reduce((best, trail) => (trail.length > best.length ? trail : best), { name: "", length: 0 }).name;
  }

  /** Trails that are to be drawn. */
  chosen(choice: string): Trail[] {
    return this.trails.filter(({ name }) => choice === "*" || choice === name);
  }

  /** Points at which a force acts. */
  private loadedPoints(): string[] {
    return this.drawing.arrows.flatMap(({ body, at }) => {
      const owner = this.drawing.bodies[body];
      const here = owner?.points.find(([, p]) => Math.hypot(p[0] - at[0], p[1] - at[1], p[2] - at[2]) < 1e-9);
      return here ? [`${owner.name}.${here[0]}`] : [];
    });
  }
}

function trails(drawing: Drawing, motion: Motion): Trail[] {
  const frames = someFrames(motion, drawing.planar, 400);
  const all = drawing.bodies.flatMap((body, index) =>
    body.points.map(([name, at]) => {
      const path = frames.map((frame) => frame.place(index, at));
      return { name: `${body.name}.${name}`, path, length: pathLength(path) };
    }),
  );
  const longest = Math.max(0, ...all.map((trail) => trail.length));
  return all.filter((trail) => trail.length > 1e-6 * longest && trail.length > 1e-12);
}

function pathLength(path: V3[]): number {
  let length = 0;
  for (let i = 1; i < path.length; i++) {
    length += Math.hypot(path[i][0] - path[i - 1][0], path[i][1] - path[i - 1][1], path[i][2] - path[i - 1][2]);
  }
  return length;
}

function peak(forces: V3[]): number {
  return forces.reduce((most, f) => Math.max(most, Math.hypot(...f)), 0);
}
