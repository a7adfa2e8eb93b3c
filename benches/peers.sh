#!/usr/bin/env bash
# One position of the lift, the paper's optimization, dynamics, and a link in finite elements, beside the programs that an engineer
# would use today, all in this call.
#
#   benches/peers.sh [PEERS] [PART]     PEERS: folder of the peer scripts (default ../shared/peers)
#                                       PART: positions, dynamics, elasticity, flexible (default: the first two; the others
#                                       take minutes)
#
# Figures are process CPU seconds, one thread. A peer that is not installed is named and left out;
# `PEERS/run.sh setup` installs them. Whole-process figures include interpreter start and imports.
set -euo pipefail
cd "$(dirname "$0")/.."
peers=$(realpath "${1:-../shared/peers}" 2>/dev/null || true)
part=${2:-both}
venv=${VENV:-$HOME/.cache/bellcrank-peers-venv}
scratch=${BASELINE_SCRATCH:-$HOME/.cache/bellcrank-peers}
program=${CARGO_TARGET_DIR:-target}/release/bellcrank
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

absent() { echo "not measured: $1 ($2)" >&2; }
ours() { cargo bench -q -p bellcrank-multibody --bench "$@"; }
# A peer's script, where its package is there. MuJoCo writes its log where it stands.
script() { # package script answer
  if [ -x "$venv/bin/python" ] && [ -d "$peers" ] && "$venv/bin/python" -c "import $1" 2> /dev/null; then
    (cd "$out" && "$venv/bin/python" "$peers/$2.py" --json "$out/$3.json" > /dev/null) || absent "$3" failed
  else
    absent "$3" "$venv"
  fi
}

positions() {
  ours cpu > "$out/bellcrank.json"
  cargo bench -q -p bellcrank-model --bench cpu -- > "$out/bellcrank-studies.json"
  if [ -x "$scratch/pin_sixbar" ]; then "$scratch/pin_sixbar" > "$out/pinocchio.json"; else absent pinocchio "$scratch/pin_sixbar"; fi
  script scipy scipy_sixbar scipy
  if command -v octave-cli > /dev/null && [ -d "$peers" ]; then
    octave-cli -qf "$peers/sixbar.m" --json "$out/octave.json" > /dev/null 2>&1 || true
  else
    absent octave octave-cli
  fi
  # Again at the end: the machine may have changed its pace meanwhile.
  ours cpu > "$out/bellcrank-after.json"
  python3 benches/peers.py "$out" "$program" "$peers" "$venv/bin/python"
}

dynamics() {
  script mujoco mujoco_sixbar mujoco
  script pydrake drake_sixbar drake
  local arm=$scratch/pinocchio_arm
  if [ ! -x "$arm" ] && "$venv/bin/python" -c "import pinocchio" 2> /dev/null; then
    benches/peers/build_pinocchio_arm.sh "$venv/bin/python" "$arm" || absent pinocchio_arm "did not compile"
  fi
  [ -x "$arm" ] || absent pinocchio_arm "$arm"
  # The two take turns.
  for _ in 1 2 3 4 5 6 7; do
    ours dynamics_cpu -- arm >> "$out/arm.jsonl"
    if [ -x "$arm" ]; then "$arm" benches/peers/arm.txt >> "$out/pinocchio_arm.jsonl"; fi
  done
  ours dynamics_cpu -- andrews lift chains > "$out/dynamics.json"
  python3 benches/dynamics.py "$out" "$program"
}

# The bell crank at 172,077 unknowns: NGSolve and CalculiX on one mesh, which the peer's script writes, then bellcrank on it.
elasticity() {
  local deck=$out/scratch
  mkdir -p "$deck"
  BASELINE_SCRATCH=$deck "$venv/bin/python" "$peers/fe_bench.py" --size 150k --reps 1 --json "$out/fe.json" > /dev/null ||
    absent "NGSolve and CalculiX" "$venv"
  [ -f "$deck/fe_150k_static.inp" ] || { absent elasticity "no deck"; return; }
  for threads in 1 2; do
    cargo bench -q -p bellcrank-fem --bench peer -- "$deck/fe_150k_static.inp" static "$threads" >> "$out/statics.jsonl"
    cargo bench -q -p bellcrank-fem --bench peer -- "$deck/fe_150k_modal.inp" modes "$threads" >> "$out/modes.jsonl"
  done
  python3 benches/elasticity.py "$out"
}

# The lift with flexible links, from model file to stress: Exudyn and NGSolve, then bellcrank.
flexible() { python3 benches/flexible.py "$out" "$program" "$peers" "$venv/bin/python"; }

echo "building" >&2
if [ "$part" = flexible ]; then
  # BELLCRANK names a release build that is there already.
  if [ -n "${BELLCRANK:-}" ]; then program=$BELLCRANK; else cargo build -q --release -p bellcrank; fi
  flexible
  exit
fi
if [ "$part" = elasticity ]; then
  cargo bench -q -p bellcrank-fem --bench peer --no-run
  elasticity
  exit
fi
if [ "$part" != dynamics ]; then ours cpu --no-run; fi
if [ "$part" != positions ]; then ours dynamics_cpu --no-run; fi
cargo build -q --release -p bellcrank
script exudyn exudyn_rigid exudyn
if [ "$part" != dynamics ]; then positions; fi
if [ "$part" != positions ]; then dynamics; fi
