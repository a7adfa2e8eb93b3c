// What drawings of parts take from the solid drawing's script, so that a page holds three.js once.

export { BufferAttribute, BufferGeometry, DoubleSide, Group, LineSegments, Matrix4, Mesh, Scene, ShaderMaterial, Vector3 } from "three";
export { Orbit } from "./orbit";
export { sharedStudio } from "./studio";
