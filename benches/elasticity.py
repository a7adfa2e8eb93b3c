"""One link in finite elements: bellcrank beside NGSolve and CalculiX on the same mesh, CPU seconds and what they found."""
import json
import pathlib
import sys

out = pathlib.Path(sys.argv[1])


def lines(name):
    path = out / name
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


def row(label, seconds, base, memory, found):
    ratio = f"{seconds / base:9.2f}" if base else " " * 9
    print(f"{label:44s} {seconds:9.2f} {ratio} {memory:>9} {found}")


fe = json.loads((out / "fe.json").read_text()) if (out / "fe.json").exists() else {}
peers = next((value for key, value in fe.items() if isinstance(value, dict) and "dof" in value), {})
ng, ccx = peers.get("ngsolve_1t", {}), peers.get("ccx_1t", {})


def cpu(table, key):
    return table.get(key, {}).get("cpu", 0.0)


statics, modes = lines("statics.jsonl"), lines("modes.jsonl")
print(f"{'unknowns: ' + str(peers.get('dof', '?')):44s} {'CPU s':>9s} {'ratio':>9s} {'MB':>9s}")
base = cpu(ng, "static_total")
if ng:
    row("static: NGSolve", base, base, round(peers.get("ngsolve_peak_MB", 0)), f"u {ng['static_result']['umax_mm']:.8f} mm")
if ccx:
    row("static: CalculiX, whole process", cpu(ccx, "static_total"), base, round(ccx["static_MB"]), f"u {ccx['umax_mm']:.8f} mm")
for found in statics:
    label = f"static: bellcrank, {found['threads']} thread(s), deck read"
    row(label, found["read"] + found["total"], base, found["peak_MB"], f"u {found['umax_mm']:.8f} mm, residual {found['residual']:.1e}")
base = cpu(ng, "modal_total")
if ng:
    row("ten modes: NGSolve and ARPACK", base, base, "", f"{ng['modal_result']['freq_Hz'][9]:.5f} Hz")
if ccx:
    row("ten modes: CalculiX, whole process", cpu(ccx, "modal_total"), base, round(ccx["modal_MB"]), f"{ccx['freq_Hz'][9]:.5f} Hz")
for found in modes:
    row(f"ten modes: bellcrank, {found['threads']} thread(s)", found["total"], base, found["peak_MB"], f"{found['freq_Hz'][9]:.5f} Hz")
