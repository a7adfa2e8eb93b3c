// What stands over and beside the part: colour bar, labels, axes of the body.

import { make } from "../dom";
import { unitShown, shown } from "../format";
import type { V2 } from "../scene/camera";
import { AXES, INK, PAPER, Pen } from "../scene/pen";
import type { Colours, Field } from "./data";
import { bandCount, stops, type Style, unit } from "./surface";

/** Room for the colour bar, px. */
export const BAR = 176;

const CAUTION = "#8a5a00";
const SOFT = "#566270";

export interface Label {
  at: V2;
  text: string;
  doubtful: boolean;
  hidden: boolean;
}

/** The bar with its numbers, at the right of a canvas of that size. */
export function drawBar(pen: Pen, field: Field, style: Style, colours: Colours, [width, height]: V2): void {
  const [left, wide] = [width - BAR + 10, 22];
  let top = 20;
  for (const line of wrapped(pen, field.unit ? `${field.name} in ${unitShown(field.unit)}` : field.name, BAR - 18)) {
    pen.text(line, [left, top], INK, 13.5);
    top += 17;
  }
  if (field.cut) {
    swatch(pen, [left, top], wide, 18, css(colours.above));
    pen.text(`above ${shown(field.high, 4)}`, [left + wide + 8, top + 13], INK);
    top += 30;
  }
  const tall = Math.min(height - top - 56, 420);
  if (tall < 40) return;
  const y = (value: number) => top + tall * (1 - (value - field.low) / (field.high - field.low));
  blocks(field, style, colours).forEach(([from, to, colour]) => {
    pen.c.fillStyle = colour;
    pen.c.fillRect(left, y(to), wide, y(from) - y(to) + 0.5);
  });
  pen.c.lineWidth = 1;
  pen.c.strokeStyle = INK;
  pen.c.strokeRect(left, top, wide, tall);
  const cutEnd = field.cut && !field.marks.some(([value]) => Math.abs(value - field.high) < 1e-9 * field.step);
  const marks = field.marks.filter(([value]) => !(cutEnd && y(value) - top < 14));
  for (const [value, text] of cutEnd ? [...marks, [field.high, shown(field.high, 4)] as [number, string]] : marks) {
    pen.line([[left + wide, y(value)], [left + wide + 4, y(value)]], 1, INK);
    pen.text(text, [left + wide + 8, y(value) + 4], INK);
  }
  const withUnit = (value: number) => `${shown(value, 4)} ${unitShown(field.unit)}`;
  pen.text(`largest ${withUnit(field.most)}`, [left, top + tall + 22], SOFT);
  pen.text(`least ${withUnit(field.least)}`, [left, top + tall + 39], SOFT);
}

/** Pieces of the bar: from, to, colour. */
function blocks(field: Field, style: Style, colours: Colours): [number, number, string][] {
  const of = stops(field, style, colours);
  const count = style.bands ? bandCount(field) : 128;
  const step = style.bands ? field.step : (field.high - field.low) / count;
  const limit = Math.max(Math.abs(field.low), Math.abs(field.high));
  return Array.from({ length: count }, (_, k): [number, number, string] => {
    const from = field.low + k * step;
    const to = Math.min(from + step, field.high);
    const share = field.signed ? 0.5 + (0.25 * (from + to)) / limit : k / Math.max(1, count - 1);
    return [from, to, css(mixed(of, share))];
  });
}

function mixed(of: number[], share: number): number[] {
  const at = Math.max(0, Math.min(1, share)) * 32;
  const k = Math.min(31, Math.floor(at));
  const [a, b] = [unit(of[k]), unit(of[k + 1])];
  return a.map((x, axis) => 255 * (x + (at - k) * (b[axis] - x)));
}

function css(colour: number[]): string {
  return `rgb(${colour.map(Math.round).join(" ")})`;
}

function swatch(pen: Pen, [x, y]: V2, width: number, height: number, colour: string): void {
  pen.polygon([[x, y], [x + width, y], [x + width, y + height], [x, y + height]], colour, INK, 1);
}

function wrapped(pen: Pen, text: string, room: number): string[] {
  pen.c.font = "13.5px system-ui, sans-serif";
  const lines: string[] = [];
  for (const word of text.split(" ")) {
    const longer = lines.length > 0 ? `${lines[lines.length - 1]} ${word}` : word;
    if (lines.length > 0 && pen.c.measureText(longer).width <= room) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Where the part is on the canvas, roughly. */
export class Cover {
  private static readonly SIZE: V2 = [80, 50];
  private readonly context = make("canvas", { width: Cover.SIZE[0], height: Cover.SIZE[1] }).getContext("2d", { willReadFrequently: true });
  private shares: Uint8ClampedArray | null = null;
  private room: V2 = [1, 1];

  /** Takes a picture of the part alone, which fills `room`. */
  take(picture: HTMLCanvasElement, room: V2): void {
    const [width, height] = Cover.SIZE;
    this.room = room;
    this.context?.clearRect(0, 0, width, height);
    this.context?.drawImage(picture, 0, 0, width, height);
    this.shares = this.context?.getImageData(0, 0, width, height).data ?? null;
  }

  /** How much of a box lies on the part. */
  share({ x, y, width, height }: Box): number {
    let sum = 0;
    for (let k = 0; k < 15; k++) sum += this.at(x + ((k % 5) / 4) * width, y + (Math.floor(k / 5) / 2) * height);
    return sum / 15;
  }

  private at(x: number, y: number): number {
    const [column, row] = [Math.floor((x / this.room[0]) * Cover.SIZE[0]), Math.floor((y / this.room[1]) * Cover.SIZE[1])];
    const inside = column >= 0 && row >= 0 && column < Cover.SIZE[0] && row < Cover.SIZE[1];
    return inside && this.shares ? this.shares[4 * (row * Cover.SIZE[0] + column) + 3] / 255 : 0;
  }
}

/** Labels with a line to their places, clear of each other and away from the middle. `before`: which of the places
 * around it each label took last time, as they should not jump about; gives those of now. */
export function drawLabels(pen: Pen, labels: Label[], cover: Cover, room: V2, before: number[]): number[] {
  const boxes: Box[] = [];
  const taken: number[] = [];
  pen.c.font = "12px system-ui, sans-serif";
  const dotsUnder = (box: Box) => labels.filter(({ at: [x, y] }) => apart(box, { x, y, width: 0, height: 0 }) < 6).length;
  labels.forEach((label, k) => {
    const around = candidates(label.at, pen.c.measureText(label.text).width + 12, room);
    const costs = around.map((box, place) => cost(box, label.at, boxes, room) + 220 * cover.share(box) + 150 * dotsUnder(box) - (place === before[k] ? 60 : 0));
    taken.push(costs.indexOf(Math.min(...costs)));
    boxes.push(around[taken[k]]);
  });
  labels.forEach((label, k) => leader(pen, label, boxes[k]));
  labels.forEach((label, k) => plate(pen, label, boxes[k]));
  return taken;
}

function cost(box: Box, at: V2, taken: Box[], room: V2): number {
  const over = taken.filter((other) => apart(box, other) < 3).length;
  const from = ([x, y]: V2) => Math.hypot(box.x + box.width / 2 - x, box.y + box.height / 2 - y);
  return 400 * over + 0.8 * from(at) - 0.3 * from([room[0] / 2, room[1] / 2]);
}

/** Boxes around a place, in twelve directions at several distances, none beyond the canvas. */
function candidates(at: V2, width: number, room: V2): Box[] {
  const height = 21;
  return [24, 50, 85, 125, 175].flatMap((distance) =>
    Array.from({ length: 12 }, (_, k): Box => {
      const [s, c] = [Math.sin((k * Math.PI) / 6), Math.cos((k * Math.PI) / 6)];
      const [x, y] = [at[0] + c * (distance + width / 2) - width / 2, at[1] + s * (distance + height / 2) - height / 2];
      return { x: Math.max(0, Math.min(room[0] - width, x)), y: Math.max(0, Math.min(room[1] - height, y)), width, height };
    }),
  );
}

/** Room between two boxes, negative where they overlap, px. */
function apart(a: Box, b: Box): number {
  return Math.max(a.x - b.x - b.width, b.x - a.x - a.width, a.y - b.y - b.height, b.y - a.y - a.height);
}

function leader(pen: Pen, label: Label, box: Box): void {
  const end: V2 = [
    Math.max(box.x, Math.min(box.x + box.width, label.at[0])),
    Math.max(box.y, Math.min(box.y + box.height, label.at[1])),
  ];
  const colour = label.doubtful ? CAUTION : INK;
  pen.bar(label.at, end, 1.3, colour);
  pen.circle(label.at, 4, label.hidden ? PAPER : colour, label.hidden ? colour : PAPER);
}

/** What is not to be trusted stands on hatched ground. */
function plate(pen: Pen, label: Label, { x, y, width, height }: Box): void {
  const colour = label.doubtful ? CAUTION : INK;
  pen.polygon([[x, y], [x + width, y], [x + width, y + height], [x, y + height]], "#fffffff0", colour, 1);
  if (label.doubtful) {
    pen.c.save();
    pen.c.beginPath();
    pen.c.rect(x, y, width, height);
    pen.c.clip();
    for (let k = 0; k < width + height; k += 7) pen.line([[x + k, y], [x + k - height, y + height]], 1.6, "#d9a63a66");
    pen.c.restore();
  }
  pen.text(label.text, [x + 6, y + 15], colour);
}

/** The axes of the body; `directions` of them on the canvas. */
export function drawAxes(pen: Pen, directions: V2[], foot: V2): void {
  directions.forEach(([x, y], k) => {
    const [, colour, name] = AXES[k];
    pen.line([foot, [foot[0] + 26 * x, foot[1] + 26 * y]], 2, colour);
    pen.text(name, [foot[0] + 36 * x - 4, foot[1] + 36 * y + 4], colour);
  });
}
