// The second script of the report: the solid drawing, with what it needs of three.js.

import { SolidView } from "./view";

window.bellcrankSolid = (facts) => new SolidView(facts);
