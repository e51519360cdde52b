"""Prints how far the rungs of both flow models are from boundary integrals with 2562 nodes, and what walls change.

python3 studies/cross_validation/rungs.py CASE.json...   runs the cases to kt = 10; takes a quarter of an hour of one core
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

CAPSTAN = pathlib.Path(__file__).resolve().parents[2] / "build/release/capstan"
LATTICE = {162: 0.4, 642: 0.2, 2562: 0.1, 10242: 0.05}  # spacing of the rung of so many nodes
OUTPUTS = {"history_every": 0.1, "shapes_every": 0}


def run(case, **keys):
    """The records from kt = 0.5 on, the seconds and the peak memory of a run; None if it has no answer."""
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory, "case.json")
        file.write_text(json.dumps({**case, "until": {"kt": 10}, "outputs": OUTPUTS, **keys}))
        out = pathlib.Path(directory, "run")
        if subprocess.run([CAPSTAN, "solve", file, "--out", out], capture_output=True).returncode != 0:
            return None
        lines = (out / "history.jsonl").read_text().splitlines()
        cost = json.loads((out / "result.json").read_text())["cost"]
        return [r for r in map(json.loads, lines) if r["kt"] > 0.45], cost["seconds"], cost["peak_memory_mb"]


def stokes(case, nodes):
    return run(case, fluid="stokes", fidelity={"nodes": nodes})


def lattice(case, nodes, box):
    return run(case, fluid="quasisteady", fidelity={"nodes": nodes, "dx": LATTICE[nodes], "box": box})


def Q(record):
    return record["D_xy"] * complex(math.cos(2 * record["theta"]), math.sin(2 * record["theta"]))


def differences(name, setting, measured, reference):
    if not measured:
        return print(f"| {name} | {setting} | no answer | | | |", flush=True)
    records, seconds, memory = measured
    pairs = list(zip(records, reference[0]))
    dQ = max(abs(Q(a) - Q(b)) for a, b in pairs)
    square = sum((a["D_xy"] - b["D_xy"]) ** 2 for a, b in pairs) / sum(b["D_xy"] ** 2 for _, b in pairs)
    print(f"| {name} | {setting} | {dQ:.4f} | {100 * math.sqrt(square):.2f} % | {seconds:.2f} | {memory:.0f} |", flush=True)


print("| case | setting | max ΔQ | ΔD_xy | seconds | MB |\n|---|---|---|---|---|---|")
for file in map(pathlib.Path, sys.argv[1:]):
    case = json.loads(file.read_text())
    exact = stokes(case, 2562)
    for nodes in (162, 642, 10242):
        differences(file.stem, f"stokes {nodes}", stokes(case, nodes), exact)
    for nodes in (162, 642, 2562, 10242):
        differences(file.stem, f"lattice {LATTICE[nodes]}", lattice(case, nodes, 51.2), exact)
    unbounded = lattice(case, 642, 51.2)
    for box in (6.4, 12.8, 25.6):
        differences(file.stem, f"box {box}", lattice(case, 642, box), unbounded)
