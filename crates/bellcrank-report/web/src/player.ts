// Play, pause, scrub, speed and loop: moves the cursor of a study from frame to frame.

import type { Cursor } from "./cursor";
import { type Motion, signal, type Study } from "./data";
import { choice, make } from "./dom";
import { withUnit } from "./format";
import { frameAt, frameCount } from "./scene/pose";

/** A sweep has no clock of its own: from end to end it takes this long, s. */
const SWEEP_SECONDS = 4;

type Loop = "swing" | "repeat" | "once";

export class Player {
  readonly element: HTMLElement;
  private readonly button: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private readonly readout: HTMLElement;
  private playing = false;
  private speed = 1;
  private loop: Loop;
  private forward = true;
  private at = 0;
  private last = 0;

  constructor(
    private readonly study: Study,
    private readonly motion: Motion,
    private readonly cursor: Cursor,
  ) {
    const inTime = study.axis[0] === "time";
    this.loop = inTime ? "repeat" : "swing";
    this.button = make("button", { type: "button", class: "play", "aria-label": "Play", click: () => this.toggle() }, "▶");
    this.slider = make("input", { type: "range", min: 0, max: frameCount(motion) - 1, step: 1, value: 0, "aria-label": "Position of the drawing" });
    this.slider.addEventListener("input", () => this.seek(Number(this.slider.value)));
    this.readout = make("output", { class: "readout" });
    const speeds = choice("Speed", [["0.25", "¼×"], ["0.5", "½×"], ["1", "1×"], ["2", "2×"], ["4", "4×"]], (v) => (this.speed = Number(v)));
    speeds.value = "1";
    const loops = choice("At the end", [["swing", "back and forth"], ["repeat", "repeat"], ["once", "stop"]], (v) => (this.loop = v as Loop));
    loops.value = this.loop;
    const step = (label: string, text: string, by: number) =>
      make("button", { type: "button", "aria-label": label, title: label, click: () => this.seek(Math.round(this.at) + by) }, text);
    this.element = make(
      "div",
      { class: "player" },
      this.button, step("One step back", "‹", -1), this.slider, step("One step on", "›", 1), this.readout, speeds, loops,
    );
    cursor.follow((row, source) => this.follow(row, source));
    this.show();
  }

  toggle(): void {
    this.playing = !this.playing;
    this.button.textContent = this.playing ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", this.playing ? "Pause" : "Play");
    if (!this.playing) return;
    const end = frameCount(this.motion) - 1;
    if (this.at >= end && this.loop !== "swing") this.at = 0;
    this.last = performance.now();
    requestAnimationFrame((now) => this.tick(now));
  }

  seek(frame: number): void {
    this.at = Math.max(0, Math.min(frameCount(this.motion) - 1, frame));
    this.cursor.set(this.motion.rows[Math.round(this.at)], this);
    this.show();
  }

  stop(): void {
    if (this.playing) this.toggle();
  }

  private tick(now: number): void {
    if (!this.playing) return;
    // A tab in the background wakes up late; that is not time to catch up with.
    const elapsed = Math.min(0.25, (now - this.last) / 1000);
    this.last = now;
    const frames = frameCount(this.motion) - 1;
    const step = ((elapsed * this.speed) / this.seconds()) * frames;
    this.seek(this.turned(this.at + (this.forward ? step : -step), frames));
    requestAnimationFrame((next) => this.tick(next));
  }

  /** What lies beyond an end, by the kind of loop. */
  private turned(at: number, end: number): number {
    if (end <= 0) return 0;
    if (this.loop === "swing") {
      if (at > end || at < 0) this.forward = at < 0;
      return at > end ? Math.max(0, 2 * end - at) : Math.abs(at);
    }
    this.forward = true;
    if (at <= end) return Math.max(0, at);
    if (this.loop === "once") this.stop();
    return this.loop === "once" ? end : at % end;
  }

  /** How long one pass takes: the true time where there is one. */
  private seconds(): number {
    const time = this.study.axis[0] === "time" ? signal(this.study, "time") : undefined;
    const span = time ? time.values[this.study.rows - 1] - time.values[0] : SWEEP_SECONDS;
    return span > 0 ? span : SWEEP_SECONDS;
  }

  private follow(row: number, source: unknown): void {
    if (source === this) return;
    this.stop();
    this.at = frameAt(this.motion, row);
    this.show();
  }

  private show(): void {
    const frame = Math.round(this.at);
    const row = this.motion.rows[frame];
    this.slider.value = String(frame);
    const text = this.study.axis
      .map((name) => signal(this.study, name))
      .map((axis) => (axis ? `${axis.name} = ${withUnit(axis.values[row], axis.unit, 4)}` : ""))
      .join(", ");
    this.readout.textContent = text || `row ${row}`;
    this.slider.setAttribute("aria-valuetext", this.readout.textContent);
  }
}
