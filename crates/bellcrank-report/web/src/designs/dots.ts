// Two columns of the designs against each other, with the best compromises where they belong.

import type { Designs } from "../data";
import { make } from "../dom";
import { heading, shown, withUnit } from "../format";
import type { Selection } from "./choice";
import { FAINT, fitted, FRONT, INK, marks, Sheet, span, whenWide } from "./sheet";

const LEFT = 84;
const RIGHT = 16;
const TOP = 14;
const BOTTOM = 48;
const REACH = 12;

export class Dots {
  readonly element: HTMLElement;
  private readonly sheet = new Sheet("Designs as dots over two of their columns");
  private readonly tip = make("div", { class: "tip", hidden: true });
  private spans: [number, number][] = [];

  constructor(
    private readonly designs: Designs,
    private readonly selection: Selection,
    public x: number,
    public y: number,
  ) {
    this.element = make("div", { class: "dots" }, this.sheet.canvas, this.tip);
    this.sheet.canvas.addEventListener("pointermove", (event) => this.point(event));
    this.sheet.canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    selection.follow(() => this.draw());
    whenWide(this.element, () => this.draw());
  }

  draw(): void {
    const width = this.element.clientWidth;
    if (width === 0) return;
    const pen = this.sheet.reset(width, Math.max(260, Math.min(420, width * 0.6)));
    const [across, up] = [this.designs.columns[this.x], this.designs.columns[this.y]];
    this.spans = [span(across.values, 0.04), span(up.values, 0.05)];
    this.grid(pen);
    const { passes } = this.selection;
    for (const wanted of [0, 1]) {
      [pen.fillStyle, pen.globalAlpha] = wanted ? ["#0b5fa5", 0.55] : [FAINT, 1];
      for (let row = 0; row < this.designs.rows; row++) if (passes[row] === wanted) this.dot(pen, row);
    }
    pen.globalAlpha = 1;
    this.front(pen);
  }

  private place(a: number, b: number): [number, number] {
    const [[x0, x1], [y0, y1]] = this.spans;
    const { width, height } = this.sheet;
    return [LEFT + ((a - x0) / (x1 - x0)) * (width - LEFT - RIGHT), height - BOTTOM - ((b - y0) / (y1 - y0)) * (height - BOTTOM - TOP)];
  }

  private at(row: number): [number, number] {
    return this.place(this.designs.columns[this.x].values[row], this.designs.columns[this.y].values[row]);
  }

  private dot(pen: CanvasRenderingContext2D, row: number): void {
    const [x, y] = this.at(row);
    if (!Number.isFinite(x) || !Number.isFinite(y)) return;
    pen.beginPath();
    pen.arc(x, y, 3, 0, 2 * Math.PI);
    pen.fill();
  }

  private front(pen: CanvasRenderingContext2D): void {
    const { front, columns } = this.designs;
    const names = [columns[this.x].name, columns[this.y].name];
    const turned = front && names[0] === front.y && names[1] === front.x;
    const straight = front && names[0] === front.x && names[1] === front.y;
    if (!front || !(turned || straight)) return;
    const [xs, ys] = turned ? [front.ys, front.xs] : [front.xs, front.ys];
    const points = xs.map((a, i) => this.place(a, ys[i]));
    [pen.strokeStyle, pen.lineWidth, pen.fillStyle] = [FRONT, 1.6, "#fff"];
    pen.beginPath();
    points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.stroke();
    for (const [x, y] of points) {
      pen.beginPath();
      pen.arc(x, y, 3.8, 0, 2 * Math.PI);
      pen.fill();
      pen.stroke();
    }
  }

  private grid(pen: CanvasRenderingContext2D): void {
    const { width, height } = this.sheet;
    const line = (x0: number, y0: number, x1: number, y1: number) => {
      pen.beginPath();
      pen.moveTo(x0, y0);
      pen.lineTo(x1, y1);
      pen.stroke();
    };
    [pen.strokeStyle, pen.lineWidth, pen.fillStyle] = ["#e3e7eb", 1, INK];
    [pen.textAlign, pen.textBaseline] = ["center", "top"];
    for (const mark of marks(this.spans[0], width / 90)) {
      const [x] = this.place(mark, 0);
      line(x, TOP, x, height - BOTTOM);
      pen.fillText(shown(mark), x, height - BOTTOM + 6);
    }
    [pen.textAlign, pen.textBaseline] = ["right", "middle"];
    for (const mark of marks(this.spans[1], height / 60)) {
      const [, y] = this.place(0, mark);
      line(LEFT, y, width - RIGHT, y);
      pen.fillText(shown(mark), LEFT - 7, y);
    }
    pen.strokeStyle = INK;
    pen.strokeRect(LEFT, TOP, width - LEFT - RIGHT, height - TOP - BOTTOM);
    this.labels(pen);
  }

  private labels(pen: CanvasRenderingContext2D): void {
    const { width, height } = this.sheet;
    const [across, up] = [this.designs.columns[this.x], this.designs.columns[this.y]];
    [pen.textAlign, pen.textBaseline] = ["center", "alphabetic"];
    pen.fillText(fitted(pen, heading(across.name, across.unit), width - LEFT), (LEFT + width - RIGHT) / 2, height - 8);
    pen.save();
    pen.translate(15, (TOP + height - BOTTOM) / 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText(fitted(pen, heading(up.name, up.unit), height - TOP - 20), 0, 0);
    pen.restore();
  }

  private point(event: PointerEvent): void {
    const [x, y] = this.sheet.at(event);
    let [best, near] = [-1, REACH];
    for (let row = 0; row < this.designs.rows; row++) {
      if (!this.selection.passes[row]) continue;
      const [a, b] = this.at(row);
      const away = Math.hypot(a - x, b - y);
      if (away < near) [best, near] = [row, away];
    }
    this.tip.hidden = best < 0;
    if (best < 0) return;
    const { number, columns } = this.designs;
    const lines = columns.map((column) => `${column.name} = ${withUnit(column.values[best], column.unit)}`);
    this.tip.replaceChildren(...[`design ${number.values[best]}`, ...lines].map((text) => make("div", {}, text)));
    const left = Math.max(0, Math.min(x + 14, this.element.clientWidth - this.tip.offsetWidth - 4));
    const top = Math.max(0, Math.min(y + 14, this.sheet.height - this.tip.offsetHeight - 4));
    this.tip.style.transform = `translate(${left}px, ${top}px)`;
  }
}
