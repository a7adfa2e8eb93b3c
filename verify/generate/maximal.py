"""An independent program for the reference numbers: mechanism analysis in absolute coordinates.

It shares nothing with bellcrank but the model file. Every body has its own pose (planar x, y, angle;
spatial place and unit quaternion) and every joint coordinate is an unknown of its own, so the equations
are "pose of the second point = pose of the first point, moved by the joint" and nothing is eliminated.

  position       Gauss-Newton with a complex-step Jacobian (exact to rounding)
  velocity,      the same equations in truncated Taylor series of time: order 1 and order 2 follow
  acceleration   from the order-0 Jacobian, with no formula for a velocity or a Coriolis term
  forces         each body taken free (Newton, Euler); unknowns are the whole wrench of each joint at
                 the second point and the drive efforts; conditions S'W = effort for each coordinate
  uniqueness     a component is unique when it vanishes on the null space of that linear system

Needs numpy.  python3 maximal.py MODEL STUDY  prints the first and last row.
"""
import ast, csv, math, os, re, sys, tomllib
import numpy as np

# ---------------------------------------------------------------- units and expressions
UNITS = dict(m=1.0, mm=1e-3, cm=1e-2, um=1e-6, ft=0.3048, kg=1.0, g=1e-3, t=1e3, lb=0.45359237, s=1.0,
             ms=1e-3, h=3600.0, N=1.0, kN=1e3, lbf=4.4482216152605, Pa=1.0, kPa=1e3, MPa=1e6, GPa=1e9, bar=1e5,
             J=1.0, W=1.0, kW=1e3, Hz=1.0, rpm=2 * math.pi / 60, rad=1.0, deg=math.pi / 180, K=1.0, L=1e-3)
UNITS["in"] = 0.0254
FUNCTIONS = dict(sin=np.sin, cos=np.cos, tan=np.tan, asin=np.arcsin, acos=np.arccos, atan=np.arctan,
                 atan2=np.arctan2, sqrt=np.sqrt, abs=abs, min=min, max=max, sign=np.sign, pi=math.pi)


def python_of(text):
    """The model file's expression as Python: `20 mm/s` means 20*mm/s, `^` is a power."""
    text = re.sub(r"(?<![A-Za-z_\d.])(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+)\s+(?=[A-Za-z])", r"\1*", text)
    text = re.sub(r"\bin\b", "inch", text)
    text = re.sub(r"[A-Za-z_]\w*(?:\.\w+)+", lambda k: f'signal["{k.group(0)}"]', text)
    return text.replace("^", "**")


def nominal(v):
    """"950 ± 0.1 mm" and "950 mm ± 0.1 mm" without the tolerance."""
    parts = re.fullmatch(r"(.*?)\s*±\s*[\d.]+\s*(.*)", v) if isinstance(v, str) else None
    if parts is None:
        return v
    value, unit = parts.groups()
    return value if re.search("[a-z]", value) else f"{value} {unit}"


def evaluate(value, names):
    if isinstance(value, (int, float)):
        return float(value)
    scope = {**UNITS, "inch": 0.0254, **FUNCTIONS, **names}
    return eval(python_of(value), {"__builtins__": {}}, scope)


# ---------------------------------------------------------------- truncated Taylor series
class Jet:
    """c[k] is the coefficient of t^k; each c[k] may carry a batch axis."""

    def __init__(self, c):
        self.c = c

    @staticmethod
    def of(x, like):
        return x if isinstance(x, Jet) else Jet([x + 0 * like.c[0]] + [0 * like.c[0]] * (len(like.c) - 1))

    def __add__(self, o):
        if not isinstance(o, Jet):
            return Jet([self.c[0] + o] + self.c[1:])
        return Jet([a + b for a, b in zip(self.c, o.c)])

    def __mul__(self, o):
        if not isinstance(o, Jet):
            return Jet([a * o for a in self.c])
        n = len(self.c)
        return Jet([sum(self.c[i] * o.c[k - i] for i in range(k + 1)) for k in range(n)])

    __radd__, __rmul__ = __add__, __mul__
    __neg__ = lambda self: self * -1.0
    __sub__ = lambda self, o: self + (-o)
    __rsub__ = lambda self, o: (-self) + o

    def sincos(self):
        s, c = [np.sin(self.c[0])], [np.cos(self.c[0])]
        for k in range(1, len(self.c)):
            s.append(sum(i * self.c[i] * c[k - i] for i in range(1, k + 1)) / k)
            c.append(-sum(i * self.c[i] * s[k - i] for i in range(1, k + 1)) / k)
        return Jet(s), Jet(c)

    def __truediv__(self, o):
        if not isinstance(o, Jet):
            return self * (1.0 / o)
        q = []
        for k in range(len(self.c)):
            q.append((self.c[k] - sum(q[i] * o.c[k - i] for i in range(k))) / o.c[0])
        return Jet(q)

    def __rtruediv__(self, o):
        return Jet.of(o, self) / self

    def __pow__(self, p):
        if p == int(p) and 0 <= p < 8:
            out = Jet.of(1.0, self)
            for _ in range(int(p)):
                out = out * self
            return out
        y = [self.c[0] ** p]
        for k in range(1, len(self.c)):
            y.append(sum((p * i - (k - i)) * self.c[i] * y[k - i] for i in range(1, k + 1)) / (k * self.c[0]))
        return Jet(y)


def _jet_unary(f, g):
    return lambda x: g(x) if isinstance(x, Jet) else f(x)


JET_FUNCTIONS = dict(FUNCTIONS, sin=_jet_unary(np.sin, lambda x: x.sincos()[0]), cos=_jet_unary(np.cos, lambda x: x.sincos()[1]),
                     sqrt=_jet_unary(np.sqrt, lambda x: x ** 0.5))


def matvec(M, v):
    return [sum((M[i][k] * v[k] for k in range(1, len(v))), M[i][0] * v[0]) for i in range(len(M))]


def matmul(A, B):
    return [[sum((A[i][k] * B[k][j] for k in range(1, 3)), A[i][0] * B[0][j]) for j in range(3)] for i in range(3)]


def rotation(axis, sc):
    """Rodrigues; works with jets (sc = (sin, cos)) and numbers."""
    s, c = sc
    x, y, z = [float(a) for a in axis]
    v = 1.0 - c if not isinstance(c, Jet) else (-c) + 1.0
    return [[v * (x * x) + c, v * (x * y) - s * z, v * (x * z) + s * y],
            [v * (x * y) + s * z, v * (y * y) + c, v * (y * z) - s * x],
            [v * (x * z) - s * y, v * (y * z) + s * x, v * (z * z) + c]]


def rot(axis, angle):
    axis = np.asarray(axis, float) / np.linalg.norm(axis)
    return np.array(rotation(axis, (math.sin(angle), math.cos(angle))))


def quaternion_matrix(q):
    w, x, y, z = q
    return [[w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z]]


def matrix_quaternion(R):
    K = np.array([[R[0, 0] - R[1, 1] - R[2, 2], 0, 0, 0], [R[0, 1] + R[1, 0], R[1, 1] - R[0, 0] - R[2, 2], 0, 0],
                  [R[0, 2] + R[2, 0], R[1, 2] + R[2, 1], R[2, 2] - R[0, 0] - R[1, 1], 0],
                  [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], np.trace(R)]]) / 3
    v = np.linalg.eigh(K)[1][:, -1]
    return np.array([v[3], v[0], v[1], v[2]])


AXES = dict(x=[1.0, 0, 0], y=[0, 1.0, 0], z=[0, 0, 1.0])
skew = lambda a: np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def rpy(r, p, y):
    return rot(AXES["z"], y) @ rot(AXES["y"], p) @ rot(AXES["x"], r)


# ---------------------------------------------------------------- motion profiles (their closed formulas)
def profile(kind, u):
    """Fraction of the stroke, and its derivatives to u, for u in [0, 1]."""
    if kind == "linear":
        return u, 1.0, 0.0
    if kind == "cycloidal":
        w = 2 * math.pi
        return u - math.sin(w * u) / w, 1 - math.cos(w * u), w * math.sin(w * u)
    if kind == "poly5":
        return u**3 * (10 - 15 * u + 6 * u * u), 30 * u * u * (1 - u) ** 2, 60 * u * (1 - u) * (1 - 2 * u)
    if kind == "trapezoid":  # thirds
        if u > 0.5:
            s, v, a = profile(kind, 1 - u)
            return 1 - s, v, -a
        return (2.25 * u * u, 4.5 * u, 4.5) if u < 1 / 3 else (0.25 + 1.5 * (u - 1 / 3), 1.5, 0.0)
    if kind == "s-curve":  # thirds, the accelerations ramped over a ninth, held a ninth, ramped a ninth
        if u > 0.5:
            s, v, a = profile(kind, 1 - u)
            return 1 - s, v, -a
        j, n = 60.75, 1 / 9
        ramp = lambda x: max(0.0, x)
        s = sum(k * j * ramp(u - i * n) ** 3 / 6 for i, k in enumerate((1, -1, -1, 1)))
        return (s, sum(k * j * ramp(u - i * n) ** 2 / 2 for i, k in enumerate((1, -1, -1, 1))),
                sum(k * j * ramp(u - i * n) for i, k in enumerate((1, -1, -1, 1))))
    raise ValueError(kind)


# ---------------------------------------------------------------- the model
class Model:
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

    # --- equations. x: list of jets (bodies then coordinates); returns a list of jets
    def pose(self, x, body):
        zero = x[0] * 0.0
        if body == "ground":
            return [zero] * 3, [[zero + float(i == j) for j in range(3)] for i in range(3)], zero
        i = self.order.index(body)
        if self.planar:
            px, py, th = x[3 * i : 3 * i + 3]
            s, c = th.sincos()
            return [px, py, zero], [[c, -s, zero], [s, c, zero], [zero, zero, zero + 1.0]], th
        return x[7 * i : 7 * i + 3], quaternion_matrix(x[7 * i + 3 : 7 * i + 7]), None

    def frame(self, x, end):
        p, R, th = self.pose(x, end[0])
        a, A = self.points[end]
        rp = matvec(R, [float(v) for v in a])
        return [p[i] + rp[i] for i in range(3)], matmul(R, [[float(v) for v in r] for r in A]), th, math.atan2(A[1, 0], A[0, 0])

    def coordinate(self, x, ref):
        return x[self.nb + self.index[ref]]

    def residual(self, x):
        out = []
        for name, j in self.joints.items():
            k, q = j["kind"], x[self.nb + j["first"] : self.nb + j["first"] + j["n"]]
            if k == "coupler":
                a, b = (self.coordinate(x, r) for r in j["pair"])
                out.append(b - a * j["ratio"] - j["offset"])
                continue
            p1, R1, t1, f1 = self.frame(x, j["ends"][0])
            p2, R2, t2, f2 = self.frame(x, j["ends"][1])
            d = [p2[i] - p1[i] for i in range(3)]
            if k == "distance":
                L = q[0] if j["n"] else j["length"]
                out.append(sum((d[i] * d[i] for i in range(1, self.dim)), d[0] * d[0]) - L * L)
                continue
            zero = x[0] * 0.0
            move, turn = [zero] * 3, None
            a = j["axis"]
            if k in ("prismatic", "point-on-line"):
                move = [q[0] * float(v) for v in a]
            elif k == "cylindrical":
                move, turn = [q[0] * float(v) for v in a], [(a, q[1])]
            elif k == "screw":
                move, turn = [q[0] * (j["pitch"] * float(v)) for v in a], [(a, q[0])]
            elif k == "revolute":
                turn = [(a, q[0])]
            elif k == "universal":
                turn = [(a, q[0]), (j["axis2"], q[1])]
            elif k == "spherical":
                turn = [(AXES["z"], q[2]), (AXES["y"], q[1]), (AXES["x"], q[0])]
            elif k == "planar":
                move, turn = [q[0], q[1], zero], [(AXES["z"], q[2])]
            elif k == "free":
                move, turn = q[:3], [(AXES["z"], q[5]), (AXES["y"], q[4]), (AXES["x"], q[3])]
            moved = matvec(R1, move)
            out += [d[i] - moved[i] for i in range(self.dim)]
            if k == "point-on-line":
                continue
            if self.planar:
                q_turn = turn[0][1] if turn else zero
                if k == "revolute" and a[2] < 0:
                    q_turn = -q_turn
                out.append(t2 + f2 - t1 - f1 - q_turn)
            else:
                M = R1
                for ax, an in turn or []:
                    M = matmul(M, rotation(ax, an.sincos()))
                out += [R2[i][m] - M[i][m] for i in range(3) for m in range(3)]
        if not self.planar:
            for i in range(len(self.order)):
                w, a, b, c = x[7 * i + 3 : 7 * i + 7]
                out.append(w * w + a * a + b * b + c * c - 1.0)
        return out

    def jacobian(self, x0):
        h = 1e-30
        P = np.repeat(x0[:, None].astype(complex), self.n, axis=1) + 1j * h * np.eye(self.n)
        r = self.residual([Jet([P[i]]) for i in range(self.n)])
        return np.array([np.broadcast_to(v.c[0], self.n).imag / h for v in r])

    def value(self, x0):
        return np.array([v.c[0][0] for v in self.residual([Jet([np.array([v])]) for v in x0])])

    # --- assembly
    def guess(self):
        """Walk the joints from ground with the start values."""
        x = np.zeros(self.n)
        R, p, th, done = {"ground": np.eye(3)}, {"ground": np.zeros(3)}, {"ground": 0.0}, {"ground"}
        for j in self.joints.values():
            for k in range(j["n"]):
                x[self.nb + j["first"] + k] = j["start"][k]
        again = True
        while again:
            again = False
            for j in self.joints.values():
                if j["kind"] in ("coupler", "distance", "point-on-line"):
                    continue
                (b1, _), (b2, _) = j["ends"]
                if (b1 in done) == (b2 in done):
                    continue
                q, a, k = j["start"], j["axis"], j["kind"]
                M, v = np.eye(3), np.zeros(3)
                if k == "revolute": M = rot(a, q[0])
                if k == "prismatic": v = q[0] * a
                if k == "cylindrical": v, M = q[0] * a, rot(a, q[1])
                if k == "screw": v, M = q[0] * j["pitch"] * a, rot(a, q[0])
                if k == "universal": M = rot(a, q[0]) @ rot(j["axis2"], q[1])
                if k == "spherical": M = rpy(*q)
                if k == "planar": v, M = np.array([q[0], q[1], 0]), rot(AXES["z"], q[2])
                if k == "free": v, M = np.array(q[:3]), rpy(*q[3:])
                (a1, A1), (a2, A2) = self.points[j["ends"][0]], self.points[j["ends"][1]]
                if b1 in done:
                    F = R[b1] @ A1
                    R[b2] = F @ M @ A2.T
                    p[b2] = p[b1] + R[b1] @ a1 + F @ v - R[b2] @ a2
                    new = b2
                else:
                    F = R[b2] @ A2
                    F1 = F @ M.T
                    R[b1] = F1 @ A1.T
                    p[b1] = p[b2] + R[b2] @ a2 - F1 @ v - R[b1] @ a1
                    new = b1
                done.add(new)
                again = True
        for i, b in enumerate(self.order):
            assert b in done, f"{b} is not reached by the walk"
            if self.planar:
                x[3 * i : 3 * i + 3] = [p[b][0], p[b][1], math.atan2(R[b][1, 0], R[b][0, 0])]
            else:
                x[7 * i : 7 * i + 3] = p[b]
                x[7 * i + 3 : 7 * i + 7] = matrix_quaternion(R[b])
        if self.planar:
            self.unwrap(x)
        return x

    def unwrap(self, x):
        """Body angles continue the joint starts (no jumps of a turn)."""
        for _ in range(len(self.joints)):
            for j in self.joints.values():
                if j["kind"] in ("revolute", "prismatic", "weld", "planar"):
                    (b1, n1), (b2, n2) = j["ends"]
                    ang = lambda b: 0.0 if b == "ground" else x[3 * self.order.index(b) + 2]
                    f = lambda e: math.atan2(self.points[e][1][1, 0], self.points[e][1][0, 0])
                    q = {"revolute": (j["start"] or [0])[0], "planar": (j["start"] + [0, 0, 0])[2]}.get(j["kind"], 0.0)
                    gap = ang(b2) + f(j["ends"][1]) - ang(b1) - f(j["ends"][0]) - q
                    turns = round(gap / (2 * math.pi))
                    if turns and b2 != "ground":
                        x[3 * self.order.index(b2) + 2] -= 2 * math.pi * turns

    def solve_position(self, x, rows):
        """rows: {coordinate index: value}. Gauss-Newton; steps bounded so that the branch is kept."""
        idx = list(rows)
        E = np.zeros((len(idx), self.n))
        for r, i in enumerate(idx):
            E[r, self.nb + i] = 1.0
        for it in range(200):
            f = np.concatenate([self.value(x), [x[self.nb + i] - rows[i] for i in idx]])
            dx = -np.linalg.lstsq(np.vstack([self.jacobian(x), E]), f, rcond=1e-11)[0]
            step = min(1.0, 0.3 / (np.abs(dx).max() + 1e-300))
            x = x + step * dx
            if np.abs(dx).max() < 1e-14 * (1 + np.abs(x).max()) or (step == 1 and np.abs(f).max() < 3e-16):
                break
        f = np.concatenate([self.value(x), [x[self.nb + i] - rows[i] for i in idx]])
        assert np.abs(f).max() < 1e-11, ("no assembly", np.abs(f).max())
        return x

    def solve_rates(self, x, rates):
        """rates: {coordinate index: (velocity, acceleration)}. Returns Taylor coefficients c1, c2."""
        idx = list(rates)
        E = np.zeros((len(idx), self.n))
        for r, i in enumerate(idx):
            E[r, self.nb + i] = 1.0
        A = np.vstack([self.jacobian(x), E])
        sv = np.linalg.svd(A, compute_uv=False)
        self.rank_gap = sv
        z = np.zeros(self.n)

        def residual_at(c1, c2, k):
            r = self.residual([Jet([np.array([x[i]]), np.array([c1[i]]), np.array([c2[i]])]) for i in range(self.n)])
            return np.array([v.c[k][0] for v in r])

        solve = lambda b: np.linalg.lstsq(A, b, rcond=1e-11)[0]
        c1 = solve(np.concatenate([-residual_at(z, z, 1), [rates[i][0] for i in idx]]))
        c2 = solve(np.concatenate([-residual_at(c1, z, 2), [rates[i][1] / 2 for i in idx]]))
        return c1, c2

    # --- kinematic quantities of bodies
    def motion(self, x, c1, c2):
        J = [Jet([np.array([x[i]]), np.array([c1[i]]), np.array([c2[i]])]) for i in range(self.n)]
        num = lambda M, k: np.array([[e.c[k][0] for e in r] for r in M])
        out = {}
        for b in ["ground"] + self.order:
            p, R, th = self.pose(J, b)
            P = [np.array([e.c[k][0] for e in p]) * (2 if k == 2 else 1) for k in range(3)]
            R0, R1, R2 = num(R, 0), num(R, 1), 2 * num(R, 2)
            W = R1 @ R0.T
            A = R2 @ R0.T + R1 @ R1.T
            vee = lambda S: 0.5 * np.array([S[2, 1] - S[1, 2], S[0, 2] - S[2, 0], S[1, 0] - S[0, 1]])
            m = dict(p=P[0], v=P[1], a=P[2], R=R0, w=vee(W), al=vee(A))
            if self.planar:
                m["angle"] = th.c[0][0]
            out[b] = m
        return out

    @staticmethod
    def at(m, local):
        """Place, velocity, acceleration of a body-fixed point."""
        r = m["R"] @ local
        return (m["p"] + r, m["v"] + np.cross(m["w"], r), m["a"] + np.cross(m["al"], r) + np.cross(m["w"], np.cross(m["w"], r)))

    def subspace(self, j, mo, q):
        """Twists [w; v] of the second body against the first, at the second point, one a coordinate."""
        (b1, _), (b2, _) = j["ends"]
        A1, A2 = self.points[j["ends"][0]][1], self.points[j["ends"][1]][1]
        R1, R2 = mo[b1]["R"] @ A1, mo[b2]["R"] @ A2
        z = np.zeros(3)
        a, k = R1 @ j["axis"], j["kind"]
        T = lambda w, v: np.concatenate([w, v])
        if k == "revolute": return [T(a, z)]
        if k in ("prismatic",): return [T(z, a)]
        if k == "cylindrical": return [T(z, a), T(a, z)]
        if k == "screw": return [T(a, j["pitch"] * a)]
        if k == "universal": return [T(a, z), T(R2 @ j["axis2"], z)]
        if k in ("spherical", "free"):
            r = q[-3:]
            Rz = rot(AXES["z"], r[2])
            W = [R1 @ Rz @ rot(AXES["y"], r[1]) @ [1, 0, 0], R1 @ Rz @ [0, 1, 0], R1 @ np.array([0, 0, 1.0])]
            S = [T(w, z) for w in W]
            return S if k == "spherical" else [T(z, R1[:, i]) for i in range(3)] + S
        if k == "planar": return [T(z, R1[:, 0]), T(z, R1[:, 1]), T(R1[:, 2], z)]
        if k == "weld": return []
        if k == "distance":
            p1 = self.at(mo[b1], self.points[j["ends"][0]][0])[0]
            p2 = self.at(mo[b2], self.points[j["ends"][1]][0])[0]
            u = (p2 - p1) / np.linalg.norm(p2 - p1)
            return [T(z, u)] if j["n"] else []
        if k == "point-on-line": return [T(z, a)]

    def wrench_basis(self, j, mo):
        """Directions of the joint's wrench [moment; force] that are unknown (all but for point/distance joints)."""
        full = np.eye(6)[:, [2, 3, 4]] if self.planar else np.eye(6)
        if j["kind"] == "distance":
            (b1, _), (b2, _) = j["ends"]
            p1 = self.at(mo[b1], self.points[j["ends"][0]][0])[0]
            p2 = self.at(mo[b2], self.points[j["ends"][1]][0])[0]
            return np.concatenate([np.zeros(3), (p2 - p1) / np.linalg.norm(p2 - p1)])[:, None]
        if j["kind"] == "point-on-line":
            return np.eye(6)[:, [3, 4]] if self.planar else np.eye(6)[:, [3, 4, 5]]
        return full

    # --- one state: kinematics and forces
    def state(self, x, c1, c2, drives, time=0.0, sweep_axis=True):
        mo = self.motion(x, c1, c2)
        q, qd, qdd = x[self.nb :], c1[self.nb :], 2 * c2[self.nb :]
        sig = {"time": time}
        for i, (name, k) in enumerate(self.coords):
            tail = "" if self.joints[name]["n"] == 1 else f".{k}"
            sig[f"joint.{name}.position{tail}"], sig[f"joint.{name}.velocity{tail}"] = q[i], qd[i]
            sig[f"joint.{name}.acceleration{tail}"] = qdd[i]
        kin = 0.0
        pot = 0.0
        for b in self.order:
            m = mo[b]
            P, V, A = self.at(m, self.bodies[b]["center"])
            for i, ax in enumerate("xyz"[: self.dim]):
                sig[f"body.{b}.{ax}"], sig[f"body.{b}.v{ax}"], sig[f"body.{b}.a{ax}"] = P[i], V[i], A[i]
            if self.planar:
                sig[f"body.{b}.angle"], sig[f"body.{b}.omega"], sig[f"body.{b}.alpha"] = m["angle"], m["w"][2], m["al"][2]
            else:
                for i, ax in enumerate("xyz"):
                    sig[f"body.{b}.omega_{ax}"], sig[f"body.{b}.alpha_{ax}"] = m["w"][i], m["al"][i]
                R = m["R"]
                sig[f"body.{b}.roll"], sig[f"body.{b}.yaw"] = math.atan2(R[2, 1], R[2, 2]), math.atan2(R[1, 0], R[0, 0])
                sig[f"body.{b}.pitch"] = math.asin(max(-1, min(1, -R[2, 0])))
            I = m["R"] @ self.bodies[b]["inertia"] @ m["R"].T
            kin += 0.5 * self.bodies[b]["mass"] * V @ V + 0.5 * m["w"] @ I @ m["w"]
            pot -= self.bodies[b]["mass"] * self.gravity @ P
        for (b, pn), (a, _) in self.points.items():
            P, V, A = self.at(mo[b], a)
            for i, ax in enumerate("xyz"[: self.dim]):
                sig[f"point.{b}.{pn}.{ax}"], sig[f"point.{b}.{pn}.v{ax}"], sig[f"point.{b}.{pn}.a{ax}"] = P[i], V[i], A[i]
        sig["energy.kinetic"] = kin
        # loads [moment about the body origin; force]
        load = {b: np.zeros(6) for b in ["ground"] + self.order}
        effort = np.zeros(len(self.coords))

        def push(body, place, force, moment=np.zeros(3)):
            load[body][:3] += np.cross(place - mo[body]["p"], force) + moment
            load[body][3:] += force

        for b in self.order:
            B, m = self.bodies[b], mo[b]
            P, V, A = self.at(m, B["center"])
            I = m["R"] @ B["inertia"] @ m["R"].T
            push(b, P, B["mass"] * (self.gravity - A), -(I @ m["al"] + np.cross(m["w"], I @ m["w"])))
        ex = lambda v: self.ev(v, time=time, signal=sig)
        frictions = []
        for fname, f in self.doc.get("forces", {}).items():
            k = f["kind"]
            if k == "force":
                b, pn = f["on"].split(".")
                v = np.array([ex(e) for e in f["vector"]] + [0.0])[:3]
                if f.get("axes", "world") == "body":
                    v = mo[b]["R"] @ v
                push(b, self.at(mo[b], self.points[b, pn][0])[0], v)
            elif k == "torque":
                b = f["on"]
                v = np.array([0, 0, ex(f["value"])]) if self.planar else np.array([ex(e) for e in f["vector"]])
                if f.get("axes", "world") == "body":
                    v = mo[b]["R"] @ v
                push(b, mo[b]["p"], np.zeros(3), v)
            elif k == "effort":
                effort[self.index[f["joint"]]] += ex(f["value"])
            elif k == "spring":
                e1, e2 = [tuple(e.split(".")) for e in f["between"]]
                p1, v1, _ = self.at(mo[e1[0]], self.points[e1][0])
                p2, v2, _ = self.at(mo[e2[0]], self.points[e2][0])
                L = np.linalg.norm(p2 - p1)
                u = (p2 - p1) / L
                rate = u @ (v2 - v1)
                kk, L0 = ex(f.get("stiffness", 0)), ex(f.get("free_length", 0))
                tension = kk * (L - L0) + ex(f.get("damping", 0)) * rate - ex(f.get("preload", 0))
                push(e1[0], p1, tension * u)
                push(e2[0], p2, -tension * u)
                sig[f"force.{fname}.length"], sig[f"force.{fname}.rate"] = L, rate
                pot += 0.5 * kk * (L - L0) ** 2 - ex(f.get("preload", 0)) * (L - L0)
            elif k == "joint-spring":
                i = self.index[f["joint"]]
                kk, q0 = ex(f.get("stiffness", 0)), ex(f.get("free_position", 0))
                effort[i] -= kk * (q[i] - q0) + ex(f.get("damping", 0)) * qd[i]
                pot += 0.5 * kk * (q[i] - q0) ** 2
            elif k == "stop":
                i, kk, c = self.index[f["joint"]], ex(f["stiffness"]), ex(f.get("damping", 0))
                if "max" in f and q[i] > ex(f["max"]):
                    effort[i] -= max(0.0, kk * (q[i] - ex(f["max"])) + c * qd[i])
                if "min" in f and q[i] < ex(f["min"]):
                    effort[i] += max(0.0, kk * (ex(f["min"]) - q[i]) - c * qd[i])
            elif k == "friction":
                frictions.append((f["joint"], f))
            elif k == "bushing":
                e1, e2 = [tuple(e.split(".")) for e in f["between"]]
                R1 = mo[e1[0]]["R"] @ self.points[e1][1]
                R2 = mo[e2[0]]["R"] @ self.points[e2][1]
                p1, v1, _ = self.at(mo[e1[0]], self.points[e1][0])
                p2, v2, _ = self.at(mo[e2[0]], self.points[e2][0])
                v1 = v1 + np.cross(mo[e1[0]]["w"], p2 - p1)
                d, dv = R1.T @ (p2 - p1), R1.T @ (v2 - v1)
                w = R1.T @ (mo[e2[0]]["w"] - mo[e1[0]]["w"])
                Rr = R1.T @ R2
                ang = np.array([0, 0, math.atan2(Rr[1, 0], Rr[0, 0])]) if self.planar else rotation_vector(Rr)
                ks, cs = [ex(e) for e in f["stiffness"]], [ex(e) for e in f.get("damping", [0] * (3 if self.planar else 6))]
                if self.planar:
                    ks, cs = [ks[0], ks[1], 0, 0, 0, ks[2]], [cs[0], cs[1], 0, 0, 0, cs[2]]
                F = R1 @ -(np.array(ks[:3]) * d + np.array(cs[:3]) * dv)
                M = R1 @ -(np.array(ks[3:]) * ang + np.array(cs[3:]) * w)
                push(e2[0], p2, F, M)
                push(e1[0], p2, -F, -M)
            else:
                raise ValueError(k)
        sig["energy.potential"] = pot
        # unknown wrenches and efforts
        cols, where = [], {}
        rows_b = {b: i for i, b in enumerate(self.order)}
        keep = [2, 3, 4] if self.planar else list(range(6))
        nbr = len(keep) * len(self.order)
        spans, nun = {}, 0
        for name, j in self.joints.items():
            if j["kind"] == "coupler":
                spans[name] = (nun, 1)
                nun += 1
                continue
            B = self.wrench_basis(j, mo)
            spans[name] = (nun, B.shape[1])
            nun += B.shape[1]
        dpos = {d: nun + i for i, d in enumerate(drives)}
        nun += len(drives)
        nrow = nbr + len(self.coords)
        A, b = np.zeros((nrow + len(self.joints) * 6, nun)), np.zeros(nrow + len(self.joints) * 6)
        extra = nrow
        for bn in self.order:
            i = rows_b[bn] * len(keep)
            b[i : i + len(keep)] = -load[bn][keep]
        def shift(place, body):
            """Wrench at `place` to the body origin."""
            X = np.eye(6)
            X[:3, 3:] = skew(place - mo[body]["p"])
            return X
        basis = {}
        for name, j in self.joints.items():
            s, w = spans[name]
            if j["kind"] == "coupler":
                ia, ib = (self.index[r] for r in j["pair"])
                A[nbr + ia, s] += j["ratio"]
                A[nbr + ib, s] -= 1.0
                continue
            B = self.wrench_basis(j, mo)
            basis[name] = B
            p2 = self.at(mo[j["ends"][1][0]], self.points[j["ends"][1]][0])[0]
            for body, sign in ((j["ends"][0][0], -1.0), (j["ends"][1][0], 1.0)):
                if body != "ground":
                    i = rows_b[body] * len(keep)
                    A[i : i + len(keep), s : s + w] += sign * (shift(p2, body) @ B)[keep]
            for k, S in enumerate(self.subspace(j, mo, q[j["first"] : j["first"] + j["n"]])):
                A[nbr + j["first"] + k, s : s + w] += S @ B
        for d, c in dpos.items():
            A[nbr + d, c] = -1.0
        tail = effort.copy()
        for _ in range(1 + 400 * bool(frictions)):
            b[nbr:nrow] = tail
            sol, *_ = np.linalg.lstsq(A[:nrow], b[:nrow], rcond=1e-12)
            W = {n: basis[n] @ sol[spans[n][0] : sum(spans[n])] for n in basis}
            new = effort.copy()
            for ref, f in frictions:
                name = ref.split(".")[0]
                j, i = self.joints[name], self.index[ref]
                S = self.subspace(j, mo, q[j["first"] : j["first"] + j["n"]])[int(ref.split(".")[1]) if "." in ref else 0]
                along = S[3:] if np.linalg.norm(S[3:]) > 0 else S[:3]
                F = W[name][3:]
                normal = np.linalg.norm(F - along * (F @ along))
                mu = ex(f.get("coulomb", 0))
                if "stribeck_velocity" in f:
                    mu = mu + (ex(f["static"]) - mu) * math.exp(-((qd[i] / ex(f["stribeck_velocity"])) ** 2))
                arm = ex(f["radius"]) if "radius" in f else 1.0
                new[i] -= mu * arm * normal * np.sign(qd[i]) + ex(f.get("viscous", 0)) * qd[i]
            if np.abs(new - tail).max() <= 1e-15 * (1 + np.abs(new).max()):
                tail = new
                break
            tail = new
        self.force_residual = np.abs(A[:nrow] @ sol - b[:nrow]).max()
        U, sv, Vt = np.linalg.svd(A[:nrow])
        rank = (sv > 1e-9 * sv[0]).sum()
        N = Vt[rank:].T
        unique = {}
        for name in basis:
            NW = basis[name] @ N[spans[name][0] : sum(spans[name])] if N.size else np.zeros((6, 1))
            for comp, i in zip(["mx", "my", "mz", "fx", "fy", "fz"], range(6)):
                if not self.planar or comp in ("fx", "fy", "mz"):
                    sig[f"joint.{name}.reaction.{comp}"] = W[name][i]
                    unique[f"{name}.{comp}"] = bool(np.abs(NW[i]).max() < 1e-7)
            sig[f"joint.{name}.reaction.force"] = np.linalg.norm(W[name][3:])
            sig[f"joint.{name}.reaction.moment"] = np.linalg.norm(W[name][:3])
        for d, c in dpos.items():
            name, k = self.coords[d]
            tail = "" if self.joints[name]["n"] == 1 else f".{k}"
            sig[f"drive.{name}.force{tail}"] = sol[c]
            sig[f"drive.{name}.power{tail}"] = sol[c] * qd[d]
            unique[f"drive.{name}{tail}"] = bool(N.size == 0 or np.abs(N[c]).max() < 1e-7)
        sig["#unique"], sig["#redundant"] = unique, N.shape[1]
        return sig

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


def rotation_vector(R):
    c = (np.trace(R) - 1) / 2
    v = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    s = np.linalg.norm(v)
    return v if s < 1e-14 else v / s * math.atan2(s, c)


def load(path, **kw):
    m = Model(path, **kw)
    m.file = os.path.basename(path)
    return m


if __name__ == "__main__":
    rows = load(sys.argv[1]).rows(sys.argv[2])
    for k in rows[0]:
        if not k.startswith("#"):
            print(f"{k:40s} {rows[0][k]:22.14g} {rows[-1][k]:22.14g}")
