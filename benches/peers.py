"""Table of the figures that peers.sh collected: microseconds a position, studies, and whole processes."""
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

out, program, peers, python = sys.argv[1:5]
out = pathlib.Path(out)


def read(name):
    path = out / f"{name}.json"
    try:
        return json.loads(path.read_text().strip().splitlines()[-1] if name.startswith("bell") else path.read_text())
    except (OSError, ValueError, IndexError):
        return None


def find(tree, *keys):
    for key in keys:
        tree = tree.get(key) if isinstance(tree, dict) else None
    return tree


rows = []
ours = [read("bellcrank"), read("bellcrank-after")]
mine = statistics.mean(x["planar_us"] for x in ours)
rows.append(("bellcrank, plane: all reactions", mine))
rows.append(("bellcrank, the same written in space (redundant)", statistics.mean(x["spatial_us"] for x in ours)))
pin = read("pinocchio")
if pin:
    rows.append(("Pinocchio C++: position, rates, RNEA, loop reactions", pin["full_position_us"]))
scipy = read("scipy")
for name, label in (("batch", "NumPy batched: Newton and 15x15 solves"), ("loop", "SciPy, position by position")):
    seconds = find(scipy, name, "analysis_601", "cpu")
    if seconds:
        rows.append((label, seconds / 601 * 1e6))
us = find(read("exudyn"), "inv601", "us_per_step_cpu")
if us:
    rows.append(("Exudyn, 600 prescribed steps", us))
octave = read("octave")
us = find(octave, "loop", "us_per_position_cpu")
if us:
    rows.append(("Octave, position by position", us))

print(f"{'one position of the lift':54s} {'us CPU':>9s} {'ratio':>8s}")
for label, value in rows:
    print(f"{label:54s} {value:9.3f} {value / mine:8.2f}")

studies = read("bellcrank-studies")
if studies:
    mine = studies["optimum_ms"]
    rows = [("bellcrank: exact gradients, whole study", mine)]
    for name, label in (("batch", "SciPy SLSQP on NumPy batched"), ("loop", "SciPy SLSQP, position by position")):
        seconds = find(scipy, name, "optimise", "cpu")
        if seconds:
            rows.append((label, seconds * 1e3))
    seconds = find(octave, "loop", "optimise_cpu")
    if seconds:
        rows.append(("Octave sqp, position by position", seconds * 1e3))
    print(f"\n{'optimum of the lift, 3 lengths, 601 positions':54s} {'ms CPU':>9s} {'ratio':>8s}")
    for label, value in rows:
        print(f"{label:54s} {value:9.2f} {value / mine:8.2f}")
    sweep = studies["sweep_ms"]
    print(f"\n{'six sensitivities of the lift, 601 positions':54s} {'ms CPU':>9s} {'sweeps':>8s}")
    for key, label in (
        ("sweep", "one sweep, all signals recorded"),
        ("six_sensitivities", "six sensitivities of the peak"),
        ("six_sensitivities_of_all_rows", "six sensitivities of the root mean square"),
    ):
        print(f"{label:54s} {studies[key + '_ms']:9.2f} {studies[key + '_ms'] / sweep:8.2f}")


def whole(command, cwd=None, repeats=7):
    """Median wall and CPU seconds of a process."""
    walls, cpus = [], []
    for _ in range(repeats):
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        subprocess.run(command, cwd=cwd, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
        walls.append(time.monotonic() - start)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        cpus.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return statistics.median(walls), statistics.median(cpus)


print(f"\n{'whole process, the lift':54s} {'s wall':>9s} {'s CPU':>8s}")
with tempfile.TemporaryDirectory() as folder:
    run = [program, "run", "models/assist-manipulator/lift.toml", "--out", folder]
    print("{:54s} {:9.3f} {:8.3f}".format("bellcrank run: two studies, CSV, JSON, plots, report", *whole(run)))
if peers and os.path.exists(python):
    script = [python, f"{peers}/exudyn_rigid.py", "--only", "inv601"]
    try:
        print("{:54s} {:9.3f} {:8.3f}".format("Exudyn, one study, no output", *whole(script, repeats=3)))
    except subprocess.CalledProcessError:
        print("Exudyn, one study: failed", file=sys.stderr)
    script = [python, f"{peers}/scipy_sixbar.py", "--only", "loop"]
    print("{:54s} {:9.3f} {:8.3f}".format("SciPy loop, one study, no output", *whole(script, repeats=3)))
