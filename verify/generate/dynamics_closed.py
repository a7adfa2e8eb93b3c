"""References of dynamics cases in closed form, or from one's own equations of motion integrated to rounding."""
import cmath, math, os
import numpy as np
from scipy.spatial.transform import Rotation
import maximal
from free import Free
from reference import Reference, ROOT, case
from published_cases import slider_crank
from ode import solve

HERE = "verify/generate/dynamics_closed.py"
deg = math.pi / 180
every = lambda step, n: [round(step * k, 9) for k in range(1, n + 1)]
clock = lambda t: {"time": f"{t:g} s"}

# ---------------------------------------------------------------- oscillators
ref = Reference("analytic", f"vibrations of one degree of freedom in closed form ({HERE})")


def free(m, c, k, x, v, t):
    """Position and velocity of m x" + c x' + k x = 0."""
    a, root = c / (2 * m), cmath.sqrt((c / (2 * m)) ** 2 - k / m)
    if abs(root) < 1e-9:
        b = v + a * x
        return (x + b * t) * math.exp(-a * t), (b - a * (x + b * t)) * math.exp(-a * t)
    p, q = -a + root, -a - root
    A = (v - q * x) / (p - q)
    B = x - A
    return (A * cmath.exp(p * t) + B * cmath.exp(q * t)).real, (A * p * cmath.exp(p * t) + B * q * cmath.exp(q * t)).real


for t in every(0.25, 12):
    for name, c in (("light", 5.0), ("critical", 50.0), ("heavy", 200.0)):
        x, v = free(2.5, c, 250, 0.1, 0.4, t)
        ref.row("run", clock(t), {f"joint.{name}.position": (x, "m"), f"joint.{name}.velocity": (v, "m/s"), f"force.{name}.effort": (-250 * x - c * v, "N")}, rtol=1e-8, atol={"m": 1e-10, "m/s": 1e-9, "N": 1e-7})
        ref.row("implicit", clock(t), {f"joint.{name}.position": (x, "m")}, rtol=0, atol={"m": 3e-4})
    x, v = 3 / (2 * 2.5 * 10) * t * math.sin(10 * t), 0.06 * (math.sin(10 * t) + 10 * t * math.cos(10 * t))
    ref.row("run", clock(t), {"joint.forced.position": (x, "m"), "joint.forced.velocity": (v, "m/s"), "joint.disk.position": (20 * deg + math.pi * math.cos(5 * t), "rad"),
        "joint.disk.velocity": (-5 * math.pi * math.sin(5 * t), "rad/s"), "joint.disk.acceleration": (-25 * math.pi * math.cos(5 * t), "rad/s^2")}, rtol=1e-8, atol={"m": 1e-9, "m/s": 1e-8, "rad": 1e-9, "rad/s": 1e-8, "rad/s^2": 1e-7})
    ref.row("implicit", clock(t), {"joint.forced.position": (x, "m"), "joint.disk.position": (20 * deg + math.pi * math.cos(5 * t), "rad")}, rtol=0, atol={"m": 1e-3, "rad": 1e-2})
slow, fast = (40 - s * math.sqrt(1500) for s in (1, -1))
for i, (w, z) in enumerate(((slow, 1), (5, 0), (10, 0.1), (fast, 1))):
    ref.summary("ring", f"modes.{i}.frequency.value", w / (2 * math.pi), "Hz", rtol=1e-9).summary("ring", f"modes.{i}.damping", z, rtol=1e-9, atol=1e-9)
ref.fact(degrees_of_freedom=5, loops=0, redundant=0, bodies=5, joints=5).write(*case("oscillators"))

# ---------------------------------------------------------------- bushing
ref = Reference("analytic", f"harmonics of the centre; Euler's equations under the moments of the rotation vector, integrated to rounding ({HERE})")
J, F = np.diag([0.03, 0.05, 0.06]), Rotation.from_euler("z", 30, degrees=True)
kr, cr = np.array([8, 12, 10.0]), np.array([0, 0.1, 0])


def turning(t, y):
    R, w = Rotation.from_quat(y[:4]), y[4:]                      # w in body axes; the body's axes are the world's at the start
    theta = (F.inv() * R * F).as_rotvec()
    W = R.apply(w)
    M = R.inv().apply(F.apply(-kr * theta - cr * F.inv().apply(W)))
    x, y_, z, s = y[:4]
    rate = 0.5 * np.array([s * w[0] + y_ * w[2] - z * w[1], s * w[1] + z * w[0] - x * w[2], s * w[2] + x * w[1] - y_ * w[0], -x * w[0] - y_ * w[1] - z * w[2]])
    return np.concatenate([rate, np.linalg.solve(J, M - np.cross(w, J @ w))])


times = every(0.1, 10)
for t, y in zip(times, solve(turning, np.concatenate([[0, 0, 0, 1.0], F.apply([4, -2, 3.0])]), times)):
    R = Rotation.from_quat(y[:4])
    W = R.apply(y[4:])
    d = [free(4, c, k, x, v, t) for k, c, x, v in ((900, 6, 0.01, 0.3), (1600, 0, -0.02, 0), (2500, 0, 0.005, -0.2))]
    place = F.apply([x for x, _ in d])
    P = place + R.apply([0.1, 0.2, 0.3])
    ref.row("run", clock(t), {**{f"joint.six.position.{i}": (x, "m") for i, (x, _) in enumerate(d)}, **{f"joint.six.velocity.{i}": (v, "m/s") for i, (_, v) in enumerate(d)},
        **{f"point.block.P.{c}": (P[i], "m") for i, c in enumerate("xyz")}, **{f"body.block.omega_{c}": (W[i], "rad/s") for i, c in enumerate("xyz")}}, rtol=0, atol={"m": 1e-9, "m/s": 1e-8, "rad/s": 1e-7})
JF = F.as_matrix().T @ J @ F.as_matrix()
mass = np.zeros((6, 6)); mass[:3, :3] = 4 * np.eye(3); mass[3:, 3:] = JF
stiff, damp = np.diag([900, 1600, 2500, *kr]), np.diag([6, 0, 0, *cr])
A = np.block([[np.zeros((6, 6)), np.eye(6)], [-np.linalg.solve(mass, stiff), -np.linalg.solve(mass, damp)]])
for i, x in enumerate(sorted((x for x in np.linalg.eigvals(A) if x.imag > 0), key=abs)):
    ref.summary("ring", f"modes.{i}.frequency.value", abs(x) / (2 * math.pi), "Hz", rtol=1e-8).summary("ring", f"modes.{i}.damping", -x.real / abs(x), rtol=1e-8, atol=1e-9)
ref.fact(degrees_of_freedom=6, loops=0, redundant=0, bodies=1, joints=1).write(*case("bushing-vibration"))

# ---------------------------------------------------------------- cart with a pendulum
ref = Reference("analytic", f"Lagrange's equations of cart and pendulum, integrated to rounding ({HERE}); conserved momentum and energy")
M, m, l, I, g = 2.0, 1.0, 0.4, 0.05, 9.81


def cart(t, y):
    s, c = math.sin(y[2]), math.cos(y[2])
    a, b, d = M + m, -m * l * s, I + m * l * l
    p, q = m * l * c * y[3] ** 2, -m * g * l * c
    det = a * d - b * b
    return np.array([y[1], (d * p - b * q) / det, y[3], (a * q - b * p) / det])


times = every(0.5, 10)
for t, y in zip(times, solve(cart, [0, 0.5, 40 * deg, 2.0], times)):
    ax, al = cart(t, y)[[1, 3]]
    fy = (M + m) * g + m * l * (math.cos(y[2]) * al - math.sin(y[2]) * y[3] ** 2)
    ref.row("run", clock(t), {"joint.rail.position": (y[0], "m"), "joint.rail.velocity": (y[1], "m/s"), "joint.rail.acceleration": (ax, "m/s^2"), "joint.hinge.position": (y[2], "rad"), "joint.hinge.velocity": (y[3], "rad/s"),
        "joint.rail.reaction.fy": (fy, "N"), "joint.rail.reaction.fx": (0, "N")}, rtol=0, atol={"m": 1e-9, "m/s": 1e-8, "m/s^2": 1e-7, "rad": 1e-8, "rad/s": 1e-7, "N": 1e-6})
    if t <= 2:
        ref.row("implicit", clock(t), {"joint.rail.position": (y[0], "m"), "joint.hinge.position": (y[2], "rad")}, rtol=0, atol={"m": 1e-3, "rad": 1e-2})
momentum = "range(2 kg*body.cart.vx + 1 kg*body.rod.vx)"
ref.value("run", 0, "N*s", reduce=momentum, atol=1e-9).value("implicit", 0, "N*s", reduce=momentum, atol=1e-4).value("run", 0, "J", reduce="range(energy.total)", atol=1e-9)
ref.fact(degrees_of_freedom=2, loops=0, redundant=0, bodies=2, joints=2).write(*case("cart-pendulum"))

# ---------------------------------------------------------------- free body about its intermediate axis
ref = Reference("analytic", f"Euler's equations and the quaternion, integrated to rounding; angular momentum and energy stay to 1e-12 there ({HERE})")
J = np.array([0.02, 0.05, 0.06])


def euler(t, y):
    x, y_, z, s = y[:4]
    w = y[4:]
    rate = 0.5 * np.array([s * w[0] + y_ * w[2] - z * w[1], s * w[1] + z * w[0] - x * w[2], s * w[2] + x * w[1] - y_ * w[0], -x * w[0] - y_ * w[1] - z * w[2]])
    return np.concatenate([rate, -np.cross(w, J * w) / J])


w0 = np.array([0.05, 8, 0.02])
times, flipped = every(0.1, 40), 0
for t, y in zip(times, solve(euler, np.concatenate([[0, 0, 0, 1.0], w0]), times)):
    R = Rotation.from_quat(y[:4])
    assert np.abs(R.apply(J * y[4:]) - J * w0).max() < 1e-12 and abs(y[4:] @ (J * y[4:]) - w0 @ (J * w0)) < 1e-12
    flipped = max(flipped, 8 - y[5])
    W, P, V = R.apply(y[4:]), R.apply([0, 1, 0]) + t * np.array([0.5, -0.2, 20 - 9.81 * t / 2]), None
    ref.row("flight", clock(t), {**{f"point.book.y.{c}": (P[i], "m") for i, c in enumerate("xyz")}, **{f"body.book.omega_{c}": (W[i], "rad/s") for i, c in enumerate("xyz")}}, rtol=0, atol={"m": 1e-7, "rad/s": 1e-6})
    if t <= 2:
        ref.row("implicit", clock(t), {f"point.book.y.{c}": (P[i], "m") for i, c in enumerate("xyz")}, rtol=0, atol={"m": 2e-2})
assert flipped > 15                                              # 8 rad/s became -8 rad/s: it did turn over
for i, c in enumerate("xyz"):
    axis = lambda k, c: f"(point.book.{k}.{c} - point.book.O.{c})"
    along = lambda k: "(" + " + ".join(f"{axis(k, c)}*body.book.omega_{c}" for c in "xyz") + ")"
    momentum = " + ".join(f"{n}*{axis(k, c)}*{along(k)}" for n, k in zip("ABC", "xyz"))
    ref.value("flight", 0, "", reduce=f"range({momentum})", atol=1e-9)
ref.value("flight", 0, "J", reduce="range(energy.total)", atol=1e-8)
ref.fact(degrees_of_freedom=6, loops=0, redundant=0, bodies=1, joints=1).write(*case("euler-top"))

# ---------------------------------------------------------------- steady precession
ref = Reference("analytic", "m g l = C (spin + P cos T) P - A P^2 cos T: tilt, precession and spin stay")
m, l, A, C, P, T = 2, 0.15, 0.06, 0.02, 1.5, 50 * deg
spin = (m * 9.81 * l / P - (C - A) * P * math.cos(T)) / C
for t in every(0.25, 8):
    c = l * np.array([math.sin(T) * math.sin(P * t), -math.sin(T) * math.cos(P * t), math.cos(T)])
    pull = -m * P * P * c
    ref.row("run", clock(t), {"joint.post.position": (P * t, "rad"), "joint.tilt.position": (T, "rad"), "joint.spin.position": (spin * t, "rad"), "joint.post.velocity": (P, "rad/s"), "joint.tilt.velocity": (0, "rad/s"),
        "joint.spin.velocity": (spin, "rad/s"), **{f"point.top.C.{k}": (c[i], "m") for i, k in enumerate("xyz")},
        "joint.post.reaction.fx": (pull[0], "N"), "joint.post.reaction.fy": (pull[1], "N"), "joint.post.reaction.fz": (m * 9.81, "N"), "joint.post.reaction.mz": (0, "N*m")},
        rtol=0, atol={"rad": 1e-8, "rad/s": 1e-7, "m": 1e-9, "N": 1e-6, "N*m": 1e-7})
ref.fact(degrees_of_freedom=3, loops=0, redundant=0, bodies=3, joints=3).write(*case("steady-precession"))

# ---------------------------------------------------------------- governor
ref = Reference("analytic", f"Lagrange's equation of an arm on a shaft that turns as told, integrated to rounding; torque from the angular momentum ({HERE})")
m, l, e, Ix, Iy, Iz, Is = 0.4, 0.3, 0.05, 0.002, 0.003, 0.001, 0.02


def shaft(t):
    if t >= 3:
        return 15.0, 0.0, 0.0
    u = 2 * math.pi * t / 3
    return 15 * (t / 3 - math.sin(u) / (2 * math.pi)), 5 * (1 - math.cos(u)), 5 * 2 * math.pi / 3 * math.sin(u)


def arm(t, y):
    s, c, W = math.sin(y[0]), math.cos(y[0]), shaft(t)[1]
    return np.array([y[1], (W * W * (m * (e + l * s) * l * c + (Ix - Iz) * s * c) - m * 9.81 * l * s) / (m * l * l + Iy)])


times = every(0.25, 16)
for t, y in zip(times, solve(arm, [10 * deg, 0.0], times, breaks=[3.0])):
    s, c, (f, W, a) = math.sin(y[0]), math.cos(y[0]), shaft(t)
    r = e + l * s
    torque = (Is + 2 * (m * r * r + Ix * s * s + Iz * c * c)) * a + 2 * W * y[1] * (2 * m * r * l * c + 2 * (Ix - Iz) * s * c)
    ref.row("run", clock(t), {"joint.shaft.position": (f, "rad"), **{f"joint.{k}.position": (y[0], "rad") for k in ("left", "right")}, "joint.left.velocity": (y[1], "rad/s"), "joint.left.acceleration": (arm(t, y)[1], "rad/s^2"),
        "drive.shaft.force": (torque, "N*m"), "drive.shaft.power": (torque * W, "W")}, rtol=0, atol={"rad": 1e-8, "rad/s": 1e-7, "rad/s^2": 1e-6, "N*m": 1e-8, "W": 1e-7})
ref.fact(degrees_of_freedom=3, loops=0, redundant=0, bodies=3, joints=3).write(*case("governor"))

# ---------------------------------------------------------------- gears, screw
ref = Reference("analytic", "inertias at the motor, torque integrated twice; nut: m g p/(I + m p^2) with p = pitch/2 pi")
p = 0.04 / (2 * math.pi)
for t in every(0.5, 8):
    f, w, a = 3 * t + 25 * t * t - 0.1 / 0.012 * t**3 / 6, 3 + 50 * t - 0.1 / 0.012 * t * t / 2, 50 - 0.1 / 0.012 * t
    b = -1.2 * 9.81 * p / (3e-4 + 1.2 * p * p)
    ref.row("run", clock(t), {"joint.motor.position": (f, "rad"), "joint.motor.velocity": (w, "rad/s"), "joint.motor.acceleration": (a, "rad/s^2"), "joint.wheel.position": (-f / 3, "rad"), "joint.wheel.velocity": (-w / 3, "rad/s"),
        "joint.motor.reaction.mz": (2e-3 * a, "N*m"), "joint.wheel.reaction.mz": (-0.03 * a, "N*m"),
        "joint.screw.position": (b * t * t / 2, "rad"), "joint.screw.velocity": (b * t, "rad/s"), "body.nut.z": (p * b * t * t / 2, "m"), "joint.screw.reaction.fz": (1.2 * (9.81 + p * b), "N"), "joint.screw.reaction.mz": (3e-4 * b, "N*m")}, rtol=1e-9,
        atol={"rad": 1e-9, "rad/s": 1e-8, "N*m": 1e-9})
ref.fact(degrees_of_freedom=2, redundant=0, bodies=3, joints=4).write(*case("gears-spun-up"))

# ---------------------------------------------------------------- four-bar that swings, in the plane and in space
cross = lambda w, v: w * np.array([-v[1], v[0]])


def loop(q):
    """Places and rates (by the crank angle) of the bars; algebraic, so that a complex step gives the next derivative."""
    A = 0.2 * np.array([np.cos(q), np.sin(q)])
    O4 = np.array([0.45, 0])
    d = O4 - A
    L = np.sqrt(d @ d)
    x = (0.5**2 - 0.4**2 + L * L) / (2 * L)
    B = A + x * d / L + np.sqrt(0.25 - x * x) * np.array([-d[1], d[0]]) / L
    n, r = B - A, B - O4
    dA = cross(1, A)
    u, v = np.linalg.solve(np.array([-cross(1, n), cross(1, r)]).T, dA)
    return A, B, dA, cross(v, r), u, v


def energies(q):
    A, B, dA, dB, u, v = loop(q)
    square = lambda a: a @ a
    inertia = square(dA / 2) + 0.2**2 / 12 + 2 * square((dA + dB) / 2) + 2 * 0.25 / 12 * u * u + 1.5 * square(dB / 2) + 1.5 * 0.16 / 12 * v * v
    return inertia, 9.81 * (A[1] / 2 + 2 * (A + B)[1] / 2 + 1.5 * B[1] / 2) + 15 * (q - math.pi / 2) ** 2


def swing(t, y):
    (i, v), h = energies(y[0] + 1e-30j), 1e-30
    return np.array([y[1], -(0.5 * i.imag / h * y[1] ** 2 + v.imag / h) / i.real])


times = every(0.1, 20)
planar = Reference("analytic", f"equation of motion from the energies of the loop, integrated to rounding ({HERE})")
spatial = Reference("analytic", f"the planar four-bar of `four-bar-free`: four parallel hinges in a leaning plane ({HERE})")
for t, y in zip(times, solve(swing, [40 * deg, 5.0], times)):
    _, B, _, _, u, v = loop(y[0])
    same = {"joint.crank.position": (y[0], "rad"), "joint.crank.velocity": (y[1], "rad/s"), "joint.crank.acceleration": (swing(t, y)[1], "rad/s^2"),
            "joint.rocker.position": (math.atan2(B[1], B[0] - 0.45), "rad"), "joint.rocker.velocity": (v * y[1], "rad/s")}
    tolerance = dict(rtol=0, atol={"rad": 1e-8, "rad/s": 1e-7, "rad/s^2": 1e-5, "m": 1e-9})
    planar.row("run", clock(t), {**same, "point.coupler.B.x": (B[0], "m"), "point.coupler.B.y": (B[1], "m"), "body.coupler.omega": (u * y[1], "rad/s")}, **tolerance)
    n = np.array([0, math.cos(115 * deg), math.sin(115 * deg)])
    place = B[0] * np.array([1, 0, 0]) + B[1] * n
    spatial.row("run", clock(t), {**same, **{f"point.rocker.B.{c}": (place[i], "m") for i, c in enumerate("xyz")}}, **tolerance)
    if t <= 1:
        planar.row("implicit", clock(t), {"joint.crank.position": (y[0], "rad")}, rtol=0, atol={"rad": 1e-2})
for ref in (planar, spatial):
    ref.value("run", 0, "J", reduce="range(energy.total)", atol=1e-8).value("run", 0, "m", reduce="max(check.closure)", atol=1e-12)
planar.fact(degrees_of_freedom=1, loops=1, redundant=0, bodies=3, joints=4).write(*case("four-bar-free"))
spatial.fact(degrees_of_freedom=1, loops=1, redundant=3, bodies=3, joints=4).write(*case("four-bar-free-spatial"))

# ---------------------------------------------------------------- double pendulum on the coupler of a driven four-bar
ref = Reference("other-code", f"double pendulum on a point that moves as told, integrated to rounding ({HERE}); its accelerations and the crank's torque by free bodies in absolute coordinates (verify/generate/free.py)")
m1, c1, I1, L, m2, I2, r0 = 0.6, 0.12, 0.003, 0.25, 0.4, 0.002, np.array([0.1, 0.02])
turn = lambda a, r: np.array([math.cos(a) * r[0] - math.sin(a) * r[1], math.sin(a) * r[0] + math.cos(a) * r[1]])


def crank(t):
    return 40 * deg + 4 * t + 0.5 * math.sin(3 * t), 4 + 1.5 * math.cos(3 * t), -4.5 * math.sin(3 * t)


def coupler(q):
    """Angle and point of the coupler, and their derivatives by the crank angle (the point's second by a complex step in `pivot`)."""
    A, B, dA, _, u, _ = loop(q)
    x = (B - A) / 0.5
    P = A + 0.3 * x + 0.15 * np.array([-x[1], x[0]])
    return math.atan2(x[1].real, x[0].real), u, dA + cross(u, P - A)


def pivot(t):
    q, w, a = crank(t)
    angle, u, dP = coupler(q + 1e-30j)
    return angle, u.real * w, dP.real * a + dP.imag / 1e-30 * w * w, u.real * a + u.imag / 1e-30 * w * w


def hung(t, y):
    a, b, va, vb = y
    pull = np.array([0, -9.81]) - pivot(t)[2]
    e, r = turn(a, [1, 0]), turn(b, r0)
    n, s = np.array([-e[1], e[0]]), np.array([-r[1], r[0]])
    knee = -0.3 * (b - a) - 0.01 * (vb - va)
    M = [[I1 + m1 * c1 * c1 + m2 * L * L, m2 * L * n @ s], [m2 * L * n @ s, I2 + m2 * r @ r]]
    f = [(m1 * c1 + m2 * L) * pull @ n + m2 * L * vb * vb * n @ r - knee, m2 * pull @ s + m2 * L * va * va * s @ e + knee]
    return np.concatenate([[va, vb], np.linalg.solve(M, f)])


angle, rate, _, _ = pivot(0.0)
a0, va0 = angle - 120 * deg, rate - 1.5
times = every(0.25, 6)
free_bodies = Free(maximal.load(os.path.join(ROOT, "verify", "cases", "four-bar-with-pendulum", "model.toml")), "run", ["hang", "knee"])
for t, y in zip(times, solve(hung, [a0, a0 + 20 * deg, va0, va0 + 0.5], times)):
    angle, rate, _, alpha = pivot(t)
    a, b, va, vb = y
    aa, ab = hung(t, y)[2:]
    state = [a - angle, b - a, va - rate, vb - va]
    found = free_bodies.accelerations(t, np.array(state))
    assert np.abs(found - [aa - alpha, ab - aa]).max() < 1e-9 * max(1, np.abs(found).max()), (t, found, aa - alpha, ab - aa)
    signals = free_bodies.at(t, np.array(state), found)
    ref.row("run", clock(t), {"joint.hang.position": (state[0], "rad"), "joint.knee.position": (state[1], "rad"), "joint.hang.velocity": (state[2], "rad/s"), "joint.knee.velocity": (state[3], "rad/s"),
        "joint.hang.acceleration": (found[0], "rad/s^2"), "joint.knee.acceleration": (found[1], "rad/s^2"), **{k: (signals[k], u) for k, u in (("drive.crank.force", "N*m"), ("joint.hang.reaction.fx", "N"), ("joint.hang.reaction.fy", "N"),
        ("joint.rocker.reaction.fx", "N"), ("joint.rocker.reaction.fy", "N"), ("point.lower.T.x", "m"), ("point.lower.T.y", "m"))}}, rtol=0, atol={"rad": 1e-8, "rad/s": 1e-7, "rad/s^2": 1e-5, "N*m": 1e-7, "N": 1e-6, "m": 1e-9})
ref.fact(degrees_of_freedom=3, loops=1, redundant=0, bodies=5, joints=6).write(*case("four-bar-with-pendulum"))

# ---------------------------------------------------------------- chain
ref = Reference("analytic", f"Lagrange's equations of a chain of rods in absolute angles, integrated to rounding ({HERE})")
n, L, m = 20, 0.1, 0.05
c = np.tril(np.full((n, n), L), -1) + np.diag(np.full(n, L / 2))
K, G, I = m * c.T @ c, m * 9.81 * c.sum(axis=0), m * L * L / 12


def chain(t, y):
    a, w = y[:n], y[n:]
    d = a[:, None] - a
    return np.concatenate([w, np.linalg.solve(K * np.cos(d) + I * np.eye(n), -(K * np.sin(d)) @ w**2 - G * np.cos(a))])


times = every(0.1, 10)
start = np.concatenate([np.full(n, -50 * deg), np.zeros(n)])
for t, y in zip(times, solve(chain, start, times)):
    a = y[:n]
    tip, mid = L * np.array([np.cos(a).sum(), np.sin(a).sum()]), L * np.array([np.cos(a[:10]).sum(), np.sin(a[:10]).sum()])
    acc = chain(t, y)[n:]
    pull = m * (c @ (-np.sin(a) * acc - np.cos(a) * y[n:] ** 2)).sum()
    ref.row("fall", clock(t), {"point.r20.B.x": (tip[0], "m"), "point.r20.B.y": (tip[1], "m"), "point.r10.B.x": (mid[0], "m"), "point.r10.B.y": (mid[1], "m"), "joint.j1.position": (a[0], "rad"), "body.r20.omega": (y[-1], "rad/s"),
        "joint.j1.reaction.fx": (pull, "N")}, rtol=0, atol={"m": 1e-8, "rad": 1e-7, "rad/s": 1e-5, "N": 1e-5})
ref.value("fall", 0, "J", reduce="range(energy.total)", atol=1e-9)
ref.fact(degrees_of_freedom=20, loops=0, redundant=0, bodies=20, joints=20).write(*case("chain-20"))

# ---------------------------------------------------------------- slider-crank under the torque that keeps its speed
ref = Reference("analytic", "reference set K1: the torque of constant speed as a function of the crank angle gives constant speed back, and every reaction (verify/generate/published_cases.py)")
for i in range(13):
    k = slider_crank(i * math.pi / 6, 100.0)
    ref.row("run", {"time": f"{i * math.pi / 600!r} s"}, {"joint.crank.position": (i * math.pi / 6, "rad"), "joint.crank.velocity": (100, "rad/s"), "joint.crank.acceleration": (0, "rad/s^2"), "joint.slide.position": (k["x"], "m"),
        "joint.slide.velocity": (k["xd"], "m/s"), "joint.slide.acceleration": (k["xdd"], "m/s^2"), "joint.A.reaction.fx": (k["Q"][0], "N"), "joint.A.reaction.fy": (k["Q"][1], "N"), "joint.crank.reaction.fx": (k["G"][0], "N"),
        "joint.slide.reaction.fy": (k["N"], "N"), "force.torque.effort": (k["torque"], "N*m")}, rtol=0,
        atol={"rad": 1e-8, "rad/s": 1e-6, "rad/s^2": 1e-3, "m": 1e-9, "m/s": 1e-7, "m/s^2": 1e-4, "N": 1e-4, "N*m": 1e-6})
ref.fact(degrees_of_freedom=1, loops=1, redundant=0, bodies=3, joints=4).write(*case("slider-crank-forward"))
