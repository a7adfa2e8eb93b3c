"""models/assist-manipulator/lift-solids.expected.toml: the lift whose arms are plates.

Mass properties by adding and subtracting rectangles, discs, half discs and the corners that a fillet fills; the drive force
from the power balance F v = dT/dt + dV/dt + load, with every place written down as a function of the stroke. Derivatives are
those of mpmath at 40 digits. Nothing of it is shared with the program.
"""
from mpmath import mp, mpf, pi, cos, sin, sqrt, acos, atan2, diff

from reference import Reference

mp.dps = 40
G, RHO, LOAD, V = mpf("9.81"), mpf(7850), mpf(800), mpf("0.02")
VALUES = dict(l31="0.732", l32="0.16", l5="0.95", plate="0.02", width="0.12", pin="0.04")
VALUES = {k: mpf(v) for k, v in VALUES.items()}
L62, L42, M1, FILLET = mpf("0.2"), mpf("0.1"), mpf("19.84"), mpf("0.015")


class Area:
    """Area, first and polar second moments about the origin of the link's axes."""

    def __init__(self):
        self.a = self.x = self.y = self.p = mpf(0)

    def add(self, a, x, y, p, sign=1):
        """A piece with its centroid, and its polar moment about that."""
        self.a += sign * a
        self.x += sign * a * x
        self.y += sign * a * y
        self.p += sign * (p + a * (x * x + y * y))

    def rectangle(self, x0, x1, y0, y1):
        w, h = x1 - x0, y1 - y0
        self.add(w * h, (x0 + x1) / 2, (y0 + y1) / 2, w * h * (w * w + h * h) / 12)

    def disc(self, x, y, r, sign=1):
        self.add(pi * r * r, x, y, pi * r**4 / 2, sign)

    def half_disc(self, x, y, r, dx, dy):
        """The half on the side of (dx, dy)."""
        c, a = 4 * r / (3 * pi), pi * r * r / 2
        self.add(a, x + c * dx, y + c * dy, pi * r**4 / 4 - a * c * c)

    def fillet(self, x, y, r, dx, dy):
        """What an arc of radius r fills of a right-angled corner at (x, y); (dx, dy) points into its open side."""
        a = r * r * (1 - pi / 4)
        c = r * (mpf(1) / 2 - (pi / 4) * (1 - 4 / (3 * pi))) / (1 - pi / 4)
        # About the corner: a square less the quarter disc about its far corner, each axis alike.
        one = r**4 / 3 - (pi * r**4 / 16 - 2 * r * (r**3 / 3) + r * r * pi * r * r / 4)
        self.add(a, x + dx * c, y + dy * c, 2 * (one - a * c * c))


def arm(l5, width, pin, **_):
    area, r = Area(), width / 2
    area.rectangle(0, l5, -r, r)
    area.half_disc(0, 0, r, -1, 0)
    area.half_disc(l5, 0, r, 1, 0)
    area.disc(0, 0, pin / 2, -1)
    area.disc(l5, 0, pin / 2, -1)
    return area


def lever(l31, l32, l5, width, pin, **_):
    area, r = arm(l5, width, pin), pin
    area.rectangle(l31 - r, l31 + r, -l32, -width / 2)
    area.half_disc(l31, -l32, r, 0, -1)
    area.disc(l31, -l32, pin / 2, -1)
    area.fillet(l31 - r, -width / 2, FILLET, -1, -1)
    area.fillet(l31 + r, -width / 2, FILLET, 1, -1)
    return area


def mass(area, plate):
    """Mass, centre and moment about the centre."""
    m = RHO * plate * area.a
    x, y = area.x / area.a, area.y / area.a
    return m, x, y, RHO * plate * area.p - m * (x * x + y * y)


def force(theta, **p):
    """Drive force with the lower arm at theta, cylinder at 20 mm/s."""
    l31, l32, l5 = p["l31"], p["l32"], p["l5"]
    l61, l1 = l32, l31
    m3, x3, y3, j3 = mass(lever(**p), p["plate"])
    m5, x5, y5, j5 = mass(arm(**p), p["plate"])
    reach, lean = sqrt(l31**2 + l32**2), atan2(l32, l31)
    # Angle at B between BO (straight down) and BN is 90 deg + theta - lean.
    stroke = lambda t: sqrt(l61**2 + reach**2 - 2 * l61 * reach * cos(pi / 2 + t - lean))
    turned = lambda s: acos((l61**2 + reach**2 - s * s) / (2 * l61 * reach)) - pi / 2 + lean

    def places(s):
        """Heights times weight, and squares of speeds need x as well: (mass, x, y, inertia, angle) of all bodies."""
        t = turned(s)
        c, n = cos(t), sin(t)
        nx, ny = l31 * c + l32 * n, l61 + l31 * n - l32 * c
        phi = atan2(ny, nx)
        return [(M1, l1 / 2 * cos(phi), l1 / 2 * sin(phi), M1 * (l1 / 2)**2, phi),
                (m3, x3 * c - y3 * n, l61 + x3 * n + y3 * c, j3, t),
                (m5, x5 * c - y5 * n, l61 + L62 + x5 * n + y5 * c, j5, t)]

    def kinetic(s):
        total = mpf(0)
        for i in range(3):
            of = lambda k: diff(lambda u: places(u)[i][k], s) * V
            m, _, _, j, _ = places(s)[i]
            total += m * (of(1)**2 + of(2)**2) / 2 + j * of(4)**2 / 2
        return total

    potential = lambda s: sum(m * G * y for m, _, y, _, _ in places(s)) + LOAD * l5 * sin(turned(s))
    s = stroke(theta)
    return diff(kinetic, s) + diff(potential, s)


def write():
    ref = Reference("analytic", "Areas of rectangles, discs and fillets; power balance of the drive; verify/generate/lift_solids.py",
                    "lift-solids.toml")
    for degrees in (-30, -12, 0, 18, 30):
        found = {"drive.slide.force": (force(mp.radians(degrees), **VALUES), "N")}
        ref.row("lift", {"joint.B.position": f"{degrees} deg"}, found, rtol=1e-9)
    low = mp.radians(-30)
    peak = force(low, **VALUES)
    for name in VALUES:
        slope = diff(lambda value: force(low, **{**VALUES, name: value}), VALUES[name])
        ref.summary("influence", f"sensitivity.{name}.relative", slope * VALUES[name] / peak, rtol=1e-8)
    ref.fact(degrees_of_freedom=1, loops=2, redundant=0, bodies=5, joints=7)
    ref.write("models", "assist-manipulator", "lift-solids.expected.toml")
    for name, area in (("lever", lever(**VALUES)), ("arm", arm(**VALUES))):
        m, x, y, j = mass(area, VALUES["plate"])
        print(f"{name}: {mp.nstr(m, 8)} kg at [{mp.nstr(x * 1000, 8)}, {mp.nstr(y * 1000, 8)}] mm, {mp.nstr(j, 8)} kg*m^2")
    print("peak", mp.nstr(peak, 10), "N; stroke ends", [mp.nstr(force(mp.radians(d), **VALUES), 10) for d in (-30, 30)])


if __name__ == "__main__":
    write()
