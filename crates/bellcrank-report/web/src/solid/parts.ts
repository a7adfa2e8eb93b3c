// Parts of bodies as geometry: all parts of one body and one kind of surface are one mesh.

import {
  BufferGeometry, CapsuleGeometry, Color, CylinderGeometry, EdgesGeometry, ExtrudeGeometry, Float32BufferAttribute, Matrix4, Path,
  Quaternion, Shape, SphereGeometry, Vector2, Vector3,
} from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import { mergeGeometries, toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Solid, V3 } from "../data";

const Y = new Vector3(0, 1, 0);
/** Neighbours of a real form that are further apart, degrees, have a visible edge between them. */
const CREASE = 30;

/** The parts of body `body` with a metal surface or without, coloured by vertex; null where there are none. */
export function bodyGeometry(solids: Solid[], body: number, metal: boolean, fine: boolean): BufferGeometry | null {
  const parts = solids.filter((part) => part.body === body && part.metal === metal);
  const geometries = parts.map((part) => coloured(plain(geometry(part.shape, fine)), part.colour));
  return geometries.length > 0 ? mergeGeometries(geometries) : null;
}

/** The visible edges of the real form of a body, one geometry a form. */
export function edgeGeometries(solids: Solid[], body: number): BufferGeometry[] {
  return solids.flatMap((part) =>
    part.body === body && "surface" in part.shape ? [new EdgesGeometry(shared(part.shape), CREASE)] : [],
  );
}

function shared({ surface, triangles }: { surface: number[]; triangles: number[] }): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(surface, 3));
  return geometry.setIndex(triangles);
}

function geometry(shape: Solid["shape"], fine: boolean): BufferGeometry {
  const around = fine ? 28 : 12;
  if ("rod" in shape) return rod(shape.rod, shape.radius, shape.round, around);
  if ("ball" in shape) return new SphereGeometry(shape.radius, around, around >> 1).translate(...shape.ball);
  if ("block" in shape) return block(shape);
  if ("surface" in shape) return toCreasedNormals(shared(shape), (CREASE * Math.PI) / 180);
  return plate(shape.plate, shape.normal, shape.radius, shape.thickness, fine);
}

function rod([from, to]: [V3, V3], radius: number, round: boolean, around: number): BufferGeometry {
  const [a, b] = [new Vector3(...from), new Vector3(...to)];
  const length = a.distanceTo(b);
  const shape = round ? new CapsuleGeometry(radius, length, 6, around) : bevelled(radius, length, around);
  const turn = new Quaternion().setFromUnitVectors(Y, b.clone().sub(a).normalize());
  return shape.applyMatrix4(new Matrix4().compose(a.add(b).divideScalar(2), turn, new Vector3(1, 1, 1)));
}

/** A cylinder whose edges catch the light. */
function bevelled(radius: number, length: number, around: number): BufferGeometry {
  const edge = Math.min(0.16 * radius, 0.2 * length);
  const cone = (top: number, bottom: number, height: number, y: number) =>
    plain(new CylinderGeometry(top, bottom, height, around, 1, true).translate(0, y, 0));
  const inner = radius - edge;
  const cap = (y: number, up: boolean) =>
    plain(new CylinderGeometry(up ? 0 : inner, up ? inner : 0, 1e-7, around, 1, true).translate(0, y, 0));
  return mergeGeometries([
    cone(radius, radius, length - 2 * edge, 0),
    cone(inner, radius, edge, (length - edge) / 2),
    cone(radius, inner, edge, -(length - edge) / 2),
    cap(length / 2, true),
    cap(-length / 2, false),
  ]);
}

function block(shape: { block: V3; along: V3; across: V3; size: V3 }): BufferGeometry {
  const [x, y] = [new Vector3(...shape.along), new Vector3(...shape.across)];
  const edge = 0.12 * Math.min(...shape.size);
  const turn = new Matrix4().makeBasis(x, y, new Vector3().crossVectors(x, y)).setPosition(...shape.block);
  return new RoundedBoxGeometry(...shape.size, 2, edge).applyMatrix4(turn);
}

/** What a disc covers on its way around `points`, with bevelled edges. */
function plate(points: V3[], normal: V3, radius: number, thickness: number, fine: boolean): BufferGeometry {
  const z = new Vector3(...normal);
  const origin = new Vector3(...points[0]);
  const x = new Vector3().crossVectors(Math.abs(z.x) < 0.9 ? new Vector3(1, 0, 0) : Y, z).normalize();
  const turn = new Matrix4().makeBasis(x, new Vector3().crossVectors(z, x), z).setPosition(origin);
  const back = turn.clone().invert();
  const flat = points.map((p) => new Vector3(...p).applyMatrix4(back)).map((p) => new Vector2(p.x, p.y));
  const bevel = Math.min(0.14 * thickness, 0.3 * radius);
  const shape = new ExtrudeGeometry(outline(flat, radius - bevel), {
    depth: thickness - 2 * bevel,
    curveSegments: fine ? 10 : 5,
    bevelThickness: bevel,
    bevelSize: bevel,
    bevelSegments: fine ? 2 : 1,
  });
  return shape.translate(0, 0, bevel - thickness / 2).applyMatrix4(turn);
}

/** Arcs around the corners of a polygon that turns left, joined by lines. */
function outline(corners: Vector2[], radius: number): Shape {
  const shape = new Shape();
  const count = corners.length;
  const outward = (k: number) => {
    const edge = corners[(k + 1) % count].clone().sub(corners[k % count]);
    return Math.atan2(edge.y, edge.x) - Math.PI / 2;
  };
  corners.forEach((corner, k) => {
    const [from, to] = count > 1 ? [outward(k + count - 1), outward(k)] : [0, 2 * Math.PI];
    const path: Path = shape;
    path.absarc(corner.x, corner.y, radius, from, to, false);
  });
  return shape;
}

/** Only what all geometries have, without shared corners, so that they can be merged. */
function plain(geometry: BufferGeometry): BufferGeometry {
  const loose = geometry.index ? geometry.toNonIndexed() : geometry;
  loose.deleteAttribute("uv");
  loose.clearGroups();
  return loose;
}

function coloured(geometry: BufferGeometry, colour: number): BufferGeometry {
  const { r, g, b } = new Color(colour);
  const count = geometry.getAttribute("position").count;
  const colours = new Float32Array(count * 3);
  for (let k = 0; k < count; k++) colours.set([r, g, b], 3 * k);
  return geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
}
