// From the world to the canvas: parallel projection, straight on in the plane, orbiting in space.

import type { V3 } from "../data";

export type V2 = [number, number];

/** How a drawing is seen, flat or solid. */
export interface Eye {
  readonly planar: boolean;
  /** Pixels of a metre. */
  readonly scale: number;
  project(p: V3): V2;
  /** A direction as seen: its two components on the canvas, y down. */
  direction(v: V3): V2;
}

export class Camera implements Eye {
  private yaw = -0.9;
  private pitch = 0.42;
  private zoom = 1;
  private pan: V2 = [0, 0];
  private center: V3 = [0, 0, 0];
  private fitted = 1;
  private size: V2 = [1, 1];
  private row0: V3 = [1, 0, 0];
  private row1: V3 = [0, 1, 0];
  private row2: V3 = [0, 0, 1];

  /** `axes`: right, up and towards the reader, as the machine is seen from the front. */
  constructor(
    readonly planar: boolean,
    private readonly axes: [V3, V3, V3],
  ) {
    this.turnRows();
  }

  /** Pixels of a metre. */
  get scale(): number {
    return this.fitted * this.zoom;
  }

  /** Shows all of `points` in a canvas of that size (px), unless moved since. */
  fit(points: V3[], size: V2, margin: number): void {
    this.size = size;
    // Loops, not spreads: a chain of ten thousand bodies has more places than a call takes arguments.
    const along = (row: V3): V2 => {
      let [low, high] = [Infinity, -Infinity];
      for (const p of points) {
        const at = dot(row, p);
        low = Math.min(low, at);
        high = Math.max(high, at);
      }
      return [low, high];
    };
    const spans = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as V3[]).map(along);
    this.center = spans.map(([low, high]) => (low + high) / 2) as V3;
    const [cx, cy, cz] = this.center;
    const radius = points.reduce((most, p) => Math.max(most, Math.hypot(p[0] - cx, p[1] - cy, p[2] - cz)), 0);
    const wide = this.planar ? spans[0][1] - spans[0][0] : 2 * radius;
    const tall = this.planar ? spans[1][1] - spans[1][0] : 1.9 * radius;
    const room = (length: number, pixels: number) => Math.max(40, pixels - 2 * margin) / Math.max(length, 1e-9);
    this.fitted = Math.min(room(wide, size[0]), room(tall, size[1]), 1e7);
  }

  project(p: V3): V2 {
    const d = [p[0] - this.center[0], p[1] - this.center[1], p[2] - this.center[2]] as V3;
    const s = this.scale;
    return [this.size[0] / 2 + this.pan[0] + s * dot(this.row0, d), this.size[1] / 2 + this.pan[1] - s * dot(this.row1, d)];
  }

  /** Larger is nearer to the reader. */
  depth(p: V3): number {
    return dot(this.row2, p);
  }

  /** A direction as seen: its two components on the canvas, y down. */
  direction(v: V3): V2 {
    return [dot(this.row0, v), -dot(this.row1, v)];
  }

  drag(dx: number, dy: number, move: boolean): void {
    if (this.planar || move) {
      this.pan = [this.pan[0] + dx, this.pan[1] + dy];
      return;
    }
    this.yaw -= dx * 0.008;
    this.pitch = Math.max(-1.55, Math.min(1.55, this.pitch + dy * 0.008));
    this.turnRows();
  }

  zoomBy(factor: number, at: V2): void {
    const next = Math.max(0.2, Math.min(40, this.zoom * factor));
    const ratio = next / this.zoom;
    const from = [at[0] - this.size[0] / 2, at[1] - this.size[1] / 2];
    this.pan = [from[0] + (this.pan[0] - from[0]) * ratio, from[1] + (this.pan[1] - from[1]) * ratio];
    this.zoom = next;
  }

  reset(): void {
    [this.zoom, this.pan, this.yaw, this.pitch] = [1, [0, 0], -0.9, 0.42];
    this.turnRows();
  }

  /** Rows of the view: right, up, towards the reader. */
  private turnRows(): void {
    if (this.planar) return;
    const [sy, cy] = [Math.sin(this.yaw), Math.cos(this.yaw)];
    const [sp, cp] = [Math.sin(this.pitch), Math.cos(this.pitch)];
    const [right, up, front] = this.axes;
    const along = (a: number, b: number, c: number) => right.map((x, k) => a * x + b * up[k] + c * front[k]) as V3;
    this.row0 = along(cy, 0, -sy);
    this.row1 = along(sp * sy, cp, sp * cy);
    this.row2 = cross(this.row0, this.row1);
  }
}

export function dot(a: V3, b: V3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function cross(a: V3, b: V3): V3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
