"""Motion profiles: their closed formulas."""
import math


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
