"""References of the tolerance studies: output angle of a four-bar (T1 of the shared set, recomputed here) and position of
an offset slider-crank.  Closed forms with derivatives in mpmath; Monte Carlo of the same closed forms in numpy.
"""
import math
import mpmath as mp
import numpy as np
from reference import Reference, case

mp.mp.dps = 40
N = 2_000_000


def theta4(th2, a, b, c, d, lib=mp):
    """Angle of the rocker, open branch: from the diagonal B-O4 of crank pin and rocker pivot."""
    x, y = a * lib.cos(th2) - d, a * lib.sin(th2)
    f2 = x * x + y * y
    # at the pivot of the rocker between diagonal and rocker
    inner = (lib.acos if lib is mp else np.arccos)((f2 + c * c - b * b) / (2 * c * (lib.sqrt(f2))))
    turn = (lib.atan2 if lib is mp else np.arctan2)(y, x)
    return turn - inner


def slider(th, r, l, e, lib=mp):
    return r * lib.cos(th) + lib.sqrt(l * l - (e - r * lib.sin(th)) ** 2)


def gradient(f, at):
    return [mp.diff(lambda x: f(*at[:i], x, *at[i + 1:]), at[i]) for i in range(len(at))]


def linear(ref, study, names, f, at, sigmas, widths, unit, per):
    g = gradient(f, at)
    sigma = mp.sqrt(sum((x * s) ** 2 for x, s in zip(g, sigmas)))
    reach = sum(abs(x) * t for x, t in zip(g, widths))
    value = f(*at)
    ref.summary(study, "response.value", value * per, unit, rtol=1e-12)
    ref.summary(study, "linear.deviation", sigma * per, unit, rtol=1e-8)
    ref.summary(study, "worst_case.min", (value - reach) * per, unit, rtol=1e-11)
    ref.summary(study, "worst_case.max", (value + reach) * per, unit, rtol=1e-11)
    corners = [f(*[x + (1 if k >> i & 1 else -1) * t for i, (x, t) in enumerate(zip(at, widths))]) for k in range(2 ** len(at))]
    ref.summary(study, "worst_case_exact.min", min(corners) * per, unit, rtol=1e-11)
    ref.summary(study, "worst_case_exact.max", max(corners) * per, unit, rtol=1e-11)
    for name, x, s in zip(names, g, sigmas):
        ref.summary(study, f"tolerances.{name}.derivative", x, rtol=1e-8)
        ref.summary(study, f"tolerances.{name}.variance_share", (x * s / sigma) ** 2, rtol=1e-8)
    return value, sigma


def drawn(ref, study, values, samples, unit, per, quantiles=()):
    """Means and deviations of 2 000 000 machines, and of bellcrank's: within 4 standard errors of the difference."""
    spread = np.std(values, ddof=1)
    kurtosis = np.mean((values - values.mean()) ** 4) / spread**4
    share = 1 / samples + 1 / N
    ref.summary(study, "monte_carlo.deviation", spread * per, unit, atol=4 * per * spread * math.sqrt((kurtosis - 1) / 4 * share))
    ref.summary(study, "monte_carlo.mean", values.mean() * per, unit, atol=4 * per * spread * math.sqrt(share))
    ref.summary(study, "monte_carlo.failed", 0, atol=0)
    for p in quantiles:
        q, density = np.quantile(values, p), 1e-3
        low, high = np.quantile(values, [p - density, p + density])
        slope = (high - low) / (2 * density)
        ref.summary(study, f"monte_carlo.quantiles.{p}", q * per, unit, atol=4 * per * slope * math.sqrt(p * (1 - p) * share))


# ---------------------------------------------------------------- T1
LENGTHS, SIGMAS = (0.04, 0.12, 0.08, 0.1), (2e-5, 3e-5, 2e-5, 3e-5)
ref = Reference("analytic", "closed form of the four-bar with derivatives in mpmath; Monte Carlo of the same closed form in numpy, 2e6 machines (verify/generate/tolerances.py)")
rng = np.random.default_rng(12345)
mm = [mp.mpf(repr(x)) for x in LENGTHS]
deg = 180 / math.pi
for d in range(0, 360, 30):
    th = mp.mpf(d) * mp.pi / 180
    f = lambda *p: theta4(th, *p)
    f = (lambda g: lambda *p: g(*p) + (2 * mp.pi if g(*mm) < 0 else 0))(f)
    value, sigma = linear(ref, f"at-{d}", "abcd", f, mm, [mp.mpf(repr(s)) for s in SIGMAS], [3 * mp.mpf(repr(s)) for s in SIGMAS], "deg", 180 / mp.pi)
    if d in (30, 210):
        study = f"drawn-at-{d}"
        # The limit in the model file is the nominal value and three standard deviations, to 12 digits.
        print(f"{study}: limit {mp.nstr(value + 3 * sigma, 12)} rad")
        limit = mp.mpf(mp.nstr(value + 3 * sigma, 12))
        ref.summary(study, "linear.yield", mp.ncdf((limit - value) / sigma), atol=1e-9)
        assert abs(mp.ncdf((limit - value) / sigma) - (1 - mp.mpf("1.3498980316e-3"))) < 1e-9
        machines = [x + s * rng.standard_normal(N) for x, s in zip(LENGTHS, SIGMAS)]
        values = theta4(float(th), *machines, lib=np)
        values += 2 * math.pi * (values < 0)
        drawn(ref, study, values, 20000, "deg", deg)
        share = float(np.mean(values <= float(limit)))
        ref.summary(study, "monte_carlo.yield.share", share, atol=4 * math.sqrt(share * (1 - share) * (1 / 20000 + 1 / N)))
        cpk = (float(limit) - values.mean()) / (3 * np.std(values))
        ref.summary(study, "cpk", cpk, rtol=0.03)
ref.write(*case("four-bar-tolerance"))

# ---------------------------------------------------------------- slider-crank, all distributions
ref = Reference("analytic", "closed form of the offset slider-crank with derivatives in mpmath; Monte Carlo of the same closed form in numpy, 2e6 machines (verify/generate/tolerances.py)")
at = [mp.mpf(x) / 1000 for x in (50, 200, 10)]
widths = [mp.mpf(x) for x in ("3e-4", "4e-4", "6e-4")]
cut = mp.mpf("4e-4") / mp.mpf("2e-4")
of_cut = mp.mpf("2e-4") * mp.sqrt(1 - 2 * cut * mp.npdf(cut) / (1 - 2 * mp.ncdf(-cut)))
sigmas = [widths[0] / 3, of_cut, widths[2] / mp.sqrt(3)]
f = lambda *p: slider(mp.pi / 3, *p)
linear(ref, "scatter", "rle", f, at, sigmas, widths, "mm", 1000)
r = 0.05 + 1e-4 * rng.standard_normal(N)
e = 0.01 + 6e-4 * (2 * rng.random(N) - 1)
l = rng.standard_normal(3 * N)
l = 0.2 + 2e-4 * l[abs(l) < 2][:N]
drawn(ref, "scatter", slider(math.pi / 3, r, l, e, lib=np), 20000, "mm", 1e3, quantiles=(0.01, 0.5, 0.95))
ref.write(*case("slider-crank-tolerance"))
