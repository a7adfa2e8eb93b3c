// A part to turn, deform and ask: the canvas with what is seen on it.

import { shown as number, withUnit } from "../format";
import type { V2 } from "../scene/camera";
import { Pen } from "../scene/pen";
import type { Kit } from "../solid/loading";
import type { Side } from "../view";
import type { Catalogue, Field, Part, Shape } from "./data";
import { BAR, Cover, drawAxes, drawBar, drawLabels, type Label } from "./overlay";
import { atNode, type Hit, nodeOf, placeOf, projected, Seen, valueAt } from "./probe";
import { type Style, Surface } from "./surface";

/** What the reader has chosen. */
export interface Choice extends Style {
  shape: number;
  field: number;
  edges: boolean;
  undeformed: boolean;
  labels: boolean;
  /** Times the displacement. */
  factor: number;
}

export class Viewer {
  readonly choice: Choice;
  /** Where a swing stands: 1 is all of the deformation. */
  phase = 1;
  playing = false;
  /** Whether graphics are computed without a graphics card. */
  readonly slow: boolean;
  private readonly surface: Surface;
  private readonly orbit;
  private readonly studio;
  private readonly pins: Hit[] = [];
  private hidden: boolean[] = [];
  /** Which of the places around it each label took. */
  private places: number[] = [];
  private readonly cover = new Cover();
  private settling = 0;
  /** Whether it is being turned; without a graphics card it is drawn coarser meanwhile. */
  private busy = false;
  private seen: Seen | null = null;
  private size: V2 = [1, 1];

  constructor(
    kit: Kit,
    readonly part: Part,
    private readonly catalogue: Catalogue,
    private readonly redraw: () => void,
  ) {
    this.surface = new Surface(kit, part, catalogue.colours);
    this.studio = kit.sharedStudio();
    this.slow = this.studio.room === null;
    const reach = sample(part, this.usual()).map((p) => new kit.Vector3(...p).applyMatrix4(this.surface.group.matrix));
    this.orbit = new kit.Orbit(reach, reach.reduce((most, p) => Math.max(most, p.length()), 1e-9));
    this.choice = {
      shape: 0, field: 0, edges: part.edges.length > 0, undeformed: true, labels: true, rainbow: false, bands: true,
      factor: this.usual(),
    };
    this.setShape(0);
    this.look("iso");
  }

  get shape(): Shape | null {
    return this.part.shapes[this.choice.shape] ?? null;
  }

  get field(): Field | null {
    return this.shape?.fields[this.choice.field] ?? null;
  }

  /** The factor at which the deformation is easily seen. */
  usual(): number {
    return this.part.shapes[this.choice?.shape ?? 0]?.usual ?? 0;
  }

  setShape(index: number): void {
    const name = this.field?.name;
    this.choice.shape = Math.max(0, Math.min(this.part.shapes.length - 1, index));
    this.choice.factor = this.usual();
    this.choice.field = Math.max(0, this.shape?.fields.findIndex((field) => field.name === name) ?? 0);
    this.surface.shape(this.shape);
    this.setColours();
  }

  /** After another field or other colours were chosen. */
  setColours(): void {
    this.surface.field(this.field, this.choice);
  }

  fit(size: V2): void {
    this.size = size;
    this.orbit.fit(this.room);
  }

  look(side: Side): void {
    this.orbit.look(side);
    // The still picture is seen from where this begins.
    if (side === "iso") this.orbit.drag((0.62 - this.catalogue.tilt[0]) / 0.007, (this.catalogue.tilt[1] - 0.42) / 0.007, false);
    this.orbit.fit(this.room);
  }

  drag(dx: number, dy: number, move: boolean): void {
    this.busy = this.slow;
    this.orbit.drag(dx, dy, move);
  }

  zoomBy(factor: number, at?: V2): void {
    this.busy = this.slow;
    this.orbit.zoomBy(factor, at ?? [this.room[0] / 2, this.room[1] / 2]);
  }

  /** The canvas without the colour bar, px. */
  private get room(): V2 {
    const bar = this.field ? BAR : 0;
    return [Math.max(1, this.size[0] - bar), this.size[1]];
  }

  draw(context: CanvasRenderingContext2D): void {
    this.seen = null;
    const factor = this.choice.factor * this.phase;
    this.surface.deform(factor);
    this.surface.show(this.choice.edges, this.choice.undeformed, this.orbit.scale);
    this.paint(context);
    const pen = new Pen(context);
    if (this.field) drawBar(pen, this.field, this.choice, this.catalogue.colours, this.size);
    drawAxes(pen, this.part.axes[0].map((_, k) => this.direction(k)), [46, this.size[1] - 46]);
    const labels = this.labels();
    // A moving part keeps its labels where they are.
    if (labels.length > 0 && !this.playing) this.cover.take(this.studio.renderer.domElement, this.room);
    this.places = drawLabels(pen, labels, this.cover, this.room, this.places);
    this.settle();
  }

  private direction(axis: number): V2 {
    const [x, y, z] = this.part.axes.map((row) => row[axis]);
    const { right, up } = this.orbit.sides;
    return [x * right.x + y * right.y + z * right.z, -(x * up.x + y * up.y + z * up.z)];
  }

  private paint(context: CanvasRenderingContext2D): void {
    const { renderer } = this.studio;
    const [width, height] = this.room;
    const coarse = this.busy || (this.slow && this.playing);
    const ratio = (context.canvas.width / this.size[0]) * (coarse ? 0.5 : 1);
    const wanted: V2 = [Math.round(width * ratio), Math.round(height * ratio)];
    const canvas = renderer.domElement;
    if (canvas.width !== wanted[0] || canvas.height !== wanted[1]) renderer.setSize(...wanted, false);
    context.fillStyle = "#ffffff";
    context.fillRect(0, 0, ...this.size);
    renderer.render(this.surface.scene, this.orbit.camera);
    context.drawImage(canvas, 0, 0, width, height);
  }

  /** From the part to the clip space. */
  private matrix(): number[] {
    const { camera } = this.orbit;
    return camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).multiply(this.surface.group.matrix).elements;
  }

  private all(): Seen {
    return (this.seen ??= new Seen(this.part, this.shape, this.choice.factor * this.phase, this.matrix(), this.room));
  }

  private labels(): Label[] {
    const marks = this.choice.labels ? this.part.marks : [];
    const matrix = this.matrix();
    const node = (node: number) => this.spot(node, matrix);
    const marked = marks.map(({ label, node: at, doubtful }, k) => ({
      at: node(at), text: label, doubtful, hidden: this.hidden[k] ?? false,
    }));
    return [...marked, ...this.pins.map((hit) => ({ at: this.pinned(hit, matrix), text: this.told(hit)[0], doubtful: false, hidden: false }))];
  }

  private spot(node: number, matrix: number[]): V2 {
    const moves = this.shape?.displacement;
    const factor = this.choice.factor * this.phase;
    const p = [0, 1, 2].map((k) => this.part.places[3 * node + k] + (moves ? factor * moves[3 * node + k] : 0));
    const [x, y] = projected(matrix, p, this.room);
    return [x, y];
  }

  private pinned(hit: Hit, matrix: number[]): V2 {
    const corners = [0, 1, 2].map((k) => this.spot(this.part.triangles[3 * hit.triangle + k], matrix));
    return [0, 1].map((axis) => corners.reduce((sum, corner, k) => sum + hit.shares[k] * corner[axis], 0)) as V2;
  }

  /** Once the picture stands still: which marks lie behind the part, and all of its fineness. */
  private settle(): void {
    window.clearTimeout(this.settling);
    if (this.playing) return;
    this.settling = window.setTimeout(() => {
      const before = this.hidden.join();
      if (this.choice.labels) this.hidden = this.part.marks.map(({ node }) => this.isHidden(node));
      const due = this.busy || this.hidden.join() !== before;
      this.busy = false;
      if (due) this.redraw();
    }, 150);
  }

  private isHidden(node: number): boolean {
    const [x, y, depth] = this.all().node(node);
    const front = this.all().hit([x, y]);
    return front !== null && front.depth < depth - 2e-4;
  }

  /** What is under the pointer. */
  hit(at: V2): Hit | null {
    return at[0] < this.room[0] ? this.all().hit(at) : null;
  }

  /** Keeps a place with its label, or lets go of the one that is near. */
  pin(at: V2): void {
    const matrix = this.matrix();
    const near = this.pins.findIndex((pin) => {
      const [x, y] = this.pinned(pin, matrix);
      return Math.hypot(x - at[0], y - at[1]) < 9;
    });
    const hit = near < 0 ? this.hit(at) : null;
    if (near >= 0) this.pins.splice(near, 1);
    else if (hit) this.pins.push(hit);
  }

  /** Keeps the place of the largest or least value; gives what is told there. */
  pinExtreme(largest: boolean): string {
    const hit = this.field && atNode(this.part, largest ? this.field.mostAt : this.field.leastAt);
    if (!hit) return "";
    this.pins.push(hit);
    return this.told(hit).join(", ");
  }

  unpin(): void {
    this.pins.length = 0;
  }

  /** Value, place, node of a hit. */
  told(hit: Hit): string[] {
    const { field, part } = this;
    const value = field && valueAt(part, field, hit);
    const place = placeOf(part, hit).map((x) => millimetres(x, part));
    const node = nodeOf(part, hit);
    return [
      field ? (value === null ? "no number here" : withUnit(value, field.unit, 4)) : "",
      `x ${place[0]}, y ${place[1]}, z ${place[2]} mm`,
      part.numbers ? `node ${part.numbers[node]}` : `node ${node + 1} of the surface`,
    ].filter((line) => line !== "");
  }

  /** What the canvas shows, in words. */
  words(): string {
    const { field, shape } = this;
    const range = field ? `${field.name} from ${number(field.least, 4)} to ${withUnit(field.most, field.unit, 4)}` : "no field";
    return [this.part.title, shape?.name, range].filter(Boolean).join(", ");
  }
}

/** A coordinate in mm, as fine as the part is told apart in the page. */
function millimetres(x: number, part: Part): string {
  const size = Math.hypot(...part.low.map((low, k) => 1e3 * (part.high[k] - low)));
  const decimals = Math.max(0, Math.min(9, 4 - Math.floor(Math.log10(size || 1))));
  return number(Number((1e3 * x).toFixed(decimals)), 9);
}

/** Some of the places of a part, undeformed and to both sides of it. */
function sample(part: Part, factor: number): [number, number, number][] {
  const count = part.places.length / 3;
  const every = Math.max(1, Math.floor(count / 3000));
  const [shape] = part.shapes;
  const sides = shape ? (shape.swings ? [-1, 1] : [0, 1]) : [0];
  const found: [number, number, number][] = [];
  for (let node = 0; node < count; node += every) {
    for (const side of sides) {
      const at = (k: number) => part.places[3 * node + k] + (shape ? side * factor * shape.displacement[3 * node + k] : 0);
      found.push([at(0), at(1), at(2)]);
    }
  }
  return found;
}
