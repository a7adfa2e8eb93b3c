"""Tables of what peers.sh measured of dynamics: a six-axis arm, runs in time, chains, the whole machine."""
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys

out, program = pathlib.Path(sys.argv[1]), sys.argv[2]
MACHINE = "models/assist-manipulator/machine.toml"


def read(name):
    try:
        return json.loads((out / f"{name}.json").read_text().strip().splitlines()[-1])
    except (OSError, ValueError, IndexError):
        return None


def rounds(name):
    """Lines of JSON, one a round; what else a program said is left out."""
    try:
        lines = (out / f"{name}.jsonl").read_text().splitlines()
    except OSError:
        return []
    return [json.loads(line) for line in lines if line.startswith("{")]


def peer(name):
    try:
        return json.loads((out / f"{name}.json").read_text())
    except (OSError, ValueError):
        return None


def find(tree, *keys):
    for key in keys:
        tree = tree.get(key) if isinstance(tree, dict) else None
    return tree


def arm():
    ours, theirs = rounds("arm"), rounds("pinocchio_arm")
    if not ours:
        return
    # The two took turns: ratios are those of neighbours, so that the pace of the machine drops out.
    print(f"\n{'six-axis arm, us CPU a call: least, median of rounds':54s} {'bellcrank':>15s} {'Pinocchio C++':>15s} {'ratio':>7s}")
    rows = (("inverse dynamics (rnea)", "rnea_us", ["rnea_us"]), ("mass matrix (crba)", "crba_us", ["crba_local_us", "crba_world_us"]))
    for label, mine, names in rows:
        a = [x[mine][0] for x in ours]
        row = f"{label:54s} {min(a):7.3f} {statistics.median(a):7.3f}"
        if theirs:
            b = [min(x[name][0] for name in names) for x in theirs]
            ratio = statistics.median(x / y for x, y in zip(a, b))
            row += f" {min(b):7.3f} {statistics.median(b):7.3f} {ratio:7.2f}"
        print(row)


def stroke(dynamics):
    print(f"\n{'the lift through its stroke of 8 s, driven at 20 mm/s':54s} {'ms CPU':>9s} {'ratio':>8s} {'force error':>13s}")
    lift = dynamics["lift"]
    mine = lift[-1]["ms"][1]
    rows = [(f"bellcrank, tolerance 1e-6, {x['rows']} rows", x["ms"][1], x["force_error_N"]) for x in lift]
    for name, study, label, error in (
        ("mujoco", "rollout_1ms", "MuJoCo, 7997 steps of 1 ms", "max_err_after_50_steps_N"),
        ("exudyn", "dyn1ms", "Exudyn, 7997 steps of 1 ms", "max_err_vs_closed_N"),
        ("drake", "discrete_1ms", "Drake, 7997 steps of 1 ms", "max_err_vs_closed_N"),
    ):
        answer = find(peer(name), study)
        seconds = find(answer, "solve", "cpu")
        if seconds:
            rows.append((label, seconds * 1e3, answer[error]))
    for label, ms, error in rows:
        print(f"{label:54s} {ms:9.2f} {ms / mine:8.2f} {error:11.1e} N")


def andrews(dynamics):
    print(f"\n{'Andrews squeezer to 0.03 s':26s} {'ms CPU: least, median':>24s} {'error, rad':>11s} {'steps':>6s} {'rejected':>9s} {'evaluations':>12s}")
    for x in dynamics["andrews"]:
        least, median = x["ms"]
        print(
            f"tolerance {x['tolerance']:<16.0e} {least:15.2f} {median:8.2f} {x['error']:11.1e} {x['steps']:6d}"
            f" {x['rejected']:9d} {x['evaluations']:12d}"
        )


def chains(dynamics):
    print(f"\n{'N four-bars, 1 s of their fall':26s} {'ms CPU':>10s} {'evaluations':>12s} {'us/evaluation/loop':>19s} {'begin, ms':>10s}")
    for x in dynamics["chains"]:
        print(
            f"N = {x['loops']:<22d} {x['ms'][0]:10.2f} {x['evaluations']:12d} {x['us_evaluation_loop']:19.3f} {x['begin_ms']:10.2f}"
        )


def machine(study, runs=3):
    """Simulated seconds over seconds: of the study alone on the clock, and of the whole process on the CPU."""
    if not os.path.exists(MACHINE):
        return
    alone, whole, simulated = [], [], 0.0
    for _ in range(runs):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = [program, "run", MACHINE, study, "--out", str(out / "machine"), "--json"]
        answer = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if answer.returncode:
            print(f"not measured: {study} (exit code {answer.returncode})", file=sys.stderr)
            return
        found = json.loads(answer.stdout)["studies"][study]
        simulated = found["signals"]["time"]["last"]
        alone.append(found["seconds"])
        whole.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    print(f"\n{'the whole assist manipulator, study ' + study:54s} {'s':>9s} {'simulated time over it':>24s}")
    for label, seconds in (("study on the clock, median", statistics.median(alone)), ("least", min(alone)), ("whole process with report, CPU", min(whole))):
        print(f"{label:54s} {seconds:9.3f} {simulated / seconds:24.0f}")


dynamics = read("dynamics")
arm()
if dynamics:
    stroke(dynamics)
    andrews(dynamics)
    chains(dynamics)
machine("cycle")
