// The solid drawing is a script of its own, packed (gzip, base64), and unpacked only when it is wanted.

import { type Flexible, readFlexible } from "../flexible/data";
import type { Facts } from "../scene/facts";
import type { View } from "../view";

/** What the packed script leaves behind: a maker of views, and what other drawings use of it. */
export type MakeSolid = (facts: Facts, flexible: Flexible | null) => View;
export type Kit = typeof import("./kit");

declare global {
  interface Window {
    bellcrankSolid?: MakeSolid;
    bellcrankKit?: Kit;
    /** On the way; kept by the page, as two scripts ask for it. */
    bellcrankLoading?: Promise<void>;
  }
}

const NO_GRAPHICS = "this browser has no WebGL 2";

/** A solid view of the study of that index, or why there is none. */
export async function solidView(facts: Facts, study: number): Promise<View | string> {
  if (!hasWebGL()) return NO_GRAPHICS;
  const flexible = await readFlexible(study);
  return made(() => window.bellcrankSolid?.(facts, flexible));
}

/** What `make` makes once the script has run, or why there is nothing. */
export async function made<T>(make: () => T | undefined): Promise<T | string> {
  if (!hasWebGL()) return NO_GRAPHICS;
  try {
    await (window.bellcrankLoading ??= unpacked());
    return make() ?? "its script did not run";
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

async function unpacked(): Promise<void> {
  const packed = document.getElementById("bellcrank-solid")?.textContent;
  if (!packed) throw new Error("this page does not hold it");
  const script = document.createElement("script");
  script.textContent = await new Response(gunzipped(packed)).text();
  document.head.append(script);
}

/** Base64 of a gzip file as what it packs. */
export function gunzipped(packed: string): ReadableStream {
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  return new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
}
