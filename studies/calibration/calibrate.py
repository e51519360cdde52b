#!/usr/bin/python3
"""Runs random cases on the rungs of their ladder and appends one JSON line a run to a file.

    studies/calibration/calibrate.py CAPSTAN RUNS.jsonl [--fluid stokes|quasisteady] [--cases FROM:TO] [--up-to NODES]
                                     [--errors 0.05,0.01]

With --errors the cases are also run with these errors asked for. A rung is named by its nodes. Runs that the file already holds are skipped, so an interrupted study goes on when the same
command is given again. evaluate.py turns the file into distances, errors and factors.
"""
import argparse
import json
import math
import random
import resource
import shutil
import subprocess
import tempfile
from pathlib import Path

NODES = {"stokes": (42, 92, 162, 362, 642, 1442, 2562, 5762, 10242), "quasisteady": (162, 362, 642, 1442, 2562, 5762)}
PARTS_OF_BOX = {162: 32, 362: 48, 642: 64, 1442: 96, 2562: 128, 5762: 192}  # box of 12.8 over dx
SECONDS = 3  # of one run: a case whose run on the rung of TIMED_AT would take longer is computed to an earlier kt
TIMED_AT = {"stokes": 2562, "quasisteady": 1442}
ORDER_OF_COST = {"stokes": 1.9, "quasisteady": 2}  # cost over the power of the nodes, beyond the fixed costs
SEED = 14


def draw(index, seed=SEED):
    """Case number `index`: its physics and its end."""
    random_of = random.Random(f"{seed} {index}")

    def log_uniform(low, high):
        return math.exp(random_of.uniform(math.log(low), math.log(high)))

    case = {"shape": random_of.choice(["sphere", "oblate", "prolate", "biconcave"])}
    aspect = {"oblate": (0.2, 0.95), "prolate": (1.05, 3)}.get(case["shape"])
    if aspect:
        case["aspect"] = random_of.uniform(*aspect)
    case["law"] = random_of.choice(["neo-hookean", "skalak"])
    C = log_uniform(0.1, 50)
    if case["law"] == "skalak":
        case["C"] = C
    case["Ca"] = log_uniform(0.01, 2)
    case["V"] = log_uniform(0.1, 20)
    without_bending = random_of.random() < 0.2
    E_b = log_uniform(0.002, 0.1)
    if not without_bending:
        case["E_b"] = E_b
    kt = random_of.uniform(4, 30)
    case = {key: float(f"{value:.4g}") if isinstance(value, float) else value for key, value in case.items()}
    return case, round(kt, 1)


def fidelity(fluid, nodes):
    return {"nodes": nodes} if fluid == "stokes" else {"dx": 12.8 / PARTS_OF_BOX[nodes], "nodes": nodes, "box": 12.8}


def case_with(case, kt, fluid, fidelity):
    inertia = {"Re": 0.05} if fluid == "quasisteady" else {}
    return {**case, **inertia, "fluid": fluid, "until": {"kt": kt}, "fidelity": fidelity,
            "outputs": {"shapes_every": 0, "history_every": 0.1}}


def case_at_rung(case, kt, fluid, rung):
    return {**case_with(case, kt, fluid, fidelity(fluid, rung)), "companion": False}


def limit_processor_time():
    resource.setrlimit(resource.RLIMIT_CPU, (20 * SECONDS, 20 * SECONDS + 5))


def run(capstan, case):
    """History and result of a case. A run that was refused or took too long has neither."""
    directory = Path(tempfile.mkdtemp(prefix="calibration"))
    try:
        (directory / "in.json").write_text(json.dumps(case))
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        ended = subprocess.run([capstan, "solve", directory / "in.json", "--out", directory / "run"],
                               capture_output=True, text=True, preexec_fn=limit_processor_time)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        line = {"seconds": round(seconds, 3)}
        if not (directory / "run/result.json").exists():
            return {**line, "stop": "no result", "message": ended.stderr.strip()[-300:], "exit": ended.returncode}
        result = json.loads((directory / "run/result.json").read_text())
        history = [json.loads(record) for record in open(directory / "run/history.jsonl")]
        line |= {key: result[key] for key in ("stop", "message", "motion", "explanation", "evidence", "error")}
        line |= {"stepper": result["case"]["fidelity"].get("stepper"), "kdt": result["case"]["fidelity"].get("kdt"),
                 "steps": result["cost"]["steps"], "warnings": result["trust"]["warnings"],
                 "surface": result["trust"].get("surface")}
        line |= {"kt_of_records": [r["kt"] for r in history]}
        line |= {key: [None if r[key] is None else round(r[key], 7) for r in history]
                 for key in ("D_xy", "theta", "psi")}
        return line
    finally:
        shutil.rmtree(directory, ignore_errors=True)


class Runs:
    """The runs in the file, by case, flow model and rung. Of runs that were repeated the last counts."""

    def __init__(self, capstan, path):
        self.capstan, self.path, self.entries = capstan, path, {}
        for line in open(path) if path.exists() else []:
            self.add(json.loads(line))

    def add(self, entry):
        self.entries[entry["index"], entry["fluid"], entry["rung"]] = entry

    def shortest_kt(self, index, fluid, kt):
        return min([kt] + [entry["kt"] for (i, f, _), entry in self.entries.items() if (i, f) == (index, fluid)])

    def recorded_or_run(self, index, fluid, rung, kt, case):
        entry = self.entries.get((index, fluid, rung))
        if not entry or entry["kt"] != kt:
            entry = {"index": index, "fluid": fluid, "rung": rung, "kt": kt, "case": draw(index)[0], **run(self.capstan, case)}
            self.add(entry)
            with open(self.path, "a") as out:
                print(json.dumps(entry), file=out)
        return entry


def expected_seconds(entry, nodes):
    """Of a finer run."""
    return entry["seconds"] * (nodes / entry["rung"]) ** ORDER_OF_COST[entry["fluid"]]


def compute_ladder(runs, fluid, index, up_to):
    """All rungs to one kt, from the coarsest on; ends before a rung that would take too long."""
    case, kt = draw(index)
    kt = runs.shortest_kt(index, fluid, kt)
    rungs = [nodes for nodes in NODES[fluid] if nodes <= up_to]

    def compute(nodes):
        return runs.recorded_or_run(index, fluid, nodes, kt, case_at_rung(case, kt, fluid, nodes))

    for position, nodes in enumerate(rungs):
        below = compute(rungs[position - 1]) if position else None
        if below and nodes > TIMED_AT[fluid] and expected_seconds(below, nodes) > SECONDS:
            return
        if below and below["stop"] == "no result" and position > 3:
            return
        entry = compute(nodes)
        is_two_below_the_timed = position + 2 < len(rungs) and rungs[position + 2] == TIMED_AT[fluid]
        if is_two_below_the_timed and kt > 4 and (expected := expected_seconds(entry, TIMED_AT[fluid])) > SECONDS:
            kt = max(4, round(kt * SECONDS / expected, 1))
            for coarser in rungs[:position + 1]:
                compute(coarser)


def compute_with_errors(runs, fluid, index, errors):
    """The case with each of these errors asked for, to the end of its ladder."""
    case, kt = draw(index)
    kt = runs.shortest_kt(index, fluid, kt)
    for error in errors:
        runs.recorded_or_run(index, fluid, f"error {error:g}", kt, case_with(case, kt, fluid, {"error": error}))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("capstan")
    parser.add_argument("runs", type=Path)
    parser.add_argument("--fluid", default="stokes", choices=NODES)
    parser.add_argument("--cases", default="0:300")
    parser.add_argument("--up-to", type=int, default=5762, help="nodes of the finest rung")
    parser.add_argument("--errors", type=lambda text: [float(e) for e in text.split(",")], default=[])
    arguments = parser.parse_args()
    first, last = map(int, arguments.cases.split(":"))
    runs = Runs(arguments.capstan, arguments.runs)
    for index in range(first, last):
        compute_ladder(runs, arguments.fluid, index, arguments.up_to)
        compute_with_errors(runs, arguments.fluid, index, arguments.errors)


if __name__ == "__main__":
    main()
