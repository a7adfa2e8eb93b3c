// The designs of a sweep: parallel axes to choose by, dots to see what was chosen.

import type { Designs } from "../data";
import { choice, make } from "../dom";
import { Selection } from "./choice";
import { Dots } from "./dots";
import { Rulers } from "./rulers";

export class Explorer {
  constructor(root: HTMLElement, designs: Designs) {
    const selection = new Selection(designs);
    const last = designs.columns.length - 1;
    const rulers = new Rulers(designs, selection, last);
    const dots = new Dots(designs, selection, ...start(designs));
    const count = make("span", { class: "hint", "aria-live": "polite" });
    const tell = () => {
      const kept = designs.rows < designs.total ? ` shown of ${designs.total}` : "";
      count.textContent = `${selection.count} of ${designs.rows} designs${kept} pass`;
    };
    selection.follow(tell);
    tell();
    const clear = make("button", { type: "button", click: () => selection.clear() }, "All designs");
    const colour = chooser("Colour", designs, rulers.colour, (column) => {
      rulers.colour = column;
      rulers.draw();
    });
    const axis = (label: string, which: "x" | "y") =>
      chooser(label, designs, dots[which], (column) => {
        dots[which] = column;
        dots.draw();
      });
    root.append(
      make("div", { class: "options" }, colour, clear, count),
      rulers.element,
      make("div", { class: "options" }, axis("Across", "x"), axis("Up", "y")),
      dots.element,
    );
    rulers.draw();
    dots.draw();
  }
}

/** The responses of the front; else the first parameter and the first response. */
function start({ columns, front, inputs }: Designs): [number, number] {
  const place = (name: string | undefined, otherwise: number) => {
    const found = columns.findIndex((column) => column.name === name);
    return found < 0 ? otherwise : found;
  };
  return [place(front?.x, 0), place(front?.y, Math.min(inputs, columns.length - 1))];
}

function chooser(label: string, { columns }: Designs, chosen: number, change: (column: number) => void): HTMLElement {
  const options = columns.map(({ name }, index): [string, string] => [String(index), name]);
  const select = choice(label, options, (value) => change(Number(value)));
  select.value = String(chosen);
  return make("label", { class: "toggle" }, label, select);
}
