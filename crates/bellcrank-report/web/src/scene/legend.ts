// What gives a drawing its size and its directions: a scale bar in the plane, axes in space.

import type { Eye, V2 } from "./camera";
import { AXES, INK, type Pen } from "./pen";

export function drawLegend(pen: Pen, camera: Eye, size: V2): void {
  scaleBar(pen, camera, size);
  if (!camera.planar) axes(pen, camera, size);
}

function scaleBar(pen: Pen, camera: Eye, [, height]: V2): void {
  const wanted = 110 / camera.scale;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const length = ([5, 2, 1].find((lead) => lead * power <= wanted) ?? 1) * power;
  const pixels = length * camera.scale;
  const [x, y] = [16, height - 16];
  pen.line([[x, y - 4], [x, y], [x + pixels, y], [x + pixels, y - 4]], 1.4, INK);
  const text = length < 1 ? `${Number((length * 1000).toPrecision(2))} mm` : `${Number(length.toPrecision(2))} m`;
  pen.text(text, [x + pixels + 7, y + 3], INK, 11);
}

function axes(pen: Pen, camera: Eye, [width, height]: V2): void {
  const at: V2 = [width - 50, height - 46];
  for (const [axis, colour, name] of AXES) {
    const [dx, dy] = camera.direction(axis);
    pen.arrow(at, [at[0] + 32 * dx, at[1] + 32 * dy], colour);
    pen.text(name, [at[0] + 40 * dx - 3, at[1] + 40 * dy + 4], colour, 12, "600");
  }
}
