"""Forward dynamics by the independent program `maximal`: coordinates that nothing drives move so that their drives
would have nothing to do. Efforts are linear in the accelerations, so a few solutions of the force balance give them."""
import numpy as np
from ode import solve


class Free:
    def __init__(self, model, study, free):
        self.model, self.free = model, [model.index[k] for k in free]
        self.names = [f"drive.{'.force.'.join(k.split('.')) if '.' in k else k + '.force'}" for k in free]
        self.motions = model.study(study).get("motions", list(model.doc.get("motions", {})))
        self.x = model.guess()

    def at(self, t, y, accelerations):
        """All signals, with the free coordinates at y = positions, rates, and with these accelerations."""
        n, told = len(self.free), dict(p for m in self.motions for p in self.model.motion_of(m, t))
        places = {**{i: v[0] for i, v in told.items()}, **dict(zip(self.free, y[:n]))}
        self.x = self.model.solve_position(self.x, places)
        c1, c2 = self.model.solve_rates(self.x, {**{i: v[1:] for i, v in told.items()}, **{i: (v, a) for i, v, a in zip(self.free, y[n:], accelerations)}})
        return self.model.state(self.x, c1, c2, self.free + list(told), time=t)

    def accelerations(self, t, y):
        n = len(self.free)
        efforts = lambda a: np.array([self.at(t, y, a)[k] for k in self.names])
        base = efforts(np.zeros(n))
        return np.linalg.solve(np.array([efforts(row) - base for row in np.eye(n)]).T, -base)

    def run(self, times, breaks=()):
        """Signals at `times`, from the starts of the free coordinates."""
        m = self.model
        starts = [m.joints[m.coords[i][0]]["start"][m.coords[i][1]] for i in self.free]
        rates = [m.joints[m.coords[i][0]]["rates"][m.coords[i][1]] for i in self.free]
        rate = lambda t, y: np.concatenate([y[len(self.free):], self.accelerations(t, y)])
        return [self.at(t, y, self.accelerations(t, y)) for t, y in zip(times, solve(rate, starts + rates, times, breaks))]
