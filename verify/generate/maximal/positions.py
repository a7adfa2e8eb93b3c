"""Positions, velocities and accelerations in absolute coordinates."""
import math
import numpy as np
from .machine import Machine
from .series import AXES, Jet, matmul, matrix_quaternion, matvec, quaternion_matrix, rot, rotation, rpy


class Positions(Machine):
    # --- equations. x: list of jets (bodies then coordinates); returns a list of jets
    def pose(self, x, body):
        zero = x[0] * 0.0
        if body == "ground":
            return [zero] * 3, [[zero + float(i == j) for j in range(3)] for i in range(3)], zero
        i = self.order.index(body)
        if self.planar:
            px, py, th = x[3 * i : 3 * i + 3]
            s, c = th.sincos()
            return [px, py, zero], [[c, -s, zero], [s, c, zero], [zero, zero, zero + 1.0]], th
        return x[7 * i : 7 * i + 3], quaternion_matrix(x[7 * i + 3 : 7 * i + 7]), None

    def frame(self, x, end):
        p, R, th = self.pose(x, end[0])
        a, A = self.points[end]
        rp = matvec(R, [float(v) for v in a])
        return [p[i] + rp[i] for i in range(3)], matmul(R, [[float(v) for v in r] for r in A]), th, math.atan2(A[1, 0], A[0, 0])

    def coordinate(self, x, ref):
        return x[self.nb + self.index[ref]]

    def residual(self, x):
        out = []
        for name, j in self.joints.items():
            k, q = j["kind"], x[self.nb + j["first"] : self.nb + j["first"] + j["n"]]
            if k == "coupler":
                a, b = (self.coordinate(x, r) for r in j["pair"])
                out.append(b - a * j["ratio"] - j["offset"])
                continue
            p1, R1, t1, f1 = self.frame(x, j["ends"][0])
            p2, R2, t2, f2 = self.frame(x, j["ends"][1])
            d = [p2[i] - p1[i] for i in range(3)]
            if k == "distance":
                L = q[0] if j["n"] else j["length"]
                out.append(sum((d[i] * d[i] for i in range(1, self.dim)), d[0] * d[0]) - L * L)
                continue
            zero = x[0] * 0.0
            move, turn = [zero] * 3, None
            a = j["axis"]
            if k in ("prismatic", "point-on-line"):
                move = [q[0] * float(v) for v in a]
            elif k == "cylindrical":
                move, turn = [q[0] * float(v) for v in a], [(a, q[1])]
            elif k == "screw":
                move, turn = [q[0] * (j["pitch"] * float(v)) for v in a], [(a, q[0])]
            elif k == "revolute":
                turn = [(a, q[0])]
            elif k == "universal":
                turn = [(a, q[0]), (j["axis2"], q[1])]
            elif k == "spherical":
                turn = [(AXES["z"], q[2]), (AXES["y"], q[1]), (AXES["x"], q[0])]
            elif k == "planar":
                move, turn = [q[0], q[1], zero], [(AXES["z"], q[2])]
            elif k == "free":
                move, turn = q[:3], [(AXES["z"], q[5]), (AXES["y"], q[4]), (AXES["x"], q[3])]
            moved = matvec(R1, move)
            out += [d[i] - moved[i] for i in range(self.dim)]
            if k == "point-on-line":
                continue
            if self.planar:
                q_turn = turn[0][1] if turn else zero
                if k == "revolute" and a[2] < 0:
                    q_turn = -q_turn
                out.append(t2 + f2 - t1 - f1 - q_turn)
            else:
                M = R1
                for ax, an in turn or []:
                    M = matmul(M, rotation(ax, an.sincos()))
                out += [R2[i][m] - M[i][m] for i in range(3) for m in range(3)]
        if not self.planar:
            for i in range(len(self.order)):
                w, a, b, c = x[7 * i + 3 : 7 * i + 7]
                out.append(w * w + a * a + b * b + c * c - 1.0)
        return out

    def jacobian(self, x0):
        h = 1e-30
        P = np.repeat(x0[:, None].astype(complex), self.n, axis=1) + 1j * h * np.eye(self.n)
        r = self.residual([Jet([P[i]]) for i in range(self.n)])
        return np.array([np.broadcast_to(v.c[0], self.n).imag / h for v in r])

    def value(self, x0):
        return np.array([v.c[0][0] for v in self.residual([Jet([np.array([v])]) for v in x0])])

    # --- assembly
    def guess(self):
        """Walk the joints from ground with the start values."""
        x = np.zeros(self.n)
        R, p, th, done = {"ground": np.eye(3)}, {"ground": np.zeros(3)}, {"ground": 0.0}, {"ground"}
        for j in self.joints.values():
            for k in range(j["n"]):
                x[self.nb + j["first"] + k] = j["start"][k]
        again = True
        while again:
            again = False
            for j in self.joints.values():
                if j["kind"] in ("coupler", "distance", "point-on-line"):
                    continue
                (b1, _), (b2, _) = j["ends"]
                if (b1 in done) == (b2 in done):
                    continue
                q, a, k = j["start"], j["axis"], j["kind"]
                M, v = np.eye(3), np.zeros(3)
                if k == "revolute": M = rot(a, q[0])
                if k == "prismatic": v = q[0] * a
                if k == "cylindrical": v, M = q[0] * a, rot(a, q[1])
                if k == "screw": v, M = q[0] * j["pitch"] * a, rot(a, q[0])
                if k == "universal": M = rot(a, q[0]) @ rot(j["axis2"], q[1])
                if k == "spherical": M = rpy(*q)
                if k == "planar": v, M = np.array([q[0], q[1], 0]), rot(AXES["z"], q[2])
                if k == "free": v, M = np.array(q[:3]), rpy(*q[3:])
                (a1, A1), (a2, A2) = self.points[j["ends"][0]], self.points[j["ends"][1]]
                if b1 in done:
                    F = R[b1] @ A1
                    R[b2] = F @ M @ A2.T
                    p[b2] = p[b1] + R[b1] @ a1 + F @ v - R[b2] @ a2
                    new = b2
                else:
                    F = R[b2] @ A2
                    F1 = F @ M.T
                    R[b1] = F1 @ A1.T
                    p[b1] = p[b2] + R[b2] @ a2 - F1 @ v - R[b1] @ a1
                    new = b1
                done.add(new)
                again = True
        for i, b in enumerate(self.order):
            assert b in done, f"{b} is not reached by the walk"
            if self.planar:
                x[3 * i : 3 * i + 3] = [p[b][0], p[b][1], math.atan2(R[b][1, 0], R[b][0, 0])]
            else:
                x[7 * i : 7 * i + 3] = p[b]
                x[7 * i + 3 : 7 * i + 7] = matrix_quaternion(R[b])
        if self.planar:
            self.unwrap(x)
        return x

    def unwrap(self, x):
        """Body angles continue the joint starts (no jumps of a turn)."""
        for _ in range(len(self.joints)):
            for j in self.joints.values():
                if j["kind"] in ("revolute", "prismatic", "weld", "planar"):
                    (b1, n1), (b2, n2) = j["ends"]
                    ang = lambda b: 0.0 if b == "ground" else x[3 * self.order.index(b) + 2]
                    f = lambda e: math.atan2(self.points[e][1][1, 0], self.points[e][1][0, 0])
                    q = {"revolute": (j["start"] or [0])[0], "planar": (j["start"] + [0, 0, 0])[2]}.get(j["kind"], 0.0)
                    gap = ang(b2) + f(j["ends"][1]) - ang(b1) - f(j["ends"][0]) - q
                    turns = round(gap / (2 * math.pi))
                    if turns and b2 != "ground":
                        x[3 * self.order.index(b2) + 2] -= 2 * math.pi * turns

    def solve_position(self, x, rows):
        """rows: {coordinate index: value}. Gauss-Newton; steps bounded so that the branch is kept."""
        idx = list(rows)
        E = np.zeros((len(idx), self.n))
        for r, i in enumerate(idx):
            E[r, self.nb + i] = 1.0
        for it in range(200):
            f = np.concatenate([self.value(x), [x[self.nb + i] - rows[i] for i in idx]])
            dx = -np.linalg.lstsq(np.vstack([self.jacobian(x), E]), f, rcond=1e-11)[0]
            step = min(1.0, 0.3 / (np.abs(dx).max() + 1e-300))
            x = x + step * dx
            if np.abs(dx).max() < 1e-14 * (1 + np.abs(x).max()) or (step == 1 and np.abs(f).max() < 3e-16):
                break
        f = np.concatenate([self.value(x), [x[self.nb + i] - rows[i] for i in idx]])
        assert np.abs(f).max() < 1e-11, ("no assembly", np.abs(f).max())
        return x

    def solve_rates(self, x, rates):
        """rates: {coordinate index: (velocity, acceleration)}. Returns Taylor coefficients c1, c2."""
        idx = list(rates)
        E = np.zeros((len(idx), self.n))
        for r, i in enumerate(idx):
            E[r, self.nb + i] = 1.0
        A = np.vstack([self.jacobian(x), E])
        sv = np.linalg.svd(A, compute_uv=False)
        self.rank_gap = sv
        z = np.zeros(self.n)

        def residual_at(c1, c2, k):
            r = self.residual([Jet([np.array([x[i]]), np.array([c1[i]]), np.array([c2[i]])]) for i in range(self.n)])
            return np.array([v.c[k][0] for v in r])

        solve = lambda b: np.linalg.lstsq(A, b, rcond=1e-11)[0]
        c1 = solve(np.concatenate([-residual_at(z, z, 1), [rates[i][0] for i in idx]]))
        c2 = solve(np.concatenate([-residual_at(c1, z, 2), [rates[i][1] / 2 for i in idx]]))
        return c1, c2
