#!/usr/bin/env bash
# One position of the lift, and the paper's optimization, beside the programs that an engineer would use today, all in this call.
#
#   benches/peers.sh [PEERS]     PEERS: folder of the peer scripts (default ../shared/peers)
#
# Figures are process CPU seconds, median, one thread. A peer that is not installed is named and left out;
# `PEERS/run.sh setup` installs them. Whole-process figures include interpreter start and imports.
set -euo pipefail
cd "$(dirname "$0")/.."
peers=$(realpath "${1:-../shared/peers}" 2>/dev/null || true)
venv=${VENV:-$HOME/.cache/bellcrank-peers-venv}
scratch=${BASELINE_SCRATCH:-$HOME/.cache/bellcrank-peers}
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

echo "building" >&2
cargo bench -q -p bellcrank-multibody --bench cpu -- > "$out/bellcrank.json"
cargo bench -q -p bellcrank-model --bench cpu -- > "$out/bellcrank-studies.json"
cargo build -q --release -p bellcrank

absent() { echo "not measured: $1 ($2)" >&2; }
if [ -x "$scratch/pin_sixbar" ]; then "$scratch/pin_sixbar" > "$out/pinocchio.json"; else absent pinocchio "$scratch/pin_sixbar"; fi
if [ -x "$venv/bin/python" ] && [ -d "$peers" ]; then
  "$venv/bin/python" "$peers/scipy_sixbar.py" --json "$out/scipy.json" > /dev/null || absent scipy failed
  "$venv/bin/python" "$peers/exudyn_rigid.py" --json "$out/exudyn.json" > /dev/null || absent exudyn failed
else
  absent "scipy, exudyn" "$venv"
fi
if command -v octave-cli > /dev/null && [ -d "$peers" ]; then
  octave-cli -qf "$peers/sixbar.m" --json "$out/octave.json" > /dev/null 2>&1 || true
else
  absent octave octave-cli
fi
# Again at the end: the machine may have changed its pace meanwhile.
cargo bench -q -p bellcrank-multibody --bench cpu -- > "$out/bellcrank-after.json"

program=${CARGO_TARGET_DIR:-target}/release/bellcrank
python3 benches/peers.py "$out" "$program" "$peers" "$venv/bin/python"
