// Joint symbols, after the usual sketches of mechanisms.

import type { Joint, V3 } from "../data";
import type { Camera, V2 } from "./camera";
import { bodyColour, INK, PAPER, type Pen, unitAndNormal } from "./pen";
import type { Frame } from "./pose";

const DRIVEN = "#ffd166";

/** What a sliding joint needs to know of its whole motion. */
export interface Travel {
  /** Smallest and largest distance between its two places, m. */
  near: number;
  far: number;
}

export interface Drawn {
  pen: Pen;
  camera: Camera;
  frame: Frame;
}

export function drawJoint(to: Drawn, joint: Joint, travel: Travel): void {
  const first = to.frame.place(...joint.first);
  const second = to.frame.place(...joint.second);
  const at = to.camera.project(second);
  const fill = joint.driven ? DRIVEN : PAPER;
  switch (joint.kind) {
    case "prismatic":
    case "cylindrical":
    case "point-on-line":
      slider(to, joint, first, second, travel, fill);
      break;
    case "distance":
      to.pen.line([to.camera.project(first), at], 2, INK, [6, 4]);
      pin(to.pen, at, fill);
      break;
    case "revolute":
    case "screw":
      revolute(to, joint, second, fill);
      break;
    case "spherical":
      to.pen.circle(at, 5.5, fill, INK);
      to.pen.circle(at, 2, INK, INK, 0.5);
      break;
    case "universal":
      to.pen.circle(at, 5.5, fill, INK);
      to.pen.line([[at[0] - 4, at[1]], [at[0] + 4, at[1]]], 1.4, INK);
      to.pen.line([[at[0], at[1] - 4], [at[0], at[1] + 4]], 1.4, INK);
      break;
    case "coupler":
      break;
    default:
      to.pen.box(at, [1, 0], 9, 9, fill, INK);
  }
}

/** The frame's support under a joint that stands on the ground. */
export function drawSupport(to: Drawn, joint: Joint): void {
  if (!to.camera.planar || joint.kind !== "revolute") return;
  if (joint.first[0] !== 0 && joint.second[0] !== 0) return;
  const [x, y] = to.camera.project(to.frame.place(...joint.first));
  to.pen.polygon([[x, y], [x - 10, y + 16], [x + 10, y + 16]], PAPER, INK, 1.6);
  to.pen.hatch([x, y + 16], [1, 0], 30);
}

function pin(pen: Pen, at: V2, fill: string): void {
  pen.circle(at, 5, fill, INK);
}

/** A pin; in space with a stroke along its axis. */
function revolute(to: Drawn, joint: Joint, place: V3, fill: string): void {
  const at = to.camera.project(place);
  if (!to.camera.planar) {
    const [dx, dy] = to.camera.direction(to.frame.turn(joint.first[0], joint.axis));
    const stretch = (s: number): V2 => [at[0] + 13 * s * dx, at[1] + 13 * s * dy];
    to.pen.line([stretch(-1), stretch(1)], 5, INK);
    to.pen.line([stretch(-1), stretch(1)], 2.6, fill);
  }
  pin(to.pen, at, fill);
}

function slider(to: Drawn, joint: Joint, first: V3, second: V3, travel: Travel, fill: string): void {
  const [a, b] = [to.camera.project(first), to.camera.project(second)];
  const axis = to.camera.direction(to.frame.turn(joint.first[0], joint.axis));
  const far = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (travel.near > 0.3 * travel.far && far > 40) cylinder(to, joint, a, b, travel, fill);
  else block(to, joint, a, b, axis, travel, fill);
}

/** Two ends that stay apart: a rod that runs into a barrel. */
function cylinder(to: Drawn, joint: Joint, a: V2, b: V2, travel: Travel, fill: string): void {
  const [u] = unitAndNormal([b[0] - a[0], b[1] - a[1]]);
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const barrel = Math.min(0.62 * travel.near * to.camera.scale, 0.9 * length);
  const middle: V2 = [b[0] - (u[0] * barrel) / 2, b[1] - (u[1] * barrel) / 2];
  to.pen.bar(a, b, 3, bodyColour(joint.first[0]));
  to.pen.box(middle, u, barrel, 13, fill, bodyColour(joint.second[0]));
}

/** A block on its guide. */
function block(to: Drawn, joint: Joint, a: V2, b: V2, axis: V2, travel: Travel, fill: string): void {
  const [u] = unitAndNormal(axis);
  const reach = Math.max(26, travel.far * to.camera.scale + 20);
  if (joint.first[0] === 0 && to.camera.planar) to.pen.hatch([b[0] - u[1] * 9, b[1] + u[0] * 9], u, 44);
  const end = (s: number): V2 => [a[0] + s * reach * u[0], a[1] + s * reach * u[1]];
  to.pen.line([end(-1), end(1)], 1.2, "#9aa4ae");
  to.pen.box(b, u, 26, 15, fill, bodyColour(joint.second[0]));
}
