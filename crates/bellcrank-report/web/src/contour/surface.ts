// A part on the graphics card: deformed and coloured there, so that only a few numbers change from picture to picture.

import type { LineSegments, ShaderMaterial } from "three";
import type { V2 } from "../scene/camera";
import type { Kit } from "../solid/loading";
import type { Colours, Field, Part, Shape } from "./data";

/** What of a part is drawn. */
export type Drawable = Pick<Part, "places" | "triangles" | "edges" | "outline" | "low" | "high" | "axes">;

/** How colours are chosen. */
export interface Style {
  rainbow: boolean;
  bands: boolean;
}

const MOVED = `
  attribute vec3 move;
  uniform float scale;
  vec4 moved() { return modelViewMatrix * vec4(position + scale * move, 1.0); }
`;

const SURFACE = {
  vertex: `${MOVED}
  attribute float value;
  varying float shown;
  varying vec3 seen;
  void main() {
    vec4 place = moved();
    shown = value;
    seen = place.xyz;
    gl_Position = projectionMatrix * place;
  }`,
  fragment: `
  uniform vec3 stops[33], above, none;
  uniform float low, high, width, count;
  uniform bool signs, cut, bands;
  varying float shown;
  varying vec3 seen;
  float share() {
    float limit = max(abs(low), abs(high));
    if (!bands) return signs ? 0.5 + 0.5 * shown / limit : (shown - low) / (high - low);
    float band = clamp(floor((shown - low) / width), 0.0, count - 1.0);
    if (!signs) return band / max(count - 1.0, 1.0);
    float from = low + band * width;
    return 0.5 + 0.25 * (from + min(from + width, high)) / limit;
  }
  vec3 colour() {
    if (shown < -1e20) return none;
    if (cut && shown > high * 1.00002) return above;
    float at = clamp(share(), 0.0, 1.0) * 32.0;
    int k = int(min(at, 31.0));
    return mix(stops[k], stops[k + 1], at - float(k));
  }
  void main() {
    vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
    if (normal.z < 0.0) normal = -normal;
    float light = 0.62 + 0.3 * max(0.0, dot(normal, normalize(vec3(-0.42, 0.5, 0.76)))) + 0.14 * normal.z;
    vec3 flat_ = colour();
    gl_FragColor = vec4(light <= 1.0 ? flat_ * light : 1.0 - (1.0 - flat_) * (2.0 - light), 1.0);
  }`,
};

const LINES = {
  vertex: `${MOVED}
  void main() { gl_Position = projectionMatrix * moved(); }`,
  fragment: `
  uniform vec4 ink;
  void main() { gl_FragColor = ink; }`,
};

/** The part and its lines in the axes of the scene (y up), its middle at the origin. */
export class Surface {
  readonly scene;
  readonly group;
  private readonly skin: ShaderMaterial;
  private readonly edges: LineSegments;
  private readonly sharp: LineSegments;
  private readonly ghost: LineSegments;
  private readonly geometries;
  /** Mean length of the elements' edges, m. */
  private readonly mesh: number;
  private factor = 0;

  constructor(
    private readonly kit: Kit,
    private readonly part: Drawable,
    private readonly colours: Colours,
  ) {
    this.scene = new kit.Scene();
    this.group = new kit.Group();
    this.group.matrixAutoUpdate = false;
    const [right, up, back] = part.axes;
    const middle = part.low.map((low, k) => (low + part.high[k]) / 2);
    this.group.matrix
      .set(...right, 0, ...up, 0, ...back, 0, 0, 0, 0, 1)
      .multiply(new kit.Matrix4().makeTranslation(-middle[0], -middle[1], -middle[2]));
    const places = new kit.BufferAttribute(part.places, 3);
    const geometry = (index: Uint32Array) =>
      new kit.BufferGeometry().setAttribute("position", places).setIndex(new kit.BufferAttribute(index, 1));
    this.skin = new kit.ShaderMaterial({
      vertexShader: SURFACE.vertex, fragmentShader: SURFACE.fragment, side: kit.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2, uniforms: uniforms(colours),
    });
    this.edges = this.lines(geometry(part.edges), [0.06, 0.09, 0.12, 0.5]);
    this.sharp = this.lines(geometry(part.outline), [0.06, 0.09, 0.12, 0.75]);
    this.ghost = this.lines(geometry(part.outline), [0.5, 0.55, 0.62, 1]);
    const skin = new kit.Mesh(geometry(part.triangles), this.skin);
    this.group.add(skin, this.edges, this.sharp, this.ghost);
    // Deformed parts lie elsewhere than their places say.
    this.group.children.forEach((child) => (child.frustumCulled = false));
    this.geometries = [skin, this.edges, this.sharp, this.ghost].map((drawn) => drawn.geometry);
    this.mesh = meanLength(part);
    this.scene.add(this.group);
  }

  private lines(geometry: LineSegments["geometry"], ink: number[]): LineSegments {
    const { ShaderMaterial, LineSegments } = this.kit;
    const material = new ShaderMaterial({
      vertexShader: LINES.vertex, fragmentShader: LINES.fragment, transparent: true, depthWrite: false,
      uniforms: { scale: { value: 0 }, ink: { value: ink } },
    });
    return new LineSegments(geometry, material);
  }

  /** Another shape: its displacements go to the card. */
  shape(shape: Shape | null): void {
    const move = shape?.displacement ?? new Float32Array(this.part.places.length);
    const attribute = new this.kit.BufferAttribute(move, 3);
    this.geometries.forEach((geometry) => geometry.setAttribute("move", attribute));
  }

  /** The displacements of the shape are others now. */
  moved(): void {
    this.geometries[0].getAttribute("move").needsUpdate = true;
  }

  /** Another field or other colours; `empty`: a field without numbers. */
  field(field: Field | null, style: Style, empty = field === null): void {
    const values = field?.values ?? new Float32Array(this.part.places.length / 3).fill(-1e30);
    // The same list keeps its place on the card.
    if (this.geometries[0].getAttribute("value")?.array !== values) {
      this.geometries[0].setAttribute("value", new this.kit.BufferAttribute(values, 1));
    }
    const set = (name: string, value: unknown) => (this.skin.uniforms[name].value = value);
    if (!field || empty) return;
    set("stops", stops(field, style, this.colours).flatMap(unit));
    set("low", field.low);
    set("high", field.high);
    set("width", field.step);
    set("count", bandCount(field));
    set("signs", field.signed);
    set("cut", field.cut);
    set("bands", style.bands);
  }

  /** The values of the field are others now. */
  recoloured(): void {
    this.geometries[0].getAttribute("value").needsUpdate = true;
  }

  /** Times the displacement; the undeformed part stays where it is. */
  deform(factor: number): void {
    this.factor = factor;
    this.skin.uniforms.scale.value = factor;
    for (const lines of [this.edges, this.sharp]) (lines.material as ShaderMaterial).uniforms.scale.value = factor;
  }

  /** Which lines are drawn; `pixels` of a metre: edges are fainter the denser they are. */
  show(edges: boolean, undeformed: boolean, pixels: number): void {
    const alpha = 0.4 * Math.max(0, Math.min(1, (this.mesh * pixels - 2.5) / 9));
    // What is hardly seen is not worth the time of a hundred thousand lines.
    this.edges.visible = edges && alpha > 0.03;
    (this.edges.material as ShaderMaterial).uniforms.ink.value = [0.06, 0.09, 0.12, alpha];
    this.ghost.visible = undeformed && this.factor !== 0;
  }
}

function uniforms(colours: Colours): ShaderMaterial["uniforms"] {
  const start = {
    scale: 0, stops: new Array(99).fill(0.7), above: colours.above.map(byte), none: colours.none.map(byte),
    low: 0, high: 1, width: 1, count: 1, signs: false, cut: false, bands: true,
  };
  return Object.fromEntries(Object.entries(start).map(([name, value]) => [name, { value }]));
}

const byte = (x: number) => x / 255;

/** 0xrrggbb as three shares. */
export function unit(colour: number): number[] {
  return [colour >> 16, (colour >> 8) & 255, colour & 255].map(byte);
}

export function stops(field: Field, style: Style, colours: Colours): number[] {
  if (style.rainbow) return colours.rainbow;
  return field.signed ? colours.signed : colours.even;
}

export function bandCount(field: Field): number {
  return Math.max(1, Math.ceil((field.high - field.low) / field.step - 1e-6));
}

function meanLength(part: Drawable): number {
  const { edges, places } = part;
  let total = 0;
  for (let k = 0; k < edges.length; k += 2) {
    const [a, b] = [3 * edges[k], 3 * edges[k + 1]];
    total += Math.hypot(places[a] - places[b], places[a + 1] - places[b + 1], places[a + 2] - places[b + 2]);
  }
  return edges.length > 0 ? (2 * total) / edges.length : 0;
}

/** A place on the canvas with its depth, px and any unit. */
export type Spot = { at: V2; depth: number };
