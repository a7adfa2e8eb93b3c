"""References of dynamics cases with events: sliding, sticking, bouncing, colliding, Hertz' contact, stick-slip."""
import math
from scipy.integrate import solve_ivp
from scipy.special import gamma
from reference import Reference, case

HERE = "verify/generate/dynamics_events.py"
g, deg = 9.81, math.pi / 180
clock = lambda t: {"time": f"{t:g} s"}

# ---------------------------------------------------------------- blocks that slide, stick and stop
ref = Reference("analytic", "reference set X1: g (sin - mu cos) on the slope, v^2/(2 mu g) to rest on the flat")
s, c = math.sin(25 * deg), math.cos(25 * deg)
a = g * (s - 0.2 * c)
assert abs(a - 2.3677092695103545) < 1e-14
rest = 3 / (0.3 * g)
for t in (0.5, 1.0, 1.5, 2.0):
    ref.row("run", clock(t), {"joint.slide.position": (a * t * t / 2, "m"), "joint.slide.velocity": (a * t, "m/s"), "joint.slide.acceleration": (a, "m/s^2"), "force.slide.effort": (-0.2 * g * c, "N"),
        "joint.stick.position": (0, "m"), "joint.stick.velocity": (0, "m/s"), "joint.stick.acceleration": (0, "m/s^2"), "force.stick.effort": (-g * s, "N"),
        "joint.flat.position": (3 * t - 0.15 * g * t * t if t < rest else 1.529051987767584, "m"), "joint.flat.velocity": (max(0, 3 - 0.3 * g * t), "m/s"), "force.flat.effort": (-0.3 * g if t < rest else 0, "N")},
        rtol=0, atol={"m": 1e-9, "m/s": 1e-9, "m/s^2": 1e-9, "N": 1e-9})
ref.summary("run", "events.0.time.value", rest, atol=1e-9).write(*case("contact-slide"))

# ---------------------------------------------------------------- bouncing ball, two blocks
ref = Reference("analytic", "reference set X1: free fall between impacts, speeds after them by the restitution; rest at t0 (1 + e)/(1 - e)")
t0, v0, e = math.sqrt(2 / g), math.sqrt(2 * g), 0.8
times, t, v = [t0], t0, v0 * e
for _ in range(60):
    t, v = t + 2 * v / g, v * e
    times.append(t)
assert abs(times[9] - 3.5788929510204386) < 1e-14 and abs(t0 * 9 - 4.063712768871579) < 1e-14


def ball(t):
    if t >= 9 * t0:
        return 0.0, 0.0
    if t < t0:
        return 1 - g * t * t / 2, -g * t
    n = max(i for i, x in enumerate(times) if x <= t)
    v, d = v0 * e ** (n + 1), t - times[n]
    return v * d - g * d * d / 2, v - g * d


va, vb = 3 - (1 + 0.6) * 4 * 2 / 3, -1 + (1 + 0.6) * 4 / 3                # impulse (1 + e) m1 m2/(m1 + m2) (v1 - v2)
assert abs(va + 1.2666666666666666) < 1e-15 and abs(vb - 1.1333333333333333) < 1e-15
for t in [0.5 * k for k in range(1, 11)]:
    y, v = ball(t)
    w = t - 0.25
    ref.row("run", clock(t), {"joint.fall.position": (y, "m"), "joint.fall.velocity": (v, "m/s"), "body.one.x": (0.75 + va * w, "m"), "body.two.x": (0.75 + vb * w, "m"), "body.one.vx": (va, "m/s"), "body.two.vx": (vb, "m/s"),
        "joint.gap.velocity": (2.4, "m/s"), "force.floor.effort": (1.3 * g if t >= 9 * t0 else 0, "N")}, rtol=0, atol={"m": 1e-9, "m/s": 1e-8, "N": 1e-8})
blows = [(0.25, 4.0, 1.6 * 4 * 2 / 3, "blow")] + [(t, v0 * e**k, 1.3 * (1 + e) * v0 * e**k, "floor") for k, t in enumerate(times[:10])]
for i, (t, v, j, _) in enumerate(blows):
    for path, value in (("time", t), ("speed", v), ("impulse", j)):
        ref.summary("run", f"events.{i}.{path}.value", value if path != "speed" else 1e3 * v, rtol=1e-9, atol=1e-9)
ref.fact(degrees_of_freedom=3, loops=0, redundant=0, bodies=3, joints=3).write(*case("contact-bounce"))

# ---------------------------------------------------------------- Hertz
ref = Reference("analytic", "reference set X1: approach from the energy (m v^2/2 = 2/5 k d^2.5), time of contact 2 sqrt(pi) Gamma(2/5)/(5/2 Gamma(9/10)) d/v")
m, k = 0.03288200310757317, 15384615384.615381
d = (5 * m / (4 * k)) ** 0.4
contact = 2 * math.sqrt(math.pi) * gamma(0.4) / (2.5 * gamma(0.9)) * d
assert abs(d / 2.3480787287320066e-05 - 1) < 1e-12 and abs(contact / 6.911041853117613e-05 - 1) < 1e-7
ref.value("deepest", -d, "m", reduce="last(joint.height.position)", rtol=1e-7).value("deepest", k * d**1.5, "N", reduce="last(force.contact.effort)", rtol=1e-7)
ref.summary("deepest", "ended.time.value", contact / 2, "s", rtol=1e-6)
ref.summary("leaves", "ended.time.value", contact, "s", rtol=1e-6).value("leaves", 1, "m/s", reduce="last(joint.height.velocity)", rtol=1e-6)
ref.fact(degrees_of_freedom=1, loops=0, redundant=0, bodies=1, joints=1).write(*case("contact-hertz"))

# ---------------------------------------------------------------- stick-slip
ref = Reference("other-code", f"piecewise with scipy's events, 1e-13 ({HERE})")
m, k, v, N = 2.0, 200.0, 0.2, 2 * g
mu = lambda slip: 0.2 + 0.3 * math.exp(-((slip / 0.1) ** 2))
rows, events = {k: None for k in [round(0.1 * i, 9) for i in range(1, 31)]}, []
t, x, w, stuck = 0.0, 0.0, 0.0, False
while t < 3:
    if stuck:
        until = t + (0.5 * N / k - x) / v
        for r in rows:
            if t < r <= min(until, 3):
                rows[r] = (x + v * (r - t), v)
        if until > 3:
            break
        t, x, w, stuck = until, 0.5 * N / k, v, False
        events.append((t, "slip"))
    else:
        slip = lambda t, y: [y[1], (mu(y[1] - v) * N - k * y[0]) / m]      # slower than the belt: it is dragged along
        match = lambda t, y: y[1] - v
        match.terminal, match.direction = True, 1
        # A slip begins at the speed of the belt, where the search for the next stick would end at once: 1 ms without it.
        y, start = [x, w], 1e-3 if events else 0.0
        if events:
            y = list(solve_ivp(slip, (t, t + start), y, method="DOP853", rtol=2.3e-14, atol=1e-16, max_step=1e-5).y[:, -1])
            assert y[1] < v
        run = solve_ivp(slip, (t + start, 3.0), y, method="DOP853", rtol=2.3e-14, atol=1e-16, events=match, dense_output=True)
        end = run.t[-1]
        for r in rows:
            if t + start < r <= end:
                p = run.sol(r)
                rows[r] = (p[0], p[1])
        if not len(run.t_events[0]):
            break
        t, (x, w), stuck = run.t_events[0][0], run.y_events[0][0], True
        assert abs(k * x) < 0.5 * N
        events.append((t, "stick"))
for t, (x, w) in rows.items():
    ref.row("run", clock(t), {"body.block.x": (x, "m"), "body.block.vx": (w, "m/s"), "joint.block.velocity": (w - v, "m/s"), "drive.belt.force": (k * x if abs(w - v) < 1e-14 else mu(w - v) * N, "N")}, rtol=0, atol={"m": 1e-8, "m/s": 1e-7, "N": 1e-6})
for i, (t, _) in enumerate(events):
    ref.summary("run", f"events.{i}.time.value", t, atol=1e-7)
ref.fact(degrees_of_freedom=2, loops=0, redundant=0, bodies=2, joints=2).write(*case("stick-slip"))
