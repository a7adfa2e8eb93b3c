// What of the flexible bodies is shown, and how much deformed.

import { choice, make, toggle } from "../dom";
import { shown } from "../format";

/** What the reader has chosen. */
export interface FlexibleChoice {
  colour: "stress" | "displacement" | "plain";
  /** Times the displacement; 1 is true to scale. */
  factor: number;
  /** The factor at which the deformation is easily seen. */
  readonly usual: number;
  spots: boolean;
  undeformed: boolean;
  edges: boolean;
  /** Frame of the largest stress. */
  readonly worst: number;
}

/** The largest factor of the slider; further where even the usual one is. */
const MOST = 1000;

/** A row of controls; `changed` is called after each change, `seek` moves the drawing to a frame. */
export function flexibleControls(chosen: FlexibleChoice, changed: () => void, seek: (frame: number) => void): HTMLElement {
  const powers = Math.log10(Math.max(MOST, 5 * chosen.usual));
  const slider = make("input", { type: "range", min: 0, max: 100, step: 0.5, "aria-label": "Deformation of flexible bodies" });
  const told = make("output", { class: "factor" });
  const set = (factor: number) => {
    chosen.factor = factor;
    if (document.activeElement !== slider) slider.value = String((100 * Math.log10(factor)) / powers);
    told.textContent = words(factor, chosen.usual);
    changed();
  };
  slider.addEventListener("input", () => set(rounded(10 ** ((powers * Number(slider.value)) / 100))));
  const colours: [FlexibleChoice["colour"], string][] = [["stress", "von Mises stress"], ["displacement", "displacement"], ["plain", "plain"]];
  const button = (label: string, text: string, act: () => void) =>
    make("button", { type: "button", "aria-label": label, title: label, click: act }, text);
  const flag = (name: "spots" | "undeformed" | "edges", label: string) =>
    toggle(label, chosen[name], (on) => {
      chosen[name] = on;
      changed();
    });
  const row = make(
    "div",
    { class: "options flexible" },
    make("span", {}, "Flexible bodies"),
    choice("Colours of flexible bodies", colours, (value) => {
      chosen.colour = value as FlexibleChoice["colour"];
      changed();
    }),
    make("span", {}, "deformation"), slider, told,
    button("Deformation true to scale", "true", () => set(1)),
    button("Deformation drawn so that it is seen", "automatic", () => set(chosen.usual)),
    flag("spots", "hot spots"), flag("undeformed", "undeformed"), flag("edges", "element edges"),
    button("Go to the largest stress", "largest", () => seek(chosen.worst)),
  );
  set(chosen.factor);
  return row;
}

function words(factor: number, usual: number): string {
  if (factor === 1) return "× 1, true to scale";
  return `× ${shown(factor, 3)}, ${factor === usual ? "automatic" : "exaggerated"}`;
}

/** Two digits are enough to set. */
function rounded(factor: number): number {
  return Number(factor.toPrecision(2));
}
