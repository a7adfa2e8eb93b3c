"""References of flexible beams: published tables (published_flexible.json), and closed forms."""
import json, math, os
from exact_beam import ExactBeam
from reference import Reference, case

HERE = "verify/generate/flexible.py"
DATA = json.load(open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "published_flexible.json")))
clock = lambda t: {"time": f"{t:g} s"}
turned = lambda psi, x, y: (x * math.cos(psi) - y * math.sin(psi), x * math.sin(psi) + y * math.cos(psi))
EXACT = "planar geometrically exact beam, orders 4 to 6 in space, extrapolated in time; a second program agrees to 1e-6 m"


def spin_up(t, speed, ramp):
    """Angle of a hub whose acceleration is 1 - cos until `ramp`."""
    s = min(t, ramp)
    return speed / ramp * (s * s / 2 + (ramp / (2 * math.pi)) ** 2 * (math.cos(2 * math.pi * s / ramp) - 1)) + speed * (t - s)


# ---------------------------------------------------------------- spin-up of Simo and Vu-Quoc
d = DATA["spin_up"]["data"]
ref = Reference("other-code", f"{EXACT} (reference set M1); data of J. C. Simo and L. Vu-Quoc, J. Appl. Mech. 53 (1986) 855; turned into the world by {HERE}")
for t, along, across, turn in DATA["spin_up"]["table"]:
    psi = spin_up(t, d["omega_s"], d["Ts"])
    x, y = turned(psi, d["L"] + along, across)
    rows = {"point.beam.B.x": (x, "m"), "point.beam.B.y": (y, "m"), "body.tip.angle": (psi + turn, "rad")}
    ref.row("run", clock(t), rows, rtol=0, atol={"m": 5e-6, "rad": 1e-6})
ref.write(*case("flexible-spin-up"))

# ---------------------------------------------------------------- slider-crank
d = DATA["slider_crank"]["data"]
ref = Reference("other-code", f"{EXACT} (reference set M3); the middle of the rod turned into the world by {HERE}")
for t, slider, chord, normal, along in DATA["slider_crank"]["table"]:
    a = turned(spin_up(t, 150, 0.05), d["l1"], 0)
    length = math.hypot(slider - a[0], a[1])
    assert abs(length - d["l2"] - chord) < 1e-11, "slider and chord say the same"
    x, y = turned(math.atan2(-a[1], slider - a[0]), d["l2"] / 2 + along, normal)
    rows = {"joint.slide.position": (slider, "m"), "point.rod.M.x": (a[0] + x, "m"), "point.rod.M.y": (a[1] + y, "m")}
    ref.row("run", clock(t), rows, rtol=0, atol={"m": 1e-7})
ref.write(*case("flexible-slider-crank"))

# ---------------------------------------------------------------- elastica
ref = Reference("analytic", f"elastica by elliptic integrals (reference set F10; {HERE})")
for load, across, back, _ in DATA["elastica"]["table"]:
    if load in (1, 2, 5, 10):
        name = f"b{load:g}"
        y = {1: 0, 2: -2, 5: -4, 10: -6}[load] + 2 * across
        rows = {f"point.{name}.B.x": (2 * (1 - back), "m"), f"point.{name}.B.y": (y, "m")}
        ref.row("bent", None, rows, rtol=0, atol={"m": {1: 2e-5, 2: 1e-4, 5: 3e-4, 10: 6e-4}[load]})
ref.write(*case("flexible-elastica"))

# ---------------------------------------------------------------- cantilever with shear deformation
d = DATA["cantilever"]
ref = Reference("literature", "K. Nachbagauer, A. S. Pechstein, H. Irschik, J. Gerstmayr, Multibody Syst. Dyn. 26 (2011) 245, as in EXUDYN (reference set F10)")
for name, base, near in (("small", 0, 1e-8), ("large", 2, 6e-4)):
    u = d[f"F_{name}"]
    rows = {f"point.{name}.B.x": (2 - u["ux"], "m"), f"point.{name}.B.y": (base - u["uy"], "m")}
    ref.row("bent", None, rows, rtol=0, atol={"m": near})
ref.write(*case("flexible-cantilever"))

# ---------------------------------------------------------------- natural frequencies
d = DATA["timoshenko"]
speed = math.sqrt(d["data"]["E"] / d["data"]["rho"])
along = lambda held: [speed * ((k + 0.5) if held else (k + 1)) / 2 for k in range(12)]          # of a bar of 1 m
for name, table, held, rigid in (("clamped", "clamped_free", True, 0), ("free", "free_free", False, 3), ("pinned", "pinned_pinned", True, 0)):
    ref = Reference("other-code", "Timoshenko's beam by Chebyshev collocation (reference set F8), between them the vibrations of a bar along its axis in closed form")
    bending = d[table]["f_Hz"]
    both = sorted(bending + [f for f in along(held) if f < bending[-1]])
    for k, f in enumerate(both):
        ref.summary("ring", f"modes.{rigid + k}.frequency.value", f, "Hz", rtol=2e-5 if k < 1 else 3e-4 if k < 4 else 1e-3)
    ref.write(*case(f"modes-beam-{name}"))

# ---------------------------------------------------------------- pendulum
b, h, length, E, rho = 0.02, 0.03, 1.1, 5e6, 1150
A, I, G = b * h, b * h**3 / 12, E / (2 * 1.45)
beam = ExactBeam(length, E * A, 5 / 6 * G * A, E * I, rho * A, rho * I, 4, 9, [0, -9.81])
times = [round(0.1 * k, 9) for k in range(1, 13)]
nodes, energies = beam.swing(-0.3, times, 1e-10)
assert max(energies) - min(energies) < 1e-10
middle, = [k for k, s in enumerate(beam.s) if abs(s - length / 2) < 1e-12]
# Elements of other sizes and orders (4 of order 7, 5 of order 8) differ by up to 5e-6 m.
ref = Reference("other-code", "planar geometrically exact beam by spectral elements (verify/generate/exact_beam.py), converged to 5e-6 m")
for t, q in zip(times, nodes):
    rows = {f"point.rod.{name}.{axis}": (q[i, k], "m") for name, k in (("M", middle), ("B", -1)) for i, axis in enumerate("xy")}
    ref.row("run", clock(t), rows, rtol=0, atol={"m": 1e-4})
ref.write(*case("flexible-pendulum"))
