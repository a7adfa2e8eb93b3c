// The camera of the solid drawing: turns about a target, in metres, y up.

import { Matrix4, PerspectiveCamera, Vector3 } from "three";
import type { V2 } from "../scene/camera";
import type { Side } from "../view";

/** Opening of the camera from top to bottom: little perspective, so that lengths can be compared. */
const OPENING = (24 * Math.PI) / 180;

/** Turn about the upright and height of each view. */
const SIDES: Record<Side, V2> = {
  iso: [0.62, 0.42],
  front: [0, 0],
  top: [0, Math.PI / 2],
  side: [Math.PI / 2, 0],
};

export class Orbit {
  readonly camera = new PerspectiveCamera((OPENING * 180) / Math.PI, 1, 0.01, 100);
  private readonly target = new Vector3();
  private distance = 1;
  private turn: V2 = [...SIDES.iso];
  private size: V2 = [1, 1];
  private readonly right = new Vector3();
  private readonly up = new Vector3();
  private readonly back = new Vector3();

  /** `reach`: places that are to be seen. */
  constructor(
    private readonly reach: Vector3[],
    private readonly radius: number,
  ) {}

  /** Pixels of a metre at the target. */
  get scale(): number {
    return this.size[1] / (2 * Math.tan(OPENING / 2) * this.distance);
  }

  /** Right and up of the picture in the scene. */
  get sides(): { right: Vector3; up: Vector3 } {
    return { right: this.right, up: this.up };
  }

  look(side: Side): void {
    this.turn = [...SIDES[side]];
    this.fit(this.size);
  }

  drag(dx: number, dy: number, move: boolean): void {
    if (move) this.shift(-dx / this.scale, dy / this.scale);
    else {
      const height = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.turn[1] + dy * 0.007));
      this.turn = [this.turn[0] - dx * 0.007, height];
    }
    this.place();
  }

  /** The place under `at` (px) stays where it is. */
  zoomBy(factor: number, at: V2): void {
    const next = Math.max(0.02 * this.radius, Math.min(40 * this.radius, this.distance / factor));
    const kept = (1 - next / this.distance) / this.scale;
    this.shift((at[0] - this.size[0] / 2) * kept, (this.size[1] / 2 - at[1]) * kept);
    this.distance = next;
    this.place();
  }

  /** As near as all of the reach can be seen. */
  fit(size: V2): void {
    this.size = [Math.max(1, size[0]), Math.max(1, size[1])];
    this.axes();
    const tall = Math.tan(OPENING / 2) * 0.86;
    const wide = tall * (this.size[0] / this.size[1]);
    this.target.set(0, 0, 0);
    // Perspective moves the middle: a few rounds settle it.
    for (let round = 0; round < 4; round++) {
      const [left, low, near] = this.spans(wide, tall);
      this.shift(left, low);
      this.distance = Math.max(near, 0.5 * this.radius);
    }
    this.place();
  }

  /** How far the middle of what is seen lies beside the target, and the distance at which all is seen. */
  private spans(wide: number, tall: number): [number, number, number] {
    const bounds = { r: [-Infinity, Infinity], u: [-Infinity, Infinity], near: 0 };
    const seen = this.reach.map((p) => {
      const d = p.clone().sub(this.target);
      return [d.dot(this.right), d.dot(this.up), d.dot(this.back)];
    });
    for (const [r, u, b] of seen) {
      // Half-planes of the view's edges, as where they meet the target's plane.
      bounds.r = [Math.max(bounds.r[0], r + wide * b), Math.min(bounds.r[1], r - wide * b)];
      bounds.u = [Math.max(bounds.u[0], u + tall * b), Math.min(bounds.u[1], u - tall * b)];
    }
    const middle = (pair: number[]) => (Number.isFinite(pair[0]) ? (pair[0] + pair[1]) / 2 : 0);
    const [x, y] = [middle(bounds.r), middle(bounds.u)];
    for (const [r, u, b] of seen) {
      bounds.near = Math.max(bounds.near, b + Math.abs(r - x) / wide, b + Math.abs(u - y) / tall);
    }
    return [x, y, bounds.near];
  }

  private shift(right: number, up: number): void {
    this.target.addScaledVector(this.right, right).addScaledVector(this.up, up);
  }

  private axes(): void {
    const [sy, cy, sp, cp] = [Math.sin(this.turn[0]), Math.cos(this.turn[0]), Math.sin(this.turn[1]), Math.cos(this.turn[1])];
    this.right.set(cy, 0, -sy);
    this.up.set(-sp * sy, cp, -sp * cy);
    this.back.set(cp * sy, sp, cp * cy);
  }

  private place(): void {
    this.axes();
    const { camera } = this;
    camera.aspect = this.size[0] / this.size[1];
    camera.near = Math.max(0.02 * this.distance, this.distance - 6 * this.radius);
    camera.far = this.distance + 12 * this.radius;
    camera.updateProjectionMatrix();
    camera.position.copy(this.target).addScaledVector(this.back, this.distance);
    camera.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(this.right, this.up, this.back));
    camera.updateMatrixWorld();
  }

  /** A place (y up, m) on the canvas, px. */
  project(place: Vector3): V2 {
    const p = place.clone().project(this.camera);
    return [((p.x + 1) / 2) * this.size[0], ((1 - p.y) / 2) * this.size[1]];
  }

  /** A direction (y up) as seen, y down. */
  direction(v: Vector3): V2 {
    return [v.dot(this.right), -v.dot(this.up)];
  }
}
