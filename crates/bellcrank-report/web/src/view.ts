// What the stage asks of a drawing, flat or solid.

import type { FlexibleChoice } from "./flexible/controls";
import type { V2 } from "./scene/camera";

/** What is drawn beside the machine itself. */
export interface Shown {
  applied: boolean;
  reactions: boolean;
  names: boolean;
  /** Centres of mass. */
  centers: boolean;
  /** Axes of the bodies. */
  frames: boolean;
  /** `BODY.POINT`, `*` for all moving points, or nothing. */
  trail: string;
}

/** A named place on the canvas, for hovering. */
export interface Spot {
  at: V2;
  title: string;
  joint: string | null;
}

/** Where a solid drawing is seen from. */
export type Side = "iso" | "front" | "top" | "side";

export interface View {
  readonly kind: "flat" | "solid";
  /** Shows all of the motion in a canvas of that size, px. */
  fit(size: V2): void;
  /** Draws frame `at`, which may lie between two, and gives the places that have a name. */
  draw(context: CanvasRenderingContext2D, at: number, shown: Shown): Spot[];
  drag(dx: number, dy: number, move: boolean): void;
  zoomBy(factor: number, at: V2): void;
  reset(): void;
  look?(from: Side): void;
  /** How flexible bodies are shown, where there are some. */
  readonly flexible?: FlexibleChoice;
}
