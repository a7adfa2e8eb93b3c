// A marker on each force hodograph at the row that is shown.

import type { Cursor } from "./cursor";
import { signal, type Study } from "./data";

export function followHodographs(index: number, study: Study, cursor: Cursor): void {
  document.querySelectorAll<HTMLElement>(`[data-hodograph="${index}"]`).forEach((figure) => follow(figure, study, cursor));
}

function follow(figure: HTMLElement, study: Study, cursor: Cursor): void {
  const svg = figure.querySelector("svg");
  const { joint, x, y } = figure.dataset;
  const across = signal(study, `joint.${joint}.reaction.${x}`);
  const up = signal(study, `joint.${joint}.reaction.${y}`);
  if (!svg || !across || !up) return;
  const [ox, oy, scale] = [svg.dataset.ox, svg.dataset.oy, svg.dataset.scale].map(Number);
  const marker = document.createElementNS(svg.namespaceURI, "circle");
  marker.setAttribute("r", "4.5");
  marker.setAttribute("class", "marker");
  svg.append(marker);
  const show = (row: number) => {
    const [a, b] = [across.values[row], up.values[row]];
    const known = Number.isFinite(a) && Number.isFinite(b);
    marker.setAttribute("visibility", known ? "visible" : "hidden");
    if (!known) return;
    marker.setAttribute("cx", (ox + a * scale).toFixed(2));
    marker.setAttribute("cy", (oy - b * scale).toFixed(2));
  };
  show(cursor.row);
  cursor.follow(show);
}
