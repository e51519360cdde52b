#!/usr/bin/python3
"""Computes the 96 red cells of fig. 17 on the lattice, and compares their labels with those of boundary integrals (fig17/result.csv).

    studies/cross_validation/labels.py [CAPSTAN] > labels.md      five minutes on two cores
"""
import concurrent.futures
import csv
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

STUDIES = Path(__file__).resolve().parents[1]
CAPSTAN = sys.argv[1] if len(sys.argv) > 1 else STUDIES.parent / "build/release/capstan"
BASE = json.loads((STUDIES / "fig17/study.json").read_text())["base"]


def on_lattice(row):
    with tempfile.TemporaryDirectory() as directory:
        case = {**BASE, "Ca": float(row["Ca"]), "V": float(row["V"]), "fluid": "quasisteady", "fidelity": "fast",
                "until": {"kt": 30, "classified": True}, "outputs": {"shapes_every": 0}}
        (Path(directory) / "case.json").write_text(json.dumps(case))
        subprocess.run([CAPSTAN, "solve", f"{directory}/case.json", "--out", f"{directory}/run"], capture_output=True)
        return json.loads(Path(f"{directory}/run/result.json").read_text())


def main():
    rows = list(csv.DictReader((STUDIES / "fig17/result.csv").open()))
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as cores:
        results = list(cores.map(on_lattice, rows))
    pairs = list(zip(rows, results))
    both = [(row, result) for row, result in pairs if row["confirmed"] == "true" and result["confirmed"]]
    print("<!-- made by labels.py -->\n")
    print(f"Equal labels: {sum(row['motion'] == result['motion'] for row, result in pairs)} of {len(pairs)}; where both are confirmed: "
          f"{sum(row['motion'] == result['motion'] for row, result in both)} of {len(both)}.\n")
    print("| Ca | V | boundary integrals | margin | error of Q | confirmed | lattice | margin | error of Q | confirmed |")
    print("|---" * 10 + "|")
    for row, result in pairs:
        if row["motion"] != result["motion"]:
            print(f"| {row['Ca']} | {row['V']} | {row['motion']} | {float(row['evidence.margin']):.4f} | {row['error.Q']} | {row['confirmed']} | "
                  f"{result['motion']} | {result['evidence']['margin']:.4f} | {result['error']['Q']} | {str(result['confirmed']).lower()} |")


if __name__ == "__main__":
    main()
