// The solid drawing of a motion.

import { Box3, Group, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshLambertMaterial, MeshStandardMaterial, Scene, Vector3 } from "three";
import { BAR, Cover, drawBar, drawLabels } from "../contour/overlay";
import type { Solid, V3 } from "../data";
import type { FlexibleChoice } from "../flexible/controls";
import type { Flexible } from "../flexible/data";
import type { Eye, V2 } from "../scene/camera";
import type { Facts } from "../scene/facts";
import { drawLegend } from "../scene/legend";
import { FORCE, INK, Pen, REACTION } from "../scene/pen";
import { Frame, places, someFrames } from "../scene/pose";
import type { Shown, Side, Spot, View } from "../view";
import { FlexibleLayer } from "./flexible";
import { Arrow, axesMark, centerMark, Stretched, trailMark } from "./marks";
import { Orbit } from "./orbit";
import { bodyGeometry, edgeGeometries } from "./parts";
import { floor, light, sharedStudio } from "./studio";

/** Machines of more parts than this are drawn with fewer corners. */
const FINE_PARTS = 1500;

export class SolidView implements View, Eye {
  readonly kind = "solid";
  readonly planar = false;
  private readonly scene = new Scene();
  /** World axes of the model inside those of the scene, where y is up. */
  private readonly world = new Group();
  private readonly turned = new Matrix4();
  private readonly bodies: Group[];
  private readonly orbit: Orbit;
  private readonly radius: number;
  private readonly applied: Arrow[];
  private readonly reactions: Arrow[];
  private readonly centers: Mesh[] = [];
  private readonly axes: Mesh[] = [];
  private readonly stretched: [number, Stretched][] = [];
  private readonly trails = new Map<string, Mesh | null>();
  private size: V2 = [1, 1];

  private readonly layer: FlexibleLayer | null;
  private readonly cover = new Cover();
  /** Which of the places around it each label of a hot spot took. */
  private taken: number[] = [];

  constructor(
    private readonly facts: Facts,
    flexible: Flexible | null,
  ) {
    const { drawing } = facts;
    this.layer = flexible && new FlexibleLayer(flexible);
    const [right, up, front] = drawing.axes;
    this.turned.set(...right, 0, ...up, 0, ...front, 0, 0, 0, 0, 1);
    const reach = this.reach();
    const middle = middleOf(reach);
    this.turned.premultiply(new Matrix4().makeTranslation(-middle.x, -middle.y, -middle.z));
    reach.forEach((p) => p.sub(middle));
    this.radius = reach.reduce((most, p) => Math.max(most, p.length()), 1e-9);
    this.world.matrixAutoUpdate = false;
    this.world.matrix.copy(this.turned);
    this.bodies = drawing.bodies.map((_, index) => this.body(index));
    this.applied = drawing.arrows.map(() => new Arrow(FORCE, 0.0075 * this.radius));
    this.reactions = drawing.joints.map(() => new Arrow(REACTION, 0.006 * this.radius));
    this.world.add(...this.bodies, ...this.applied, ...this.reactions);
    if (this.layer) this.world.add(this.layer.group);
    this.addDistances();
    light(this.scene, sharedStudio(), this.radius);
    const low = reach.reduce((least, p) => Math.min(least, p.y), this.lowestOfGround());
    this.scene.add(this.world, floor(low - 0.003 * this.radius, this.radius, sharedStudio()));
    this.orbit = new Orbit([...reach, ...this.feet()], this.radius);
    if (drawing.planar) this.orbit.drag(40, -20, false);
  }

  get flexible(): FlexibleChoice | undefined {
    return this.layer?.choice;
  }

  /** The canvas without the colour bar, px; its room stays where there is none at the moment, so that the view does. */
  private get room(): V2 {
    return [Math.max(1, this.size[0] - (this.layer ? BAR : 0)), this.size[1]];
  }

  get scale(): number {
    return this.orbit.scale;
  }

  project(p: V3): V2 {
    return this.orbit.project(new Vector3(...p).applyMatrix4(this.turned));
  }

  direction(v: V3): V2 {
    return this.orbit.direction(new Vector3(...v).transformDirection(this.turned));
  }

  fit(size: V2): void {
    this.size = size;
    this.orbit.fit(this.room);
  }

  drag(dx: number, dy: number, move: boolean): void {
    this.orbit.drag(dx, dy, move);
  }

  zoomBy(factor: number, at: V2): void {
    this.orbit.zoomBy(factor, at);
  }

  reset(): void {
    this.orbit.fit(this.room);
  }

  look(side: Side): void {
    this.orbit.look(side);
  }

  draw(context: CanvasRenderingContext2D, at: number, shown: Shown): Spot[] {
    const { drawing, motion } = this.facts;
    const frame = new Frame(motion, drawing.planar, at);
    this.pose(frame);
    this.layer?.show(at, this.orbit.scale);
    this.point(frame, shown);
    this.mark(shown);
    this.paint(context);
    const pen = new Pen(context);
    drawLegend(pen, this, this.room);
    if (this.layer) this.tell(this.layer, pen, at);
    if (shown.applied) this.nameForces(pen, frame);
    const spots = this.spots(frame);
    if (shown.names) spots.forEach((spot) => pen.text(spot.title, [spot.at[0] + 9, spot.at[1] - 8], INK, 12));
    return spots;
  }

  private reach(): Vector3[] {
    const { drawing, motion } = this.facts;
    const joints = drawing.joints.flatMap((joint) => [joint.first, joint.second]);
    // Points of the ground on which nothing stands may be far away.
    const all = [...places(drawing).filter(([body]) => body !== 0), ...joints, ...motion.solids.flatMap(corners)];
    const seen = someFrames(motion, drawing.planar, 60).flatMap((frame) => all.map(([body, p]) => frame.place(body, p)));
    seen.push(...(this.layer?.reach() ?? []));
    return seen.filter((p) => p.every(Number.isFinite)).map((p) => new Vector3(...p).applyMatrix4(this.turned));
  }

  /** Where arrows of applied forces begin. */
  private feet(): Vector3[] {
    const { drawing, motion, appliedPeak } = this.facts;
    const foot = (frame: Frame, index: number) => {
      const { body, at } = drawing.arrows[index];
      return new Vector3(...frame.place(body, at)).sub(this.arrow(frame.force(index), appliedPeak));
    };
    const feet = someFrames(motion, drawing.planar, 60).flatMap((frame) => drawing.arrows.map((_, k) => foot(frame, k)));
    return feet.map((p) => p.applyMatrix4(this.turned)).filter((p) => Number.isFinite(p.length()));
  }

  private body(index: number): Group {
    const { drawing, motion } = this.facts;
    const group = new Group();
    // A flexible body is drawn by itself; its pins stay.
    const stands = this.layer?.stands(index) ?? false;
    const solids = motion.solids.filter((part) => !(stands && part.body === index && "surface" in part.shape));
    for (const metal of [false, true]) {
      const geometry = bodyGeometry(solids, index, metal, motion.solids.length < FINE_PARTS);
      if (!geometry) continue;
      const surface = metal ? { roughness: 0.32, metalness: 0.75 } : { roughness: 0.5, metalness: 0.05 };
      const material = sharedStudio().room
        ? new MeshStandardMaterial({ vertexColors: true, ...surface })
        : new MeshLambertMaterial({ vertexColors: true });
      const mesh = new Mesh(geometry, material);
      mesh.castShadow = mesh.receiveShadow = true;
      group.add(mesh);
    }
    for (const edges of edgeGeometries(solids, index)) {
      group.add(new LineSegments(edges, new LineBasicMaterial({ color: 0x1c2733, transparent: true, opacity: 0.55 })));
    }
    const { center } = drawing.bodies[index];
    if (center) {
      const mark = centerMark(0.018 * this.radius);
      mark.position.set(...center);
      this.centers.push(mark);
      group.add(mark);
    }
    const axes = axesMark(0.11 * this.radius);
    this.axes.push(axes);
    group.add(axes);
    return group;
  }

  private addDistances(): void {
    this.facts.drawing.joints.forEach((joint, index) => {
      if (joint.kind !== "distance") return;
      const rod = new Stretched(0.011 * this.radius);
      this.stretched.push([index, rod]);
      this.world.add(rod);
    });
  }

  private lowestOfGround(): number {
    const mesh = this.bodies[0]?.children.find((child): child is Mesh => child instanceof Mesh && child.castShadow);
    if (!mesh) return Infinity;
    mesh.geometry.computeBoundingBox();
    return mesh.geometry.boundingBox?.clone().applyMatrix4(this.turned).min.y ?? Infinity;
  }

  private pose(frame: Frame): void {
    this.bodies.forEach((group, index) => {
      const { position, turn } = frame.pose(index);
      group.position.set(...position);
      group.quaternion.set(turn[1], turn[2], turn[3], turn[0]);
    });
    const at = ([body, p]: [number, V3]) => new Vector3(...frame.place(body, p));
    for (const [index, rod] of this.stretched) {
      const joint = this.facts.drawing.joints[index];
      rod.set(at(joint.first), at(joint.second));
    }
  }

  /** Length of an arrow in the world. */
  private arrow(force: V3, peak: number): Vector3 {
    const all = force.every(Number.isFinite) && peak > 0;
    return all ? new Vector3(...force).multiplyScalar((0.42 * this.radius) / peak) : new Vector3();
  }

  private point(frame: Frame, shown: Shown): void {
    const { drawing, appliedPeak, reactionPeak } = this.facts;
    drawing.arrows.forEach(({ body, at }, index) => {
      const reach = this.arrow(frame.force(index), appliedPeak);
      // A load is drawn pushing: its tip is where it acts.
      this.applied[index].set(new Vector3(...frame.place(body, at)).sub(reach), reach);
      this.applied[index].visible &&= shown.applied;
    });
    drawing.joints.forEach((joint, index) => {
      const reach = shown.reactions ? this.arrow(this.facts.reaction(joint.name, frame), reactionPeak) : new Vector3();
      this.reactions[index].set(new Vector3(...frame.place(...joint.second)), reach);
    });
  }

  private mark(shown: Shown): void {
    this.centers.forEach((mark) => (mark.visible = shown.centers));
    this.axes.forEach((mark) => (mark.visible = shown.frames));
    const chosen = new Set(this.facts.chosen(shown.trail).map(({ name }) => name));
    for (const { name, path } of this.facts.chosen(shown.trail)) {
      if (this.trails.has(name)) continue;
      const mark = trailMark(path, 0.0032 * this.radius);
      this.trails.set(name, mark);
      if (mark) this.world.add(mark);
    }
    this.trails.forEach((mark, name) => mark && (mark.visible = chosen.has(name)));
  }

  /** What colours mean, and hot spots with their numbers. */
  private tell(layer: FlexibleLayer, pen: Pen, at: number): void {
    const { legend, flexible } = layer;
    if (legend) drawBar(pen, legend, { rainbow: false, bands: true }, flexible.colours, this.size);
    const labels = layer.labels(at, (p) => this.project(p));
    if (labels.length === 0) return;
    this.cover.take(sharedStudio().renderer.domElement, this.room);
    this.taken = drawLabels(pen, labels, this.cover, this.room, this.taken);
  }

  /** A quiet background, then what the renderer shows. */
  private paint(context: CanvasRenderingContext2D): void {
    const [width, height] = this.size;
    const sky = context.createLinearGradient(0, 0, 0, height);
    sky.addColorStop(0, "#f8fafc");
    sky.addColorStop(1, "#e4e9ee");
    context.fillStyle = sky;
    context.fillRect(0, 0, width, height);
    const { renderer } = sharedStudio();
    const canvas = renderer.domElement;
    const ratio = context.canvas.width / width;
    const wanted: V2 = [Math.round(this.room[0] * ratio), context.canvas.height];
    // Setting a size, even the same one, clears the picture and costs time.
    if (canvas.width !== wanted[0] || canvas.height !== wanted[1]) renderer.setSize(...wanted, false);
    renderer.render(this.scene, this.orbit.camera);
    context.drawImage(canvas, 0, 0, this.room[0], height);
  }

  private nameForces(pen: Pen, frame: Frame): void {
    const { drawing, appliedPeak } = this.facts;
    drawing.arrows.forEach(({ name, body, at }, index) => {
      const reach = this.arrow(frame.force(index), appliedPeak);
      if (reach.length() < 0.015 * this.radius) return;
      const foot = new Vector3(...frame.place(body, at)).sub(reach);
      const [x, y] = this.project([foot.x, foot.y, foot.z]);
      pen.text(name, [x + 8, y + 4], FORCE);
    });
  }

  private spots(frame: Frame): Spot[] {
    const { drawing } = this.facts;
    const joints = drawing.joints
      .filter((joint) => joint.kind !== "coupler")
      .map((joint) => ({ at: this.project(frame.place(...joint.second)), title: joint.name, joint: joint.name }));
    const away = (at: V2) => !joints.some((joint) => Math.hypot(joint.at[0] - at[0], joint.at[1] - at[1]) < 6);
    const points = drawing.bodies.flatMap((body, index) =>
      index === 0 ? [] : body.points.map(([name, p]) => ({ at: this.project(frame.place(index, p)), title: `${body.name}.${name}`, joint: null })),
    );
    // Names of all points of a large machine would hide it.
    return drawing.bodies.length > 12 ? joints : [...joints, ...points.filter(({ at }) => away(at))];
  }
}

/** Corners of a block or of the box around a real form, with its body; other parts reach hardly beyond the places they lie between. */
function corners({ body, shape }: Solid): [number, V3][] {
  if ("surface" in shape) {
    const { min, max } = new Box3().setFromArray(shape.surface);
    const ends = [min.toArray(), max.toArray()];
    return ends.flatMap(([x]) => ends.flatMap(([, y]) => ends.map(([, , z]): [number, V3] => [body, [x, y, z]])));
  }
  if (!("block" in shape)) return [];
  const { block, along, across, size } = shape;
  const high = new Vector3(...along).cross(new Vector3(...across));
  const signs = [-0.5, 0.5];
  const corner = (a: number, b: number, c: number) =>
    block.map((x, k) => x + a * size[0] * along[k] + b * size[1] * across[k] + c * size[2] * high.getComponent(k)) as V3;
  return signs.flatMap((a) => signs.flatMap((b) => signs.map((c): [number, V3] => [body, corner(a, b, c)])));
}

function middleOf(places: Vector3[]): Vector3 {
  const [low, high] = [new Vector3().setScalar(Infinity), new Vector3().setScalar(-Infinity)];
  places.forEach((p) => (low.min(p), high.max(p)));
  return places.length > 0 ? low.add(high).divideScalar(2) : new Vector3();
}
