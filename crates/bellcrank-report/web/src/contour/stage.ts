// The controls around a part: what is shown, how much deformed, swinging or still, and the keys for it.

import { choice, make, toggle } from "../dom";
import { shown, unitShown } from "../format";
import type { V2 } from "../scene/camera";
import type { Side } from "../view";
import type { Choice, Viewer } from "./viewer";

const SIDES: [string, Side][] = [["1", "iso"], ["2", "front"], ["3", "top"], ["4", "side"]];
/** A swing to and fro, s. */
const PERIOD = 2.4;

export class PartStage {
  readonly element: HTMLElement;
  private readonly canvas = make("canvas", { tabindex: 0, role: "img" });
  private readonly tip = make("div", { class: "tip", hidden: true });
  private readonly frame = make("div", { class: "frame" }, this.canvas, this.tip);
  private readonly said = make("p", { class: "hint", "aria-live": "polite" });
  private readonly fields = make("span", { class: "group" });
  private readonly scale = make("output", { class: "factor" });
  private readonly slider = make("input", { type: "range", min: 0, max: 100, value: 50, "aria-label": "Deformation" });
  private readonly button = make("button", { type: "button", "aria-label": "Let it move", click: () => this.play(!this.playing) }, "▶");
  private shapes: HTMLSelectElement | null = null;
  private size: V2 = [1, 1];
  private pending = false;
  private playing = false;
  private near = false;
  private start = 0;
  private pressed: V2 | null = null;

  constructor(private readonly viewer: Viewer) {
    const { part } = viewer;
    this.slider.addEventListener("input", () => this.slide());
    this.element = make("div", { class: "live" }, make("b", { class: "title" }, part.title), this.chosen(), this.frame, this.deformation(), this.options(), this.said);
    this.shapeChanged();
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.frame);
    new IntersectionObserver(([entry]) => this.comes(entry.isIntersecting)).observe(this.frame);
    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches || viewer.slow;
    if (viewer.shape?.swings && !still) this.play(true);
  }

  /** Which shape, which field, which colours. */
  private chosen(): HTMLElement {
    const { part } = this.viewer;
    const row = make("div", { class: "options" });
    if (part.shapes.length > 1) {
      const names = part.shapes.map(({ name }, k): [string, string] => [String(k), name || `shape ${k + 1}`]);
      this.shapes = choice("Shape", names, (value) => this.setShape(Number(value)));
      row.append(this.shapes);
    }
    const colours = choice("Colours", [["even", "even colours"], ["rainbow", "rainbow"]], (value) => this.recolour({ rainbow: value === "rainbow" }));
    row.append(this.fields, colours, toggle("bands", true, (bands) => this.recolour({ bands })));
    return row;
  }

  private recolour(change: Partial<Choice>): void {
    Object.assign(this.viewer.choice, change);
    this.viewer.setColours();
    this.redraw();
  }

  private deformation(): HTMLElement {
    const { viewer } = this;
    if (viewer.part.shapes.every((shape) => shape.usual === 0)) return make("div", { class: "player", hidden: true });
    const set = (label: string, factor: () => number) =>
      make("button", { type: "button", click: () => this.deform(factor()) }, label);
    const swings = viewer.part.shapes.every((shape) => shape.swings);
    return make(
      "div",
      { class: "player" },
      this.button, make("span", {}, "deformation"), this.slider, this.scale,
      ...(swings ? [] : [set("true", () => 1)]), set("usual", () => viewer.usual()), set("none", () => 0),
    );
  }

  private options(): HTMLElement {
    const { choice: chosen, part } = this.viewer;
    const set = (name: "edges" | "undeformed" | "labels") => (on: boolean) => {
      chosen[name] = on;
      this.redraw();
    };
    const button = (label: string, text: string, act: () => void) =>
      make("button", { type: "button", "aria-label": label, title: label, click: () => this.act(act) }, text);
    const row = make("div", { class: "options" });
    if (part.edges.length > 0) row.append(toggle("element edges", true, set("edges")));
    if (part.shapes.length > 0) row.append(toggle("undeformed", true, set("undeformed")));
    if (part.marks.length > 0) row.append(toggle("labels", true, set("labels")));
    const probes = make(
      "span",
      { class: "group" },
      button("Mark the largest value", "largest", () => (this.said.textContent = this.viewer.pinExtreme(true))),
      button("Mark the least value", "least", () => (this.said.textContent = this.viewer.pinExtreme(false))),
      button("Remove what was marked", "clear", () => this.viewer.unpin()),
    );
    const sides = SIDES.map(([key, side]) => button(`View: ${side} (key ${key})`, side, () => this.viewer.look(side)));
    const zooms = [
      button("Zoom in", "+", () => this.viewer.zoomBy(1.25)),
      button("Zoom out", "−", () => this.viewer.zoomBy(0.8)),
      button("Show all", "fit", () => this.viewer.fit(this.size)),
    ];
    if (part.shapes.some((shape) => shape.fields.length > 0)) row.append(probes);
    row.append(make("span", { class: "group" }, ...sides), make("span", { class: "group" }, ...zooms));
    return row;
  }

  private act(action: () => void): void {
    action();
    this.redraw();
  }

  private setShape(index: number): void {
    this.viewer.setShape(index);
    if (this.shapes) this.shapes.value = String(this.viewer.choice.shape);
    this.shapeChanged();
    this.redraw();
  }

  /** Fields and the slider are those of the shape. */
  private shapeChanged(): void {
    const { viewer } = this;
    const names = viewer.shape?.fields.map(({ name, unit }, k): [string, string] => [String(k), unit ? `${name} in ${unitShown(unit)}` : name]) ?? [];
    const fields = choice("Field", names, (value) => this.recolour({ field: Number(value) }));
    fields.value = String(viewer.choice.field);
    this.fields.hidden = names.length < 2;
    this.fields.replaceChildren(fields);
    this.deform(viewer.choice.factor);
  }

  /** The middle of the slider is the usual factor, its end five times that. */
  private slide(): void {
    this.deform(this.viewer.usual() * (Number(this.slider.value) / 50) ** 2.32);
  }

  private deform(factor: number): void {
    const { viewer } = this;
    const usual = viewer.usual();
    viewer.choice.factor = factor;
    const at = usual > 0 ? 50 * (factor / usual) ** (1 / 2.32) : 0;
    if (document.activeElement !== this.slider) this.slider.value = String(at);
    this.scale.textContent = viewer.shape?.swings
      ? `${shown((100 * factor) / usual, 3)} %, size arbitrary`
      : factor === 1 ? "× 1, true" : `× ${shown(factor, 3)}`;
    this.redraw();
  }

  private play(on: boolean): void {
    this.playing = this.viewer.playing = on;
    this.button.textContent = on ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", on ? "Hold still" : "Let it move");
    if (on) this.start = performance.now();
    else this.viewer.phase = 1;
    this.redraw();
  }

  /** Nothing moves that is not seen. */
  private comes(near: boolean): void {
    this.near = near;
    if (near) this.redraw();
  }

  /** A mode swings to both sides, a state under load goes there and back. */
  private phase(now: number): number {
    const turn = ((now - this.start) / 1000 / PERIOD) * 2 * Math.PI;
    return this.viewer.shape?.swings ? Math.cos(turn) : (1 + Math.cos(turn)) / 2;
  }

  private redraw(): void {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame((now) => {
      this.pending = false;
      if (this.playing) this.viewer.phase = this.phase(now);
      this.draw();
      if (this.playing && this.near) this.redraw();
    });
  }

  /** Asked for from outside: a picture is due. */
  refresh(): void {
    this.redraw();
  }

  private draw(): void {
    const context = this.canvas.getContext("2d");
    if (!context || this.size[0] < 1 || this.size[1] < 1) return;
    const ratio = this.canvas.width / this.size[0];
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.viewer.draw(context);
    this.canvas.setAttribute("aria-label", `${this.viewer.words()}. Arrow keys turn, plus and minus zoom, 0 shows all, 1 to 4 choose a view, space lets it move, page up and down change the shape.`);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.frame;
    const ratio = window.devicePixelRatio || 1;
    this.size = [clientWidth, clientHeight];
    this.canvas.width = Math.round(clientWidth * ratio);
    this.canvas.height = Math.round(clientHeight * ratio);
    this.viewer.fit(this.size);
    this.draw();
  }

  private listen(): void {
    const { canvas } = this;
    const fingers = new Map<number, V2>();
    canvas.addEventListener("pointerdown", (event) => {
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      canvas.setPointerCapture(event.pointerId);
      this.pressed = fingers.size === 1 ? [event.offsetX, event.offsetY] : null;
      this.tip.hidden = true;
    });
    canvas.addEventListener("pointerup", (event) => {
      fingers.delete(event.pointerId);
      this.lifted([event.offsetX, event.offsetY]);
    });
    canvas.addEventListener("pointercancel", (event) => fingers.delete(event.pointerId));
    canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    canvas.addEventListener("pointermove", (event) => {
      if (fingers.has(event.pointerId)) this.moved(fingers, event);
      else this.hover([event.offsetX, event.offsetY]);
    });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("dblclick", () => this.act(() => this.viewer.fit(this.size)));
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** One finger or button turns (moves with shift, middle or right button), two fingers move and zoom. */
  private moved(fingers: Map<number, V2>, event: PointerEvent): void {
    const [from, to]: V2[] = [fingers.get(event.pointerId) ?? [0, 0], [event.clientX, event.clientY]];
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    fingers.set(event.pointerId, to);
    if (other) {
      const apart = (p: V2) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
      const box = this.canvas.getBoundingClientRect();
      this.viewer.drag((to[0] - from[0]) / 2, (to[1] - from[1]) / 2, true);
      this.viewer.zoomBy(apart(to) / apart(from), [(to[0] + other[0]) / 2 - box.left, (to[1] + other[1]) / 2 - box.top]);
    } else this.viewer.drag(to[0] - from[0], to[1] - from[1], event.shiftKey || (event.buttons & 6) !== 0);
    this.redraw();
  }

  /** A click without a way in between keeps the place. */
  private lifted(at: V2): void {
    const from = this.pressed;
    this.pressed = null;
    if (!from || Math.hypot(at[0] - from[0], at[1] - from[1]) > 4) return;
    this.act(() => this.viewer.pin(at));
  }

  private wheel(event: WheelEvent): void {
    // A page that is scrolled past the drawing must not zoom it: only once it has the focus.
    if (document.activeElement !== this.canvas && !event.ctrlKey) return;
    event.preventDefault();
    this.act(() => this.viewer.zoomBy(Math.exp(-event.deltaY * 0.0015), [event.offsetX, event.offsetY]));
  }

  private key(event: KeyboardEvent): void {
    const action = this.keys()[event.key];
    if (!action || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    this.act(action);
  }

  private keys(): Record<string, () => void> {
    const { viewer } = this;
    const turn = (dx: number, dy: number) => () => viewer.drag(dx, dy, false);
    const next = (step: number) => () => this.setShape(viewer.choice.shape + step);
    return {
      ArrowRight: turn(20, 0), ArrowLeft: turn(-20, 0), ArrowUp: turn(0, -20), ArrowDown: turn(0, 20),
      "+": () => viewer.zoomBy(1.25), "-": () => viewer.zoomBy(0.8), "0": () => viewer.fit(this.size),
      PageDown: next(1), PageUp: next(-1), " ": () => this.play(!this.playing), Escape: () => viewer.unpin(),
      ...Object.fromEntries(SIDES.map(([key, side]) => [key, () => viewer.look(side)])),
    };
  }

  private hover(at: V2): void {
    const hit = this.playing ? null : this.viewer.hit(at);
    this.tip.hidden = !hit;
    if (!hit) return;
    const [value, ...more] = this.viewer.told(hit);
    this.tip.replaceChildren(make("b", {}, value), ...more.map((line) => make("div", {}, line)));
    const left = Math.min(at[0] + 16, this.size[0] - this.tip.offsetWidth - 6);
    const top = at[1] > this.tip.offsetHeight + 22 ? at[1] - 16 - this.tip.offsetHeight : at[1] + 20;
    this.tip.style.transform = `translate(${left}px, ${top}px)`;
  }
}
