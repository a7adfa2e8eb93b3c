// Light, floor and the one renderer of a page.

import {
  BufferGeometry, DirectionalLight, Float32BufferAttribute, Group, HemisphereLight, LineBasicMaterial, LineSegments, Mesh,
  NeutralToneMapping, PCFShadowMap, PlaneGeometry, PMREMGenerator, type Scene, ShadowMaterial, type Texture, WebGLRenderer,
} from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";

/** One renderer for all drawings of a page: browsers keep only some WebGL contexts alive. */
export interface Studio {
  renderer: WebGLRenderer;
  /** What metal mirrors; null where graphics are computed without a graphics card, which is too slow for that and for
   * shadows. */
  room: Texture | null;
}

let studio: Studio | null = null;

export function sharedStudio(): Studio {
  return (studio ??= made());
}

function made(): Studio {
  const renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: "default" });
  renderer.setClearColor(0, 0);
  renderer.toneMapping = NeutralToneMapping;
  if (isSoftware(renderer)) return { renderer, room: null };
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  const room = new PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
  return { renderer, room };
}

function isSoftware(renderer: WebGLRenderer): boolean {
  const gl = renderer.getContext();
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

/** Lights for a machine within `radius` of the origin. */
export function light(scene: Scene, studio: Studio, radius: number): void {
  if (!studio.room) {
    scene.add(new HemisphereLight(0xffffff, 0x9aa4ae, 2.2));
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(1.4, 3, 1.9);
    scene.add(sun);
    return;
  }
  scene.environment = studio.room;
  scene.environmentIntensity = 0.55;
  scene.add(new HemisphereLight(0xffffff, 0xb8c2cc, 0.9));
  const sun = new DirectionalLight(0xffffff, 2.1);
  sun.position.set(1.4 * radius, 3 * radius, 1.9 * radius);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.radius = 4;
  sun.shadow.normalBias = 0.004 * radius;
  sun.shadow.bias = -0.0004;
  const { camera } = sun.shadow;
  [camera.left, camera.right, camera.bottom, camera.top] = [-1.5, 1.5, -1.5, 1.5].map((side) => side * radius);
  [camera.near, camera.far] = [0.1 * radius, 8 * radius];
  scene.add(sun);
}

/** Squares of a round length on the floor, fading outwards, and the shadow on them. */
export function floor(height: number, radius: number, studio: Studio): Group {
  const group = new Group();
  const cell = roundLength(radius / 3);
  const reach = 2.6 * radius;
  const lines: number[] = [];
  const count = Math.ceil(reach / cell);
  const pieces = 24;
  for (let k = -count; k <= count; k++) {
    for (let piece = -pieces; piece < pieces; piece++) {
      const [from, to] = [(piece / pieces) * reach, ((piece + 1) / pieces) * reach];
      lines.push(k * cell, 0, from, k * cell, 0, to, from, 0, k * cell, to, 0, k * cell);
    }
  }
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(lines, 3));
  const shades: number[] = [];
  for (let k = 0; k < lines.length; k += 3) {
    const share = Math.min(1, Math.hypot(lines[k], lines[k + 2]) / reach);
    shades.push(0.42, 0.48, 0.55, 0.5 * (1 - share) ** 1.2);
  }
  geometry.setAttribute("color", new Float32BufferAttribute(shades, 4));
  group.add(new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false })));
  group.position.y = height;
  if (!studio.room) return group;
  const shadow = new Mesh(new PlaneGeometry(2 * reach, 2 * reach), new ShadowMaterial({ opacity: 0.2, depthWrite: false }));
  shadow.rotation.x = -Math.PI / 2;
  shadow.receiveShadow = true;
  group.add(shadow);
  return group;
}

/** The largest 1, 2 or 5 times a power of ten below `length`. */
function roundLength(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  return ([5, 2, 1].find((lead) => lead * power <= length) ?? 1) * power;
}
