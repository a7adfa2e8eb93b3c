// Play, pause, scrub, speed and loop: moves the cursor of a study from frame to frame.

import type { Cursor } from "./cursor";
import { type Motion, signal, type Study } from "./data";
import { choice, make } from "./dom";
import { withUnit } from "./format";
import { frameAt, frameCount, placeIn } from "./scene/pose";

/** A sweep has no clock of its own: from end to end it takes this long, s. */
const SWEEP_SECONDS = 4;

type Loop = "swing" | "repeat" | "once";

export class Player {
  readonly element: HTMLElement;
  private readonly button: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private readonly readout: HTMLElement;
  /** Where the drawing is, in frames; between two frames while it plays. */
  at = 0;
  /** Seconds from the start at which each frame is shown. */
  private readonly clock: Float64Array;
  private listeners: (() => void)[] = [];
  private playing = false;
  private speed = 1;
  private loop: Loop;
  private forward = true;
  private last = 0;

  constructor(
    private readonly study: Study,
    private readonly motion: Motion,
    private readonly cursor: Cursor,
  ) {
    this.clock = clock(study, motion);
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
    cursor.follow((row, source) => this.moved(row, source));
    this.show();
  }

  /** Tells whenever the drawing is to be somewhere else. */
  follow(listener: () => void): void {
    this.listeners.push(listener);
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
    for (const listener of this.listeners) listener();
  }

  stop(): void {
    if (this.playing) this.toggle();
  }

  private tick(now: number): void {
    if (!this.playing) return;
    // A tab in the background wakes up late; that is not time to catch up with.
    const elapsed = Math.min(0.25, (now - this.last) / 1000);
    this.last = now;
    const step = elapsed * this.speed;
    const next = timeAt(this.clock, this.at) + (this.forward ? step : -step);
    this.seek(placeIn(this.clock, this.turned(next, this.clock[this.clock.length - 1])));
    requestAnimationFrame((then) => this.tick(then));
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

  private moved(row: number, source: unknown): void {
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

/** True time where rows have one; else even steps. */
function clock(study: Study, motion: Motion): Float64Array {
  const time = study.axis[0] === "time" ? signal(study, "time")?.values : undefined;
  const last = motion.rows[motion.rows.length - 1];
  const seconds = (row: number) => (time ? time[row] - time[motion.rows[0]] : (SWEEP_SECONDS * row) / Math.max(1, last));
  const rising = Float64Array.from(motion.rows, seconds);
  return rising.every((at, k) => k === 0 || at >= rising[k - 1]) && rising[rising.length - 1] > 0
    ? rising
    : Float64Array.from(motion.rows, (_, k) => (SWEEP_SECONDS * k) / Math.max(1, motion.rows.length - 1));
}

/** The time of a place between two frames. */
function timeAt(clock: Float64Array, at: number): number {
  const low = Math.min(Math.floor(at), clock.length - 1);
  const high = Math.min(low + 1, clock.length - 1);
  return clock[low] + (clock[high] - clock[low]) * (at - low);
}
