// One chart: lines of some signals over the common axis, with its own choice of signals.

import uPlot from "uplot";
import type { Cursor } from "../cursor";
import { type Signal, signal, type Study } from "../data";
import { make } from "../dom";
import { heading, shown, unitShown } from "../format";
import { Picker } from "./picker";
import { direction } from "./presets";

const COLOURS = ["#0b5fa5", "#c4510a", "#12805c", "#8a2b78", "#1d2733", "#9a7400", "#4a90c2", "#7a3b10"];
const DASHES: number[][] = [[], [7, 3], [2, 3], [9, 3, 2, 3], [14, 4], [5, 2, 1, 2], [1, 3], [16, 3, 3, 3]];
/** Nearest thing to the dashes that a border can show. */
const MARKERS = ["solid", "dashed", "dotted", "dashed", "dashed", "dotted", "dotted", "dashed"];
const FONT = "12px system-ui, sans-serif";

/** What the panels of a study share. */
export interface Shared {
  study: Study;
  cursor: Cursor;
  axis: Signal | null;
  zoom(from: Panel, range: [number, number] | null): void;
}

export class Panel {
  readonly element: HTMLElement;
  private readonly plotAt = make("div", { class: "plot" });
  private plot: uPlot | null = null;
  private following = false;
  /** Columns of the plot run against the rows: the axis falls. */
  private reversed = false;

  constructor(
    private readonly shared: Shared,
    title: string,
    private names: string[],
    remove: (panel: Panel) => void,
  ) {
    const picker = new Picker(shared.study.signals, names, (next) => {
      this.names = next;
      this.build();
    });
    const close = make("button", { type: "button", class: "quiet", "aria-label": "Remove chart", title: "Remove chart", click: () => remove(this) }, "×");
    const head = make("div", { class: "head" }, make("b", {}, title), picker.button, close);
    this.element = make("div", { class: "panel" }, head, picker.list, this.plotAt);
    // After the layout: drawing changes the height that is being observed.
    new ResizeObserver(() => setTimeout(() => this.resize())).observe(this.plotAt);
    shared.cursor.follow((row, source) => source !== this && this.follow(row));
  }

  /** Draws anew: after another axis, other signals, or the first time. */
  build(): void {
    this.plot?.destroy();
    const width = this.plotAt.clientWidth;
    if (width === 0) return;
    const signals = this.names.flatMap((name) => signal(this.shared.study, name) ?? []);
    this.plot = new uPlot(this.options(signals, width), this.columns(signals), this.plotAt);
  }

  setRange(range: [number, number] | null): void {
    if (!this.plot) return;
    const xs = this.plot.data[0];
    const [min, max] = range ?? [xs[0], xs[xs.length - 1]];
    this.following = true;
    this.plot.setScale("x", { min, max });
    this.following = false;
  }

  private columns(signals: Signal[]): uPlot.AlignedData {
    const { axis, study } = this.shared;
    // Without the last digits of a conversion, so that the chart ends at 30 and not before it.
    const tidy = (value: number) => Number(value.toPrecision(12));
    const across = Array.from({ length: study.rows }, (_, row) => (axis ? tidy(axis.values[row]) : row));
    this.reversed = direction(across) < 0;
    const column = (values: ArrayLike<number>) => {
      const list = Array.from(values, (v) => (Number.isFinite(v) ? v : null));
      return this.reversed ? list.reverse() : list;
    };
    return [column(across), ...signals.map(({ values }) => column(values))] as uPlot.AlignedData;
  }

  private options(signals: Signal[], width: number): uPlot.Options {
    const units = [...new Set(signals.map(({ unit }) => unit))];
    const axis = this.shared.axis;
    const grid = { stroke: "#e3e7eb", width: 1 };
    const ticks = { stroke: "#b9c1c9", width: 1, size: 5 };
    const values = (_: uPlot, splits: number[]) => splits.map((value) => shown(value));
    const base = { stroke: "#1d2733", font: FONT, labelFont: FONT, grid, ticks, values };
    return {
      width,
      height: Math.max(220, Math.min(300, width * 0.55)),
      scales: { x: { time: false } },
      axes: [
        { ...base, label: axis ? heading(axis.name, axis.unit) : "row", labelSize: 22, size: 34 },
        ...units.slice(0, 2).map((unit, index) => ({
          ...base,
          scale: `unit:${unit}`,
          label: unitShown(unit),
          labelSize: 18,
          side: (index === 0 ? 3 : 1) as uPlot.Axis.Side,
          grid: { ...grid, show: index === 0 },
          size: (_: uPlot, texts: string[] | null) => 14 + 7 * Math.max(3, ...(texts ?? []).map((text) => text.length)),
        })),
      ],
      series: [
        { label: axis ? heading(axis.name, axis.unit) : "row", value: (_, v) => shown(v) },
        ...signals.map((one, index) => ({
          label: heading(one.name, one.unit),
          scale: `unit:${one.unit}`,
          stroke: COLOURS[index % COLOURS.length],
          dash: DASHES[index % DASHES.length],
          width: 1.8,
          pxAlign: 0,
          points: { show: false },
          value: (_: uPlot, v: number | null) => shown(v),
        })),
      ],
      cursor: { y: false, drag: { x: true, y: false } },
      legend: { live: true, markers: { width: 2, dash: (_, index) => MARKERS[(index - 1) % MARKERS.length] } },
      hooks: {
        ready: [() => this.follow(this.shared.cursor.row)],
        setCursor: [(plot) => this.moved(plot)],
        setScale: [(plot, key) => key === "x" && this.zoomed(plot)],
      },
    };
  }

  /** The reader points at the chart: everything goes to that row. */
  private moved(plot: uPlot): void {
    const at = plot.cursor.idx;
    if (this.following || plot.status !== 1) return;
    // The pointer has left: back to the row that is shown.
    if (at === null || at === undefined) return this.follow(this.shared.cursor.row);
    if (!plot.cursor.event) return;
    this.shared.cursor.set(this.row(at), this);
  }

  private zoomed(plot: uPlot): void {
    const { min, max } = plot.scales.x;
    if (this.following || min === undefined || max === undefined || min === null || max === null) return;
    this.shared.zoom(this, [min, max]);
  }

  private follow(row: number): void {
    const plot = this.plot;
    if (!plot || plot.status !== 1) return;
    const at = this.row(row);
    const left = plot.valToPos(plot.data[0][at], "x");
    this.following = true;
    const seen = left >= 0 && left <= plot.over.clientWidth;
    plot.setCursor({ left: seen ? left : -10, top: seen ? 4 : -10 }, false);
    plot.setLegend({ idx: at }, false);
    this.following = false;
  }

  /** From the row of the table to the place in the chart, and back. */
  private row(at: number): number {
    return this.reversed ? this.shared.study.rows - 1 - at : at;
  }

  private resize(): void {
    const width = this.plotAt.clientWidth;
    if (!this.plot) this.build();
    else if (width > 0 && width !== this.plot.width) {
      this.plot.setSize({ width, height: this.plot.height });
      this.follow(this.shared.cursor.row);
    }
  }
}
