"""Flexible links, from model file to stress: verify/cases/lift-flexible-exudyn, and exudyn_flex.py of the peers."""
import json
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys

out, program, peers, python = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3]), sys.argv[4]
MODEL, STUDY = "verify/cases/lift-flexible-exudyn/model.toml", "stroke"
ROUNDS = int(sys.argv[5]) if len(sys.argv) > 5 else 3


def measured(command):
    """CPU seconds of a process (user and system), and what it printed; nothing where it failed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    answer = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return (seconds, answer.stdout) if answer.returncode == 0 else (None, "")


def ours(*options, study=STUDY):
    command = [program, "run", MODEL, study, "--threads", "1", "--json", "--out", str(out / "lift"), *options]
    seconds, text = measured(command)
    if seconds is None:
        sys.exit(f"not measured: {' '.join(command)}")
    return seconds, json.loads(text)["studies"][study]


def theirs():
    answer = out / "exudyn_flex.json"
    seconds, _ = measured([python, str(peers / "exudyn_flex.py"), "--reps", "1", "--json", str(answer)])
    return (seconds, json.loads(answer.read_text())) if seconds else None


def row(label, mine, other=None):
    ratio = f"{other / mine:9.1f}" if other else f"{'':>9s}"
    print(f"{label:62s} {mine:10.3f} {f'{other:10.3f}' if other else '         –'} {ratio}")


def median(pairs):
    return statistics.median(seconds for seconds, _ in pairs)


cache = out / "cache"
whole, first, again, ends, still, peer = [], [], [], [], [], []
for _ in range(ROUNDS):
    whole.append(ours("--no-cache"))
    peer += filter(None, [theirs() if not peer else None])
    shutil.rmtree(cache, ignore_errors=True)
    first.append(ours("--cache", str(cache)))
    again.append(ours("--cache", str(cache)))
    ends.append(ours("--cache", str(cache), study="stroke-ends"))
    still.append(ours("--cache", str(cache), study="ends"))
study = again[-1][1]
simulated = study["signals"]["time"]["last"]
exudyn = peer[0] if peer else (None, None)

print(f"{'flexible links over the stroke, one thread':62s} {'bellcrank':>10s} {'Exudyn':>10s} {'ratio':>9s}")
if exudyn[1]:
    meshes = [study["flexible"]["bodies"][body]["mesh"]["nodes"] * 3 for body in ("link3", "link5")]
    print(f"{'unknowns of lever and arm':62s} {meshes[0]:5d},{meshes[1]:5d} {exudyn[1]['crank']['fe_dof']:5d},{exudyn[1]['rocker']['fe_dof']:5d}")
row("whole job, model file to stress (process, CPU s)", median(whole), exudyn[0])
row("with the cache: first run (process, CPU s)", median(first))
row("with the cache: repeated (process, CPU s)", median(again))
row("  first over repeated: ratio in the last column", median(again), median(first))
simulation = max(median(ends) - median(still), 1e-3)
row("simulation (run of three rows less one without motion)", simulation, exudyn[1] and exudyn[1]["simulation"]["cpu"])
row("  simulated seconds over that: ratio in the last column", simulation, simulated)
row("  simulated seconds over the repeated run, all in it", median(again), simulated)
print("effort:", ", ".join(f"{key} {value}" for key, value in study["effort"].items()))
