// The second script of the report: the solid drawing, with what it needs of three.js.

import * as kit from "./kit";
import { SolidView } from "./view";

window.bellcrankKit = kit;
window.bellcrankSolid = (facts, flexible) => new SolidView(facts, flexible);
