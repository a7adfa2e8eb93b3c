"""References of published dynamics cases: Andrews' squeezer, IFToMM A01 and A02, heavy top, Whipple bicycle, small vibrations."""
import json, math, os
import numpy as np
from mpmath import mp, mpf
from maximal import quaternion_matrix
from reference import Reference, case
from ode import solve

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "published_dynamics.json")) as f:
    DATA = json.load(f)

# ---------------------------------------------------------------- Andrews' squeezer
ref = Reference("other-code", "reference set C01: test-set equations and an absolute-coordinate model, both in quadruple precision, agree to 1e-20; IVP test set, Hairer and Wanner, IFToMM A03")
names = ["beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon"]
for t, row in DATA["andrews"].items():
    if float(t) > 0.03:
        continue
    at = {"time": f"{float(t):g} s"}
    q, v, w, lam = ([float(x) for x in row[k]] for k in ("q", "qdot", "qddot", "lambda_"))
    size = lambda a: max(abs(x) for x in a)
    ref.row("whirl", at, {f"joint.{n}.position": (x, "rad") for n, x in zip(names, q)}, rtol=1e-9, atol={"rad": 1e-8})
    ref.row("whirl", at, {f"joint.{n}.velocity": (x, "rad/s") for n, x in zip(names, v)}, rtol=1e-8, atol={"rad/s": 1e-8 * size(v)})
    ref.row("whirl", at, {f"joint.{n}.acceleration": (x, "rad/s^2") for n, x in zip(names, w)}, rtol=1e-7, atol={"rad/s^2": 1e-7 * size(w)})
    ref.row("whirl", at, {f"joint.{n}.reaction.{c}": (lam[k], "N") for k, (n, c) in enumerate((n, c) for n in ("E3", "E4", "E6") for c in ("fx", "fy"))},
            rtol=1e-7, atol={"N": 1e-7 * size(lam)})
    ref.row("implicit", at, {f"joint.{n}.position": (x, "rad") for n, x in zip(names, q)}, rtol=0, atol={"rad": 1e-3})
ref.value("whirl", 0, "J", reduce="range(energy.total - torque*joint.beta.position/1 rad)", atol=1e-10)
ref.value("whirl", 0, "m", reduce="max(check.closure)", atol=1e-12)
ref.fact(degrees_of_freedom=1, loops=3, redundant=0, bodies=7, joints=10).write(*case("andrews-squeezer"))

# ---------------------------------------------------------------- A01, and a swing of 170 degrees
ref = Reference("analytic", "Jacobi elliptic functions: IFToMM A01 (reference set C03), and a compound pendulum with an amplitude of 170 degrees (verify/generate/dynamics_published.py)")
mp.dps = 30


def swing(amplitude, w0, t, phase=0):
    """Angle from below and its rate, let go at `amplitude` at t = 0."""
    k = mp.sin(amplitude / 2)
    u = mp.ellipk(k * k) + w0 * t
    sn, cn, dn = (mp.ellipfun(f, u, m=k * k) for f in ("sn", "cn", "dn"))
    return 2 * mp.asin(k * sn), 2 * k * w0 * cn


for row in DATA["a01"]:
    t, (x, y, vx, vy, phi, rate) = row[0], (float(v) for v in row[1:])
    a, w = swing(-mp.pi / 2, mp.sqrt(mpf("9.81")), mpf(str(t)))
    assert abs(a - phi) < 1e-12 and abs(w - rate) < 1e-12, (t, a, phi)
    at = {"time": f"{t:g} s"}
    ref.row("swing", at, {"point.bob.P.x": (x, "m"), "point.bob.P.y": (y, "m"), "point.bob.P.vx": (vx, "m/s"), "point.bob.P.vy": (vy, "m/s"),
        "joint.hinge.position": (phi - math.pi / 2, "rad"), "joint.hinge.velocity": (rate, "rad/s")}, rtol=0, atol={"m": 1e-9, "m/s": 1e-8, "rad": 1e-9, "rad/s": 1e-8})
    if t <= 2:
        ref.row("implicit", at, {"point.bob.P.x": (x, "m"), "point.bob.P.y": (y, "m")}, rtol=0, atol={"m": 1e-3})
for t in (1, 2.5, 5, 7.5, 10):
    a, w = swing(170 * mp.pi / 180, mp.sqrt(mpf(3) * mpf("9.81") * mpf("0.2") / (mpf("0.25") + 3 * mpf("0.04"))), mpf(str(t)))
    ref.row("swing", {"time": f"{t:g} s"}, {"joint.high.position": (float(a - mp.pi / 2), "rad"), "joint.high.velocity": (float(w), "rad/s")}, rtol=0, atol={"rad": 1e-8, "rad/s": 1e-7})
ref.value("swing", 0, "J", reduce="range(energy.total)", atol=1e-9)
ref.fact(degrees_of_freedom=2, loops=0, redundant=0, bodies=2, joints=2).write(*case("pendulum-a01"))

# ---------------------------------------------------------------- A02: N four-bars are one rotating pendulum

def four_bars(n, times):
    inertia, moment = (n + 1) / 3 + n, (n + 1) / 2 + n
    return solve(lambda t, y: np.array([y[1], -9.81 * moment / inertia * math.cos(y[0])]), [math.pi / 2, -1.0], times)


def rows(ref, n, times, reading, tolerance):
    for t, (a, w) in zip(times, reading):
        ref.row("turn", {"time": f"{t:g} s"}, {"joint.a0.position": (a, "rad"), "joint.a0.velocity": (w, "rad/s"), f"joint.a{n}.position": (a, "rad"),
            "point.v0.B.x": (math.cos(a), "m"), "point.v0.B.y": (math.sin(a), "m"), f"point.c{n}.B.x": (n + math.cos(a), "m"), f"point.c{n}.B.vy": (w * math.cos(a), "m/s"), f"body.c{n}.omega": (0, "rad/s")},
            rtol=0, atol={"m": tolerance, "m/s": 10 * tolerance, "rad": tolerance, "rad/s": 10 * tolerance})
    ref.value("turn", 0, "J", reduce="range(energy.total)", atol=n * tolerance)
    ref.fact(degrees_of_freedom=1, loops=n, redundant=0, bodies=2 * n + 1, joints=3 * n + 1)


table = [[float(v) for v in r] for r in DATA["a02"]]
ref = Reference("analytic", "reference set C03 (IFToMM A02): all vertical links stay parallel, so the machine is one rotating pendulum")
for r, (a, w) in zip(table, four_bars(2, [r[0] for r in table])):
    assert abs(a - r[5]) < 1e-9 and abs(w - r[6]) < 1e-9, (r[0], a - r[5])
rows(ref, 2, [r[0] for r in table], [(r[5], r[6]) for r in table], 1e-6)
ref.write(*case("n-four-bar-free"))
ref = Reference("analytic", "all vertical links stay parallel, so the machine is one rotating pendulum (scipy, 1e-13; agrees with reference set C03 for N = 2)")
times = [0.5, 1.0, 1.5, 2.0]
rows(ref, 40, times, four_bars(40, times), 1e-6)
ref.write(*case("n-four-bar-free-40"))

# ---------------------------------------------------------------- heavy top
ref = Reference("other-code", "reference set C06 (Bruls, Cardona and Arnold), quadruple precision; published Runge-Kutta values at 0.2 s agree to all their digits")
for row in DATA["heavy_top"]:
    t, place, p, v, W, lam = row[0], row[1:4], np.array(row[4:8]), row[8:11], np.array(row[11:14]), row[14:17]
    w = np.array(quaternion_matrix(p)) @ W
    at = {"time": f"{t:g} s"}
    ref.row("spin", at, {**{f"point.top.C.{c}": (x, "m") for c, x in zip("xyz", place)}, **{f"point.top.C.v{c}": (x, "m/s") for c, x in zip("xyz", v)},
        **{f"body.top.omega_{c}": (x, "rad/s") for c, x in zip("xyz", w)}, **{f"joint.tip.reaction.f{c}": (-x, "N") for c, x in zip("xyz", lam)}},
        rtol=0, atol={"m": 1e-8, "m/s": 1e-7, "rad/s": 1e-6, "N": 1e-5})
    if t <= 1:
        ref.row("implicit", at, {f"point.top.C.{c}": (x, "m") for c, x in zip("xyz", place)}, rtol=0, atol={"m": 1e-2})
ref.value("spin", 0, "J", reduce="range(energy.total)", atol=1e-6)
# 150 rad/s about the axis, all the time: the axis is the line from the tip to C.
ref.value("spin", 0, "m/s", reduce="max(abs(body.top.omega_x*point.top.C.x + body.top.omega_y*point.top.C.y + body.top.omega_z*point.top.C.z - 150 m/s*1 rad))", atol=1e-8)
ref.fact(degrees_of_freedom=3, loops=0, redundant=0, bodies=1, joints=1).write(*case("heavy-top"))

# ---------------------------------------------------------------- small vibrations
ref = Reference("analytic", "omega^2 = 3 (1 -+ 2/sqrt 7) g/L (reference set C07)")
for i, s in enumerate((-1, 1)):
    ref.summary("ring", f"modes.{i}.frequency.value", math.sqrt(3 * (1 + 2 * s / math.sqrt(7)) * 9.81) / (2 * math.pi), "Hz", rtol=1e-9).summary("ring", f"modes.{i}.damping", 0, atol=1e-9)
ref.summary("ring", "freedom", 2).write(*case("modes-double-pendulum"))
ref = Reference("other-code", "reference set C07: potential and kinetic energy of the loop by an independent program")
ref.summary("ring", "modes.0.frequency.value", 2.3682369369899976, "Hz", rtol=1e-9)
ref.value("ring", 1.5679584347667532, "rad", signal="joint.crank.position", atol=1e-8)
ref.summary("ring", "freedom", 1).write(*case("modes-four-bar"))

M = np.array([[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]])
C1 = np.array([[0.0, 33.86641391492494], [-0.85035641456978, 1.6854039739756]])
K0 = np.array([[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]])
K2 = np.array([[0.0, 76.59734589573222], [0.0, 2.65431523794604]])


def bicycle(v):
    A = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.linalg.solve(M, 9.81 * K0 + v * v * K2), -np.linalg.solve(M, v * C1)]])
    return sorted((x for x in np.linalg.eigvals(A) if x.imag >= 0), key=abs)


ref = Reference("literature", "Meijaard, Papadopoulos, Ruina and Schwab 2007: capsize, weave and caster at 4 m/s (reference set C07)")
known = [-1.42944427361326, complex(0.41325331521125, 3.07910818603206), -12.15861426576447]
assert max(abs(a - b) for a, b in zip(bicycle(4.0), known)) < 1e-11, bicycle(4.0)
for i, x in enumerate(known):
    x = complex(x)
    ref.summary("at-4-m-s", f"modes.{i}.eigenvalue.re", x.real, rtol=1e-9).summary("at-4-m-s", f"modes.{i}.eigenvalue.im", x.imag, rtol=1e-9, atol=1e-9)
ref.summary("at-4-m-s", "freedom", 2).write(*case("modes-bicycle"))
