"""Every body taken free: reactions, drive efforts, and which of them rigid bodies tell."""
import math
import numpy as np
from .positions import Positions
from .series import AXES, Jet, rot, rotation_vector, skew


class Forces(Positions):
    # --- kinematic quantities of bodies
    def motion(self, x, c1, c2):
        J = [Jet([np.array([x[i]]), np.array([c1[i]]), np.array([c2[i]])]) for i in range(self.n)]
        num = lambda M, k: np.array([[e.c[k][0] for e in r] for r in M])
        out = {}
        for b in ["ground"] + self.order:
            p, R, th = self.pose(J, b)
            P = [np.array([e.c[k][0] for e in p]) * (2 if k == 2 else 1) for k in range(3)]
            R0, R1, R2 = num(R, 0), num(R, 1), 2 * num(R, 2)
            W = R1 @ R0.T
            A = R2 @ R0.T + R1 @ R1.T
            vee = lambda S: 0.5 * np.array([S[2, 1] - S[1, 2], S[0, 2] - S[2, 0], S[1, 0] - S[0, 1]])
            m = dict(p=P[0], v=P[1], a=P[2], R=R0, w=vee(W), al=vee(A))
            if self.planar:
                m["angle"] = th.c[0][0]
            out[b] = m
        return out

    @staticmethod
    def at(m, local):
        """Place, velocity, acceleration of a body-fixed point."""
        r = m["R"] @ local
        return (m["p"] + r, m["v"] + np.cross(m["w"], r), m["a"] + np.cross(m["al"], r) + np.cross(m["w"], np.cross(m["w"], r)))

    def subspace(self, j, mo, q):
        """Twists [w; v] of the second body against the first, at the second point, one a coordinate."""
        (b1, _), (b2, _) = j["ends"]
        A1, A2 = self.points[j["ends"][0]][1], self.points[j["ends"][1]][1]
        R1, R2 = mo[b1]["R"] @ A1, mo[b2]["R"] @ A2
        z = np.zeros(3)
        a, k = R1 @ j["axis"], j["kind"]
        T = lambda w, v: np.concatenate([w, v])
        if k == "revolute": return [T(a, z)]
        if k in ("prismatic",): return [T(z, a)]
        if k == "cylindrical": return [T(z, a), T(a, z)]
        if k == "screw": return [T(a, j["pitch"] * a)]
        if k == "universal": return [T(a, z), T(R2 @ j["axis2"], z)]
        if k in ("spherical", "free"):
            r = q[-3:]
            Rz = rot(AXES["z"], r[2])
            W = [R1 @ Rz @ rot(AXES["y"], r[1]) @ [1, 0, 0], R1 @ Rz @ [0, 1, 0], R1 @ np.array([0, 0, 1.0])]
            S = [T(w, z) for w in W]
            return S if k == "spherical" else [T(z, R1[:, i]) for i in range(3)] + S
        if k == "planar": return [T(z, R1[:, 0]), T(z, R1[:, 1]), T(R1[:, 2], z)]
        if k == "weld": return []
        if k == "distance":
            p1 = self.at(mo[b1], self.points[j["ends"][0]][0])[0]
            p2 = self.at(mo[b2], self.points[j["ends"][1]][0])[0]
            u = (p2 - p1) / np.linalg.norm(p2 - p1)
            return [T(z, u)] if j["n"] else []
        if k == "point-on-line": return [T(z, a)]

    def wrench_basis(self, j, mo):
        """Directions of the joint's wrench [moment; force] that are unknown (all but for point/distance joints)."""
        full = np.eye(6)[:, [2, 3, 4]] if self.planar else np.eye(6)
        if j["kind"] == "distance":
            (b1, _), (b2, _) = j["ends"]
            p1 = self.at(mo[b1], self.points[j["ends"][0]][0])[0]
            p2 = self.at(mo[b2], self.points[j["ends"][1]][0])[0]
            return np.concatenate([np.zeros(3), (p2 - p1) / np.linalg.norm(p2 - p1)])[:, None]
        if j["kind"] == "point-on-line":
            return np.eye(6)[:, [3, 4]] if self.planar else np.eye(6)[:, [3, 4, 5]]
        return full

    # --- one state: kinematics and forces
    def state(self, x, c1, c2, drives, time=0.0, sweep_axis=True):
        mo = self.motion(x, c1, c2)
        q, qd, qdd = x[self.nb :], c1[self.nb :], 2 * c2[self.nb :]
        sig = {"time": time}
        for i, (name, k) in enumerate(self.coords):
            tail = "" if self.joints[name]["n"] == 1 else f".{k}"
            sig[f"joint.{name}.position{tail}"], sig[f"joint.{name}.velocity{tail}"] = q[i], qd[i]
            sig[f"joint.{name}.acceleration{tail}"] = qdd[i]
        kin = 0.0
        pot = 0.0
        for b in self.order:
            m = mo[b]
            P, V, A = self.at(m, self.bodies[b]["center"])
            for i, ax in enumerate("xyz"[: self.dim]):
                sig[f"body.{b}.{ax}"], sig[f"body.{b}.v{ax}"], sig[f"body.{b}.a{ax}"] = P[i], V[i], A[i]
            if self.planar:
                sig[f"body.{b}.angle"], sig[f"body.{b}.omega"], sig[f"body.{b}.alpha"] = m["angle"], m["w"][2], m["al"][2]
            else:
                for i, ax in enumerate("xyz"):
                    sig[f"body.{b}.omega_{ax}"], sig[f"body.{b}.alpha_{ax}"] = m["w"][i], m["al"][i]
                R = m["R"]
                sig[f"body.{b}.roll"], sig[f"body.{b}.yaw"] = math.atan2(R[2, 1], R[2, 2]), math.atan2(R[1, 0], R[0, 0])
                sig[f"body.{b}.pitch"] = math.asin(max(-1, min(1, -R[2, 0])))
            I = m["R"] @ self.bodies[b]["inertia"] @ m["R"].T
            kin += 0.5 * self.bodies[b]["mass"] * V @ V + 0.5 * m["w"] @ I @ m["w"]
            pot -= self.bodies[b]["mass"] * self.gravity @ P
        for (b, pn), (a, _) in self.points.items():
            P, V, A = self.at(mo[b], a)
            for i, ax in enumerate("xyz"[: self.dim]):
                sig[f"point.{b}.{pn}.{ax}"], sig[f"point.{b}.{pn}.v{ax}"], sig[f"point.{b}.{pn}.a{ax}"] = P[i], V[i], A[i]
        sig["energy.kinetic"] = kin
        # loads [moment about the body origin; force]
        load = {b: np.zeros(6) for b in ["ground"] + self.order}
        effort = np.zeros(len(self.coords))

        def push(body, place, force, moment=np.zeros(3)):
            load[body][:3] += np.cross(place - mo[body]["p"], force) + moment
            load[body][3:] += force

        for b in self.order:
            B, m = self.bodies[b], mo[b]
            P, V, A = self.at(m, B["center"])
            I = m["R"] @ B["inertia"] @ m["R"].T
            push(b, P, B["mass"] * (self.gravity - A), -(I @ m["al"] + np.cross(m["w"], I @ m["w"])))
        ex = lambda v: self.ev(v, time=time, signal=sig)
        frictions = []
        for fname, f in self.doc.get("forces", {}).items():
            k = f["kind"]
            if k == "force":
                b, pn = f["on"].split(".")
                v = np.array([ex(e) for e in f["vector"]] + [0.0])[:3]
                if f.get("axes", "world") == "body":
                    v = mo[b]["R"] @ v
                push(b, self.at(mo[b], self.points[b, pn][0])[0], v)
            elif k == "torque":
                b = f["on"]
                v = np.array([0, 0, ex(f["value"])]) if self.planar else np.array([ex(e) for e in f["vector"]])
                if f.get("axes", "world") == "body":
                    v = mo[b]["R"] @ v
                push(b, mo[b]["p"], np.zeros(3), v)
            elif k == "effort":
                effort[self.index[f["joint"]]] += ex(f["value"])
            elif k == "spring":
                e1, e2 = [tuple(e.split(".")) for e in f["between"]]
                p1, v1, _ = self.at(mo[e1[0]], self.points[e1][0])
                p2, v2, _ = self.at(mo[e2[0]], self.points[e2][0])
                L = np.linalg.norm(p2 - p1)
                u = (p2 - p1) / L
                rate = u @ (v2 - v1)
                kk, L0 = ex(f.get("stiffness", 0)), ex(f.get("free_length", 0))
                tension = kk * (L - L0) + ex(f.get("damping", 0)) * rate - ex(f.get("preload", 0))
                push(e1[0], p1, tension * u)
                push(e2[0], p2, -tension * u)
                sig[f"force.{fname}.length"], sig[f"force.{fname}.rate"] = L, rate
                pot += 0.5 * kk * (L - L0) ** 2 - ex(f.get("preload", 0)) * (L - L0)
            elif k == "joint-spring":
                i = self.index[f["joint"]]
                kk, q0 = ex(f.get("stiffness", 0)), ex(f.get("free_position", 0))
                effort[i] -= kk * (q[i] - q0) + ex(f.get("damping", 0)) * qd[i]
                pot += 0.5 * kk * (q[i] - q0) ** 2
            elif k == "stop":
                i, kk, c = self.index[f["joint"]], ex(f["stiffness"]), ex(f.get("damping", 0))
                if "max" in f and q[i] > ex(f["max"]):
                    effort[i] -= max(0.0, kk * (q[i] - ex(f["max"])) + c * qd[i])
                if "min" in f and q[i] < ex(f["min"]):
                    effort[i] += max(0.0, kk * (ex(f["min"]) - q[i]) - c * qd[i])
            elif k == "friction":
                frictions.append((f["joint"], f))
            elif k == "bushing":
                e1, e2 = [tuple(e.split(".")) for e in f["between"]]
                R1 = mo[e1[0]]["R"] @ self.points[e1][1]
                R2 = mo[e2[0]]["R"] @ self.points[e2][1]
                p1, v1, _ = self.at(mo[e1[0]], self.points[e1][0])
                p2, v2, _ = self.at(mo[e2[0]], self.points[e2][0])
                v1 = v1 + np.cross(mo[e1[0]]["w"], p2 - p1)
                d, dv = R1.T @ (p2 - p1), R1.T @ (v2 - v1)
                w = R1.T @ (mo[e2[0]]["w"] - mo[e1[0]]["w"])
                Rr = R1.T @ R2
                ang = np.array([0, 0, math.atan2(Rr[1, 0], Rr[0, 0])]) if self.planar else rotation_vector(Rr)
                ks, cs = [ex(e) for e in f["stiffness"]], [ex(e) for e in f.get("damping", [0] * (3 if self.planar else 6))]
                if self.planar:
                    ks, cs = [ks[0], ks[1], 0, 0, 0, ks[2]], [cs[0], cs[1], 0, 0, 0, cs[2]]
                F = R1 @ -(np.array(ks[:3]) * d + np.array(cs[:3]) * dv)
                M = R1 @ -(np.array(ks[3:]) * ang + np.array(cs[3:]) * w)
                push(e2[0], p2, F, M)
                push(e1[0], p2, -F, -M)
            else:
                raise ValueError(k)
        sig["energy.potential"] = pot
        # unknown wrenches and efforts
        cols, where = [], {}
        rows_b = {b: i for i, b in enumerate(self.order)}
        keep = [2, 3, 4] if self.planar else list(range(6))
        nbr = len(keep) * len(self.order)
        spans, nun = {}, 0
        for name, j in self.joints.items():
            if j["kind"] == "coupler":
                spans[name] = (nun, 1)
                nun += 1
                continue
            B = self.wrench_basis(j, mo)
            spans[name] = (nun, B.shape[1])
            nun += B.shape[1]
        dpos = {d: nun + i for i, d in enumerate(drives)}
        nun += len(drives)
        nrow = nbr + len(self.coords)
        A, b = np.zeros((nrow + len(self.joints) * 6, nun)), np.zeros(nrow + len(self.joints) * 6)
        extra = nrow
        for bn in self.order:
            i = rows_b[bn] * len(keep)
            b[i : i + len(keep)] = -load[bn][keep]
        def shift(place, body):
            """Wrench at `place` to the body origin."""
            X = np.eye(6)
            X[:3, 3:] = skew(place - mo[body]["p"])
            return X
        basis = {}
        for name, j in self.joints.items():
            s, w = spans[name]
            if j["kind"] == "coupler":
                ia, ib = (self.index[r] for r in j["pair"])
                A[nbr + ia, s] += j["ratio"]
                A[nbr + ib, s] -= 1.0
                continue
            B = self.wrench_basis(j, mo)
            basis[name] = B
            p2 = self.at(mo[j["ends"][1][0]], self.points[j["ends"][1]][0])[0]
            for body, sign in ((j["ends"][0][0], -1.0), (j["ends"][1][0], 1.0)):
                if body != "ground":
                    i = rows_b[body] * len(keep)
                    A[i : i + len(keep), s : s + w] += sign * (shift(p2, body) @ B)[keep]
            for k, S in enumerate(self.subspace(j, mo, q[j["first"] : j["first"] + j["n"]])):
                A[nbr + j["first"] + k, s : s + w] += S @ B
        for d, c in dpos.items():
            A[nbr + d, c] = -1.0
        tail = effort.copy()
        for _ in range(1 + 400 * bool(frictions)):
            b[nbr:nrow] = tail
            sol, *_ = np.linalg.lstsq(A[:nrow], b[:nrow], rcond=1e-12)
            W = {n: basis[n] @ sol[spans[n][0] : sum(spans[n])] for n in basis}
            new = effort.copy()
            for ref, f in frictions:
                name = ref.split(".")[0]
                j, i = self.joints[name], self.index[ref]
                S = self.subspace(j, mo, q[j["first"] : j["first"] + j["n"]])[int(ref.split(".")[1]) if "." in ref else 0]
                along = S[3:] if np.linalg.norm(S[3:]) > 0 else S[:3]
                F = W[name][3:]
                normal = np.linalg.norm(F - along * (F @ along))
                mu = ex(f.get("coulomb", 0))
                if "stribeck_velocity" in f:
                    mu = mu + (ex(f["static"]) - mu) * math.exp(-((qd[i] / ex(f["stribeck_velocity"])) ** 2))
                arm = ex(f["radius"]) if "radius" in f else 1.0
                new[i] -= mu * arm * normal * np.sign(qd[i]) + ex(f.get("viscous", 0)) * qd[i]
            if np.abs(new - tail).max() <= 1e-15 * (1 + np.abs(new).max()):
                tail = new
                break
            tail = new
        self.force_residual = np.abs(A[:nrow] @ sol - b[:nrow]).max()
        U, sv, Vt = np.linalg.svd(A[:nrow])
        rank = (sv > 1e-9 * sv[0]).sum()
        N = Vt[rank:].T
        unique = {}
        for name in basis:
            NW = basis[name] @ N[spans[name][0] : sum(spans[name])] if N.size else np.zeros((6, 1))
            for comp, i in zip(["mx", "my", "mz", "fx", "fy", "fz"], range(6)):
                if not self.planar or comp in ("fx", "fy", "mz"):
                    sig[f"joint.{name}.reaction.{comp}"] = W[name][i]
                    unique[f"{name}.{comp}"] = bool(np.abs(NW[i]).max() < 1e-7)
            sig[f"joint.{name}.reaction.force"] = np.linalg.norm(W[name][3:])
            sig[f"joint.{name}.reaction.moment"] = np.linalg.norm(W[name][:3])
        for d, c in dpos.items():
            name, k = self.coords[d]
            tail = "" if self.joints[name]["n"] == 1 else f".{k}"
            sig[f"drive.{name}.force{tail}"] = sol[c]
            sig[f"drive.{name}.power{tail}"] = sol[c] * qd[d]
            unique[f"drive.{name}{tail}"] = bool(N.size == 0 or np.abs(N[c]).max() < 1e-7)
        sig["#unique"], sig["#redundant"] = unique, N.shape[1]
        return sig
