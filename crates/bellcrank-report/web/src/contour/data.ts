// What the Rust side packed of the parts (src/html/contours/), unpacked.

import type { V3 } from "../data";
import { Integers, threefold } from "../integers";
import { gunzipped } from "../solid/loading";

/** Colours from low to high as 0xrrggbb; what lies above the end, and where there is no number, as bytes. */
export interface Colours {
  even: number[];
  signed: number[];
  rainbow: number[];
  above: V3;
  none: V3;
}

/** Numbers in display units; places in m. */
export interface Field {
  name: string;
  unit: string;
  low: number;
  high: number;
  step: number;
  least: number;
  most: number;
  leastAt: number;
  mostAt: number;
  signed: boolean;
  /** Whether values lie above `high`, where the colours end. */
  cut: boolean;
  marks: [number, string][];
  values: Float32Array;
}

export interface Shape {
  name: string;
  swings: boolean;
  /** Times the displacement that is easily seen. */
  usual: number;
  /** x, y, z node by node. */
  displacement: Float32Array;
  fields: Field[];
}

export interface Mark {
  label: string;
  node: number;
  doubtful: boolean;
}

export interface Part {
  title: string;
  /** x, y, z node by node. */
  places: Float32Array;
  triangles: Uint32Array;
  edges: Uint32Array;
  /** Sharp edges. */
  outline: Uint32Array;
  /** Numbers of the nodes in mesh files, where there are some. */
  numbers: Uint32Array | null;
  low: V3;
  high: V3;
  /** Right, up and towards the reader: the plan of the part. */
  axes: [V3, V3, V3];
  shapes: Shape[];
  marks: Mark[];
}

type PackedField = Omit<Field, "values">;
type PackedShape = Omit<Shape, "displacement" | "fields"> & { most: number; fields: PackedField[] };

interface PackedPart extends Pick<Part, "title" | "low" | "high" | "axes" | "marks"> {
  key: string;
  nodes: number;
  triangles: number;
  edges: number;
  outline: number;
  numbered: boolean;
  shapes: PackedShape[];
}

export interface Catalogue {
  colours: Colours;
  tilt: [number, number];
  contours: PackedPart[];
}

/** Less than any number: there is none at a node. */
export const NO_VALUE = -1e30;

export function readCatalogue(): Catalogue | null {
  const text = document.getElementById("bellcrank-contours")?.textContent;
  return text ? (JSON.parse(text) as Catalogue) : null;
}

/** The part of that key with its numbers. */
export async function readPart(catalogue: Catalogue, key: string): Promise<Part> {
  const packed = catalogue.contours.find((part) => part.key === key);
  const text = document.getElementById(`bellcrank-contour-${key}`)?.textContent;
  if (!packed || !text) throw new Error("this page does not hold its numbers");
  const bytes = new Uint8Array(await new Response(gunzipped(text)).arrayBuffer());
  return unpacked(packed, new Integers(bytes));
}

function unpacked(packed: PackedPart, numbers: Integers): Part {
  const { title, low, high, axes, marks, nodes } = packed;
  const places = numbers.places(nodes, low, high);
  const triangles = numbers.next(3 * packed.triangles, 4);
  const edges = numbers.next(2 * packed.edges, 4);
  const outline = numbers.next(2 * packed.outline, 4);
  const own = packed.numbered ? numbers.next(nodes, 4) : null;
  const shapes = packed.shapes.map((shape) => unpackedShape(shape, nodes, numbers));
  return { title, places, triangles, edges, outline, numbers: own, low, high, axes, shapes, marks };
}

function unpackedShape(shape: PackedShape, nodes: number, numbers: Integers): Shape {
  const per = shape.most / 32_767;
  const displacement = threefold(nodes, () => Float32Array.from(numbers.next(nodes, 2), (step) => (step - 32_767) * per));
  return { ...shape, displacement, fields: shape.fields.map((field) => unpackedField(field, nodes, numbers)) };
}

function unpackedField(field: PackedField, nodes: number, numbers: Integers): Field {
  const per = (field.most - field.least) / 65_534;
  const values = Float32Array.from(numbers.next(nodes, 2), (step) => (step === 65_535 ? NO_VALUE : field.least + step * per));
  return { ...field, values };
}
