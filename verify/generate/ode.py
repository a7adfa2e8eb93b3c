"""Equations of motion integrated to rounding (scipy, order 8), for references that no formula gives."""
import numpy as np
from scipy.integrate import solve_ivp

RTOL, ATOL = 2.3e-14, 1e-15


def solve(rate, start, times, breaks=()):
    """States at `times` (ascending) of y' = rate(t, y), y(0) = start. No step passes over a break."""
    y, now, out = np.asarray(start, float), 0.0, []
    for stop in sorted(set(times) | {b for b in breaks if b < max(times)}):
        if stop > now:
            run = solve_ivp(rate, (now, stop), y, method="DOP853", rtol=RTOL, atol=ATOL)
            assert run.success, run.message
            y, now = run.y[:, -1], stop
        if stop in times:
            out.append(y)
    return out
