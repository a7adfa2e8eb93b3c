"""Exudyn + NGSolve at the start: von Mises on circles round the bores, bending stress at the lower edge.

flexible_points_exudyn.py PEERS [--maxh 0.012 --hole 0.005]
"""
import sys, json
sys.path.insert(0, sys.argv[1])
import numpy as np
sys.argv += ["--reps", "1"]
import exudyn_flex as ef
from common import params
from scipy.interpolate import griddata, LinearNDInterpolator
p = params(); T = {}
import fe_link as fl
hh = float(sys.argv[sys.argv.index("--hole") + 1]) if "--hole" in sys.argv else 0.010
om = fl.mesh
fl.mesh = lambda kind, h, hole: om(kind, h, hh)
crank, rocker = ef.Link("crank", T), ef.Link("rocker", T)
o = ef.simulate(p, crank, rocker, steps=2, h=1e-6)
print("nodes", len(crank.X), len(rocker.X), "mass", crank.mass, rocker.mass, "drive", o["static_F"])
print("freq", crank.fem.GetEigenFrequenciesHz(), rocker.fem.GetEigenFrequenciesHz())
def six(link, q): 
    S = link.S; return np.einsum("nmc,m->nc", S.reshape(len(S), link.nm, 6), q)
for name, link, q in (("link3", crank, o["Q3"][0]), ("link5", rocker, o["Q5"][0])):
    s = six(link, q) / 1e6; X = link.X * 1e3; vm = fl.vonmises(s)
    top = np.abs(np.abs(X[:, 2]) - 10) < 1e-6
    for n, (x, y) in link.holes.items():
        r = np.hypot(X[:, 0] - x * 1e3, X[:, 1] - y * 1e3)
        out = []
        for R in (22.5, 25, 30, 35):
            a = np.arange(0, 360, 2) * np.pi / 180
            t = top & (X[:, 2] > 0)
            v = griddata(X[t][:, :2], s[t], np.c_[x * 1e3 + R * np.cos(a), y * 1e3 + R * np.sin(a)])
            out.append(round(float(fl.vonmises(v).max()), 3))
        z = r < 35; free = z & (r > 20.5)
        print(name, n, "zone", vm[z].max().round(3), X[z][vm[z].argmax()].round(1), "zone without bore", vm[free].max().round(3), X[free][vm[free].argmax()].round(1), "circles 22.5 25 30 35:", out)
    d = np.hypot(X[:, 0] - 501.5, X[:, 1] + 60)
    i = np.argsort(d)[:4]
    print(name, [(X[k].round(1).tolist(), s[k, 0].round(3), vm[k].round(3)) for k in i])
    t = np.abs(X[:, 1] + 60) < 1e-6
    for z in (0, 10): print("sxx at 501.5,-60,", z, griddata(X[t][:, [0, 2]], s[t, 0], [[501.5, z * 0.999]]))
