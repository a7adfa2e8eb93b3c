"""Sensitivities and optima of shipped machines: closed forms, differentiated by mpmath or by differences, and scipy.

The optima are found without bellcrank: where two constraints meet (slider-crank), from the closed form of the crank-rocker
of time ratio one (four-bar, held against a grid over both lengths), by a grid (lamp)."""
import math
import mpmath as mp
import numpy as np
from scipy.optimize import brentq, minimize_scalar
from published_cases import slider_crank

deg = math.pi / 180


def relative(f, at):
    """d ln f / d ln p for each named p, by mpmath."""
    names, point = list(at), [mp.mpf(v) for v in at.values()]
    value = f(*point)
    return {n: float(mp.diff(lambda x: f(*point[:i], x, *point[i + 1:]), point[i]) * point[i] / value) for i, n in enumerate(names)}


# ---------------------------------------------------------------- slider-crank
def greatest_torque(r=0.05, l=0.2, off=0.01, gas=500.0):
    torque = lambda th: torque_at(th, 100.0, r, l, off, gas)
    found = minimize_scalar(lambda th: -torque(th), bounds=(240 * deg, 280 * deg), method="bounded", options=dict(xatol=1e-12))
    return -found.fun


def torque_at(th, w, r, l, off, gas):
    """Torque of the crank by the power balance: sum m (a - g).v + J alpha omega - F.v over w, at a steady speed."""
    c1, c2, m, J2 = 0.02, 0.07, (0.8, 0.5, 0.6), 0.0022
    phi = math.asin((off - r * math.sin(th)) / l)
    p1 = -r * math.cos(th) * w / (l * math.cos(phi))
    p2 = (r * math.sin(th) * w * w + l * math.sin(phi) * p1**2) / (l * math.cos(phi))
    arm = lambda length, a, d1, d2: (length * np.array([-math.sin(a), math.cos(a)]) * d1,
                                     length * (np.array([-math.sin(a), math.cos(a)]) * d2 - np.array([math.cos(a), math.sin(a)]) * d1**2))
    vA, aA = arm(r, th, w, 0.0)
    v1, a1 = arm(c1, th, w, 0.0)
    v2, a2 = (x + y for x, y in zip((vA, aA), arm(c2, phi, p1, p2)))
    v3, a3 = (x + y for x, y in zip((vA, aA), arm(l, phi, p1, p2)))
    g = np.array([0, -9.81])
    power = m[0] * (a1 - g) @ v1 + m[1] * (a2 - g) @ v2 + J2 * p2 * p1 + m[2] * (a3 - g) @ v3 + gas * v3[0]
    return power / w


def slider_crank_questions(ref):
    for d in range(0, 360, 17):
        assert abs(torque_at(d * deg, 100.0, 0.05, 0.2, 0.01, 500.0) - slider_crank(d * deg, 100.0)["torque"]) < 1e-11
    nominal = dict(gas=500.0, crank=0.05, rod=0.2, offset=0.01)
    words = dict(gas="gas", crank="r", rod="l", offset="off")
    peak = greatest_torque()
    ref.summary("influence", "response.value", peak, "N*m", rtol=1e-9)
    for name, p in nominal.items():
        change = lambda h: (greatest_torque(**{words[name]: p * (1 + h)}) - greatest_torque(**{words[name]: p * (1 - h)})) / 2 / h
        ref.summary("influence", f"sensitivity.{name}.relative", (4 * change(1e-3) - change(2e-3)) / 3 / peak, rtol=1e-6, atol=1e-8)
    # both constraints bite: the rod leans most where the crank stands upright, on the side away from the guide
    off, lean = 10.0, math.sin(20 * deg)
    rod = lambda r: (r + off) / lean
    stroke = lambda r, l: math.sqrt((l + r) ** 2 - off**2) - math.sqrt((l - r) ** 2 - off**2)
    r = brentq(lambda r: stroke(r, rod(r)) - 100.0, 30.0, 80.0, xtol=1e-13)
    # nothing shorter on a grid meets both
    assert all(stroke(x, y) < 100 or y < rod(x) - 1e-9 for x in np.linspace(30, 80, 301) for y in np.linspace(120, r + rod(r) - x - 1e-6, 50) if y > x + off)
    ref.summary("compact", "variables.crank.value", r, "mm", rtol=1e-7)
    ref.summary("compact", "variables.rod.value", rod(r), "mm", rtol=1e-7)
    ref.summary("compact", "objective.value", r + rod(r), "mm", rtol=1e-7)
    converged(ref, "compact", active=2)


# ---------------------------------------------------------------- four-bar
def four_bar_questions(ref):
    least = lambda a, b, c, d: mp.acos((b * b + c * c - (d - a) ** 2) / (2 * b * c))
    at = dict(crank=40, coupler=120, rocker=80, base=100)
    ref.summary("transmission", "response.value", least(*map(mp.mpf, at.values())) / mp.pi * 180, "deg", rtol=1e-10)
    for name, value in relative(least, at).items():
        ref.summary("transmission", f"sensitivity.{name}.relative", value, rtol=1e-8)
    # a crank-rocker of time ratio one, b^2 + c^2 = a^2 + d^2, deviates from 90 deg alike on both sides; its swing has sin(swing/2) = a/c
    a, d, swing = 40.0, 100.0, 70 * deg
    c = a / math.sin(swing / 2)
    b = math.sqrt(a * a + d * d - c * c)
    worst = lambda b, c: max(abs(math.acos((b * b + c * c - (d + s * a) ** 2) / (2 * b * c)) - math.pi / 2) for s in (-1, 1))
    reach = lambda b, c: (lambda f: f(b + a) - f(b - a))(lambda r: math.acos((c * c + d * d - r * r) / (2 * c * d)))
    turns = lambda b, c: b > a and abs(b - c) < d - a and b + c > d + a
    assert abs(reach(b, c) - swing) < 1e-12
    grid = [(y, x) for y in np.linspace(60, 150, 361) for x in np.linspace(50, 110, 241) if turns(y, x) and reach(y, x) >= swing]
    assert min(worst(*p) for p in grid) > worst(b, c)
    ref.summary("smooth", "variables.coupler.value", b, "mm", rtol=1e-7)
    ref.summary("smooth", "variables.rocker.value", c, "mm", rtol=1e-7)
    ref.summary("smooth", "objective.value", worst(b, c) / deg, "deg", rtol=1e-7)
    converged(ref, "smooth", active=1)


# ---------------------------------------------------------------- lamp
def lamp_questions(ref):
    def rest(h, a, c, m, k, L0):
        L = L0 / (1 - m * mp.mpf("9.81") * c / (k * h * a))
        return mp.asin((h * h + a * a - L * L) / (2 * h * a))

    at = dict(h_post="0.12", a_arm="0.09", reach="0.42", mass="0.85", stiff="520", free="0.05")
    ref.summary("influence", "response.value", rest(*map(mp.mpf, at.values())) / mp.pi * 180, "deg", rtol=1e-8)
    for name, value in relative(rest, at).items():
        ref.summary("influence", f"sensitivity.{name}.relative", value, rtol=1e-6)
    h, a, weight = 0.12, 0.09, 0.85 * 9.81 * 0.42
    length = lambda q: np.sqrt(h * h + a * a - 2 * h * a * np.sin(q))
    moment = lambda k, L0, q: np.cos(q) * (weight - k * h * a * (1 - L0 / length(q)))
    q = np.radians(np.linspace(-60, 60, 24001))
    worst = lambda k, L0: np.max(np.abs(moment(k, L0, q)))
    longest = length(np.radians(-60))
    stiffest = lambda L0: min(800.0, 75.0 / (longest - L0))
    best = min((worst(k, L0), k, L0) for L0 in np.linspace(0.03, 0.07, 41) for k in np.linspace(400, stiffest(L0), 41))
    assert best[2] == 0.03 and best[1] == stiffest(0.03)  # the corner of bound and constraint
    ref.summary("lighter", "variables.stiff.value", best[1], "N/m", rtol=1e-7)
    ref.summary("lighter", "variables.free.value", 30.0, "mm", rtol=1e-9)
    ref.summary("lighter", "objective.value", best[0], "N*m", rtol=1e-6)
    converged(ref, "lighter", active=1)


def converged(ref, study, active):
    ref.checks.append(["[[check]]", f'study = "{study}"', 'summary = "status"', 'text = "converged"'])
    for i in range(active):
        ref.summary(study, f"constraints.{i}.active", 1, atol=0)
