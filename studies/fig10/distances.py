"""Prints how far the curves of the fluids quasisteady and unsteady are apart, for every Ca and Re of a study.

python3 studies/fig10/distances.py STUDY.json...   runs the cases one after the other; takes a minute
"""
import itertools
import json
import math
import pathlib
import subprocess
import sys
import tempfile

CAPSTAN = pathlib.Path(__file__).resolve().parents[2] / "build/release/capstan"


def history(case):
    """The records of a run: one dictionary a line of history.jsonl."""
    with tempfile.TemporaryDirectory() as directory:
        file = pathlib.Path(directory, "case.json")
        file.write_text(json.dumps(case))
        run = pathlib.Path(directory, "run")
        subprocess.run([CAPSTAN, "solve", file, "--out", run], check=True, capture_output=True)
        return [json.loads(line) for line in (run / "history.jsonl").read_text().splitlines()]


def Q(record):
    return record["D_xy"] * complex(math.cos(2 * record["theta"]), math.sin(2 * record["theta"]))


def row(study, Ca, Re):
    steady, unsteady = (
        history({**study["base"], "Ca": Ca, "Re": Re, "fluid": fluid}) for fluid in ("quasisteady", "unsteady")
    )
    pairs = list(zip(steady, unsteady))[1:]  # at the start D_xy of a sphere is 0
    dD = max(abs(a["D_xy"] - b["D_xy"]) for a, b in pairs)
    dQ = max(abs(Q(a) - Q(b)) for a, b in pairs)
    return f"| {Ca} | {Re} | {dD:.4f} | {dQ:.4f} | {dQ / Re:.3f} |"


for name in sys.argv[1:]:
    study = json.loads(pathlib.Path(name).read_text())
    print(f"\n{study['name']}\n\n| Ca | Re | ΔD_xy | ΔQ | ΔQ/Re |\n|---|---|---|---|---|")
    for Ca, Re in itertools.product(study["axes"]["Ca"], study["axes"]["Re"]):
        print(row(study, Ca, Re), flush=True)
