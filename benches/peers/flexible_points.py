"""Von Mises stress on circles round the bores, from `--export vtu` of study lift, at its first row.

flexible_points.py RESULTS STUDY    (numpy, scipy)
"""
import csv
import re
import sys

import numpy as np
from scipy.interpolate import griddata
def vtu(path):
    raw = open(path, "rb").read()
    at = raw.index(b'<AppendedData'); data = raw.index(b"\n_", at) + 2
    out = {}
    for kind, name, n, off in re.findall(rb'type="(\w+)" Name="([^"]*)" NumberOfComponents="(\d+)" format="appended" offset="(\d+)"', raw[:at]):
        o = data + int(off); size = int(np.frombuffer(raw[o:o + 8], "<u8")[0])
        out[name.decode()] = np.frombuffer(raw[o + 8:o + 8 + size], {"Float32": "<f4", "Int64": "<i8", "UInt8": "u1"}[kind.decode()]).reshape(-1, int(n)).astype(float)
    return out
def vonmises(s):
    return np.sqrt(0.5 * ((s[..., 0] - s[..., 1])**2 + (s[..., 1] - s[..., 2])**2 + (s[..., 2] - s[..., 0])**2) + 3 * (s[..., 3]**2 + s[..., 4]**2 + s[..., 5]**2))
d, study = sys.argv[1], sys.argv[2]
row = next(csv.DictReader(open(f"{d}/{study}/series.csv")))
ang = lambda j: np.radians(float(row[f"joint.{j}.position [deg]"]))
HOLES = dict(link3=dict(B=(0, 0), E=(950, 0), N=(732, -160)), link5=dict(A=(0, 0), H=(950, 0)))
for body, j, y0 in (("link3", "B", 160.), ("link5", "A", 360.)):
    v = vtu(f"{d}/{study}/{body}/{body}_0000.vtu")
    P = v["Points"] * 1e3; a = ang(j); c, s_ = np.cos(a), np.sin(a)
    X = np.c_[c * P[:, 0] + s_ * (P[:, 1] - y0), -s_ * P[:, 0] + c * (P[:, 1] - y0), P[:, 2]]
    s = v["stress [Pa]"] / 1e6; vm = vonmises(s)
    print(body, "nodes on surface", len(X), "max", vm.max(), X[vm.argmax()].round(1))
    top = X[:, 2] > 9.99
    for n, (x, y) in HOLES[body].items():
        r = np.hypot(X[:, 0] - x, X[:, 1] - y)
        z = r < 35; free = z & (r > 20.5); out = []
        for R in (22.5, 25, 30, 35):
            t = np.arange(0, 360, 2) * np.pi / 180
            val = griddata(X[top][:, :2], s[top], np.c_[x + R * np.cos(t), y + R * np.sin(t)])
            out.append(round(float(vonmises(val).max()), 3))
        print(body, n, "zone", vm[z].max().round(3), X[z][vm[z].argmax()].round(1), "zone without bore", vm[free].max().round(3), X[free][vm[free].argmax()].round(1), "circles 22.5 25 30 35:", out)
    t = np.abs(X[:, 1] + 60) < 1e-2
    for z in (0, 10): print("sxx at 501.5,-60,", z, griddata(X[t][:, [0, 2]], s[t, 0], [[501.5, z * 0.999]]))
