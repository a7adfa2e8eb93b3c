// The whole drawing of one frame.

import type { Drawing, Motion, V3 } from "../data";
import type { Shown, Spot, View } from "../view";
import { Camera, type V2 } from "./camera";
import type { Facts } from "./facts";
import { drawLegend } from "./legend";
import { hull } from "./hull";
import { AXES, bodyColour, FORCE, INK, Pen, REACTION } from "./pen";
import { Frame, places, someFrames } from "./pose";
import { type Drawn, drawJoint, drawSupport, type Travel } from "./symbols";

export class Scene implements View {
  readonly kind = "flat";
  readonly camera: Camera;
  private readonly drawing: Drawing;
  private readonly motion: Motion;
  private readonly reach: V3[];
  private readonly travels: Travel[];
  private size: V2 = [1, 1];

  constructor(private readonly facts: Facts) {
    const { drawing, motion } = facts;
    [this.drawing, this.motion] = [drawing, motion];
    this.camera = new Camera(drawing.planar, drawing.axes);
    const frames = someFrames(motion, drawing.planar, 80);
    const all = places(drawing);
    this.reach = frames.flatMap((frame) => all.map(([body, at]) => frame.place(body, at)));
    this.travels = drawing.joints.map((joint) => travel(frames, joint.first, joint.second));
  }

  drag(dx: number, dy: number, move: boolean): void {
    this.camera.drag(dx, dy, move);
  }

  zoomBy(factor: number, at: V2): void {
    this.camera.zoomBy(factor, at);
  }

  reset(): void {
    this.camera.reset();
    this.fit(this.size);
  }

  fit(size: V2): void {
    this.size = size;
    // Arrows of forces stand out of what the bodies reach.
    const margin = this.drawing.arrows.length > 0 ? 84 : 56;
    if (this.reach.length > 0) this.camera.fit(this.reach, size, Math.min(margin, size[0] * 0.1));
  }

  /** Draws a frame and gives the places that have a name. */
  draw(context: CanvasRenderingContext2D, at: number, shown: Shown): Spot[] {
    const frame = new Frame(this.motion, this.drawing.planar, at);
    const to: Drawn = { pen: new Pen(context), camera: this.camera, frame };
    this.drawTrails(to, shown.trail);
    this.drawing.joints.forEach((joint) => drawSupport(to, joint));
    this.drawBodies(to, shown);
    this.inDepthOrder(to).forEach((k) => drawJoint(to, this.drawing.joints[k], this.travels[k]));
    if (shown.reactions) this.drawReactions(to);
    if (shown.applied) this.drawApplied(to);
    if (shown.frames) this.drawFrames(to);
    drawLegend(to.pen, this.camera, this.size);
    const spots = this.spots(to);
    if (shown.names) spots.forEach((spot) => to.pen.text(spot.title, [spot.at[0] + 9, spot.at[1] - 8], INK, 12));
    return spots;
  }

  private inDepthOrder({ camera, frame }: Drawn): number[] {
    const depth = this.drawing.joints.map((joint) => camera.depth(frame.place(...joint.second)));
    return [...depth.keys()].sort((a, b) => depth[a] - depth[b]);
  }

  private drawTrails({ pen, camera }: Drawn, choice: string): void {
    for (const trail of this.facts.chosen(choice)) {
      pen.line(trail.path.map((p) => camera.project(p)), 1.3, "#7a8794", [5, 3]);
    }
  }

  private drawBodies(to: Drawn, shown: Shown): void {
    const { camera, frame } = to;
    const bodies = this.drawing.bodies.map((body, index) => ({
      index,
      body,
      seen: body.points.map(([, at]) => frame.place(index, at)),
    }));
    const depth = (seen: V3[]) => seen.reduce((sum, p) => sum + camera.depth(p), 0) / Math.max(1, seen.length);
    bodies.sort((a, b) => (camera.planar ? a.index - b.index : depth(a.seen) - depth(b.seen)));
    for (const { index, body, seen } of bodies) {
      const points = seen.map((p) => camera.project(p));
      const closed = body.lines.length >= 3 && points.length >= 3;
      const colour = bodyColour(index);
      if (closed) to.pen.polygon(hull(points), `${colour}26`, colour, 0);
      for (const [a, b] of body.lines) if (points[a] && points[b]) to.pen.bar(points[a], points[b], index === 0 ? 1.6 : 3.4, colour);
      if (body.center && shown.centers) centerMark(to.pen, camera.project(frame.place(index, body.center)));
    }
  }

  private drawFrames({ pen, camera, frame }: Drawn): void {
    this.drawing.bodies.forEach((_, body) => {
      const at = camera.project(frame.place(body, [0, 0, 0]));
      for (const [axis, colour] of AXES) {
        const [dx, dy] = camera.direction(frame.turn(body, axis));
        pen.arrow(at, [at[0] + 26 * dx, at[1] + 26 * dy], colour);
      }
    });
  }

  private drawApplied({ pen, camera, frame }: Drawn): void {
    this.drawing.arrows.forEach((arrow, index) => {
      const tip = camera.project(frame.place(arrow.body, arrow.at));
      const [dx, dy] = this.arrowLength(camera.direction(frame.force(index)), this.facts.appliedPeak);
      // A load is drawn pushing: its tip is where it acts.
      pen.arrow([tip[0] - dx, tip[1] - dy], tip, FORCE);
      pen.text(arrow.name, [tip[0] - dx + 6, tip[1] - dy + 4], FORCE);
    });
  }

  private drawReactions({ pen, camera, frame }: Drawn): void {
    for (const joint of this.drawing.joints) {
      const foot = camera.project(frame.place(...joint.second));
      const [dx, dy] = this.arrowLength(camera.direction(this.facts.reaction(joint.name, frame)), this.facts.reactionPeak);
      pen.arrow(foot, [foot[0] + dx, foot[1] + dy], REACTION);
    }
  }

  private arrowLength([x, y]: V2, peak: number): V2 {
    const scale = peak > 0 ? 80 / peak : 0;
    return [x * scale, y * scale];
  }

  private spots({ camera, frame }: Drawn): Spot[] {
    const joints = this.drawing.joints
      .filter((joint) => joint.kind !== "coupler")
      .map((joint) => ({ at: camera.project(this.middle(frame, joint)), title: joint.name, joint: joint.name }));
    // In space, names of all points would hide the drawing.
    if (!camera.planar) return joints;
    const points = this.drawing.bodies.flatMap((body, index) =>
      body.points.map(([name, at]) => ({
        at: camera.project(frame.place(index, at)),
        title: `${body.name}.${name}`,
        joint: null,
      })),
    );
    const free = points.filter((p) => !joints.some((j) => Math.hypot(j.at[0] - p.at[0], j.at[1] - p.at[1]) < 6));
    return [...joints, ...free];
  }

  /** A long slider is named at its middle, so that its pins keep their names. */
  private middle(frame: Frame, joint: Drawing["joints"][number]): V3 {
    const [a, b] = [frame.place(...joint.first), frame.place(...joint.second)];
    return joint.kind === "prismatic" ? [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2] : b;
  }
}

/** The usual sign of a centre of mass. */
function centerMark(pen: Pen, [x, y]: V2): void {
  pen.circle([x, y], 4.5, "#fff", INK, 1);
  const c = pen.c;
  c.fillStyle = INK;
  for (const from of [0, Math.PI]) {
    c.beginPath();
    c.moveTo(x, y);
    c.arc(x, y, 4.5, from, from + Math.PI / 2);
    c.fill();
  }
}

function travel(frames: Frame[], first: [number, V3], second: [number, V3]): Travel {
  const lengths = frames.map((frame) => {
    const [a, b] = [frame.place(...first), frame.place(...second)];
    return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  });
  return { near: Math.min(...lengths), far: Math.max(...lengths) };
}
