// The moving drawing with its controls.

import type { Cursor } from "./cursor";
import { type Drawing, type Motion, signal, type Study } from "./data";
import { choice, make, toggle } from "./dom";
import { flexibleControls } from "./flexible/controls";
import { hasFlexible } from "./flexible/data";
import { withUnit } from "./format";
import { Player } from "./player";
import type { V2 } from "./scene/camera";
import { Facts } from "./scene/facts";
import { Scene } from "./scene/scene";
import { solidView } from "./solid/loading";
import type { Shown, Side, Spot, View } from "./view";

/** Views by the key that chooses them. */
const SIDES: [string, Side][] = [["1", "iso"], ["2", "front"], ["3", "top"], ["4", "side"]];

export class Stage {
  private readonly canvas = make("canvas", { tabindex: 0, role: "img" });
  private readonly tip = make("div", { class: "tip", hidden: true });
  private readonly word = make("p", { class: "hint", hidden: true });
  private readonly sides = make("span", { class: "group", hidden: true });
  /** Controls of flexible bodies. */
  private readonly elastic = make("div", { hidden: true });
  private readonly facts: Facts;
  private readonly flat: Scene;
  private solid: View | null = null;
  private view: View;
  private readonly player: Player;
  private readonly shown: Shown;
  private spots: Spot[] = [];
  private size: V2 = [1, 1];
  private pending = false;

  constructor(
    private readonly mount: HTMLElement,
    private readonly drawing: Drawing,
    private readonly study: Study,
    motion: Motion,
    private readonly cursor: Cursor,
    private readonly index: number,
  ) {
    this.facts = new Facts(drawing, motion, study);
    this.view = this.flat = new Scene(this.facts);
    this.player = new Player(study, motion, cursor);
    const trail = this.facts.usualTrail();
    this.shown = { applied: true, reactions: false, names: false, centers: drawing.planar, frames: false, trail };
    const frame = make("div", { class: "frame" }, this.canvas, this.tip);
    // A single position has nothing to play.
    mount.append(frame, ...(study.rows > 1 ? [this.player.element] : []), this.elastic, this.options(), this.word);
    this.name();
    this.player.follow(() => this.redraw());
    cursor.follow(() => this.redraw());
    new ResizeObserver(() => this.resize()).observe(frame);
    this.listen();
    if (this.solidFirst()) void this.useSolid(true);
  }

  /** A machine in the plane is flat, but for bodies that are coloured and deformed. */
  private solidFirst(): boolean {
    const { planar, solids } = { planar: this.drawing.planar, solids: this.facts.motion.solids };
    return (!planar && solids.length > 0) || hasFlexible(this.index);
  }

  private options(): HTMLElement {
    const set = (change: (shown: Shown) => void) => {
      change(this.shown);
      this.redraw();
    };
    const trails = choice(
      "Trail of",
      [["", "no trail"], ["*", "all trails"], ...this.facts.trails.map(({ name }): [string, string] => [name, `trail of ${name}`])],
      (value) => set((shown) => (shown.trail = value)),
    );
    trails.value = this.shown.trail;
    const button = (label: string, text: string, act: () => void) =>
      make("button", { type: "button", "aria-label": label, title: label, click: () => set(act) }, text);
    const options: Node[] = [];
    if (this.facts.motion.solids.length > 0 || hasFlexible(this.index)) {
      options.push(toggle("3D", this.solidFirst(), (on) => void this.useSolid(on)));
    }
    options.push(trails);
    if (this.drawing.arrows.length > 0) options.push(toggle("applied forces", true, (on) => set((s) => (s.applied = on))));
    if (this.facts.reactionPeak > 0) options.push(toggle("joint forces", false, (on) => set((s) => (s.reactions = on))));
    options.push(toggle("names", false, (on) => set((s) => (s.names = on))));
    options.push(toggle("centres of mass", this.shown.centers, (on) => set((s) => (s.centers = on))));
    options.push(toggle("axes of bodies", false, (on) => set((s) => (s.frames = on))));
    this.sides.append(...SIDES.map(([key, side]) => button(`View: ${side} (key ${key})`, side, () => this.view.look?.(side))));
    options.push(
      this.sides,
      make(
        "span",
        { class: "group" },
        button("Zoom in", "+", () => this.zoom(1.25)),
        button("Zoom out", "−", () => this.zoom(0.8)),
        button("Show all", "fit", () => this.view.reset()),
      ),
    );
    return make("div", { class: "options" }, ...options);
  }

  /** Solid where the browser can, else flat with a word on why. */
  private async useSolid(on: boolean): Promise<void> {
    if (on && !this.solid) {
      const made = await solidView(this.facts, this.index);
      if (typeof made === "string") {
        this.word.textContent = `The flat drawing is shown: ${made}.`;
        this.word.hidden = false;
      } else this.solid = made;
      const chosen = this.solid?.flexible;
      if (chosen) this.elastic.append(flexibleControls(chosen, () => this.redraw(), (frame) => this.player.seek(frame)));
    }
    this.view = (on && this.solid) || this.flat;
    this.sides.hidden = !this.view.look;
    this.elastic.hidden = !this.view.flexible;
    this.name();
    this.view.fit(this.size);
    this.redraw();
  }

  private name(): void {
    const more = this.view.look ? ", shift and arrow keys turn, 1 to 4 choose a view" : "";
    this.canvas.setAttribute(
      "aria-label",
      `Drawing of the mechanism. Space plays, arrow keys step, plus and minus zoom, 0 shows all${more}.`,
    );
    this.mount.dataset.view = this.view.kind;
  }

  private zoom(factor: number): void {
    this.view.zoomBy(factor, [this.size[0] / 2, this.size[1] / 2]);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement ?? this.canvas;
    const ratio = window.devicePixelRatio || 1;
    this.size = [clientWidth, clientHeight];
    this.canvas.width = Math.round(clientWidth * ratio);
    this.canvas.height = Math.round(clientHeight * ratio);
    this.view.fit(this.size);
    this.draw();
  }

  private redraw(): void {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      this.draw();
    });
  }

  private draw(): void {
    const context = this.canvas.getContext("2d");
    if (!context || this.size[0] < 1 || this.size[1] < 1) return;
    const ratio = this.canvas.width / this.size[0];
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, ...this.size);
    this.spots = this.view.draw(context, this.player.at, this.shown);
    this.mount.dataset.row = String(this.cursor.row);
  }

  private listen(): void {
    const canvas = this.canvas;
    const fingers = new Map<number, V2>();
    const lift = (event: PointerEvent) => fingers.delete(event.pointerId);
    canvas.addEventListener("pointerdown", (event) => {
      fingers.set(event.pointerId, [event.clientX, event.clientY]);
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointerup", lift);
    canvas.addEventListener("pointercancel", lift);
    canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    canvas.addEventListener("pointermove", (event) => {
      if (fingers.has(event.pointerId)) this.moved(fingers, event);
      else this.hover([event.offsetX, event.offsetY]);
    });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    // A page that is scrolled past the drawing must not zoom it: only once it has the focus.
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("dblclick", () => {
      this.view.reset();
      this.redraw();
    });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** One finger or button turns (moves with shift, middle or right button), two fingers move and zoom. */
  private moved(fingers: Map<number, V2>, event: PointerEvent): void {
    const [from, to]: V2[] = [fingers.get(event.pointerId) ?? [0, 0], [event.clientX, event.clientY]];
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    fingers.set(event.pointerId, to);
    const move = event.shiftKey || (event.buttons & 6) !== 0;
    if (other) {
      const apart = (p: V2) => Math.max(1, Math.hypot(p[0] - other[0], p[1] - other[1]));
      const box = this.canvas.getBoundingClientRect();
      this.view.drag((to[0] - from[0]) / 2, (to[1] - from[1]) / 2, true);
      this.view.zoomBy(apart(to) / apart(from), [(to[0] + other[0]) / 2 - box.left, (to[1] + other[1]) / 2 - box.top]);
    } else this.view.drag(to[0] - from[0], to[1] - from[1], move);
    this.redraw();
  }

  private wheel(event: WheelEvent): void {
    if (document.activeElement !== this.canvas && !event.ctrlKey) return;
    event.preventDefault();
    this.view.zoomBy(Math.exp(-event.deltaY * 0.0015), [event.offsetX, event.offsetY]);
    this.redraw();
  }

  private key(event: KeyboardEvent): void {
    const action = (event.shiftKey && this.view.look ? this.turns() : this.steps())[event.key];
    if (!action || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    action();
    this.redraw();
  }

  private turns(): Record<string, () => void> {
    const turn = (dx: number, dy: number) => () => this.view.drag(dx, dy, false);
    const turns = { ArrowRight: turn(20, 0), ArrowLeft: turn(-20, 0), ArrowUp: turn(0, -20), ArrowDown: turn(0, 20) };
    // On many keyboards plus stands above shift.
    return { ...turns, "+": () => this.zoom(1.25) };
  }

  private steps(): Record<string, () => void> {
    const frame = Math.round(this.player.at);
    const sides = SIDES.map(([key, side]): [string, () => void] => [key, () => this.view.look?.(side)]);
    return {
      " ": () => this.player.toggle(),
      ArrowRight: () => this.player.seek(frame + 1),
      ArrowLeft: () => this.player.seek(frame - 1),
      Home: () => this.player.seek(0),
      End: () => this.player.seek(Infinity),
      "+": () => this.zoom(1.25),
      "-": () => this.zoom(0.8),
      "0": () => this.view.reset(),
      ...(this.view.look ? Object.fromEntries(sides) : {}),
    };
  }

  private hover(at: V2): void {
    const far = (spot: Spot) => Math.hypot(spot.at[0] - at[0], spot.at[1] - at[1]);
    const nearest = this.spots.reduce<Spot | null>((best, spot) => (!best || far(spot) < far(best) ? spot : best), null);
    this.tip.hidden = !nearest || far(nearest) > 16;
    if (this.tip.hidden || !nearest) return;
    this.tip.replaceChildren(make("b", {}, nearest.title), ...this.numbers(nearest).map((line) => make("div", {}, line)));
    const left = Math.min(nearest.at[0] + 14, this.size[0] - this.tip.offsetWidth - 6);
    this.tip.style.transform = `translate(${left}px, ${Math.max(4, nearest.at[1] - 14 - this.tip.offsetHeight)}px)`;
  }

  /** The numbers of a joint at this row. */
  private numbers(spot: Spot): string[] {
    if (spot.joint === null) return [];
    const joint = this.drawing.joints.find((candidate) => candidate.name === spot.joint);
    const value = (label: string, name: string) => {
      const found = signal(this.study, name);
      return found ? [`${label} ${withUnit(found.values[this.cursor.row], found.unit, 5)}`] : [];
    };
    return [
      joint ? joint.kind + (joint.driven ? ", driven" : "") : "",
      ...value("position", `joint.${spot.joint}.position`),
      ...value("reaction", `joint.${spot.joint}.reaction.force`),
      ...value("drive", `drive.${spot.joint}.force`),
    ];
  }
}
