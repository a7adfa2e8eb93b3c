// The charts of a study over a common axis.

import type { Cursor } from "../cursor";
import type { Study } from "../data";
import { choice, make } from "../dom";
import { heading } from "../format";
import { Panel, type Shared } from "./panel";
import { axes, presets } from "./presets";

export class Curves {
  private readonly grid = make("div", { class: "panels" });
  private readonly panels: Panel[] = [];
  private readonly shared: Shared;

  constructor(mount: HTMLElement, study: Study, cursor: Cursor) {
    const across = axes(study);
    this.shared = { study, cursor, axis: across[0] ?? null, zoom: (from, range) => this.zoom(from, range) };
    const pick = choice("Horizontal axis", across.map(({ name, unit }) => [name, heading(name, unit)]), (name) => {
      this.shared.axis = across.find((one) => one.name === name) ?? null;
      this.panels.forEach((panel) => panel.build());
    });
    const add = make("button", { type: "button", click: () => this.add("Chart", []).build() }, "add a chart");
    const reset = make("button", { type: "button", click: () => this.zoom(null, null) }, "reset zoom");
    const hint = make("span", { class: "hint" }, "Drag across a chart to zoom, double-click to go back. Pointing at a curve moves the drawing.");
    mount.append(make("div", { class: "options" }, make("label", { class: "toggle" }, "over ", pick), reset, add, hint), this.grid);
    for (const { title, names } of presets(study)) this.add(title, names);
    this.panels.forEach((panel) => panel.build());
  }

  private add(title: string, names: string[]): Panel {
    const panel = new Panel(this.shared, title, names, (gone) => this.remove(gone));
    this.panels.push(panel);
    this.grid.append(panel.element);
    return panel;
  }

  private remove(panel: Panel): void {
    panel.element.remove();
    this.panels.splice(this.panels.indexOf(panel), 1);
  }

  private zoom(from: Panel | null, range: [number, number] | null): void {
    this.panels.filter((panel) => panel !== from).forEach((panel) => panel.setRange(range));
  }
}
