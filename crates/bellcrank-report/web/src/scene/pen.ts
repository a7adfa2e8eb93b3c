// Strokes and shapes on the canvas, in pixels.

import type { V3 } from "../data";
import type { V2 } from "./camera";

export const INK = "#1d2733";
export const PAPER = "#ffffff";
export const FORCE = "#c4510a";
export const REACTION = "#8a2b78";
/** Axes with their colours and names. */
export const AXES: [V3, string, string][] = [
  [[1, 0, 0], "#b3261e", "x"],
  [[0, 1, 0], "#12805c", "y"],
  [[0, 0, 1], "#0b5fa5", "z"],
];
const BODIES = ["#0b5fa5", "#12805c", "#9a5b00", "#5b4aa8", "#a23a4a", "#3b6f7d", "#6b6b00", "#7a3b10"];

/** The colour of a body; the ground has the ink's. */
export function bodyColour(index: number): string {
  return index === 0 ? "#6b7684" : BODIES[(index - 1) % BODIES.length];
}

export class Pen {
  constructor(readonly c: CanvasRenderingContext2D) {}

  /** A line with a paper-coloured edge, so that crossing links read as one before the other. */
  bar(from: V2, to: V2, width: number, colour: string): void {
    this.line([from, to], width + 3, PAPER);
    this.line([from, to], width, colour);
  }

  line(points: V2[], width: number, colour: string, dash: number[] = []): void {
    const c = this.c;
    c.beginPath();
    points.forEach(([x, y], index) => (index === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
    c.lineWidth = width;
    c.strokeStyle = colour;
    c.lineCap = c.lineJoin = "round";
    c.setLineDash(dash);
    c.stroke();
    c.setLineDash([]);
  }

  polygon(points: V2[], fill: string, stroke: string, width: number): void {
    const c = this.c;
    c.beginPath();
    points.forEach(([x, y], index) => (index === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
    c.closePath();
    c.fillStyle = fill;
    c.fill();
    if (width > 0) {
      c.lineWidth = width;
      c.strokeStyle = stroke;
      c.lineJoin = "round";
      c.stroke();
    }
  }

  circle([x, y]: V2, radius: number, fill: string, stroke: string, width = 1.6): void {
    const c = this.c;
    c.beginPath();
    c.arc(x, y, radius, 0, 2 * Math.PI);
    c.fillStyle = fill;
    c.fill();
    c.lineWidth = width;
    c.strokeStyle = stroke;
    c.stroke();
  }

  /** A box around `at`, its long side along `along`. */
  box(at: V2, along: V2, length: number, height: number, fill: string, stroke: string): void {
    const [u, n] = unitAndNormal(along);
    const corner = (a: number, b: number): V2 => [at[0] + a * u[0] + b * n[0], at[1] + a * u[1] + b * n[1]];
    const [l, h] = [length / 2, height / 2];
    this.polygon([corner(-l, -h), corner(l, -h), corner(l, h), corner(-l, h)], fill, stroke, 1.6);
  }

  arrow(foot: V2, tip: V2, colour: string): void {
    const [dx, dy] = [tip[0] - foot[0], tip[1] - foot[1]];
    const length = Math.hypot(dx, dy);
    if (length < 2) return;
    const head = Math.min(11, length * 0.6);
    const [u, n] = unitAndNormal([dx, dy]);
    const neck: V2 = [tip[0] - head * u[0], tip[1] - head * u[1]];
    this.line([foot, neck], 2.2, colour);
    const side = (s: number): V2 => [neck[0] + s * head * 0.42 * n[0], neck[1] + s * head * 0.42 * n[1]];
    this.polygon([tip, side(1), side(-1)], colour, colour, 0);
  }

  text(text: string, [x, y]: V2, colour: string, size = 12, weight = ""): void {
    const c = this.c;
    c.font = `${weight} ${size}px system-ui, sans-serif`;
    c.lineWidth = 3;
    c.strokeStyle = PAPER;
    c.lineJoin = "round";
    c.strokeText(text, x, y);
    c.fillStyle = colour;
    c.fillText(text, x, y);
  }

  /** Hatched ground along `along`, on the side of the normal. */
  hatch(at: V2, along: V2, length: number): void {
    const [u, n] = unitAndNormal(along);
    const on = (a: number, b: number): V2 => [at[0] + a * u[0] + b * n[0], at[1] + a * u[1] + b * n[1]];
    this.line([on(-length / 2, 0), on(length / 2, 0)], 1.6, INK);
    for (let a = -length / 2; a <= length / 2 - 3; a += 5) this.line([on(a + 4, 0), on(a, 6)], 1, INK);
  }
}

/** A direction of length one and the one a quarter turn clockwise from it as seen (y down). */
export function unitAndNormal([x, y]: V2): [V2, V2] {
  const length = Math.hypot(x, y) || 1;
  const u: V2 = length < 1e-9 ? [1, 0] : [x / length, y / length];
  return [u, [-u[1], u[0]]];
}
