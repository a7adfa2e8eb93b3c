// A canvas that is sharp on every screen, and round numbers for its axes.

import { make } from "../dom";

export const INK = "#1d2733";
export const SOFT = "#566270";
export const FAINT = "#dfe4e8";
export const FRONT = "#c4510a";
export const FONT = "12px system-ui, sans-serif";

export class Sheet {
  readonly canvas: HTMLCanvasElement = make("canvas", {});
  readonly pen: CanvasRenderingContext2D;
  width = 0;
  height = 0;

  constructor(label: string) {
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", label);
    this.pen = this.canvas.getContext("2d")!;
  }

  /** Clears, and takes that size in CSS pixels. */
  reset(width: number, height: number): CanvasRenderingContext2D {
    const ratio = window.devicePixelRatio || 1;
    [this.width, this.height] = [width, height];
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.canvas.style.width = `${width}px`;
    this.canvas.style.height = `${height}px`;
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.pen.clearRect(0, 0, width, height);
    this.pen.font = FONT;
    return this.pen;
  }

  at(event: PointerEvent): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
}

/** Smallest and largest finite value; never empty. */
export function span(values: ArrayLike<number>, margin = 0): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    if (!Number.isFinite(value)) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (low > high) return [-1, 1];
  const half = (high - low) / 2;
  if (half < 1e-9 * Math.max(Math.abs(low), 1e-3)) return [low - Math.max(Math.abs(low) * 0.1, 1e-9), high + Math.max(Math.abs(high) * 0.1, 1e-9)];
  return [low - margin * 2 * half, high + margin * 2 * half];
}

/** About `count` round numbers within the span. */
export function marks([low, high]: [number, number], count: number): number[] {
  const raw = (high - low) / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = ([1, 2, 5].find((lead) => lead * power >= raw * (1 - 1e-9)) ?? 10) * power;
  const found: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) found.push(Number((i * step).toPrecision(12)));
  return found;
}

/** From blue over grey to orange, as in the pictures. */
export function tint(share: number): string {
  const stops = [
    [11, 95, 165],
    [150, 150, 150],
    [196, 81, 10],
  ];
  const along = 2 * Math.min(1, Math.max(0, share));
  const from = along < 1 ? 0 : 1;
  const mix = (k: number) => Math.round(stops[from][k] + (along - from) * (stops[from + 1][k] - stops[from][k]));
  return `rgb(${mix(0)} ${mix(1)} ${mix(2)})`;
}

/** The end of a text that is too wide says more than its beginning. */
export function fitted(pen: CanvasRenderingContext2D, text: string, width: number): string {
  if (pen.measureText(text).width <= width) return text;
  let kept = text;
  while (kept.length > 2 && pen.measureText(`…${kept}`).width > width) kept = kept.slice(1);
  return `…${kept}`;
}

/** Acts when the element gets another width, after the layout: the act may change its height. */
export function whenWide(element: HTMLElement, act: () => void): void {
  let width = element.clientWidth;
  new ResizeObserver(() => {
    if (element.clientWidth === width) return;
    width = element.clientWidth;
    setTimeout(act);
  }).observe(element);
}
