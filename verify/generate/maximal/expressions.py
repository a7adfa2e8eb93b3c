"""Units and expressions of the model file."""
import math, re
import numpy as np

UNITS = dict(m=1.0, mm=1e-3, cm=1e-2, um=1e-6, ft=0.3048, kg=1.0, g=1e-3, t=1e3, lb=0.45359237, s=1.0,
             ms=1e-3, h=3600.0, N=1.0, kN=1e3, lbf=4.4482216152605, Pa=1.0, kPa=1e3, MPa=1e6, GPa=1e9, bar=1e5,
             J=1.0, W=1.0, kW=1e3, Hz=1.0, rpm=2 * math.pi / 60, rad=1.0, deg=math.pi / 180, K=1.0, L=1e-3)
UNITS["in"] = 0.0254
FUNCTIONS = dict(sin=np.sin, cos=np.cos, tan=np.tan, asin=np.arcsin, acos=np.arccos, atan=np.arctan,
                 atan2=np.arctan2, sqrt=np.sqrt, abs=abs, min=min, max=max, sign=np.sign, pi=math.pi)


def python_of(text):
    """The model file's expression as Python: `20 mm/s` means 20*mm/s, `^` is a power."""
    text = re.sub(r"(?<![A-Za-z_\d.])(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+)\s+(?=[A-Za-z])", r"\1*", text)
    text = re.sub(r"\bin\b", "inch", text)
    text = re.sub(r"[A-Za-z_]\w*(?:\.\w+)+", lambda k: f'signal["{k.group(0)}"]', text)
    return text.replace("^", "**")


def nominal(v):
    """"950 ± 0.1 mm" and "950 mm ± 0.1 mm" without the tolerance."""
    parts = re.fullmatch(r"(.*?)\s*±\s*[\d.]+\s*(.*)", v) if isinstance(v, str) else None
    if parts is None:
        return v
    value, unit = parts.groups()
    return value if re.search("[a-z]", value) else f"{value} {unit}"


def evaluate(value, names):
    if isinstance(value, (int, float)):
        return float(value)
    scope = {**UNITS, "inch": 0.0254, **FUNCTIONS, **names}
    return eval(python_of(value), {"__builtins__": {}}, scope)
