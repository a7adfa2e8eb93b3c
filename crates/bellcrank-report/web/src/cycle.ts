// A line in the cycle chart at the instant that is shown.

import type { Cursor } from "./cursor";
import { signal, type Study } from "./data";

export function followCycle(index: number, study: Study, cursor: Cursor): void {
  const svg = document.querySelector<SVGSVGElement>(`[data-cycle="${index}"] svg`);
  const time = signal(study, "time");
  if (!svg || !time) return;
  const [x0, x1, t0, t1] = [svg.dataset.x0, svg.dataset.x1, svg.dataset.t0, svg.dataset.t1].map(Number);
  const line = document.createElementNS(svg.namespaceURI, "line");
  line.setAttribute("class", "now");
  line.setAttribute("y1", svg.dataset.top ?? "0");
  line.setAttribute("y2", svg.dataset.bottom ?? "0");
  svg.append(line);
  const show = (row: number) => {
    const x = (x0 + ((time.values[row] - t0) / (t1 - t0)) * (x1 - x0)).toFixed(2);
    line.setAttribute("x1", x);
    line.setAttribute("x2", x);
  };
  show(cursor.row);
  cursor.follow(show);
}
