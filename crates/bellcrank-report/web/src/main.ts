// Puts life into the page that the Rust side wrote.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import { Cursor } from "./cursor";
import { Curves } from "./curves/curves";
import { type Drawing, readReport, type Study } from "./data";
import { followCycle } from "./cycle";
import { Explorer } from "./designs/explorer";
import { followHodographs } from "./hodograph";
import { Stage } from "./stage";

function liven(drawing: Drawing, study: Study, index: number): void {
  const { designs } = study;
  const explorer = document.querySelector<HTMLElement>(`[data-designs="${index}"]`);
  if (explorer && designs) whenNear(explorer, () => new Explorer(explorer, designs));
  if (study.rows === 0) return;
  const cursor = new Cursor(study.rows);
  const stage = document.querySelector<HTMLElement>(`[data-stage="${index}"]`);
  if (stage && study.motion) new Stage(stage, drawing, study, study.motion, cursor, index);
  const curves = document.querySelector<HTMLElement>(`[data-curves="${index}"]`);
  if (curves) whenNear(curves, () => new Curves(curves, study, cursor));
  followHodographs(index, study, cursor);
  followCycle(index, study, cursor);
}

/** Charts are made when the reader comes near them: a report of ten studies opens at once. */
function whenNear(element: HTMLElement, act: () => void): void {
  const observer = new IntersectionObserver(
    (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      act();
    },
    { rootMargin: "600px" },
  );
  observer.observe(element);
}

const report = readReport();
report?.studies.forEach((study, index) => liven(report.drawing, study, index));
