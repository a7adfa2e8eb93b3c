// A searchable list of all signals with a box to tick on each.

import type { Signal } from "../data";
import { make } from "../dom";
import { unitShown } from "../format";

export class Picker {
  readonly button: HTMLButtonElement;
  readonly list: HTMLElement;
  private readonly chosen: Set<string>;
  private readonly search = make("input", { type: "search", placeholder: "Search signals, e.g. reaction B", "aria-label": "Search signals" });
  private readonly items = make("div", { class: "items", role: "group", "aria-label": "Signals" });
  private filled = false;

  constructor(
    private readonly signals: Signal[],
    names: string[],
    private readonly change: (names: string[]) => void,
  ) {
    this.chosen = new Set(names);
    this.button = make("button", { type: "button", class: "quiet", "aria-expanded": "false", click: () => this.toggle() }, "signals…");
    this.list = make("div", { class: "picker", hidden: true }, this.search, this.items);
    this.search.addEventListener("input", () => this.filter());
    this.list.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      this.toggle();
      this.button.focus();
    });
  }

  private toggle(): void {
    this.fill();
    this.list.hidden = !this.list.hidden;
    this.button.setAttribute("aria-expanded", String(!this.list.hidden));
    if (!this.list.hidden) this.search.focus();
  }

  /** Hundreds of entries a chart are made only when somebody looks. */
  private fill(): void {
    if (this.filled) return;
    this.filled = true;
    this.items.append(...this.signals.map((signal) => this.item(signal)));
  }

  private item({ name, unit }: Signal): HTMLElement {
    const box = make("input", { type: "checkbox" });
    box.checked = this.chosen.has(name);
    box.addEventListener("change", () => {
      if (box.checked) this.chosen.add(name);
      else this.chosen.delete(name);
      this.change([...this.chosen]);
    });
    return make("label", { "data-name": name.toLowerCase() }, box, make("span", {}, name), make("small", {}, unitShown(unit)));
  }

  /** Every word must occur somewhere in the name. */
  private filter(): void {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const item of this.items.children) {
      const name = (item as HTMLElement).dataset.name ?? "";
      (item as HTMLElement).hidden = !words.every((word) => name.includes(word));
    }
  }
}
