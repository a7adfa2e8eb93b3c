"""A machine as its file describes it."""
import math, os, tomllib
import numpy as np
from .expressions import FUNCTIONS, UNITS, evaluate, nominal
from .series import AXES, quaternion_matrix, rot, rpy


class Machine:
    def __init__(self, path, **override):
        with open(path, "rb") as f:
            self.doc = tomllib.load(f)
        self.dir = os.path.dirname(path)
        d = self.doc
        assert d["bellcrank"] == 1 and d["space"] in ("planar", "spatial")
        self.planar = d["space"] == "planar"
        self.dim = 2 if self.planar else 3
        raw = {k: (v["value"] if isinstance(v, dict) else v) for k, v in d.get("parameters", {}).items()}
        raw = {k: nominal(v) for k, v in raw.items()}
        raw.update(override)
        for k in raw:
            assert k not in UNITS and k not in FUNCTIONS and k not in ("time", "min"), k
        self.par = {}
        for _ in range(len(raw) + 1):
            for k, v in raw.items():
                if k not in self.par:
                    try:
                        self.par[k] = evaluate(v, self.par)
                    except NameError:
                        pass
        assert len(self.par) == len(raw), set(raw) - set(self.par)
        ev = self.ev
        self.gravity = np.array([ev(x) for x in d["gravity"]] + [0.0] * (3 - self.dim))
        self.bodies, self.points = {}, {("ground", "origin"): (np.zeros(3), np.eye(3))}
        for name, p in d.get("ground", {}).get("points", {}).items():
            self.points["ground", name] = self.point(p)
        for name, b in d["bodies"].items():
            inertia = b.get("inertia", 0)
            if self.planar:
                I = np.diag([0, 0, ev(inertia)])
            else:
                v = [ev(x) for x in inertia] if inertia else [0.0] * 3
                v = v + [0.0] * (6 - len(v))
                I = np.array([[v[0], v[3], v[4]], [v[3], v[1], v[5]], [v[4], v[5], v[2]]])
            c = np.array([ev(x) for x in b.get("center", [0, 0, 0])] + [0.0] * 3)[:3]
            assert ("mass" in b) or "center" not in b, name
            self.bodies[name] = dict(mass=ev(b.get("mass", 0)), center=c, inertia=I)
            for pn, p in b.get("points", {}).items():
                self.points[name, pn] = self.point(p)
        self.joints, self.coords = {}, []
        sizes = dict(revolute=1, prismatic=1, cylindrical=2, screw=1, universal=2, spherical=3, planar=3, free=6, weld=0,
                     distance=1, coupler=0)
        sizes["point-on-line"] = 1
        for name, j in d["joints"].items():
            kind = j["kind"]
            n = 0 if kind == "distance" and "length" in j else sizes[kind]
            jt = dict(kind=kind, n=n, name=name)
            if kind == "coupler":
                jt.update(pair=j["joints"], ratio=ev(j["ratio"]), offset=ev(j.get("offset", 0)))
            else:
                jt["ends"] = [tuple(e.split(".")) for e in j["connects"]]
                for e in jt["ends"]:
                    assert e in self.points, (name, e)
                ax = lambda k, default: (lambda a: np.array(a) / np.linalg.norm(a))(
                    np.array(AXES[j.get(k, default)] if isinstance(j.get(k, default), str) else
                             ([float(ev(x)) for x in j[k]] + [0.0])[:3]))
                jt["axis"] = ax("axis", "z")
                if kind == "universal":
                    jt["axis2"] = ax("axis2", "y")
                jt["pitch"] = ev(j.get("pitch", 0)) / (2 * math.pi)
                if "length" in j:
                    jt["length"] = ev(j["length"])
            st = j.get("start", 0)
            st = [ev(x) for x in st] if isinstance(st, list) else [ev(st)] + [0.0] * (n - 1)
            jt["start"] = st if n else []
            st = j.get("start_velocity", 0)
            jt["rates"] = [ev(x) for x in st] if isinstance(st, list) else [ev(st)] + [0.0] * (n - 1)
            jt["first"] = len(self.coords)
            self.coords += [(name, k) for k in range(n)]
            self.joints[name] = jt
        self.index = {}
        for i, (name, k) in enumerate(self.coords):
            self.index[f"{name}.{k}"] = i
            if self.joints[name]["n"] == 1:
                self.index[name] = i
        self.nb = (3 if self.planar else 7) * len(self.bodies)
        self.order = list(self.bodies)
        self.n = self.nb + len(self.coords)

    def ev(self, v, **more):
        return evaluate(v, {**self.par, **more})

    def point(self, p):
        R = np.eye(3)
        if isinstance(p, dict):
            if "rotate" in p:
                r = p["rotate"]
                a = r.get("axis", "z")
                R = rot(AXES[a] if isinstance(a, str) else [self.ev(x) for x in a], self.ev(r["angle"]))
            if "rpy" in p:
                R = rpy(*[self.ev(x) for x in p["rpy"]])
            if "quaternion" in p:
                q = np.array([self.ev(x) for x in p["quaternion"]])
                R = np.array(quaternion_matrix(q / np.linalg.norm(q)))
            p = p["at"]
        return np.array([self.ev(x) for x in p] + [0.0] * (3 - len(p))), R
