#!/usr/bin/python3
"""Computes the 96 red cells of fig. 17 on the lattice, and compares their labels with those of boundary integrals (fig17/result.csv).

    studies/cross_validation/labels.py [CAPSTAN] > labels.md      six minutes on two cores

Points whose labels differ are repeated on the lattice of `standard`, at half the spacing.
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


def on_lattice(row, fidelity="fast"):
    with tempfile.TemporaryDirectory() as directory:
        case = {**BASE, "Ca": float(row["Ca"]), "V": float(row["V"]), "fluid": "quasisteady", "fidelity": fidelity,
                "until": {"kt": 30, "classified": True}, "outputs": {"shapes_every": 0}}
        (Path(directory) / "case.json").write_text(json.dumps(case))
        subprocess.run([CAPSTAN, "solve", f"{directory}/case.json", "--out", f"{directory}/run"], capture_output=True)
        return json.loads(Path(f"{directory}/run/result.json").read_text())


def in_parallel(function, rows):
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as cores:
        return list(cores.map(function, rows))


def numbers(motion, margin, error, confirmed):
    return f"{motion} | {margin:.4f} | {error} | {str(confirmed).lower()}"


def main():
    rows = list(csv.DictReader((STUDIES / "fig17/result.csv").open()))
    pairs = list(zip(rows, in_parallel(on_lattice, rows)))
    both = [(row, result) for row, result in pairs if row["confirmed"] == "true" and result["confirmed"]]
    different = [(row, result) for row, result in pairs if row["motion"] != result["motion"]]
    finer = in_parallel(lambda pair: on_lattice(pair[0], "standard"), different)
    print("<!-- made by labels.py -->\n")
    print(f"Equal labels: {len(pairs) - len(different)} of {len(pairs)}; where both are confirmed: "
          f"{sum(row['motion'] == result['motion'] for row, result in both)} of {len(both)}. Of the others, equal at `standard`: "
          f"{sum(row['motion'] == result['motion'] for (row, _), result in zip(different, finer))} of {len(different)}.\n")
    print("| Ca | V | boundary integrals | margin | error of Q | confirmed | lattice | margin | error of Q | confirmed | "
          "lattice, `standard` | margin | error of Q | confirmed |")
    print("|---" * 14 + "|")
    for (row, result), again in zip(different, finer):
        cells = [numbers(row["motion"], float(row["evidence.margin"]), row["error.Q"], row["confirmed"] == "true")]
        cells += [numbers(each["motion"], each["evidence"]["margin"], each["error"]["Q"], each["confirmed"]) for each in (result, again)]
        print(f"| {row['Ca']} | {row['V']} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
