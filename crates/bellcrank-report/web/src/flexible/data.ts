// Flexible bodies as the Rust side packed them (src/html/flexible/), unpacked.

import type { Colours, Field } from "../contour/data";
import type { V3 } from "../data";
import { Integers, threefold } from "../integers";
import { gunzipped } from "../solid/loading";

/** What colours mean in every row: numbers in display units, `factor` is the SI value of one. */
export type Legend = Omit<Field, "values" | "leastAt" | "mostAt"> & { factor: number };

/** A hot spot with its stress in each frame, display units. */
export interface Spot {
  label: string;
  node: number;
  doubtful: boolean;
  history: Float32Array;
}

/** What the body does when a coordinate is 1; nothing where that is too little to be seen. */
export interface Column {
  /** Displacement in m: x, y, z node by node. */
  move: Float32Array | null;
  /** Stress in Pa: all xx, then all yy, zz, xy, yz, zx. */
  stress: Float32Array | null;
  /** The coordinate in each frame. */
  coordinate: Float32Array;
}

export interface FlexibleBody {
  name: string;
  /** Index in the drawing. */
  body: number | null;
  /** x, y, z node by node, m, axes of the floating frame. */
  places: Float32Array;
  triangles: Uint32Array;
  edges: Uint32Array;
  outline: Uint32Array;
  low: V3;
  high: V3;
  axes: [V3, V3, V3];
  columns: Column[];
  /** Floating frame in each frame of the drawing: x, y, z, then the turn w, x, y, z. */
  poses: Float32Array[];
  spots: Spot[];
  /** Frame of the largest stress. */
  worst: number;
}

export interface Flexible {
  bodies: FlexibleBody[];
  colours: Colours;
  stress: Legend;
  displacement: Legend;
  /** Times the displacement that is easily seen. */
  usual: number;
}

interface PackedColumn {
  moveStep: number;
  moveWidth: number;
  stressStep: number;
  stressWidth: number;
}

interface PackedBody extends Pick<FlexibleBody, "name" | "body" | "low" | "high" | "worst"> {
  key: string;
  nodes: number;
  triangles: number;
  edges: number;
  outline: number;
  columns: PackedColumn[];
  frames: number;
  marks: Omit<Spot, "history">[];
}

export interface PackedFlexible extends Pick<Flexible, "stress" | "displacement" | "usual"> {
  study: number;
  bodies: PackedBody[];
}

interface Catalogue {
  colours: Colours;
  studies: PackedFlexible[];
}

function catalogue(): Catalogue | null {
  const text = document.getElementById("bellcrank-flexible")?.textContent;
  return text ? (JSON.parse(text) as Catalogue) : null;
}

/** Whether a study has flexible bodies in this page. */
export function hasFlexible(study: number): boolean {
  return catalogue()?.studies.some((of) => of.study === study) ?? false;
}

/** The flexible bodies of a study with their numbers; nothing where it has none. */
export async function readFlexible(study: number): Promise<Flexible | null> {
  const all = catalogue();
  const packed = all?.studies.find((of) => of.study === study);
  if (!all || !packed) return null;
  const bodies = await Promise.all(packed.bodies.map(readBody));
  return { bodies, colours: all.colours, stress: packed.stress, displacement: packed.displacement, usual: packed.usual };
}

async function readBody(packed: PackedBody): Promise<FlexibleBody> {
  const text = document.getElementById(`bellcrank-flexible-${packed.key}`)?.textContent ?? "";
  const bytes = new Uint8Array(await new Response(gunzipped(text)).arrayBuffer());
  return unpacked(packed, new Integers(bytes));
}

/** In the order in which it was written. */
function unpacked(packed: PackedBody, numbers: Integers): FlexibleBody {
  const { name, body, low, high, worst, nodes, frames } = packed;
  const places = numbers.places(nodes, low, high);
  const triangles = numbers.next(3 * packed.triangles, 4);
  const edges = numbers.next(2 * packed.edges, 4);
  const outline = numbers.next(2 * packed.outline, 4);
  const shapes = packed.columns.map((column) => shape(column, nodes, numbers));
  const columns = shapes.map((of): Column => ({ ...of, coordinate: numbers.floats(frames) }));
  const poses = Array.from({ length: 7 }, () => numbers.floats(frames));
  const spots = packed.marks.map((mark): Spot => ({ ...mark, history: numbers.floats(frames) }));
  const axes: FlexibleBody["axes"] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  return { name, body, places, triangles, edges, outline, low, high, axes, columns, poses, spots, worst };
}

function shape(column: PackedColumn, nodes: number, numbers: Integers): Pick<Column, "move" | "stress"> {
  const { moveWidth, moveStep, stressWidth, stressStep } = column;
  // All three components are one list of differences.
  const flat = moveWidth > 0 ? numbers.signed(3 * nodes, moveWidth, moveStep) : null;
  const move = flat && threefold(nodes, (k) => flat.subarray(k * nodes, (k + 1) * nodes));
  return { move, stress: stressWidth > 0 ? numbers.signed(6 * nodes, stressWidth, stressStep) : null };
}
