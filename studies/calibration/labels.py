#!/usr/bin/python3
"""Compares the labels of `fast` with those of the second rung above, on the grid of fig. 17 and at random points around it.

    studies/calibration/labels.py [CAPSTAN] > labels.md      about a quarter of an hour on two cores
"""
import concurrent.futures
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CAPSTAN = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/capstan"
SEED, RANDOM_POINTS = 17, 60
FAST, TWO_ABOVE = "fast", {"nodes": 2562}  # 642, 1442, 2562 nodes


def points():
    study = json.loads((ROOT / "studies/fig17/study.json").read_text())
    axes = study["axes"]
    grid = [{**study["base"], "Ca": Ca, "V": V} for Ca in axes["Ca"] for V in axes["V"]]
    random_of = random.Random(SEED)

    def log_uniform(low, high):
        return float(f"{math.exp(random_of.uniform(math.log(low), math.log(high))):.3g}")

    return grid + [{**study["base"], "Ca": log_uniform(0.1, 1.2), "V": log_uniform(0.5, 12)} for _ in range(RANDOM_POINTS)]


def result(case, fidelity):
    with tempfile.TemporaryDirectory() as directory:
        asked = {**case, "fidelity": fidelity, "until": {"kt": 30, "classified": True}, "outputs": {"shapes_every": 0}}
        (Path(directory) / "case.json").write_text(json.dumps(asked))
        subprocess.run([CAPSTAN, "solve", f"{directory}/case.json", "--out", f"{directory}/run"], capture_output=True)
        return json.loads(Path(f"{directory}/run/result.json").read_text())


def compared(case):
    return case, result(case, FAST), result({**case, "companion": False}, TWO_ABOVE)


def main():
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as cores:
        rows = []
        for row in cores.map(compared, points()):
            rows.append(row)
            print(len(rows), file=sys.stderr)
    print("<!-- made by labels.py -->\n")
    counts = Counter((fast["confirmed"], fast["motion"] == finer["motion"]) for _, fast, finer in rows)
    print("| label at `fast` | the same with 2562 nodes | another |\n|---|---|---|")
    for confirmed, words in ((True, "confirmed"), (False, "not confirmed")):
        print(f"| {words} | {counts[confirmed, True]} | {counts[confirmed, False]} |")
    if all(fast["motion"] == finer["motion"] for _, fast, finer in rows):
        return
    print("\n| Ca | V | `fast` | 2562 nodes | confirmed | margin | stated error of Q |\n|---|---|---|---|---|---|---|")
    for case, fast, finer in rows:
        if fast["motion"] != finer["motion"]:
            print(f"| {case['Ca']} | {case['V']} | {fast['motion']} | {finer['motion']} | {'yes' if fast['confirmed'] else 'no'} | "
                  f"{fast['evidence']['margin']:.3f} | {fast['error'].get('Q')} |")


if __name__ == "__main__":
    main()
