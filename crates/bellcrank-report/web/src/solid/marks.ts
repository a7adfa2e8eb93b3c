// What is shown on demand: arrows of forces, centres of mass, axes of bodies, trails.

import {
  BufferGeometry, CatmullRomCurve3, Color, ConeGeometry, CylinderGeometry, Float32BufferAttribute, Group, Matrix4, Mesh,
  MeshBasicMaterial, MeshStandardMaterial, Quaternion, SphereGeometry, TubeGeometry, Vector3,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { V3 } from "../data";
import { AXES } from "../scene/pen";

const Y = new Vector3(0, 1, 0);

/** An arrow whose shaft can be stretched without its head. */
export class Arrow extends Group {
  private readonly shaft: Mesh;
  private readonly head: Mesh;

  constructor(
    colour: string,
    private readonly radius: number,
  ) {
    super();
    const material = new MeshStandardMaterial({ color: colour, roughness: 0.5, metalness: 0.1 });
    this.shaft = new Mesh(new CylinderGeometry(radius, radius, 1, 20).translate(0, 0.5, 0), material);
    this.head = new Mesh(new ConeGeometry(2.6 * radius, 6.5 * radius, 24).translate(0, -3.25 * radius, 0), material);
    this.shaft.castShadow = this.head.castShadow = true;
    this.add(this.shaft, this.head);
  }

  /** Points from `foot` along `reach`; hidden where that has no length. */
  set(foot: Vector3, reach: Vector3): void {
    const length = reach.length();
    this.visible = length > 2 * this.radius;
    if (!this.visible) return;
    this.position.copy(foot);
    this.quaternion.setFromUnitVectors(Y, reach.clone().divideScalar(length));
    const head = Math.min(1, length / (9 * this.radius));
    this.head.scale.setScalar(head);
    this.head.position.y = length;
    this.shaft.scale.y = Math.max(1e-6, length - 6 * head * this.radius);
  }
}

/** A rod between two places that change their distance. */
export class Stretched extends Mesh {
  constructor(radius: number) {
    const geometry = new CylinderGeometry(radius, radius, 1, 16).translate(0, 0.5, 0);
    super(geometry, new MeshStandardMaterial({ color: 0xb4bcc4, roughness: 0.35, metalness: 0.6 }));
    this.castShadow = this.receiveShadow = true;
  }

  set(from: Vector3, to: Vector3): void {
    const way = to.clone().sub(from);
    this.position.copy(from);
    this.scale.y = Math.max(1e-9, way.length());
    this.quaternion.setFromUnitVectors(Y, way.normalize());
  }
}

/** The usual sign of a centre of mass, a ball in quarters of black and white; seen through parts. */
export function centerMark(radius: number): Mesh {
  const ball = new SphereGeometry(radius, 24, 16).toNonIndexed();
  const at = ball.getAttribute("position");
  const colours: number[] = [];
  for (let k = 0; k < at.count; k += 3) {
    const middle = (axis: "getX" | "getY" | "getZ") => at[axis](k) + at[axis](k + 1) + at[axis](k + 2);
    const dark = middle("getX") * middle("getY") * middle("getZ") > 0;
    for (let corner = 0; corner < 9; corner++) colours.push(dark ? 0.01 : 1);
  }
  ball.setAttribute("color", new Float32BufferAttribute(colours, 3));
  const mark = new Mesh(ball, new MeshBasicMaterial({ vertexColors: true, depthTest: false, transparent: true }));
  mark.renderOrder = 3;
  return mark;
}

/** Three arrows along the axes of a body, in the colours of the legend; seen through parts. */
export function axesMark(length: number): Mesh {
  const arms = AXES.map(([axis, colour]) => {
    const arm = mergeGeometries([
      new CylinderGeometry(0.022 * length, 0.022 * length, 0.8 * length, 10).translate(0, 0.4 * length, 0),
      new ConeGeometry(0.07 * length, 0.22 * length, 14).translate(0, 0.89 * length, 0),
    ]);
    const turn = new Quaternion().setFromUnitVectors(Y, new Vector3(...axis));
    return painted(arm.applyMatrix4(new Matrix4().makeRotationFromQuaternion(turn)), new Color(colour));
  });
  const mark = new Mesh(mergeGeometries(arms), new MeshBasicMaterial({ vertexColors: true, depthTest: false, transparent: true }));
  mark.renderOrder = 2;
  return mark;
}

function painted(geometry: BufferGeometry, { r, g, b }: Color): BufferGeometry {
  const count = geometry.getAttribute("position").count;
  const colours = Array.from({ length: count }, () => [r, g, b]).flat();
  return geometry.setAttribute("color", new Float32BufferAttribute(colours, 3));
}

/** The path of a point as a thin tube; null where it does not move. */
export function trailMark(path: V3[], radius: number): Mesh | null {
  const places: Vector3[] = [];
  for (const p of path) {
    const next = new Vector3(...p);
    if (places.length === 0 || next.distanceTo(places[places.length - 1]) > 0.3 * radius) places.push(next);
  }
  if (places.length < 2) return null;
  const tube = new TubeGeometry(new CatmullRomCurve3(places), Math.min(800, 3 * places.length), radius, 6);
  return new Mesh(tube, new MeshBasicMaterial({ color: 0xd9570b, transparent: true, opacity: 0.75 }));
}
