"""Writes reference.toml (verify/cases) and expected.toml (models) from numbers computed elsewhere."""
import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def number(v):
    v = float(v)
    return "0" if v == 0 else repr(v)


class Reference:
    def __init__(self, kind, source, model=None):
        self.head = ([f'model = "{model}"'] if model else []) + [f'kind = "{kind}"', f'source = "{source}"']
        self.checks = []

    def row(self, study, at, values, rtol=1e-9, atol=None):
        """values: {signal: (number, unit) or (number, unit, atol)}; atol: {unit: number} for all of them."""
        for signal, v in values.items():
            unit = v[1]
            floor = v[2] if len(v) > 2 else (atol or {}).get(unit)
            self.value(study, v[0], unit, signal=signal, at=at, rtol=rtol, atol=floor)
        return self

    def value(self, study, value, unit, signal=None, reduce=None, at=None, rtol=None, atol=None):
        t = ["[[check]]", f'study = "{study}"']
        t.append(f'signal = "{signal}"' if signal else f'reduce = "{reduce}"')
        if at:
            t.append("at = { " + ", ".join(f'"{k}" = "{v}"' if "." in k else f'{k} = "{v}"' for k, v in at.items()) + " }")
        u = f" {unit}" if unit else ""
        t.append(f'value = "{number(value)}{u}"')
        if rtol is not None:
            t.append(f"rtol = {rtol:g}")
        if atol is not None:
            t.append(f'atol = "{atol:g}{u}"')
        self.checks.append(t)
        return self

    def summary(self, study, path, value, unit="", rtol=None, atol=None):
        """A number of the study's summary.json, in the unit shown there."""
        t = ["[[check]]", f'study = "{study}"', f'summary = "{path}"', f"value = {number(value)}"]
        t += [f'unit = "{unit}"'] if unit else []
        t += [f"rtol = {rtol:g}"] if rtol is not None else []
        t += [f"atol = {atol:g}"] if atol is not None else []
        self.checks.append(t)
        return self

    def fact(self, **facts):
        for k, v in facts.items():
            self.checks.append(["[[check]]", f'scalar = "{k}"', f"value = {v}"])
        return self

    def unique(self, **_):
        raise NotImplementedError

    def uniqueness(self, table):
        for k, v in table.items():
            self.checks.append(["[[check]]", f'unique = "{k}"', f"value = {str(v).lower()}"])
        return self

    def write(self, *path):
        with open(os.path.join(ROOT, *path), "w") as f:
            f.write("\n".join(self.head) + "\n")
            for c in self.checks:
                f.write("\n" + "\n".join(c) + "\n")
        return self


def case(name):
    return ("verify", "cases", name, "reference.toml")
