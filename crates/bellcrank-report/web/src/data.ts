// What the Rust side packed into the page (src/html/data.rs), unpacked.

export type V3 = [number, number, number];

export interface Body {
  name: string;
  points: [string, V3][];
  lines: [number, number][];
  center: V3 | null;
}

export interface Joint {
  name: string;
  kind: string;
  first: [number, V3];
  second: [number, V3];
  axis: V3;
  driven: boolean;
}

export interface Arrow {
  name: string;
  body: number;
  at: V3;
}

/** A part fixed on a body, body axes, m; colour as 0xrrggbb. */
export interface Solid {
  body: number;
  colour: number;
  metal: boolean;
  shape:
    | { rod: [V3, V3]; radius: number; round: boolean }
    | { ball: V3; radius: number }
    | { block: V3; along: V3; across: V3; size: V3 }
    | { plate: V3[]; normal: V3; radius: number; thickness: number }
    // Coordinates and corners one after another: the real form of a body.
    | { surface: number[]; triangles: number[] };
}

export interface Drawing {
  planar: boolean;
  /** Right, up and towards the reader in world axes, as the machine is seen from the front. */
  axes: [V3, V3, V3];
  bodies: Body[];
  joints: Joint[];
  arrows: Arrow[];
}

/** A signal in display units. */
export interface Signal {
  name: string;
  unit: string;
  values: ArrayLike<number>;
}

/** Poses and arrows (SI) of the frames; `rows[frame]` is the row it belongs to. */
export interface Motion {
  rows: number[];
  bodies: number;
  arrowCount: number;
  poses: Float32Array;
  arrows: Float32Array;
  solids: Solid[];
}

/** Designs of a sweep: the number of the design, what was varied, what was found. */
export interface Designs {
  rows: number;
  total: number;
  number: Signal;
  columns: Signal[];
  /** How many leading columns were varied. */
  inputs: number;
  /** Best compromises of two responses, in order. */
  front: { x: string; y: string; xs: number[]; ys: number[] } | null;
}

export interface Study {
  name: string;
  axis: string[];
  rows: number;
  signals: Signal[];
  byName: Map<string, Signal>;
  motion: Motion | null;
  designs: Designs | null;
}

interface PackedColumn {
  name: string;
  unit: string;
  constant?: number | null;
  at?: number;
  double?: boolean;
}

interface PackedMotion {
  rows: number[];
  bodies: number;
  arrows: number;
  posesAt: number;
  arrowsAt: number;
  solids: Solid[];
}

interface PackedStudy {
  name: string;
  axis: string[];
  rows: number;
  columns: PackedColumn[];
  animation: PackedMotion | null;
  designs: { rows: number; total: number; inputs: number; columns: PackedColumn[]; front: Designs["front"] } | null;
}

export interface Report {
  drawing: Drawing;
  studies: Study[];
}

/** The report in this page; nothing where the page carries none. */
export function readReport(): Report | null {
  const text = document.getElementById("bellcrank-data")?.textContent;
  if (!text) return null;
  const packed = JSON.parse(text) as { drawing: Drawing; studies: PackedStudy[] };
  const studies = packed.studies.map((study, index) => unpack(study, blob(index), packed.drawing.planar));
  return { drawing: packed.drawing, studies };
}

function blob(index: number): ArrayBuffer {
  const text = document.getElementById(`bellcrank-blob-${index}`)?.textContent ?? "";
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes.buffer;
}

function unpack(study: PackedStudy, buffer: ArrayBuffer, planar: boolean): Study {
  const signals = study.columns.map((column) => unpacked(column, buffer, study.rows));
  return {
    name: study.name,
    axis: study.axis,
    rows: study.rows,
    signals,
    byName: new Map(signals.map((signal) => [signal.name, signal])),
    motion: motion(study, buffer, planar),
    designs: designs(study, buffer),
  };
}

function unpacked(column: PackedColumn, buffer: ArrayBuffer, rows: number): Signal {
  return { name: column.name, unit: column.unit, values: values(column, buffer, rows) };
}

function designs(study: PackedStudy, buffer: ArrayBuffer): Designs | null {
  const packed = study.designs;
  if (!packed || packed.rows < 2) return null;
  const [number, ...columns] = packed.columns.map((column) => unpacked(column, buffer, packed.rows));
  return { rows: packed.rows, total: packed.total, number, columns, inputs: packed.inputs, front: packed.front };
}

function values(column: PackedColumn, buffer: ArrayBuffer, rows: number): ArrayLike<number> {
  if (column.at === undefined) return new Float64Array(rows).fill(column.constant ?? NaN);
  return column.double ? new Float64Array(buffer, column.at, rows) : new Float32Array(buffer, column.at, rows);
}

function motion(study: PackedStudy, buffer: ArrayBuffer, planar: boolean): Motion | null {
  const packed = study.animation;
  if (!packed || packed.rows.length === 0) return null;
  const poseCount = packed.rows.length * packed.bodies * (planar ? 3 : 7);
  return {
    rows: packed.rows,
    bodies: packed.bodies,
    arrowCount: packed.arrows,
    poses: new Float32Array(buffer, packed.posesAt, poseCount),
    arrows: new Float32Array(buffer, packed.arrowsAt, packed.rows.length * packed.arrows * 3),
    solids: packed.solids,
  };
}

export function signal(study: Study, name: string): Signal | undefined {
  return study.byName.get(name);
}
