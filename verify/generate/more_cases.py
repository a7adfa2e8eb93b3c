"""References in closed form: statics, free bodies in space, redundant reactions, motion profiles and tables."""
import math
import numpy as np
from scipy.optimize import brentq
from reference import Reference, case
from closed_forms import cross, e, perp, rot2, deg, Rz, TOL, G2, tensor, wrench
from published_cases import lift

HERE = "verify/generate/more_cases.py"
Ry = lambda a: np.array([[math.cos(a), 0, math.sin(a)], [0, 1, 0], [-math.sin(a), 0, math.cos(a)]])
z = np.array([0, 0, 1.0])

# ---------------------------------------------------------------- statics
ref = Reference("analytic", "moments of each bar about its upper hinge: tan(angle) = sum of vertical over horizontal moments")
W1, W2, F = 2 * 9.81, 1.2 * 9.81, (9.0, -3.0)
a = math.atan((0.5 * F[1] - 0.2 * W2) / (0.5 * F[0]))
u = math.atan((0.7 * (F[1] - W2) - 0.3 * W1) / (0.7 * F[0]))
ref.row("rest", None, {"joint.O.position": (u, "rad"), "joint.A.position": (a - u, "rad"), "body.lower.angle": (a, "rad"),
    "joint.A.reaction.fx": (-F[0], "N"), "joint.A.reaction.fy": (W2 - F[1], "N"), "joint.O.reaction.fx": (-F[0], "N"), "joint.O.reaction.fy": (W1 + W2 - F[1], "N")}, rtol=1e-8)
ref.fact(degrees_of_freedom=2, loops=0, redundant=0, bodies=2, joints=2).write(*case("double-pendulum-statics"))

ref = Reference("other-code", "reference set C07 (four-bar with a torsion spring): equilibrium of the potential energy by an independent program")
def potential(q):
    A = 0.2 * e(q)
    O4 = np.array([0.45, 0])
    d = O4 - A
    L = np.hypot(*d)
    x = (0.5**2 - 0.4**2 + L * L) / (2 * L)
    B = A + x * d / L + math.sqrt(0.25 - x * x) * perp(d) / L
    return B, 9.81 * (1 * A[1] / 2 + 2 * (A + B)[1] / 2 + 1.5 * B[1] / 2) + 15 * (q - math.pi / 2) ** 2
def slope(q, h=1e-3):
    f = [potential(q + k * h)[1] for k in (-4, -3, -2, -1, 1, 2, 3, 4)]
    return (f[0] / 280 - 4 * f[1] / 105 + f[2] / 5 - 4 * f[3] / 5 + 4 * f[4] / 5 - f[5] / 5 + 4 * f[6] / 105 - f[7] / 280) / h
q = brentq(slope, 1.3, 1.8, xtol=1e-15)
assert abs(q - 1.5679584347667532) < 1e-10
q = 1.5679584347667532
B = potential(q)[0]
ref.row("rest", None, {"joint.crank.position": (q, "rad"), "joint.rocker.position": (math.atan2(B[1], B[0] - 0.45), "rad"), "point.coupler.B.x": (B[0], "m"), "point.coupler.B.y": (B[1], "m")}, rtol=1e-8)
ref.fact(degrees_of_freedom=1, loops=1, redundant=0, bodies=3, joints=4).write(*case("four-bar-spring-statics"))

ref = Reference("analytic", f"virtual work of weights and load for the held cylinder length ({HERE})")
th = brentq(lambda x: lift(x)["slide"] - 0.7, -0.5, 0.5, xtol=1e-16, rtol=1e-15)
k = lift(th)
power = 800 * k["w3"] * 0.95 * math.cos(th) + 9.81 * math.cos(th) * k["w3"] * (20.8 * 0.425 + 19.4 * 0.475) + 9.81 * 19.84 * 0.366 * math.cos(k["theta1"]) * k["w1"]
ref.row("held", None, {"joint.B.position": (th, "rad"), "joint.O.position": (k["theta1"], "rad"), "joint.slide.position": (0.7, "m"), "drive.slide.force": (power / 0.02, "N")}, rtol=1e-8)
ref.write(*case("hold-statics"))

# ---------------------------------------------------------------- rotor, gyroscope
ref = Reference("analytic", f"Newton and Euler for one body ({HERE})")
g = np.array([-1, 0.5, -9.7])
R0 = Ry(40 * deg)
n, w, al = R0 @ z, 1500 * 2 * math.pi / 60, 80.0
for d in range(0, 360, 60):
    F, M = wrench(R0 @ Rz(d * deg), w * n, al * n, np.zeros(3), 6.0, np.array([0.004, -0.003, 0.12]), tensor(0.09, 0.08, 0.05, 0.001, 0.004, -0.003), g)
    ref.row("run", {"joint.bearing.position": f"{d} deg"}, {"drive.bearing.force": (M @ n, "N*m"), **{f"joint.bearing.reaction.f{s}": (F[i], "N") for i, s in enumerate("xyz")},
        **{f"joint.bearing.reaction.m{s}": (M[i], "N*m") for i, s in enumerate("xyz")}, "joint.bearing.reaction.moment": (np.linalg.norm(M), "N*m")}, atol={**TOL, "N*m": 1e-8})
ref.fact(degrees_of_freedom=1, loops=0, redundant=0, bodies=1, joints=1).write(*case("rotor-unbalance"))

ref = Reference("analytic", f"Newton and Euler for arm and disk; the gyroscopic moment J spin x precession among them ({HERE})")
g = np.array([0, 0, -9.81])
for t in (0, 0.2, 0.4, 0.6):
    q, v, a, s = 10 * deg + 2.2 * t + 0.4 * t * t, 2.2 + 0.8 * t, 0.8, 900 * 2 * math.pi / 60
    R1 = Rz(q)
    r = R1 @ [0.25, 0.03, 0.05]
    n = R1 @ Ry(75 * deg) @ z
    w2, al2 = v * z + s * n, a * z + s * np.cross(v * z, n)
    a0 = np.cross(a * z, r) + np.cross(v * z, np.cross(v * z, r))
    F2, M2 = wrench(R1 @ Ry(75 * deg) @ Rz(s * t), w2, al2, a0, 4.0, np.array([0, 0, 0.02]), tensor(0.016, 0.016, 0.03), g)
    F1, M1 = wrench(R1, v * z, a * z, np.zeros(3), 1.5, np.array([0.1, 0.02, -0.01]), tensor(0.003, 0.011, 0.012, 0.0004, -0.0003, 0.0002), g)
    F1, M1 = F1 + F2, M1 + M2 + np.cross(r, F2)
    ref.row("run", {"time": f"{t:g} s"}, {"drive.post.force": (M1[2], "N*m"), "drive.spin.force": (M2 @ n, "N*m"), "joint.spin.position": (s * t, "rad"),
        **{f"joint.spin.reaction.m{x}": (M2[i], "N*m") for i, x in enumerate("xyz")}, **{f"joint.spin.reaction.f{x}": (F2[i], "N") for i, x in enumerate("xyz")},
        **{f"joint.post.reaction.m{x}": (M1[i], "N*m") for i, x in enumerate("xyz")}}, atol=TOL)
ref.fact(degrees_of_freedom=2, loops=0, redundant=0, bodies=2, joints=2).write(*case("gyroscope"))

# ---------------------------------------------------------------- weld, guide moment
ref = Reference("analytic", "free bodies of a translating carriage and its mast")
g, a = np.array([0.6, -9.81]), 2.4 * e(12 * deg)
wind = np.array([-35.0, 8])
c2, tip = rot2(82 * deg) @ [0.6, 0.04], rot2(82 * deg) @ [1.2, 0]
F2 = 3 * (a - g) - wind
M2 = cross(c2, 3 * (a - g)) - cross(tip, wind)
foot, c1 = rot2(12 * deg) @ [0.1, 0.2], rot2(12 * deg) @ [0.05, 0.12]
F1 = F2 + 9 * (a - g)
M1 = M2 + cross(foot, F2) + cross(c1, 9 * (a - g))
for x in (0, 1, 2):
    ref.row("run", {"joint.rail.position": f"{x} m"}, {"drive.rail.force": (F1 @ e(12 * deg), "N"), "joint.rail.reaction.fx": (F1[0], "N"), "joint.rail.reaction.fy": (F1[1], "N"), "joint.rail.reaction.mz": (M1, "N*m"),
        "joint.foot.reaction.fx": (F2[0], "N"), "joint.foot.reaction.fy": (F2[1], "N"), "joint.foot.reaction.mz": (M2, "N*m"), "body.mast.angle": (82 * deg, "rad")}, atol=TOL)
ref.fact(degrees_of_freedom=1, loops=0, redundant=0, bodies=2, joints=2).write(*case("weld-and-slide"))

# ---------------------------------------------------------------- two-link arm
def arm(q1, v1, a1, q2, v2, a2):
    m1, m2, l, c1, c2, I1, I2, g = 3, 2, 0.5, 0.22, 0.17, 0.06, 0.03, 9.81
    h = m2 * l * c2
    M11 = I1 + m1 * c1**2 + I2 + m2 * (l * l + c2 * c2) + 2 * h * math.cos(q2)
    M12, M22 = I2 + m2 * c2**2 + h * math.cos(q2), I2 + m2 * c2**2
    s = h * math.sin(q2)
    t2 = M12 * a1 + M22 * a2 + s * v1 * v1 + m2 * g * c2 * math.cos(q1 + q2)
    t1 = M11 * a1 + M12 * a2 - s * (2 * v1 * v2 + v2 * v2) + (m1 * c1 + m2 * l) * g * math.cos(q1) + m2 * g * c2 * math.cos(q1 + q2)
    return t1, t2


ref = Reference("analytic", "two-link planar arm, equations of motion in closed form (Craig, Introduction to Robotics, section 6.7; here with inertias)")
for d in (-30, 0, 30, 60):
    t1, t2 = arm(d * deg, 2.0, 5.0, 50 * deg, 0.0, 0.0)
    ref.row("held", {"joint.q1.position": f"{d} deg"}, {"drive.q1.force": (t1, "N*m"), "drive.q2.force": (t2, "N*m"), "joint.q2.velocity": (0, "rad/s"), "drive.q2.power": (0, "W")}, atol=TOL)
for t in (0, 0.2, 0.4, 0.6, 0.8):
    q = (0.6 * math.sin(3 * t), 1.8 * math.cos(3 * t), -5.4 * math.sin(3 * t), 50 * deg + 0.5 * math.cos(4 * t), -2 * math.sin(4 * t), -8 * math.cos(4 * t))
    t1, t2 = arm(*q)
    ref.row("moving", {"time": f"{t:g} s"}, {"drive.q1.force": (t1, "N*m"), "drive.q2.force": (t2, "N*m"), "drive.q2.power": (t2 * q[4], "W"), "joint.q1.reaction.mz": (t1, "N*m")}, atol=TOL)
ref.fact(degrees_of_freedom=2, loops=0, redundant=0, bodies=2, joints=2).write(*case("two-link-hold"))

# ---------------------------------------------------------------- redundant reactions
ref = Reference("analytic", f"strut force from the moments about the hinge line; radial hinge forces from the other two moments ({HERE})")
g, wall, eye, com = np.array([0.4, -0.3, -9.8]), np.array([0.5, -0.6, 1.0]), np.array([0.7, -0.03, 1.2]), np.array([0.42, 0.015, 1.05])
I = tensor(9.5, 11, 1.7, 0.05, -0.1, 0.03)
for s in (0.7, 0.9, 1.1):
    length = lambda f: np.linalg.norm(Rz(f) @ eye - wall) - s
    f = brentq(length, -45 * deg, 120 * deg, xtol=1e-16, rtol=1e-15)
    r = Rz(f) @ eye
    d = r - wall
    uu = d / s
    d1 = uu @ np.cross(z, r)
    rd = np.cross(z, r)
    d2 = (rd @ rd + d @ np.cross(z, rd) - d1 * d1) / s
    w = 0.3 / d1
    al = (-0.2 - d2 * w * w) / d1
    F, M = wrench(Rz(f), w * z, al * z, np.zeros(3), 28.0, com, I, g)
    N = M[2] / np.cross(r, uu)[2]
    Fh = F - N * uu
    Mh = M - np.cross(r, N * uu)  # = 0.3 z x Flow + 1.9 z x Fhigh
    hx = (Mh[1] - 0.3 * Fh[0]) / 1.6
    hy = (-Mh[0] - 0.3 * Fh[1]) / 1.6
    ref.row("run", {"joint.strut.position": f"{s:g} m"}, {"joint.strut.velocity": (0.3, "m/s"), "body.door.omega_z": (w, "rad/s"), "body.door.alpha_z": (al, "rad/s^2"), "drive.strut.force": (N, "N"),
        "joint.high.reaction.fx": (hx, "N"), "joint.high.reaction.fy": (hy, "N"), "joint.low.reaction.fx": (Fh[0] - hx, "N"), "joint.low.reaction.fy": (Fh[1] - hy, "N"),
        "joint.low.reaction.mx": (0, "N*m"), "point.door.eye.x": (r[0], "m"), "point.door.eye.y": (r[1], "m")}, atol={**TOL, "N": 1e-8})
ref.fact(degrees_of_freedom=1, redundant=1, bodies=1, joints=3)
ref.uniqueness({"low.fz": False, "high.fz": False, "low.fx": True, "low.fy": True, "high.fx": True, "high.fy": True, "strut.fx": True, "strut.fz": True}).write(*case("door-two-hinges"))

ref = Reference("analytic", "platform in translation: torque from the moments of three equal cranks and the platform's inertia and weight")
r, w, al = 0.3, 4.0, -7.0
for d in range(30, 180, 30):
    th = d * deg
    p = r * e(th)
    a = al * perp(p) - w * w * p
    torque = sum(J * al + m * np.dot(c, c) * al - cross(rot2(th) @ c, m * G2) for m, c, J in ((1, (0.12, 0.01), 0.01), (1.2, (0.13, 0.01), 0.011), (0.8, (0.14, -0.01), 0.009)))
    torque += cross(p, 5 * (a - G2)) - cross(p, np.array([-20, -90]))
    ref.row("run", {"joint.one.position": f"{d} deg"}, {"drive.one.force": (torque, "N*m"), "joint.three.position": (th, "rad"), "joint.c.velocity": (-w, "rad/s"), "body.platform.ax": (a[0], "m/s^2"),
        "body.platform.ay": (a[1], "m/s^2"), "body.platform.alpha": (0, "rad/s^2"), "joint.two.reaction.mz": (0, "N*m")}, atol=TOL)
ref.fact(degrees_of_freedom=1, loops=2, redundant=1, bodies=4, joints=6)
ref.uniqueness({"a.fx": False, "b.fy": False, "three.fx": False, "one.mz": True, "c.mz": True}).write(*case("parallelogram-extra-bar"))

# ---------------------------------------------------------------- motion profiles
def law(kind, u):
    if kind == "linear":
        return u, 1.0, 0.0
    if kind == "cycloidal":
        c = 2 * math.pi
        return u - math.sin(c * u) / c, 1 - math.cos(c * u), c * math.sin(c * u)
    if kind == "poly5":
        return 10 * u**3 - 15 * u**4 + 6 * u**5, 30 * u**2 - 60 * u**3 + 30 * u**4, 60 * u - 180 * u**2 + 120 * u**3
    if u > 0.5:
        s, v, a = law(kind, 1 - u)
        return 1 - s, v, -a
    if kind == "trapezoid":
        return (2.25 * u * u, 4.5 * u, 4.5) if u < 1 / 3 else (0.25 + 1.5 * (u - 1 / 3), 1.5, 0.0)
    j, n, A = 60.75, 1 / 9, 6.75  # s-curve
    if u < n:
        return j * u**3 / 6, j * u * u / 2, j * u
    if u < 2 * n:
        x = u - n
        return j * n**3 / 6 + j * n * n / 2 * x + A * x * x / 2, j * n * n / 2 + A * x, A
    if u < 3 * n:
        x = 3 * n - u
        return 0.25 - 1.5 * x + j * x**3 / 6, 1.5 - j * x * x / 2, j * x
    return 0.25 + 1.5 * (u - 1 / 3), 1.5, 0.0


ref = Reference("analytic", "profiles by their closed formulas: cycloidal, 10 u^3 - 15 u^4 + 6 u^5, trapezoid in thirds, s-curve (thirds, accelerations ramped over ninths: peak velocity 1.5, peak acceleration 6.75), linear")
for t in (0.05, 0.13, 0.2, 0.25, 0.37, 0.45, 0.55, 0.66, 0.75, 0.83, 0.95, 1.1, 1.2):
    v = {}
    for kind in ("cycloidal", "poly5", "trapezoid", "s-curve", "linear"):
        if t < 0.1:
            p, vel, acc = 0.05, 0.0, 0.0
        elif t < 0.7:
            s = law(kind, (t - 0.1) / 0.6)
            p, vel, acc = 0.05 + 0.3 * s[0], 0.3 * s[1] / 0.6, 0.3 * s[2] / 0.36
        else:
            s = law(kind, min((t - 0.7) / 0.5, 1.0))
            p, vel, acc = 0.35 - 0.25 * s[0], -0.25 * s[1] / 0.5, -0.25 * s[2] / 0.25
        n = kind.replace("-", "_")
        v[f"joint.{n}.position"] = (p, "m")
        if t < 1.2 or kind in ("cycloidal", "poly5"):
            v[f"joint.{n}.velocity"], v[f"joint.{n}.acceleration"], v[f"drive.{n}.force"] = (vel, "m/s"), (acc, "m/s^2"), (2 * acc, "N")
    ref.row("run", {"time": f"{t:g} s"}, v, atol=TOL)
ref.write(*case("motion-profiles"))

ref = Reference("analytic", "a cubic, 20 + 300 t - 450 t^2 + 260 t^3 mm, sampled at uneven times; a not-a-knot cubic spline reproduces it")
for t in (0, 0.05, 0.2, 0.35, 0.45, 0.6, 0.7, 0.95):
    p, v, a = 0.02 + 0.3 * t - 0.45 * t * t + 0.26 * t**3, 0.3 - 0.9 * t + 0.78 * t * t, -0.9 + 1.56 * t
    ref.row("run", {"time": f"{t:g} s"}, {"joint.slide.position": (p, "m"), "joint.slide.velocity": (v, "m/s", 1e-11), "joint.slide.acceleration": (a, "m/s^2", 1e-10), "drive.slide.force": (2 * a, "N", 1e-9)}, atol={"m": 1e-12})
ref.write(*case("motion-table"))

# ---------------------------------------------------------------- R-U-S-R with a massive coupler: another program
import os, maximal
from reference import ROOT
from closed_forms import RSSR_ANGLES

ref = Reference("other-code", "rocker angle: RSSR closure in closed form; torque and forces: verify/generate/maximal (absolute coordinates, every body taken free)")
rows = maximal.load(os.path.join(ROOT, "verify/cases/rusr-coupler/model.toml")).rows("run")
for d, row in zip(range(0, 360, 30), rows):
    p, v, a = RSSR_ANGLES[d]
    assert abs(row["joint.rocker.position"] - p) < 1e-11 and abs(row["joint.rocker.acceleration"] - a) < 1e-8
    ref.row("run", {"joint.crank.position": f"{d} deg"}, {"joint.rocker.position": (p, "rad"), "joint.rocker.velocity": (v, "rad/s"), "joint.rocker.acceleration": (a, "rad/s^2"),
        **{s: (row[s], "N") for j in ("A", "B", "rocker", "crank") for s in (f"joint.{j}.reaction.f{x}" for x in "xyz")},
        **{s: (row[s], "N*m") for s in ("drive.crank.force", "joint.A.reaction.mx", "joint.A.reaction.my", "joint.A.reaction.mz", "joint.rocker.reaction.mx", "joint.crank.reaction.mx")}}, rtol=1e-8, atol={**TOL, "N": 1e-8, "N*m": 1e-9})
ref.fact(degrees_of_freedom=1, loops=1, redundant=0, bodies=3, joints=4).write(*case("rusr-coupler"))
