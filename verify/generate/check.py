"""Holds every reference.toml and expected.toml against its model file, solved by `maximal`.

This is a check of the references and of the model files before bellcrank sees them: closed forms and published
values on one side, the independent program on the other.  python3 check.py [NAME ...]
"""
import glob, os, re, sys, tomllib
import numpy as np
import maximal
from reference import ROOT


def reduction(text, rows, model):
    signals = sorted(set(re.findall(r"[a-z]\w*(?:\.\w+)+", text)), key=len, reverse=True)
    scope = {}
    for i, s in enumerate(signals):
        text = text.replace(s, f"_{i}")
        scope[f"_{i}"] = np.array([r[s] for r in rows])
    f = dict(max=np.max, min=np.min, range=np.ptp, first=lambda a: a[0], last=lambda a: a[-1], abs=np.abs,
             mean=np.mean, rms=lambda a: np.sqrt(np.mean(a**2)), sqrt=np.sqrt)
    return float(eval(text, {"__builtins__": {}}, {**f, **scope, **model.par}))


# coordinates that find their place in the statics cases
FREE = {"lamp": ["hinge"], "toggle-press": ["O"], "double-pendulum-statics": ["O", "A"], "four-bar-spring-statics": ["crank"], "hold-statics": []}


def hold_against(model_path, ref_path):
    ref = tomllib.load(open(ref_path, "rb"))
    assert ref["kind"] in ("analytic", "literature", "other-code", "regression") and ref["source"]
    m = maximal.load(model_path)
    cache, bad, worst, skipped = {}, [], 0.0, 0
    facts = None
    for c in ref["check"]:
        if "scalar" in c:
            if facts is None:
                facts = m.facts()
                facts["loops"] = facts["joints"] - facts["bodies"]
                study = next((n for n in m.doc["studies"] if m.study(n)["kind"] in ("kinematics", "inverse-dynamics")), None)
                case = os.path.basename(os.path.dirname(ref_path))
                if study is None and case in FREE:
                    study = next(iter(m.doc["studies"]))
                    cache.setdefault(study, [m.rest(study, FREE[case])])
                if study is not None:                              # of dynamics alone nothing is solved here: `free.py` does
                    s = m.study(study)
                    few = cache.get(study) or m.rows(study, [m.ev(s["sweep"]["from"])] if "sweep" in s else [0.4 * m.ev(s["duration"])])
                    facts["redundant"] = few[len(few) // 2]["#redundant"]
            if c["scalar"] in facts and facts[c["scalar"]] != c["value"]:
                bad.append(f"{c['scalar']}: {facts[c['scalar']]} is not {c['value']}")
            continue
        if "unique" in c:
            study = next((n for n in cache if len(cache[n]) > 1), None) or next(n for n in m.doc["studies"])
            if study not in cache:
                cache[study] = m.rows(study, [m.ev(m.study(study)["sweep"]["from"]) + 0.1 * k for k in (0, 1)])
            if cache[study][1]["#unique"][c["unique"]] != c["value"]:
                bad.append(f"unique {c['unique']}: not {c['value']}")
            continue
        if "summary" in c:
            skipped += 1
            continue
        study = c["study"]
        if m.study(study)["kind"] == "statics" and study not in cache:
            moving = [k for k in FREE.get(os.path.basename(os.path.dirname(ref_path)), [])]
            cache[study] = [m.rest(study, moving)]
        if m.study(study)["kind"] != "statics" and m.study(study)["kind"] not in ("kinematics", "inverse-dynamics"):
            skipped += 1
            continue
        if study not in cache:
            mine = [k for k in ref["check"] if k.get("study") == study]
            times = sorted({m.ev(next(iter(k["at"].values()))) for k in mine if len(k.get("at", {})) == 1})
            if any(k not in ("time", "joint." + m.study(study).get("sweep", {}).get("joint", "") + ".position") for c2 in mine for k in c2.get("at", {})):
                times = []
            cache[study] = m.rows(study, times if len(times) and not any("reduce" in k for k in mine) else None)
        rows = cache[study]
        if "reduce" in c:
            if "check." in c["reduce"]:
                skipped += 1
                continue
            got = reduction(c["reduce"], rows, m)
        else:
            row = rows[0] if "at" not in c else None
            for k, v in c.get("at", {}).items():
                place = m.ev(v)
                row = min(rows, key=lambda r: abs(r[k] - place))
                assert abs(row[k] - place) < 1e-9, (k, v, row[k])
            if c["signal"] not in row:
                bad.append("no signal " + c["signal"])
                continue
            got = row[c["signal"]]
        want = m.ev(c["value"])
        tol = c.get("rtol", 0.0) * abs(want) + (m.ev(c["atol"]) if "atol" in c else 0.0)
        err = abs(got - want)
        worst = max(worst, err / (tol + 1e-300))
        if not err <= tol:
            bad.append(f"{c.get('signal', c.get('reduce'))} {c.get('at', '')}: program {got!r}, reference {want!r}, error {err:.2e} over {tol:.1e}")
    return len(ref["check"]), skipped, worst, bad


if __name__ == "__main__":
    pairs = [(os.path.join(os.path.dirname(p), "model.toml"), p) for p in glob.glob(f"{ROOT}/verify/cases/*/reference.toml")]
    for p in glob.glob(f"{ROOT}/models/*/expected.toml"):
        pairs.append((os.path.join(os.path.dirname(p), tomllib.load(open(p, "rb"))["model"]), p))
    failed = 0
    for mp, rp in sorted(pairs, key=lambda p: p[1]):
        name = os.path.relpath(os.path.dirname(rp), ROOT)
        if sys.argv[1:] and not any(a in name for a in sys.argv[1:]):
            continue
        try:
            n, skipped, worst, bad = hold_against(mp, rp)
        except Exception as e:
            n, skipped, worst, bad = 0, 0, 0, [f"{type(e).__name__}: {e}"]
        failed += bool(bad)
        print(f"{'BAD ' if bad else 'ok  '} {name:44s} {n:4d} checks, {skipped} not covered, worst error/tolerance {worst:.2e}")
        for b in bad[:8]:
            print("      ", b)
    sys.exit(bool(failed))
