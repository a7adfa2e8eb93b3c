"""References in closed form: joints, loops, elements and friction of the cases named below.

Where a law of motion is implicit in an angle, its derivatives are taken by mpmath at 40 digits from the closed form.
A single body is treated by Newton and Euler directly (`wrench`).  Needs numpy, mpmath, scipy.
"""
import math
import mpmath as mp
import numpy as np
from reference import Reference, case

mp.mp.dps = 40
deg = math.pi / 180
e = lambda a: np.array([math.cos(a), math.sin(a)])
perp = lambda v: np.array([-v[1], v[0]])
cross = lambda a, b: a[0] * b[1] - a[1] * b[0]
rot2 = lambda a: np.array([[math.cos(a), -math.sin(a)], [math.sin(a), math.cos(a)]])
Rz = lambda a: np.array([[math.cos(a), -math.sin(a), 0], [math.sin(a), math.cos(a), 0], [0, 0, 1.0]])
Rx = lambda a: np.array([[1.0, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]])
G2 = np.array([0, -9.81])
TOL = {"N": 1e-9, "N*m": 1e-10, "rad": 1e-12, "rad/s": 1e-10, "m": 1e-13, "m/s": 1e-12, "m/s^2": 1e-10, "rad/s^2": 1e-9, "W": 1e-9}
HERE = "verify/generate/closed_forms.py"


def derivatives(f, x):
    """f, f', f'' at x."""
    return [float(mp.diff(f, mp.mpf(x), n)) if n else float(f(mp.mpf(x))) for n in range(3)]


def along(f, x, rate, acc):
    """Value, velocity and acceleration of f(x(t))."""
    p, d1, d2 = derivatives(f, x)
    return p, d1 * rate, d1 * acc + d2 * rate**2, d1


def wrench(R, w, al, a0, m, c, I, g):
    """Force and moment at the body origin that a body needs; c, I in body axes, a0 the origin's acceleration."""
    r, I = R @ c, R @ I @ R.T
    a = a0 + np.cross(al, r) + np.cross(w, np.cross(w, r))
    F = m * (a - g)
    return F, I @ al + np.cross(w, I @ w) + np.cross(r, F)


def tensor(xx, yy, zz, xy=0, xz=0, yz=0):
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


# ---------------------------------------------------------------- Cardan
ref = Reference("analytic", "Hooke joint: tan(theta2) = tan(theta1)/cos(beta); torque from the power balance")
b, w, al = 35 * deg, 12.0, -9.0
for d in range(10, 80, 10):
    t1 = d * deg
    t2, v2, a2, ratio = along(lambda x: mp.atan(mp.tan(x) / mp.cos(mp.mpf(35) * mp.pi / 180)), t1, w, al)
    assert abs(ratio - math.cos(b) / (1 - math.sin(b) ** 2 * math.cos(t1) ** 2)) < 1e-14
    torque = 0.013 * al + (0.031 * a2 + 7.5) * ratio
    ref.row("run", {"joint.in.position": f"{d} deg"}, {
        "joint.out.position": (t2, "rad"), "joint.out.velocity": (v2, "rad/s"), "joint.out.acceleration": (a2, "rad/s^2"),
        "drive.in.force": (torque, "N*m"), "drive.in.power": (torque * w, "W")}, atol=TOL)
ref.fact(degrees_of_freedom=1, loops=1, redundant=3, bodies=2, joints=3).uniqueness({"in.mz": True})
CARDAN = ref

# ---------------------------------------------------------------- spherical four-bar
ref = Reference("analytic", "spherical four-bar: cos(coupler) = b.c gives A cos(psi) + B sin(psi) = C (Chiang, Kinematics of Spherical Mechanisms)")
w, al = 1.5, 0.7


def spherical(x):
    a1, cp, rk, bs = [mp.mpf(v) * mp.pi / 180 for v in (40, 75, 60, 80)]
    n = [mp.sin(a1) * mp.sin(x), -mp.sin(a1) * mp.cos(x), mp.cos(a1)]  # axis b; then in the axes of d
    n = [n[0], mp.cos(bs) * n[1] + mp.sin(bs) * n[2], -mp.sin(bs) * n[1] + mp.cos(bs) * n[2]]
    A, B, C = -n[1] * mp.sin(rk), n[0] * mp.sin(rk), mp.cos(cp) - n[2] * mp.cos(rk)
    return A, B, C


def branch(system, sign):
    def f(x):
        A, B, C = system(x)
        return mp.atan2(B, A) + sign * mp.acos(C / mp.sqrt(A * A + B * B))
    return f


last = 57 * deg
for d in range(30, 340, 30):
    p, v, a, _ = along(branch(spherical, -1), d * deg, w, al)
    while abs(p - last) > math.pi:
        p += math.copysign(2 * math.pi, last - p)
    last = p
    ref.row("run", {"joint.crank.position": f"{d} deg"}, {
        "joint.rocker.position": (p, "rad"), "joint.rocker.velocity": (v, "rad/s"), "joint.rocker.acceleration": (a, "rad/s^2")}, atol=TOL)
ref.fact(degrees_of_freedom=1, loops=1, redundant=3, bodies=3, joints=4)
ref.write(*case("spherical-four-bar"))

# ---------------------------------------------------------------- screw jack
ref = Reference("analytic", "screw: nut travel = -angle lead/(2 pi); torque = J alpha - lead/(2 pi) (m a + m g.n + load)")
n, g = np.array([1, 2, 2]) / 3, np.array([-3, -2, -9.0])
for d in (0, -720, -1440):
    k, w, al = 0.006 / (2 * math.pi), -20.0, -350.0
    a = -k * al
    torque = 0.004 * al - k * (8 * a - 8 * (g @ n) + 1500)
    ref.row("run", {"joint.spin.position": f"{d} deg"}, {
        "joint.guide.position": (-k * d * deg, "m"), "joint.guide.velocity": (-k * w, "m/s"), "joint.guide.acceleration": (a, "m/s^2"),
        "drive.spin.force": (torque, "N*m"), "drive.spin.power": (torque * w, "W")}, atol=TOL)
ref.fact(degrees_of_freedom=1, loops=1, redundant=4, bodies=2, joints=3)
ref.write(*case("screw-jack"))

# ---------------------------------------------------------------- one body on one joint of several coordinates
t = mp.mpf
g = np.array([2, -5, -8.0])
I = tensor(0.03, 0.05, 0.04, 0.002, -0.003, 0.004)
ref = Reference("analytic", f"Newton and Euler for one body ({HERE})")
for k in range(7):
    T = k / 10
    z = derivatives(lambda x: mp.mpf("0.2") * mp.sin(3 * x) + mp.mpf("0.1") * x, T)
    q = derivatives(lambda x: mp.mpf(50) * mp.pi / 180 * x + 2 * x * x, T)
    F, M = wrench(Rz(q[0]), np.array([0, 0, q[1]]), np.array([0, 0, q[2]]), np.array([0, 0, z[2]]), 4.0, np.array([0.07, 0.02, -0.03]), I, g)
    ref.row("run", {"time": f"{T:g} s"}, {
        "joint.rod.position.0": (z[0], "m"), "joint.rod.velocity.0": (z[1], "m/s"), "joint.rod.acceleration.0": (z[2], "m/s^2"),
        "joint.rod.position.1": (q[0], "rad"), "joint.rod.velocity.1": (q[1], "rad/s"), "joint.rod.acceleration.1": (q[2], "rad/s^2"),
        "drive.rod.force.0": (F[2], "N"), "drive.rod.force.1": (M[2], "N*m"),
        **{f"joint.rod.reaction.f{x}": (F[i], "N") for i, x in enumerate("xyz")},
        **{f"joint.rod.reaction.m{x}": (M[i], "N*m") for i, x in enumerate("xyz")}}, atol=TOL)
ref.fact(degrees_of_freedom=2, loops=0, redundant=0, bodies=1, joints=1)
ref.write(*case("cylindrical-joint"))

g = np.array([1, -2, -9.0])
I = tensor(0.01, 0.02, 0.025, 0.001, 0.0015, -0.002)
ref = Reference("analytic", f"Newton and Euler for one body ({HERE})")
for k in range(5):
    T = k / 5
    x = derivatives(lambda s: mp.mpf("0.3") * mp.cos(2 * s), T)
    y = (0.5 * T * T, T, 1.0)
    q = derivatives(lambda s: mp.mpf("1.2") * mp.sin(s * mp.mpf("1.5")), T)
    F, M = wrench(Rz(q[0]), np.array([0, 0, q[1]]), np.array([0, 0, q[2]]), np.array([x[2], y[2], 0]), 2.5, np.array([0.04, -0.03, 0.02]), I, g)
    ref.row("run", {"time": f"{T:g} s"}, {
        "joint.table.position.0": (x[0], "m"), "joint.table.velocity.1": (y[1], "m/s"), "joint.table.acceleration.2": (q[2], "rad/s^2"),
        "point.plate.o.x": (0.1 + x[0], "m"), "point.plate.o.y": (0.2 + y[0], "m"), "point.plate.o.z": (0.3, "m"),
        "drive.table.force.0": (F[0], "N"), "drive.table.force.1": (F[1], "N"), "drive.table.force.2": (M[2], "N*m"),
        **{f"joint.table.reaction.f{x}": (F[i], "N") for i, x in enumerate("xyz")},
        **{f"joint.table.reaction.m{x}": (M[i], "N*m") for i, x in enumerate("xyz")}}, atol=TOL)
ref.fact(degrees_of_freedom=3, loops=0, redundant=0, bodies=1, joints=1)
ref.write(*case("planar-joint"))

# ---------------------------------------------------------------- RSSR
def rssr(x):
    L = mp.mpf("0.46")
    c, s = mp.cos(-70 * mp.pi / 180), mp.sin(-70 * mp.pi / 180)
    a = [mp.mpf("0.12") * mp.cos(x) - mp.mpf("0.35"), mp.mpf("0.12") * mp.sin(x) - mp.mpf("0.1"), mp.mpf("0.015") + mp.mpf("0.05")]
    a = [a[0], c * a[1] + s * a[2], -s * a[1] + c * a[2]]  # A seen from the rocker hinge, its axes
    b = [mp.mpf("0.26"), mp.mpf("-0.02")]
    return a[0] * b[0], a[1] * b[0], (b[0] ** 2 + b[1] ** 2 + a[0] ** 2 + a[1] ** 2 + a[2] ** 2 - L * L) / 2 - a[2] * b[1]


ref = Reference("analytic", f"RSSR closure A cos(psi) + B sin(psi) = C; rod force from the moments of the rocker about its axis ({HERE})")
ref2 = []
w, al, g = 8.0, 5.0, np.array([0.5, -1.5, -9.6])
RC, pC = Rx(-70 * deg), np.array([0.35, 0.1, -0.05])
last = -30 * deg
RSSR_ANGLES = {}
for d in range(0, 360, 30):
    th = d * deg
    p, v, a, ratio = along(branch(rssr, 1), th, w, al)
    while abs(p - last) > math.pi:
        p += math.copysign(2 * math.pi, last - p)
    last = p
    RSSR_ANGLES[d] = (p, v, a)
    A = Rz(th) @ [0.12, 0, 0.015]
    Rr = RC @ Rz(p)
    rB = Rr @ [0.26, 0, -0.02]
    u = (pC + rB - A) / 0.46
    assert abs(np.linalg.norm(u) - 1) < 1e-13
    axis, com = RC @ [0, 0, 1], Rr @ [0.09, -0.01, 0.005]
    N = ((0.006 + 1.4 * (0.09**2 + 0.01**2)) * a - axis @ np.cross(com, 1.4 * g) + 3) / (axis @ np.cross(rB, u))
    com1 = Rz(th) @ [0.05, 0.008, 0]
    torque = (0.003 + 0.9 * (0.05**2 + 0.008**2)) * al - np.cross(com1, 0.9 * g)[2] + np.cross(A, N * u)[2]
    ref.row("run", {"joint.crank.position": f"{d} deg"}, {
        "joint.rocker.position": (p, "rad"), "joint.rocker.velocity": (v, "rad/s"), "joint.rocker.acceleration": (a, "rad/s^2"),
        "drive.crank.force": (torque, "N*m"), **{f"joint.rod.reaction.f{x}": (N * u[i], "N") for i, x in enumerate("xyz")},
        "joint.rod.reaction.force": (abs(N), "N")}, atol=TOL)
ref.fact(degrees_of_freedom=1, redundant=0, bodies=2, joints=3)
ref.write(*case("rssr-rod"))

# ---------------------------------------------------------------- scotch yoke
ref = Reference("analytic", "x = r cos(theta); torque and slot force from free bodies")
r, w, al, g, F = 0.08, 14.0, -40.0, np.array([1.5, -9.7]), np.array([-60.0, 15.0])
c = np.array([0.05, -0.02])
for d in range(20, 360, 30):
    th = d * deg
    x, v, a = r * math.cos(th), -r * math.sin(th) * w, -r * (math.sin(th) * al + math.cos(th) * w * w)
    pin = 2.3 * (a - g[0]) - F[0]  # crank pin on yoke
    com = rot2(th) @ [0.03, 0.012]
    torque = (0.002 + 1.1 * (0.03**2 + 0.012**2)) * al - cross(com, 1.1 * g) - r * math.sin(th) * pin
    fy = -2.3 * g[1] - F[1]
    mz = cross(c, 2.3 * (np.array([a, 0]) - g)) + r * math.sin(th) * pin
    a1 = al * perp(com) - w * w * com
    G = 1.1 * (a1 - g) + np.array([pin, 0])
    ref.row("run", {"joint.crank.position": f"{d} deg"}, {
        "joint.slide.position": (x, "m"), "joint.slide.velocity": (v, "m/s"), "joint.slide.acceleration": (a, "m/s^2"),
        "joint.slot.position": (r * math.sin(th), "m"), "drive.crank.force": (torque, "N*m"),
        "joint.slot.reaction.fx": (-pin, "N"), "joint.slot.reaction.fy": (0, "N"),
        "joint.slide.reaction.fx": (0, "N"), "joint.slide.reaction.fy": (fy, "N"), "joint.slide.reaction.mz": (mz, "N*m"),
        "joint.crank.reaction.fx": (G[0], "N"), "joint.crank.reaction.fy": (G[1], "N")}, atol=TOL)
ref.fact(degrees_of_freedom=1, redundant=0, bodies=2, joints=3)
ref.write(*case("scotch-yoke"))

# ---------------------------------------------------------------- gears
ref = Reference("analytic", "gear pair: theta_w = ratio theta_p + offset; inertia reflected by ratio^2, torque by ratio")
k, w, al = -23 / 57, 60.0, 130.0
for d in range(0, 500, 100):
    tw = k * d * deg + 11 * deg
    c = rot2(tw) @ [0.015, 0.005]
    Jw = 0.021 + 4 * (0.015**2 + 0.005**2)
    torque = 0.0006 * al + k * (Jw * k * al - cross(c, 4 * G2) + 35)
    ac = k * al * perp(c) - (k * w) ** 2 * c
    ref.row("run", {"joint.pinion.position": f"{d} deg"}, {
        "joint.wheel.position": (tw, "rad"), "joint.wheel.velocity": (k * w, "rad/s"), "joint.wheel.acceleration": (k * al, "rad/s^2"),
        "drive.pinion.force": (torque, "N*m"), "joint.wheel.reaction.fx": (4 * ac[0], "N"), "joint.wheel.reaction.fy": (4 * (ac[1] + 9.81), "N")}, atol=TOL)
ref.fact(degrees_of_freedom=1, bodies=2).write(*case("gear-pair"))

ref = Reference("analytic", "Willis: omega_sun = (1 + z_ring/z_sun) omega_arm; torque from the power balance")
zs, zp = 24, 18
zr, arm, w, al = zs + 2 * zp, 0.042, 9.0, 70.0
ks, kp = 1 + zr / zs, 1 - zr / zp
for d in range(0, 360, 60):
    th = d * deg
    torque = (0.0011 + 0.0002 * ks**2 + 0.00005 * kp**2 + 0.3 * arm**2) * al + 0.3 * 9.81 * arm * math.cos(th) + 2.5 * ks
    ref.row("run", {"joint.arm.position": f"{d} deg"}, {
        "body.sun.omega": (ks * w, "rad/s"), "body.planet.omega": (kp * w, "rad/s"), "joint.planet.velocity": (-zr / zp * w, "rad/s"),
        "joint.sun.position": (zr / zs * th, "rad"), "body.sun.alpha": (ks * al, "rad/s^2"), "drive.arm.force": (torque, "N*m")}, atol=TOL)
ref.fact(degrees_of_freedom=1, bodies=3).write(*case("planetary-gear"))

# ---------------------------------------------------------------- boom on a cylinder
ref = Reference("analytic", "length and its derivatives by the cosine law; force from the moments about the hinge")
for d in range(-10, 70, 10):
    th = d * deg
    rD, rT, rc = rot2(th) @ [0.9, -0.12], rot2(th) @ [2.3, 0.1], rot2(th) @ [1.1, 0.08]
    p = rD - np.array([0.4, -0.7])
    L = np.hypot(*p)
    d1 = p @ perp(rD) / L
    d2 = (rD @ rD - p @ rD - d1 * d1) / L
    w = 0.12 / d1
    al = (-0.3 - d2 * w * w) / d1
    F = np.array([150.0, -900.0])
    cyl = ((60 + 120 * (rc @ rc)) * al - cross(rc, 120 * G2) - cross(rT, F)) / d1
    a = al * perp(rc) - w * w * rc
    G = 120 * (a - G2) - F - cyl * p / L
    ref.row("run", {"joint.boom.position": f"{d} deg"}, {
        "joint.cyl.position": (L, "m"), "joint.cyl.velocity": (0.12, "m/s"), "joint.cyl.acceleration": (-0.3, "m/s^2"),
        "joint.boom.velocity": (w, "rad/s"), "joint.boom.acceleration": (al, "rad/s^2"), "drive.cyl.force": (cyl, "N"), "drive.cyl.power": (0.12 * cyl, "W"),
        "joint.cyl.reaction.fx": (cyl * p[0] / L, "N"), "joint.cyl.reaction.fy": (cyl * p[1] / L, "N"),
        "joint.boom.reaction.fx": (G[0], "N"), "joint.boom.reaction.fy": (G[1], "N"), "joint.boom.reaction.mz": (0, "N*m", 1e-8)}, atol=TOL)
ref.fact(degrees_of_freedom=1, redundant=0, bodies=1, joints=2).write(*case("pendulum-cylinder"))

# ---------------------------------------------------------------- spring and damper
ref = Reference("analytic", "effort = preload - k (L - L0) - c L', positive pushes apart; torque from the moments about the hinge")
for d in range(-40, 120, 20):
    th, w, al = d * deg, 2.5, -6.0
    r, c = rot2(th) @ [0.4, -0.05], rot2(th) @ [0.15, 0.03]
    p = np.array([0.1, -0.2]) + r - np.array([0.5, 0.6])
    L = np.hypot(*p)
    rate = p @ perp(r) * w / L
    tension = 1800 * (L - 0.55) + 120 * rate - 40
    F = -tension * p / L
    torque = (0.05 + 3 * (c @ c)) * al - cross(c, 3 * G2) - cross(r, F)
    G = 3 * (al * perp(c) - w * w * c - G2) - F
    ref.row("run", {"joint.lever.position": f"{d} deg"}, {
        "force.spring.length": (L, "m"), "force.spring.rate": (rate, "m/s"), "drive.lever.force": (torque, "N*m"),
        "joint.lever.reaction.fx": (G[0], "N"), "joint.lever.reaction.fy": (G[1], "N"), "joint.lever.reaction.mz": (torque, "N*m")}, atol=TOL)
ref.fact(degrees_of_freedom=1, loops=0, redundant=0, bodies=1, joints=1).write(*case("spring-damper"))

# ---------------------------------------------------------------- joint springs
ref = Reference("analytic", "arm and sliding mass in turning axes; springs and dampers along the two coordinates")
for k in range(5):
    T = k / 4
    q = (15 * deg + 0.8 * math.sin(2 * T), 1.6 * math.cos(2 * T), -3.2 * math.sin(2 * T))
    s = (0.2 + 0.3 * T - 0.25 * T * T, 0.3 - 0.5 * T, -0.5)
    rho = np.array([0.1 + s[0], 0.05])
    a = np.array([s[2], 0]) + q[2] * perp(rho) + 2 * q[1] * perp(np.array([s[1], 0])) - q[1] ** 2 * rho
    gb = rot2(q[0]).T @ G2
    f = 0.9 * (a - gb)
    c = np.array([0.2, 0.03])
    slide = f[0] + 300 * (s[0] - 0.12) + 11 * s[1]
    moment = (0.04 + 1.5 * (c @ c)) * q[2] - cross(c, 1.5 * gb) + cross(rho, f) + 0.003 * q[2]
    hinge = moment + 14 * (q[0] + 25 * deg) + 0.6 * q[1]
    fw = rot2(q[0]) @ f
    ref.row("run", {"time": f"{T:g} s"}, {
        "drive.hinge.force": (hinge, "N*m"), "drive.slide.force": (slide, "N"), "joint.slide.position": (s[0], "m"), "joint.hinge.velocity": (q[1], "rad/s"),
        "joint.slide.reaction.fx": (fw[0], "N"), "joint.slide.reaction.fy": (fw[1], "N"), "joint.slide.reaction.mz": (0.003 * q[2], "N*m"),
        "joint.hinge.reaction.mz": (moment, "N*m"), "drive.hinge.power": (hinge * q[1], "W")}, atol=TOL)
ref.fact(degrees_of_freedom=2, loops=0, redundant=0, bodies=2, joints=2).write(*case("joint-spring"))

# ---------------------------------------------------------------- bushings
ref = Reference("analytic", "bushing wrench at its second point, displacement in the axes of the first; drives from Newton and Euler")
for k in range(6):
    T = k / 10
    x = np.array([0.004 * math.sin(9 * T), 0.003 * math.cos(7 * T)])
    v = np.array([0.036 * math.cos(9 * T), -0.021 * math.sin(7 * T)])
    a = np.array([-0.324 * math.sin(9 * T), -0.147 * math.cos(7 * T)])
    q = [3 * deg * f for f in (math.sin(5 * T), 5 * math.cos(5 * T), -25 * math.sin(5 * T))]
    rb, c = rot2(q[0]) @ [0.19, 0.12], rot2(q[0]) @ [0.1, 0.05]
    R1 = rot2(30 * deg)
    d = R1.T @ (x + rb - np.array([0.2, 0.1]))
    dv = R1.T @ (v + q[1] * perp(rb))
    fb = R1 @ -(np.array([2e5, 8e4]) * d + np.array([900, 400]) * dv)
    mb = -350 * (q[0] - 2 * deg) - 3 * q[1]
    g = np.array([0.7, -9.81])
    f = 2 * (a + q[2] * perp(c) - q[1] ** 2 * c - g)
    F = f - fb
    M = 0.02 * q[2] + cross(c, f) - cross(rb, fb) - mb
    ref.row("run", {"time": f"{T:g} s"}, {"drive.place.force.0": (F[0], "N"), "drive.place.force.1": (F[1], "N"), "drive.place.force.2": (M, "N*m"),
        "joint.place.reaction.fx": (F[0], "N"), "joint.place.reaction.mz": (M, "N*m")}, atol={**TOL, "N": 1e-8, "N*m": 1e-9})
ref.fact(degrees_of_freedom=3, loops=0, redundant=0, bodies=1, joints=1).write(*case("bushing-planar"))

ref = Reference("analytic", "bushing wrench at its second point, displacement in the axes of the first; drives from Newton and Euler")
for k in range(6):
    T = k / 10
    x = np.array([0.004 * math.sin(9 * T), 0.003 * math.cos(7 * T), 0.002 * math.sin(4 * T)])
    v = np.array([0.036 * math.cos(9 * T), -0.021 * math.sin(7 * T), 0.008 * math.cos(4 * T)])
    a = np.array([-0.324 * math.sin(9 * T), -0.147 * math.cos(7 * T), -0.032 * math.sin(4 * T)])
    q = [6 * deg * f for f in (math.sin(5 * T), 5 * math.cos(5 * T), -25 * math.sin(5 * T))]
    z = np.array([0, 0, 1.0])
    F, M = wrench(Rz(q[0]), q[1] * z, q[2] * z, a, 2.0, np.array([0.03, -0.02, 0.01]), tensor(0.02, 0.03, 0.025), np.array([0.7, -9.5, 1.1]))
    F = F + np.array([2e5, 8e4, 5e4]) * x + np.array([900, 400, 300]) * v
    M = M + z * (150 * q[0] + q[1])
    roll, pitch = Rz(q[0]) @ [1, 0, 0], Rz(q[0]) @ [0, 1, 0]
    ref.row("run", {"time": f"{T:g} s"}, {**{f"drive.place.force.{i}": (F[i], "N") for i in range(3)}, "drive.place.force.3": (M @ roll, "N*m"),
        "drive.place.force.4": (M @ pitch, "N*m"), "drive.place.force.5": (M[2], "N*m"),
        **{f"joint.place.reaction.f{s}": (F[i], "N") for i, s in enumerate("xyz")}, **{f"joint.place.reaction.m{s}": (M[i], "N*m") for i, s in enumerate("xyz")}},
        atol={**TOL, "N": 1e-8, "N*m": 1e-9})
ref.fact(degrees_of_freedom=6, loops=0, redundant=0, bodies=1, joints=1).write(*case("bushing-spatial"))

# ---------------------------------------------------------------- loads
ref = Reference("analytic", "moments about the hinge, each load by its formula")
for k in range(6):
    T = k / 5
    th, w, al = 5 * deg + 3 * T + 1.1 * T * T, 3 + 2.2 * T, 2.2
    c, P, Q = rot2(th) @ [0.12, 0.03], rot2(th) @ [0.3, 0.05], rot2(th) @ [0.22, -0.04]
    f1, f2 = rot2(th) @ [12, -31], 20 * e(3 * T)
    torque = 1.7 * math.sin(4 * T) - 0.3 * T
    drag = -0.21 * w * abs(w)
    M = (0.015 + 2 * (c @ c)) * al - cross(c, 2 * G2) - cross(P, f1) - cross(Q, f2) - torque
    G = 2 * (al * perp(c) - w * w * c - G2) - f1 - f2
    ref.row("run", {"time": f"{T:g} s"}, {"drive.crank.force": (M - drag, "N*m"), "joint.crank.reaction.fx": (G[0], "N"), "joint.crank.reaction.fy": (G[1], "N"),
        "joint.crank.reaction.mz": (M, "N*m"), "joint.crank.position": (th, "rad")}, atol=TOL)
ref.write(*case("loads"))

# ---------------------------------------------------------------- friction
ref = Reference("analytic", "m g (sin a + sign(v) mu cos a) + viscous v + m a (reference set X1, incline 25 deg, mu 0.2)")
for study, v, a in (("up", 0.8, 0.0), ("down", -0.8, 0.5)):
    s, c = math.sin(25 * deg), math.cos(25 * deg)
    F = 6 * a + 6 * 9.81 * s + math.copysign(1, v) * 0.2 * 6 * 9.81 * c + 14 * v
    for x in ("0", "0.5", "1"):
        ref.row(study, {"joint.rail.position": f"{x} m"}, {"drive.rail.force": (F, "N"), "drive.rail.power": (F * v, "W"),
            "joint.rail.reaction.fx": (6 * a * c, "N"), "joint.rail.reaction.fy": (6 * a * s + 6 * 9.81, "N"), "joint.rail.reaction.mz": (0, "N*m")}, atol=TOL)
ref.write(*case("friction-incline"))

ref = Reference("analytic", "Stribeck curve mu(v) = coulomb + (static - coulomb) exp(-(v/vs)^2) (Armstrong-Helouvry, Dupont, Canudas de Wit 1994, exponent 2)")
for study, v in (("slow", 0.04), ("fast", 0.11)):
    F = (0.12 + 0.18 * math.exp(-((v / 0.05) ** 2))) * 5 * 9.81 + 20 * v
    ref.row(study, {"joint.rail.position": "1 m"}, {"drive.rail.force": (F, "N")})
ref.write(*case("friction-stribeck"))

ref = Reference("analytic", "dry pin: moment mu radius |F| against the turning; F = m (a - g)")
for d in range(-70, 140, 30):
    th, w, al = d * deg, -3.0, 4.0
    c = rot2(th) @ [0.4, 0.1]
    G = 7 * (al * perp(c) - w * w * c - G2)
    M = (0.3 + 7 * (c @ c)) * al - cross(c, 7 * G2)
    friction = -0.18 * 0.025 * np.hypot(*G) * math.copysign(1, w)
    ref.row("run", {"joint.pin.position": f"{d} deg"}, {"drive.pin.force": (M - friction, "N*m"), "joint.pin.reaction.mz": (M, "N*m"),
        "joint.pin.reaction.force": (np.hypot(*G), "N"), "joint.pin.reaction.fx": (G[0], "N"), "joint.pin.reaction.fy": (G[1], "N")}, atol=TOL)
ref.write(*case("friction-pin"))


def slider_crank_friction(th, mu):
    """The slider-crank of K1 with friction mu |N| at the guide, N by repeated substitution to rounding."""
    r, l, off, w, m, J2, c1, c2 = 0.05, 0.2, 0.01, 100.0, (0.8, 0.5, 0.6), 0.0022, 0.02, 0.07
    phi = math.asin((off - r * math.sin(th)) / l)
    pd = -r * math.cos(th) * w / (l * math.cos(phi))
    pdd = (r * math.sin(th) * w * w + l * math.sin(phi) * pd**2) / (l * math.cos(phi))
    xd = -r * math.sin(th) * w - l * math.sin(phi) * pd
    xdd = -r * math.cos(th) * w * w - l * math.sin(phi) * pdd - l * math.cos(phi) * pd**2
    a2 = -r * w * w * e(th) + c2 * (pdd * perp(e(phi)) - pd**2 * e(phi))
    N = 0.0
    for _ in range(200):
        fr = -mu * abs(N) * math.copysign(1, xd)
        Sx = -500 + fr - m[2] * xdd
        Sy = (J2 * pdd - c2 * cross(e(phi), m[1] * (G2 - a2)) + l * math.sin(phi) * Sx) / (l * math.cos(phi))
        N = Sy - m[2] * G2[1]
    Q = np.array([Sx, Sy]) + m[1] * (G2 - a2)
    torque = -cross(c1 * e(th), m[0] * (G2 + c1 * w * w * e(th))) - cross(r * e(th), Q)
    return torque, N, fr, Sx, Sy


ref = Reference("analytic", f"free bodies with the guide friction by repeated substitution ({HERE})")
for d in range(15, 375, 30):
    torque, N, fr, Sx, Sy = slider_crank_friction(d * deg, 0.25)
    ref.row("run", {"joint.crank.position": f"{d} deg"}, {"drive.crank.force": (torque, "N*m"), "joint.slide.reaction.fy": (N, "N"), "joint.slide.reaction.fx": (fr, "N"),
        "joint.B.reaction.fx": (Sx, "N"), "joint.B.reaction.fy": (Sy, "N")}, rtol=1e-9, atol=TOL)
ref.write(*case("friction-slider-crank"))
CARDAN.write(*case("cardan-shaft"))
