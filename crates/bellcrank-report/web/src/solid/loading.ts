// The solid drawing is a script of its own, packed (gzip, base64), and unpacked only when it is wanted.

import type { Facts } from "../scene/facts";
import type { View } from "../view";

/** What the packed script leaves behind: a maker of views. */
export type MakeSolid = (facts: Facts) => View;

declare global {
  interface Window {
    bellcrankSolid?: MakeSolid;
  }
}

let loading: Promise<MakeSolid> | null = null;

/** A solid view, or why there is none. */
export async function solidView(facts: Facts): Promise<View | string> {
  if (!hasWebGL()) return "this browser has no WebGL 2";
  try {
    loading ??= unpacked();
    return (await loading)(facts);
  } catch (error) {
    return `the solid one could not be made (${error instanceof Error ? error.message : String(error)})`;
  }
}

function hasWebGL(): boolean {
  const context = document.createElement("canvas").getContext("webgl2");
  // Browsers keep only some contexts alive at a time.
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

async function unpacked(): Promise<MakeSolid> {
  const packed = document.getElementById("bellcrank-solid")?.textContent;
  if (!packed) throw new Error("this page does not hold it");
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  const script = document.createElement("script");
  script.textContent = await new Response(stream).text();
  document.head.append(script);
  if (!window.bellcrankSolid) throw new Error("its script did not run");
  return window.bellcrankSolid;
}
