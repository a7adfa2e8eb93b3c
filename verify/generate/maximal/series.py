"""Truncated Taylor series of time, rotations of numbers and of series."""
import math
import numpy as np
from .expressions import FUNCTIONS


class Jet:
    """c[k] is the coefficient of t^k; each c[k] may carry a batch axis."""

    def __init__(self, c):
        self.c = c

    @staticmethod
    def of(x, like):
        return x if isinstance(x, Jet) else Jet([x + 0 * like.c[0]] + [0 * like.c[0]] * (len(like.c) - 1))

    def __add__(self, o):
        if not isinstance(o, Jet):
            return Jet([self.c[0] + o] + self.c[1:])
        return Jet([a + b for a, b in zip(self.c, o.c)])

    def __mul__(self, o):
        if not isinstance(o, Jet):
            return Jet([a * o for a in self.c])
        n = len(self.c)
        return Jet([sum(self.c[i] * o.c[k - i] for i in range(k + 1)) for k in range(n)])

    __radd__, __rmul__ = __add__, __mul__
    __neg__ = lambda self: self * -1.0
    __sub__ = lambda self, o: self + (-o)
    __rsub__ = lambda self, o: (-self) + o

    def sincos(self):
        s, c = [np.sin(self.c[0])], [np.cos(self.c[0])]
        for k in range(1, len(self.c)):
            s.append(sum(i * self.c[i] * c[k - i] for i in range(1, k + 1)) / k)
            c.append(-sum(i * self.c[i] * s[k - i] for i in range(1, k + 1)) / k)
        return Jet(s), Jet(c)

    def __truediv__(self, o):
        if not isinstance(o, Jet):
            return self * (1.0 / o)
        q = []
        for k in range(len(self.c)):
            q.append((self.c[k] - sum(q[i] * o.c[k - i] for i in range(k))) / o.c[0])
        return Jet(q)

    def __rtruediv__(self, o):
        return Jet.of(o, self) / self

    def __pow__(self, p):
        if p == int(p) and 0 <= p < 8:
            out = Jet.of(1.0, self)
            for _ in range(int(p)):
                out = out * self
            return out
        y = [self.c[0] ** p]
        for k in range(1, len(self.c)):
            y.append(sum((p * i - (k - i)) * self.c[i] * y[k - i] for i in range(1, k + 1)) / (k * self.c[0]))
        return Jet(y)


def _jet_unary(f, g):
    return lambda x: g(x) if isinstance(x, Jet) else f(x)


JET_FUNCTIONS = dict(FUNCTIONS, sin=_jet_unary(np.sin, lambda x: x.sincos()[0]), cos=_jet_unary(np.cos, lambda x: x.sincos()[1]),
                     sqrt=_jet_unary(np.sqrt, lambda x: x ** 0.5))


def matvec(M, v):
    return [sum((M[i][k] * v[k] for k in range(1, len(v))), M[i][0] * v[0]) for i in range(len(M))]


def matmul(A, B):
    return [[sum((A[i][k] * B[k][j] for k in range(1, 3)), A[i][0] * B[0][j]) for j in range(3)] for i in range(3)]


def rotation(axis, sc):
    """Rodrigues; works with jets (sc = (sin, cos)) and numbers."""
    s, c = sc
    x, y, z = [float(a) for a in axis]
    v = 1.0 - c if not isinstance(c, Jet) else (-c) + 1.0
    return [[v * (x * x) + c, v * (x * y) - s * z, v * (x * z) + s * y],
            [v * (x * y) + s * z, v * (y * y) + c, v * (y * z) - s * x],
            [v * (x * z) - s * y, v * (y * z) + s * x, v * (z * z) + c]]


def rot(axis, angle):
    axis = np.asarray(axis, float) / np.linalg.norm(axis)
    return np.array(rotation(axis, (math.sin(angle), math.cos(angle))))


def quaternion_matrix(q):
    w, x, y, z = q
    return [[w * w + x * x - y * y - z * z, 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), w * w - x * x - y * y + z * z]]


def matrix_quaternion(R):
    K = np.array([[R[0, 0] - R[1, 1] - R[2, 2], 0, 0, 0], [R[0, 1] + R[1, 0], R[1, 1] - R[0, 0] - R[2, 2], 0, 0],
                  [R[0, 2] + R[2, 0], R[1, 2] + R[2, 1], R[2, 2] - R[0, 0] - R[1, 1], 0],
                  [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], np.trace(R)]]) / 3
    v = np.linalg.eigh(K)[1][:, -1]
    return np.array([v[3], v[0], v[1], v[2]])


AXES = dict(x=[1.0, 0, 0], y=[0, 1.0, 0], z=[0, 0, 1.0])
skew = lambda a: np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])


def rpy(r, p, y):
    return rot(AXES["z"], y) @ rot(AXES["y"], p) @ rot(AXES["x"], r)




def rotation_vector(R):
    c = (np.trace(R) - 1) / 2
    v = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    s = np.linalg.norm(v)
    return v if s < 1e-14 else v / s * math.atan2(s, c)
