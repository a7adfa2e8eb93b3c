// The moving drawing with its controls.

import type { Cursor } from "./cursor";
import { type Drawing, type Motion, signal, type Study } from "./data";
import { choice, make, toggle } from "./dom";
import { withUnit } from "./format";
import { Player } from "./player";
import type { V2 } from "./scene/camera";
import { drawLegend } from "./scene/legend";
import { Pen } from "./scene/pen";
import { frameAt } from "./scene/pose";
import { Scene, type Shown, type Spot } from "./scene/scene";

export class Stage {
  private readonly canvas = make("canvas", { tabindex: 0, role: "img" });
  private readonly tip = make("div", { class: "tip", hidden: true });
  private readonly scene: Scene;
  private readonly player: Player;
  private readonly shown: Shown;
  private spots: Spot[] = [];
  private size: V2 = [1, 1];
  private pending = false;

  constructor(
    private readonly mount: HTMLElement,
    drawing: Drawing,
    private readonly study: Study,
    private readonly motion: Motion,
    private readonly cursor: Cursor,
  ) {
    this.scene = new Scene(drawing, motion, study);
    this.player = new Player(study, motion, cursor);
    this.shown = { applied: true, reactions: false, names: false, trail: this.longestTrail() };
    this.canvas.setAttribute("aria-label", "Drawing of the mechanism. Space plays, arrow keys step, plus and minus zoom.");
    const frame = make("div", { class: "frame" }, this.canvas, this.tip);
    // A single position has nothing to play.
    mount.append(frame, ...(study.rows > 1 ? [this.player.element] : []), this.options());
    cursor.follow(() => this.redraw());
    new ResizeObserver(() => this.resize()).observe(frame);
    this.listen();
  }

  /** The path of the load where there is one, else the longest. */
  private longestTrail(): string {
    const loaded = this.scene.loadedPoints();
    const chosen = this.scene.trails.filter(({ name }) => loaded.includes(name));
    const candidates = chosen.length > 0 ? chosen : this.scene.trails;
    return candidates.reduce((best, trail) => (trail.length > best.length ? trail : best), { name: "", length: 0 }).name;
  }

  private options(): HTMLElement {
    const set = (change: (shown: Shown) => void) => {
      change(this.shown);
      this.redraw();
    };
    const trails = choice(
      "Trail of",
      [["", "no trail"], ["*", "all trails"], ...this.scene.trails.map(({ name }): [string, string] => [name, `trail of ${name}`])],
      (value) => set((shown) => (shown.trail = value)),
    );
    trails.value = this.shown.trail;
    const button = (label: string, text: string, act: () => void) =>
      make("button", { type: "button", "aria-label": label, title: label, click: () => set(act) }, text);
    const options: Node[] = [trails];
    if (this.scene.drawing.arrows.length > 0) options.push(toggle("applied forces", true, (on) => set((s) => (s.applied = on))));
    if (this.scene.hasReactions) options.push(toggle("joint forces", false, (on) => set((s) => (s.reactions = on))));
    options.push(toggle("names", false, (on) => set((s) => (s.names = on))));
    options.push(
      make(
        "span",
        { class: "group" },
        button("Zoom in", "+", () => this.zoom(1.25)),
        button("Zoom out", "−", () => this.zoom(0.8)),
        button("Show all", "fit", () => this.reset()),
      ),
    );
    return make("div", { class: "options" }, ...options);
  }

  private zoom(factor: number): void {
    this.scene.camera.zoomBy(factor, [this.size[0] / 2, this.size[1] / 2]);
  }

  private reset(): void {
    this.scene.camera.reset();
    this.scene.fit(this.size);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement ?? this.canvas;
    const ratio = window.devicePixelRatio || 1;
    this.size = [clientWidth, clientHeight];
    this.canvas.width = Math.round(clientWidth * ratio);
    this.canvas.height = Math.round(clientHeight * ratio);
    this.scene.fit(this.size);
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
    if (!context) return;
    const ratio = this.canvas.width / Math.max(1, this.size[0]);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, ...this.size);
    this.spots = this.scene.draw(context, frameAt(this.motion, this.cursor.row), this.shown);
    drawLegend(new Pen(context), this.scene.camera, this.size);
    this.mount.dataset.row = String(this.cursor.row);
  }

  private listen(): void {
    const canvas = this.canvas;
    let from: V2 | null = null;
    canvas.addEventListener("pointerdown", (event) => {
      from = [event.clientX, event.clientY];
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointerup", () => (from = null));
    canvas.addEventListener("pointercancel", () => (from = null));
    canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    canvas.addEventListener("pointermove", (event) => {
      if (from) {
        this.scene.camera.drag(event.clientX - from[0], event.clientY - from[1], event.shiftKey || event.buttons === 4);
        from = [event.clientX, event.clientY];
        this.redraw();
      } else this.hover([event.offsetX, event.offsetY]);
    });
    // A page that is scrolled past the drawing must not zoom it: only once it has the focus.
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("dblclick", () => {
      this.reset();
      this.redraw();
    });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  private wheel(event: WheelEvent): void {
    if (document.activeElement !== this.canvas && !event.ctrlKey) return;
    event.preventDefault();
    this.scene.camera.zoomBy(Math.exp(-event.deltaY * 0.0015), [event.offsetX, event.offsetY]);
    this.redraw();
  }

  private key(event: KeyboardEvent): void {
    const frame = frameAt(this.motion, this.cursor.row);
    const actions: Record<string, () => void> = {
      " ": () => this.player.toggle(),
      ArrowRight: () => this.player.seek(frame + 1),
      ArrowLeft: () => this.player.seek(frame - 1),
      Home: () => this.player.seek(0),
      End: () => this.player.seek(Infinity),
      "+": () => this.zoom(1.25),
      "-": () => this.zoom(0.8),
      "0": () => this.reset(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
    this.redraw();
  }

  private hover(at: V2): void {
    const far = (spot: Spot) => Math.hypot(spot.at[0] - at[0], spot.at[1] - at[1]);
    const nearest = this.spots.reduce<Spot | null>((best, spot) => (!best || far(spot) < far(best) ? spot : best), null);
    this.tip.hidden = !nearest || far(nearest) > 16;
    if (this.tip.hidden || !nearest) return;
    this.tip.replaceChildren(make("b", {}, nearest.title), ...this.facts(nearest).map((line) => make("div", {}, line)));
    const left = Math.min(nearest.at[0] + 14, this.size[0] - this.tip.offsetWidth - 6);
    this.tip.style.transform = `translate(${left}px, ${Math.max(4, nearest.at[1] - 14 - this.tip.offsetHeight)}px)`;
  }

  /** The numbers of a joint at this row. */
  private facts(spot: Spot): string[] {
    if (spot.joint === null) return [];
    const joint = this.scene.drawing.joints.find((candidate) => candidate.name === spot.joint);
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
