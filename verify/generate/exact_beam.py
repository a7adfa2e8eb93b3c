"""A planar geometrically exact beam (Simo and Reissner) by spectral elements: place and turn of sections are the unknowns,
in the world, so that nothing of floating frames or of small strains is in it."""
import numpy as np
from numpy.polynomial import legendre
from scipy.integrate import solve_ivp


def lobatto(p):
    """The p + 1 nodes of Gauss, Lobatto and Legendre on [-1, 1]."""
    return np.concatenate([[-1.0], np.sort(legendre.Legendre.basis(p).deriv().roots().real), [1.0]])


def lagrange(nodes, x):
    """Values and slopes at x (rows) of the polynomials that are 1 at one node each (columns)."""
    inverse = np.linalg.inv(legendre.legvander(nodes, len(nodes) - 1))
    slopes = np.stack([legendre.Legendre.basis(k).deriv()(x) if k else 0 * x for k in range(len(nodes))], axis=1)
    return legendre.legvander(x, len(nodes) - 1) @ inverse, slopes @ inverse


class ExactBeam:
    """`elements` of order `order`; constants a length as in the names; the first end is pinned at the origin."""

    def __init__(self, length, EA, GA, EI, rhoA, rhoI, elements, order, gravity):
        self.EA, self.GA, self.EI, self.g = EA, GA, EI, np.array(gravity, float)
        points, weights = legendre.leggauss(order + 4)
        values, slopes = lagrange(lobatto(order), points)
        half, n = length / elements / 2, elements * order + 1
        self.N, self.D = np.zeros((elements * len(points), n)), np.zeros((elements * len(points), n))
        for e in range(elements):
            rows, columns = slice(e * len(points), (e + 1) * len(points)), slice(e * order, (e + 1) * order + 1)
            self.N[rows, columns], self.D[rows, columns] = values, slopes / half
        self.w, self.n = np.tile(weights * half, elements), n
        consistent = self.N.T @ (self.w[:, None] * self.N)
        self.s = np.concatenate([[0]] + [length / elements * (e + (lobatto(order)[1:] + 1) / 2) for e in range(elements)])
        self.inertia = rhoA * consistent, rhoI * consistent
        self.inverse = np.linalg.inv(self.inertia[0][1:, 1:]), np.linalg.inv(self.inertia[1])
        self.load = rhoA * np.outer(self.g, self.N.T @ self.w)

    def forces(self, q):
        """Internal forces on x, y, turn of the nodes (3, n), and the elastic energy."""
        (rx, ry, kappa), turn = q @ self.D.T, q[2] @ self.N.T
        c, s = np.cos(turn), np.sin(turn)
        stretch, shear = c * rx + s * ry - 1, -s * rx + c * ry
        n, v, m = self.EA * stretch, self.GA * shear, self.EI * kappa
        fx, fy = self.w * (c * n - s * v), self.w * (s * n + c * v)
        turning = self.w * (n * shear - v * (1 + stretch))
        out = np.stack([fx @ self.D, fy @ self.D, (self.w * m) @ self.D + turning @ self.N])
        return out, 0.5 * np.sum(self.w * (n * stretch + v * shear + m * kappa))

    def accelerations(self, q):
        inside, _ = self.forces(q)
        outside = self.load - inside[:2]
        a = np.zeros_like(q)
        a[:2, 1:] = outside[:, 1:] @ self.inverse[0]
        a[2] = -inside[2] @ self.inverse[1]
        return a

    def energy(self, q, v):
        kinetic = 0.5 * (np.sum(v[:2] * (v[:2] @ self.inertia[0])) + v[2] @ self.inertia[1] @ v[2])
        return kinetic + self.forces(q)[1] - np.sum(self.load * q[:2])

    def swing(self, angle, times, tolerance):
        """Let go straight, at rest, turned by `angle`: nodes (3, n) and energies at the times."""
        q = np.stack([self.s * np.cos(angle), self.s * np.sin(angle), np.full(self.n, angle)])
        rates = lambda t, y: np.concatenate([y[q.size:], self.accelerations(y[: q.size].reshape(q.shape)).ravel()])
        y = np.concatenate([q.ravel(), 0 * q.ravel()])
        found = solve_ivp(rates, (0, times[-1]), y, "DOP853", times, rtol=tolerance, atol=tolerance * 1e-1).y.T
        states = [(y[: q.size].reshape(q.shape), y[q.size :].reshape(q.shape)) for y in found]
        return [q for q, _ in states], [self.energy(q, v) for q, v in states]
