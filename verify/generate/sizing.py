"""References of the sizing studies: forces of ISO 15552 cylinders, buckling after Euler, air, and the flow law of ISO 6358.

The slide pushes 3 bar times the area of a bore of 63 mm over 100 mm at 80 mm/s.  Flow: 387.14 L/min ANR from 7 to 4 bar
absolute with C = 1 L/(s*bar), b = 0.3 (law of ISO 6358; reference air 1.185 kg/m^3 at 100 kPa, 20 degC).
"""
import math
from reference import Reference, case


def area(d):
    return math.pi / 4 * d**2


BORE, ROD, STROKE, FORCE = 0.063, 0.02, 0.1, 935.1  # N; 3 bar times the area is 935.17 N
ref = Reference("analytic", "areas of circles, Euler's column, the flow law of ISO 6358 (verify/generate/sizing.py)")
ring = area(BORE) - area(ROD)


def told(study, values, candidate=0):
    for key, (value, unit) in values.items():
        ref.summary(study, f"candidates.{candidate}.properties.{key}.value", value, unit, rtol=1e-9)


def chosen(study, name):
    ref.checks.append(["[[check]]", f'study = "{study}"', 'summary = "chosen"', f'text = "{name}"'])


def check(study, place, value, unit, passes):
    ref.summary(study, f"candidates.0.checks.{place}.{'needed' if place < 7 else 'available'}", value, unit, rtol=1e-9)
    ref.summary(study, f"candidates.0.checks.{place}.passes", passes, atol=0)


# Pushing: rear mounting, a column of two strokes and 190 mm, both ends turn.
chosen("push", "iso15552-63, stroke 100 mm")
column = 2 * STROKE + 0.19
euler = math.pi**2 * 2.1e11 * math.pi / 64 * ROD**4 / column**2
double = (area(BORE) + ring) * STROKE * 7 + 0.05e-3 * 6
told("push", {
    "push": (6e5 * area(BORE), "N"), "pull": (6e5 * ring, "N"), "working_pressure": (FORCE / area(BORE) / 1e5, "bar"),
    "needed_supply": (FORCE / area(BORE) / 0.7 / 1e5, "bar"), "column": (column * 1e3, "mm"), "critical_load": (euler, "N"),
    "air_per_double_stroke": (double * 1e3, "L"), "mean_air": (double * 1e3 * 12, "L/min"),
    "peak_air": (area(BORE) * 0.08 * 7 * 6e4, "L/min")})
# From 7 bar into the working pressure, both absolute: past the critical ratio.
ratio = (FORCE / area(BORE) + 1e5) / 7e5
flow = 1e-8 * 7e5 * math.sqrt(1 - ((ratio - 0.3) / 0.7) ** 2)
assert abs(flow * 6e4 - 387.14) < 0.02
check("push", 7, flow * 6e4, "L/min", 1)
# The other way round the ring does the work.
chosen("pull", "iso15552-63, stroke 100 mm")
told("pull", {"working_pressure": (FORCE / ring / 1e5, "bar")})
# 6.5 bar and 12 kg: an ordered stroke of 110 mm, of a cylinder with a cushion of a file beside the model.
chosen("own", "own-60, special stroke 110 mm")
told("own", {"working_pressure": (FORCE / area(0.06) / 0.9 / 1e5, "bar"), "stroke": (110, "mm")})
check("own", 6, 0.5 * (12 + 0.8 + 2.5 * 0.11) * 0.08**2, "J", 1)
# Clamped and free: the longest column.
euler = math.pi**2 * 2.1e11 * math.pi / 64 * ROD**4 / (2 * 1.5 * STROKE) ** 2
told("free", {"critical_load": (euler, "N"), "column": (150, "mm")})
# An electric drive at the same force and speed.
ref.summary("motor", "requirements.rms_force.value", FORCE, "N", rtol=1e-9)
ref.summary("motor", "requirements.mean_power.value", FORCE * 0.08, "W", rtol=1e-9)
told("motor", {"shaft_rms_force": (FORCE * 1.2 * math.sqrt(STROKE / 0.08 / 5), "N")})
ref.write(*case("cylinder-iso15552"))
