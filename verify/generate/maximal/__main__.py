import sys
from . import load

rows = load(sys.argv[1]).rows(sys.argv[2])
for k in rows[0]:
    if not k.startswith("#"):
        print(f"{k:40s} {rows[0][k]:22.14g} {rows[-1][k]:22.14g}")
