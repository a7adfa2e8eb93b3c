// Flexible bodies in the solid drawing: moved, deformed and coloured from frame to frame.

import { Group, Quaternion, Vector3 } from "three";
import type { Field, Shape } from "../contour/data";
import type { Label } from "../contour/overlay";
import { type Style, Surface } from "../contour/surface";
import type { V3 } from "../data";
import type { FlexibleChoice } from "../flexible/controls";
import { type Flexible, type FlexibleBody, type Legend } from "../flexible/data";
import { between, Sums } from "../flexible/sums";
import { withUnit } from "../format";
import type { V2 } from "../scene/camera";
import { bodyColour } from "../scene/pen";
import * as kit from "./kit";

const STYLE: Style = { rainbow: false, bands: true };
/** Hot spots with less than this share of the largest stress stand in the table only. */
const TOLD = 0.1;
const ONE = new Vector3(1, 1, 1);

export class FlexibleLayer {
  readonly choice: FlexibleChoice;
  readonly group = new Group();
  private readonly drawn: Drawn[];
  /** Stress that a hot spot has in some frame to be worth a label. */
  private readonly told: number;

  constructor(readonly flexible: Flexible) {
    const { bodies, usual } = flexible;
    this.choice = { colour: "stress", factor: usual, usual, spots: true, undeformed: false, edges: true, worst: strongest(bodies)?.worst ?? 0 };
    this.told = Math.max(0, ...bodies.map(peak)) * TOLD;
    this.drawn = bodies.map((body, k) => new Drawn(body, flexible, k));
    this.group.add(...this.drawn.map(({ surface }) => surface.group));
  }

  /** What colours mean at the moment. */
  get legend(): Field | null {
    const legend = this.present();
    return legend && { ...legend, leastAt: 0, mostAt: 0, values: new Float32Array() };
  }

  private present(): Legend | null {
    if (this.choice.colour === "plain") return null;
    return this.flexible[this.choice.colour];
  }

  /** Moves everything to a frame; `pixels` of a metre. */
  show(at: number, pixels: number): void {
    const { factor, edges, undeformed } = this.choice;
    for (const drawn of this.drawn) {
      drawn.show(at, this.choice.colour, this.present());
      drawn.surface.deform(factor);
      drawn.surface.show(edges, undeformed, pixels);
    }
  }

  /** Hot spots with their present stress; `project` puts a place in the world on the canvas. */
  labels(at: number, project: (p: V3) => V2): Label[] {
    if (!this.choice.spots || this.choice.colour !== "stress") return [];
    const named = this.drawn.length > 1;
    return this.drawn.flatMap((drawn) =>
      drawn.body.spots.filter(({ history }) => most(history) >= this.told).map(({ label, node, doubtful, history }) => {
        const stress = withUnit(between(history, at), this.flexible.stress.unit, 3);
        const text = `${named ? `${drawn.body.name}, ` : ""}${label}: ${stress}`;
        return { at: project(drawn.place(node, this.choice.factor)), text, doubtful, hidden: false };
      }),
    );
  }

  /** Corners of the boxes around the bodies in some frames, world axes. */
  reach(): V3[] {
    return this.drawn.flatMap((drawn) => drawn.reach());
  }

  /** Bodies of the drawing whose own form these stand for. */
  stands(body: number): boolean {
    return this.flexible.bodies.some((flexible) => flexible.body === body);
  }
}

function most(history: Float32Array): number {
  return history.reduce((most, stress) => (stress > most ? stress : most), 0);
}

/** The largest stress of the hot spots of a body. */
function peak(body: FlexibleBody): number {
  return Math.max(0, ...body.spots.map(({ history }) => most(history)));
}

function strongest(bodies: FlexibleBody[]): FlexibleBody | undefined {
  return [...bodies].sort((a, b) => peak(b) - peak(a))[0];
}

/** One body on the graphics card. */
class Drawn {
  readonly surface: Surface;
  private readonly sums: Sums;
  private readonly values: Float32Array;
  private shown: FlexibleChoice["colour"] | null = null;
  private at = NaN;

  constructor(
    readonly body: FlexibleBody,
    flexible: Flexible,
    index: number,
  ) {
    // The colour of a body without field.
    const colour = parseInt(bodyColour(body.body ?? index + 1).slice(1), 16);
    const none: V3 = [colour >> 16, (colour >> 8) & 255, colour & 255];
    this.surface = new Surface(kit, body, { ...flexible.colours, none });
    this.sums = new Sums(body);
    this.values = new Float32Array(body.places.length / 3);
    this.surface.shape({ displacement: this.sums.move } as Shape);
  }

  /** Sums are taken anew only where something changes: a drawing that is turned stays what it is. */
  show(at: number, chosen: FlexibleChoice["colour"], legend: Legend | null): void {
    const moved = at !== this.at;
    if (moved) this.moveTo(at);
    if (moved || chosen !== this.shown) this.colour(chosen, legend, at);
    this.at = at;
    this.shown = chosen;
  }

  private moveTo(at: number): void {
    const { position, turn } = this.sums.pose(at);
    const [w, x, y, z] = turn;
    this.surface.group.matrix.compose(new Vector3().fromArray(position), new Quaternion(x, y, z, w), ONE);
    this.surface.group.matrixWorldNeedsUpdate = true;
    this.sums.moveTo(at);
    this.surface.moved();
  }

  private colour(chosen: FlexibleChoice["colour"], legend: Legend | null, at: number): void {
    if (chosen === "stress") this.sums.stressAt(at);
    this.fill(chosen, legend?.factor ?? 1);
    if (this.shown !== chosen) {
      const field = legend && { ...legend, leastAt: 0, mostAt: 0, values: this.values };
      this.surface.field(field ?? ({ values: this.values } as Field), STYLE, field === null);
    }
    this.surface.recoloured();
  }

  private fill(chosen: FlexibleChoice["colour"], factor: number): void {
    const { move, stress } = this.sums;
    const { values } = this;
    if (chosen === "plain") values.fill(-1e30);
    else if (chosen === "stress") for (let k = 0; k < values.length; k++) values[k] = stress[k] / factor;
    else for (let k = 0; k < values.length; k++) values[k] = Math.hypot(move[3 * k], move[3 * k + 1], move[3 * k + 2]) / factor;
  }

  /** A node in the world as it is drawn. */
  place(node: number, factor: number): V3 {
    const of = (k: number) => this.body.places[3 * node + k] + factor * this.sums.move[3 * node + k];
    return new Vector3(of(0), of(1), of(2)).applyMatrix4(this.surface.group.matrix).toArray();
  }

  reach(): V3[] {
    const { low, high, poses } = this.body;
    const count = poses[0].length;
    const found: V3[] = [];
    for (let at = 0; at < count; at += Math.max(1, Math.ceil(count / 60))) {
      const { position, turn: [w, x, y, z] } = this.sums.pose(at);
      const turn = new Quaternion(x, y, z, w);
      for (let corner = 0; corner < 8; corner++) {
        const p = [0, 1, 2].map((k) => (corner & (1 << k) ? high[k] : low[k]));
        found.push(new Vector3().fromArray(p).applyQuaternion(turn).add(new Vector3().fromArray(position)).toArray());
      }
    }
    return found;
  }
}
