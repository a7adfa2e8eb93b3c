// Parallel axes: a line a design, and stretches to choose by.

import type { Designs } from "../data";
import { make } from "../dom";
import { heading, shown } from "../format";
import type { Selection } from "./choice";
import { FAINT, fitted, INK, marks, Sheet, SOFT, span, tint, whenWide } from "./sheet";

const TOP = 58;
const BOTTOM = 30;
const HEIGHT = 360;
const EDGE = 64;
/** Narrower than that the numbers of one axis run into the next: then the sheet scrolls. */
const NARROWEST = 96;
/** How near the pointer must be to an axis. */
const REACH = 26;

export class Rulers {
  readonly element: HTMLElement;
  private readonly sheet = new Sheet("Designs as lines over parallel axes");
  private readonly spans: [number, number][];
  private drawing: { column: number; from: number } | null = null;

  constructor(
    private readonly designs: Designs,
    private readonly selection: Selection,
    public colour: number,
  ) {
    this.element = make("div", { class: "rulers" }, this.sheet.canvas);
    this.spans = designs.columns.map(({ values }) => span(values));
    const { canvas } = this.sheet;
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    canvas.addEventListener("pointerup", (event) => this.release(event));
    canvas.addEventListener("pointercancel", () => (this.drawing = null));
    selection.follow(() => this.draw());
    whenWide(this.element, () => this.draw());
  }

  draw(): void {
    const count = this.designs.columns.length;
    const width = Math.max(this.element.clientWidth, 2 * EDGE + NARROWEST * (count - 1));
    if (this.element.clientWidth === 0) return;
    const pen = this.sheet.reset(width, HEIGHT);
    this.lines(pen);
    for (let column = 0; column < count; column++) this.ruler(pen, column);
  }

  private x(column: number): number {
    return EDGE + ((this.sheet.width - 2 * EDGE) * column) / Math.max(1, this.designs.columns.length - 1);
  }

  private y(column: number, value: number): number {
    const [low, high] = this.spans[column];
    return HEIGHT - BOTTOM - ((value - low) / (high - low)) * (HEIGHT - BOTTOM - TOP);
  }

  private value(column: number, y: number): number {
    const [low, high] = this.spans[column];
    return low + ((HEIGHT - BOTTOM - y) / (HEIGHT - BOTTOM - TOP)) * (high - low);
  }

  /** Those that do not pass lie below those that do. */
  private lines(pen: CanvasRenderingContext2D): void {
    const { passes, stretches } = this.selection;
    const all = this.designs.rows;
    if (stretches.size > 0) {
      [pen.strokeStyle, pen.lineWidth, pen.globalAlpha] = [FAINT, 1, 0.8];
      for (let row = 0; row < all; row++) if (!passes[row]) this.line(pen, row);
    }
    [pen.lineWidth, pen.globalAlpha] = [1.1, this.selection.count > 800 ? 0.28 : 0.6];
    const [low, high] = this.spans[this.colour];
    const { values } = this.designs.columns[this.colour];
    for (let row = 0; row < all; row++) {
      if (!passes[row]) continue;
      const known = Number.isFinite(values[row]);
      pen.strokeStyle = known ? tint((values[row] - low) / (high - low)) : SOFT;
      pen.setLineDash(known ? [] : [3, 3]);
      this.line(pen, row);
    }
    pen.setLineDash([]);
    pen.globalAlpha = 1;
  }

  private line(pen: CanvasRenderingContext2D, row: number): void {
    pen.beginPath();
    let down = false;
    this.designs.columns.forEach(({ values }, column) => {
      const value = values[row];
      if (!Number.isFinite(value)) down = false;
      else if (down) pen.lineTo(this.x(column), this.y(column, value));
      else {
        pen.moveTo(this.x(column), this.y(column, value));
        down = true;
      }
    });
    pen.stroke();
  }

  private ruler(pen: CanvasRenderingContext2D, column: number): void {
    const x = this.x(column);
    [pen.strokeStyle, pen.lineWidth] = [INK, 1.2];
    pen.beginPath();
    pen.moveTo(x, TOP);
    pen.lineTo(x, HEIGHT - BOTTOM);
    pen.stroke();
    this.numbers(pen, column);
    this.name(pen, column);
    const stretch = this.selection.stretches.get(column);
    if (!stretch) return;
    const [from, to] = [this.y(column, stretch[1]), this.y(column, stretch[0])];
    [pen.fillStyle, pen.strokeStyle] = ["#0b5fa533", "#0b5fa5"];
    pen.fillRect(x - 8, from, 16, to - from);
    pen.strokeRect(x - 8, from, 16, to - from);
  }

  private numbers(pen: CanvasRenderingContext2D, column: number): void {
    const x = this.x(column);
    [pen.textAlign, pen.textBaseline, pen.lineJoin] = ["right", "middle", "round"];
    // Without a single value there is nothing to measure.
    const known = Array.prototype.some.call(this.designs.columns[column].values, Number.isFinite);
    for (const mark of known ? marks(this.spans[column], 5) : []) {
      const y = this.y(column, mark);
      [pen.strokeStyle, pen.lineWidth] = ["#fff", 3];
      pen.strokeText(shown(mark), x - 7, y);
      pen.fillStyle = INK;
      pen.fillText(shown(mark), x - 7, y);
      [pen.strokeStyle, pen.lineWidth] = [INK, 1];
      pen.beginPath();
      pen.moveTo(x - 4, y);
      pen.lineTo(x, y);
      pen.stroke();
    }
  }

  /** On two levels in turn, so that neighbours have twice the room. */
  private name(pen: CanvasRenderingContext2D, column: number): void {
    const { name, unit } = this.designs.columns[column];
    const last = this.designs.columns.length - 1;
    const room = 1.7 * (this.x(1) - this.x(0) || this.sheet.width);
    const level = TOP - (column % 2 ? 32 : 14);
    const text = fitted(pen, heading(name, unit), room);
    pen.textAlign = column === 0 ? "left" : column === last ? "right" : "center";
    [pen.textBaseline, pen.fillStyle] = ["alphabetic", INK];
    const aside = column === 0 ? 8 - EDGE : column === last ? EDGE - 8 : 0;
    pen.fillText(text, this.x(column) + aside, level);
    if (column % 2) {
      [pen.strokeStyle, pen.lineWidth] = ["#b9c1c9", 1];
      pen.beginPath();
      pen.moveTo(this.x(column), level + 4);
      pen.lineTo(this.x(column), TOP);
      pen.stroke();
    }
    [pen.textAlign, pen.fillStyle] = ["center", SOFT];
    pen.fillText(column < this.designs.inputs ? "varied" : "found", this.x(column), HEIGHT - 10);
  }

  private nearest(x: number): number | null {
    const columns = this.designs.columns.map((_, column) => column);
    const best = columns.reduce((a, b) => (Math.abs(this.x(b) - x) < Math.abs(this.x(a) - x) ? b : a));
    return Math.abs(this.x(best) - x) <= REACH ? best : null;
  }

  private press(event: PointerEvent): void {
    const [x, y] = this.sheet.at(event);
    const column = this.nearest(x);
    if (column === null) return;
    this.drawing = { column, from: this.value(column, y) };
    this.sheet.canvas.setPointerCapture(event.pointerId);
    event.preventDefault();
  }

  private drag(event: PointerEvent): void {
    if (!this.drawing) return;
    const { column, from } = this.drawing;
    const to = this.value(column, this.sheet.at(event)[1]);
    this.selection.set(column, from < to ? [from, to] : [to, from]);
  }

  /** A click lets go. */
  private release(event: PointerEvent): void {
    if (!this.drawing) return;
    const { column, from } = this.drawing;
    this.drawing = null;
    if (Math.abs(this.y(column, from) - this.sheet.at(event)[1]) < 4) this.selection.set(column, null);
  }
}
