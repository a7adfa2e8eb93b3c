"""Studies of a model file, row by row."""
import csv, math, os, re
import numpy as np
from .expressions import UNITS, python_of
from .forces import Forces
from .profiles import profile
from .series import JET_FUNCTIONS, Jet


class Model(Forces):
    # --- studies
    def study(self, name):
        s = dict(self.doc["studies"][name])
        while "like" in s:
            base = dict(self.doc["studies"][s.pop("like")])
            base.update(s)
            s = base
        return s

    def motion_of(self, mname, t):
        """[(coordinate index, (position, velocity, acceleration))] of a motion at time t."""
        m = self.doc["motions"][mname]
        ref = m["joint"]
        idx = [self.index[ref]] if ref in self.index else [self.index[f"{ref}.{k}"] for k in range(self.joints[ref]["n"])]
        if "expression" in m:
            exprs = m["expression"] if isinstance(m["expression"], list) else [m["expression"]]
            out = []
            for i, e in zip(idx, exprs):
                jet = Jet([np.array([t]), np.array([1.0]), np.array([0.0])])
                v = Jet.of(eval(python_of(e) if isinstance(e, str) else repr(e), {"__builtins__": {}},
                                {**UNITS, "inch": 0.0254, **JET_FUNCTIONS, **self.par, "time": jet}), jet)
                out.append((i, (v.c[0][0], v.c[1][0], 2 * v.c[2][0])))
            return out
        i = idx[0]
        name, k = self.coords[i]
        q0 = self.joints[name]["start"][k]
        if "velocity" in m:
            v = self.ev(m["velocity"])
            return [(i, (q0 + v * t, v, 0.0))]
        if "segments" in m:
            t0 = 0.0
            for sgm in m["segments"]:
                T = self.ev(sgm.get("over", sgm.get("hold")))
                target = self.ev(sgm["to"]) if "to" in sgm else q0
                if t <= t0 + T + 1e-12:
                    if "hold" in sgm:
                        return [(i, (q0, 0.0, 0.0))]
                    f, fd, fdd = profile(sgm["profile"], min(1.0, (t - t0) / T))
                    D = target - q0
                    return [(i, (q0 + D * f, D * fd / T, D * fdd / T / T))]
                t0, q0 = t0 + T, target
            return [(i, (q0, 0.0, 0.0))]
        if "table" in m:  # through the points: cubic spline, not-a-knot
            from scipy.interpolate import CubicSpline
            with open(os.path.join(self.dir, m["table"])) as f:
                lines = [r for r in csv.reader(f)]
            unit = [UNITS[re.search(r"\[(\w+)\]", h).group(1)] for h in lines[0]]
            xy = np.array([[float(c) for c in r] for r in lines[1:]]) * unit
            s = CubicSpline(xy[:, 0], xy[:, 1], bc_type="not-a-knot")
            return [(i, (float(s(t)), float(s(t, 1)), float(s(t, 2))))]
        raise ValueError(m)

    def rows(self, name, times=None):
        """All rows of a kinematics / inverse-dynamics study, as signal dictionaries; only at `times` (or sweep places) if given."""
        s = self.study(name)
        if "set" in s:
            other = Model(os.path.join(self.dir, self.file), **s["set"]) if hasattr(self, "file") else None
            other.file = self.file
            other.doc["studies"][name] = {k: v for k, v in s.items() if k != "set"}
            return other.rows(name, times)
        hold = {self.index[k]: self.ev(v) for k, v in s.get("hold", {}).items()}
        x, out = self.guess(), []
        if "sweep" in s:
            sw = s["sweep"]
            i, n = self.index[sw["joint"]], sw["points"]
            a, b = self.ev(sw["from"]), self.ev(sw["to"])
            dr = s.get("drive", {"joint": sw["joint"]})
            di = self.index[dr["joint"]]
            rates = {di: (self.ev(dr.get("velocity", 0)), self.ev(dr.get("acceleration", 0))), **{h: (0.0, 0.0) for h in hold}}
            grid = [a + (b - a) * k / (n - 1) for k in range(n)] if n > 1 else [a]
            for k, g in enumerate(grid if times is None else sorted(times, key=lambda p: abs(p - a))):
                x = self.track(x, {i: g, **hold}, first=k == 0)
                c1, c2 = self.solve_rates(x, rates)
                out.append(self.state(x, c1, c2, [di] + list(hold)))
            return out
        T, dt = self.ev(s["duration"]), self.ev(s["step"])
        names = s.get("motions", list(self.doc.get("motions", {})))
        moving = [i for m in names for i, _ in self.motion_of(m, 0.0)]
        drives = [self.index[d] for d in s["drives"]] if "drives" in s else moving
        count = int(round(T / dt))
        for k, t in enumerate([min(k * dt, T) for k in range(count + 1)] if times is None else times):
            now = dict(p for m in names for p in self.motion_of(m, t))
            x = self.track(x, {**{i: v[0] for i, v in now.items()}, **hold}, first=k == 0)
            c1, c2 = self.solve_rates(x, {**{i: v[1:] for i, v in now.items()}, **{h: (0.0, 0.0) for h in hold}})
            out.append(self.state(x, c1, c2, drives + list(hold), time=t))
        return out

    def rest(self, name, free):
        """Equilibrium: the efforts that would hold the coordinates `free` vanish (Newton by differences from their starts)."""
        s = self.study(name)
        if "set" in s:
            other = Model(os.path.join(self.dir, self.file), **s["set"])
            other.file = self.file
            other.doc["studies"][name] = {k: v for k, v in s.items() if k != "set"}
            return other.rest(name, free)
        from scipy.optimize import root
        held = {self.index[k]: self.ev(v) for k, v in s.get("hold", {}).items()}
        idx = [self.index[k] for k in free]
        x = self.guess()
        last = {}

        def at(z):
            last["x"] = self.solve_position(last.get("x", x), {**dict(zip(idx, z)), **held})
            none = np.zeros(self.n)
            return self.state(last["x"], none, none, idx + list(held))

        names = [f"drive.{k}.force" for k in free]
        if not free:
            return at([])
        z = root(lambda z: [at(z)[n] for n in names], [x[self.nb + i] for i in idx], tol=1e-14, method="hybr").x
        return at(z)

    def track(self, x, target, first, parts=1):
        if first:
            return self.solve_position(x, target)
        now = {i: x[self.nb + i] for i in target}
        biggest = max(abs(target[i] - now[i]) for i in target)
        parts = max(1, int(math.ceil(biggest / 0.06)))
        for k in range(1, parts + 1):
            x = self.solve_position(x, {i: now[i] + (target[i] - now[i]) * k / parts for i in target})
        return x

    def facts(self):
        x = self.solve_position(self.guess(), {})
        J = self.jacobian(x)
        sv = np.linalg.svd(J, compute_uv=False)
        rank = (sv > 1e-8 * sv[0]).sum()
        return dict(degrees_of_freedom=self.n - rank, bodies=len(self.bodies), joints=len(self.joints))


def load(path, **kw):
    m = Model(path, **kw)
    m.file = os.path.basename(path)
    return m
