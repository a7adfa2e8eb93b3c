// The third script of the report, only in pages with pictures of parts: lets them be turned where the browser can.

import "./contour.css";
import { make } from "../dom";
import { made } from "../solid/loading";
import { type Catalogue, readCatalogue, readPart } from "./data";
import { PartStage } from "./stage";
import { Viewer } from "./viewer";

async function liven(figure: HTMLElement, catalogue: Catalogue): Promise<void> {
  const kit = await made(() => window.bellcrankKit);
  try {
    if (typeof kit === "string") throw new Error(kit);
    const part = await readPart(catalogue, figure.dataset.contour ?? "");
    let stage: PartStage | null = null;
    stage = new PartStage(new Viewer(kit, part, catalogue, () => stage?.refresh()));
    figure.prepend(stage.element);
    figure.classList.add("on");
    figure.dataset.view = "contour";
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    figure.append(make("p", { class: "hint" }, `The still picture is shown: ${why}.`));
    figure.dataset.view = "still";
  }
}

const catalogue = readCatalogue();
if (catalogue) {
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        void liven(target as HTMLElement, catalogue);
      }
    },
    { rootMargin: "600px" },
  );
  document.querySelectorAll("[data-contour]").forEach((figure) => observer.observe(figure));
}
