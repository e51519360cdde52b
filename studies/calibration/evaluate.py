#!/usr/bin/python3
"""Distances between the rungs of calibrate.py's runs, and the factor from distance to stated error.

    studies/calibration/evaluate.py RUNS.jsonl ERRORS.jsonl > results.md
"""
import json
import math
import sys
from collections import defaultdict

import numpy as np

from calibrate import NODES

KINDS = ("Q", "D_xy", "theta", "period")
START = 3  # kt from which half-turns are counted
CLEARLY_INCLINED = 0.05  # D_xy below which theta is not compared
ENDED = ("reached_end", "steady", "classified")


class Run:
    def __init__(self, entry):
        self.entry = entry
        self.kt, self.D_xy, self.theta, self.psi = (
            np.array([math.nan if v is None else v for v in entry[key]], float)
            for key in ("kt_of_records", "D_xy", "theta", "psi"))
        self.Q = self.D_xy * np.exp(2j * self.theta)

    def frequency(self):
        """Half-turns of shape and membrane a unit of kt; NaN if less than half of one was seen."""
        seen = self.kt >= START - 1e-9
        if seen.sum() < 2:
            return math.nan
        turned = -(self.theta + self.psi)[seen]
        half_turns = (turned[-1] - turned[0]) / math.pi
        return half_turns / np.ptp(self.kt[seen]) if half_turns >= 0.5 else math.nan

    def ended(self):
        return self.entry["stop"] in ENDED


def distance(a, b):
    """As solver/observe/distance.hpp."""
    _, i, j = np.intersect1d(np.round(a.kt, 6), np.round(b.kt, 6), return_indices=True)
    angle = np.abs(np.remainder(a.theta[i] - b.theta[j] + math.pi / 2, math.pi) - math.pi / 2)
    inclined = np.minimum(a.D_xy[i], b.D_xy[j]) >= CLEARLY_INCLINED
    return {"Q": np.abs(a.Q[i] - b.Q[j]).max(), "D_xy": np.abs(a.D_xy[i] - b.D_xy[j]).max(),
            "theta": angle[inclined].max() if inclined.any() else math.nan,
            "period": abs(a.frequency() / b.frequency() - 1)}


def read(path):
    """Ladders by (fluid, case): runs by rung, all to the same kt; and the runs with an error asked for, by the same keys. Of runs that were
    repeated the last counts."""
    ladders, asked = defaultdict(dict), defaultdict(dict)
    for line in open(path):
        entry = json.loads(line)
        if entry["stop"] != "no result":
            runs = asked if isinstance(entry["rung"], str) else ladders
            runs[entry["fluid"], entry["index"]][entry["rung"]] = Run(entry)
    for runs in ladders.values():
        end = min(run.entry["kt"] for run in runs.values())
        for rung in [rung for rung, run in runs.items() if run.entry["kt"] > end]:
            del runs[rung]
    return ladders, asked


def to_companion(run, companion):
    """The distance; a companion that ended early is taken to go on in proportion to time."""
    longer = run.kt[-1] / max(companion.kt[-1], 1e-3) if companion.kt[-1] < run.kt[-1] - 1e-6 else 1
    return {kind: longer * value for kind, value in distance(run, companion).items()}


# The reference, the finest run, is itself off by about a third of its distance to the run at twice its spacing.
REFERENCE_ERROR = 1 / 3


def companion(nodes):
    """Nodes of the run at twice the spacing."""
    return (nodes - 2) // 4 + 2


def errors_of(runs):
    """Errors of each run that is at most half as fine as the finest, by its nodes."""
    done = [nodes for nodes in sorted(runs) if runs[nodes].ended()]
    finest = max(done, default=0)
    if companion(finest) not in done:
        return {}
    last = distance(runs[companion(finest)], runs[finest])
    return {nodes: {kind: error + REFERENCE_ERROR * last[kind] for kind, error in distance(runs[nodes], runs[finest]).items()}
            for nodes in done if nodes <= companion(finest)}


def rows_of(ladders):
    """One row for each run that has a companion and an error."""
    rows = []
    for (fluid, index), runs in ladders.items():
        for nodes, error in errors_of(runs).items():
            if companion(nodes) in runs and runs[companion(nodes)].ended():
                rows.append({"fluid": fluid, "index": index, "rung": nodes, "finest": max(n for n in runs if runs[n].ended()),
                             "case": runs[nodes].entry["case"], "kt": runs[nodes].entry["kt"],
                             "d": to_companion(runs[nodes], runs[companion(nodes)]), "t": error, "runs": runs})
    return rows


# Factor and floor of Q, as in solver/observe/error_estimate.cpp.
COARSEST, COARSE, BOUNDARY_INTEGRALS, LATTICE = (1.3, 0.01), (0.65, 0.002), (0.65, 8e-4), (1, 1e-3)
COARSEST_DIMPLES = (1.3, 0.04)
LATTICE_THIN, COARSE_LATTICE_VISCOUS = (1.4, 1e-3), (6, 1e-3)
WRINKLES = (0.9, 2e-3), (1.5, 0.05), (1.5, 0.2)  # without bending stiffness, begins to wrinkle, folded
ROUGH_SPHERE = (0, 0.02)
WRINKLING, ROUGH = 40, 30  # degrees


def largest_dihedral(row):
    return row["runs"][row["rung"]].entry["surface"]["largest_dihedral"]


def is_folded(row):
    return row["runs"][row["rung"]].entry["surface"]["folded_from"] is not None


def kind_of_scene(row):
    return "folded" if is_folded(row) else "with bending" if row["case"].get("E_b", 0) > 0 else "E_b = 0"


def is_rough_on_both(row, other):
    """Whether the mesh of a membrane without bending stiffness is not smoother than that of the coarser run."""
    smoother = 0.8 if other == companion(row["rung"]) else 0.9
    coarser = row["runs"][other].entry["surface"]["largest_dihedral"]
    return largest_dihedral(row) > ROUGH and largest_dihedral(row) > smoother * coarser


def calibration_of_lattice(row):
    case = row["case"]
    if case["V"] < 0.2:
        return LATTICE_THIN
    return COARSE_LATTICE_VISCOUS if case["shape"] == "biconcave" and case["V"] > 6.5 and row["rung"] < 1442 else LATTICE


def calibration_of_rung(row):
    if row["fluid"] != "stokes":
        return calibration_of_lattice(row)
    if row["rung"] <= 162 and row["case"]["shape"] == "biconcave":
        return COARSEST_DIMPLES
    return COARSEST if row["rung"] <= 162 else COARSE if row["rung"] < 642 else BOUNDARY_INTEGRALS


def with_wrinkles(row, of_rung, wrinkles, other):
    """The largest of all factors and floors that apply to a run that is compared with the run at the rung `other`."""
    without_bending, begins_to_wrinkle, folded = wrinkles
    all_that_apply = [of_rung]
    if row["case"].get("E_b", 0) == 0:
        all_that_apply.append(without_bending)
        if largest_dihedral(row) > WRINKLING:
            all_that_apply.append(begins_to_wrinkle)
        if is_rough_on_both(row, other):
            all_that_apply.append(ROUGH_SPHERE if row["case"]["shape"] == "sphere" else folded)
    if is_folded(row):
        all_that_apply.append(folded)
    return [max(values) for values in zip(*all_that_apply)]


def calibration_of(row):
    return with_wrinkles(row, calibration_of_rung(row), WRINKLES, companion(row["rung"]))


def stated(row):
    factor, floor = calibration_of(row)
    half_turns = max(0.5, row["runs"][row["rung"]].entry["evidence"]["turns"])
    Q = min(max(floor, factor * row["d"]["Q"]), 2)
    return {"Q": Q, "D_xy": max(factor * row["d"]["D_xy"], 0.75 * Q),
            "theta": min(max(factor * row["d"]["theta"], 2 * Q), math.pi / 2),
            "period": max(factor * row["d"]["period"], 3 * Q / half_turns)}


# An estimate from the next coarser rung: factor over that of an error of order p, and floor, as in the same file.
NEXT_RUNG = {92: (2.3, 0.01, 0.04), 162: (1.15, 0.003, 0.02), 362: (1.15, 0.0015, 0.0015)}  # factor, floor, floor of red cells
NEXT_FINE = (1.15, 8e-4, 8e-4)
NEXT_WRINKLES = (1.5, 3e-3), (2.2, 3e-3), (2.2, 0.2)


def stated_from_next_rung(row):
    """Of Q, and nothing if the next coarser rung has no answer."""
    runs, nodes, on_lattice = row["runs"], row["rung"], row["fluid"] != "stokes"
    rungs = NODES[row["fluid"]]
    below = rungs[rungs.index(nodes) - 1]
    if below not in runs or not runs[below].ended():
        return None
    if on_lattice:
        factor, floor = with_wrinkles(row, calibration_of_lattice(row), WRINKLES, below)
    else:
        factor, usual_floor, of_red_cells = NEXT_RUNG.get(nodes, NEXT_FINE)
        of_rung = factor, of_red_cells if row["case"]["shape"] == "biconcave" else usual_floor
        factor, floor = with_wrinkles(row, of_rung, NEXT_WRINKLES, below)
    ratio = math.sqrt((nodes - 2) / (below - 2))
    order = 1 if on_lattice else 2
    return min(2, max(floor, factor * to_companion(runs[nodes], runs[below])["Q"] / (ratio**order - 1)))


def print_coverage_from_next_rung(ladders):
    print("## The same for the error of Q that is stated from the next coarser rung\n")
    lines = []
    # The error of the finest rung follows from the same distance as its estimate.
    rows = [{"fluid": fluid, "rung": nodes, "case": runs[nodes].entry["case"], "runs": runs, "true": error}
            for (fluid, _), runs in ladders.items() for nodes, error in true_errors(fluid, runs).items()
            if NODES[fluid][0] < nodes < max(runs)]
    for (fluid, rung), here in groups(rows, model_and_rung):
        pairs = [(of_row, row["true"]) for row in here if (of_row := stated_from_next_rung(row))]
        lines.append([fluid, str(rung), str(len(pairs)), f"{sum(of_row >= true for of_row, true in pairs)} of {len(pairs)}",
                      f"{sum(1.25 * of_row >= true for of_row, true in pairs)} of {len(pairs)}",
                      np.median([of_row / true for of_row, true in pairs])])
    table(["model", "rung", "cases", "Q", "Q within 1.25 times", "median of stated over true error"], lines)


def finite(rows, kind):
    return [r for r in rows if math.isfinite(r["d"][kind]) and math.isfinite(r["t"][kind])]


def factor_for(rows, kind, floor, share):
    """Smallest factor that covers this share of the rows."""
    needed = sorted(0 if r["t"][kind] <= floor else r["t"][kind] / max(r["d"][kind], 1e-12) for r in finite(rows, kind))
    return needed[min(len(needed) - 1, math.ceil(share * len(needed)) - 1)] if needed else math.nan


def margin(run):
    e = run.entry["evidence"]
    if run.entry["motion"] not in ("tumbling", "tank_treading"):
        return 0
    text = run.entry["explanation"]
    if text.startswith("The shape is steady"):
        return e["D_min"]
    settled = text.startswith("The last")
    seen = run.kt >= START - 1e-9
    required = 0 if settled else min(0.06, run.D_xy[seen].max() / 2)
    turns = min(e["turns"], 3) if settled else e["turns"]
    to_threshold = min(abs(e["r"] - 0.25), abs(e["r"] - 0.75))
    return min(e["D_min"] - required, e["D_min"] * math.sin(min(math.pi / 2, math.pi * turns * to_threshold)))


def quantiles(values):
    values = np.array([v for v in values if math.isfinite(v)])
    return [np.quantile(values, q) for q in (0.5, 0.9, 0.95, 0.97, 1)] if len(values) else [math.nan] * 5


def table(head, rows):
    print("| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    for row in rows:
        print("| " + " | ".join(cell if isinstance(cell, str) else f"{cell:.3g}" for cell in row) + " |")
    print()


def groups(rows, key):
    return [(name, [r for r in rows if key(r) == name]) for name in sorted({key(r) for r in rows})]


def model_and_rung(row):
    return row["fluid"], row["rung"]


def model_rung_and_kind(row):
    return *model_and_rung(row), kind_of_scene(row)


def print_ratios(rows):
    print("## True error of Q over the distance to the companion\n")
    table(["model", "rung", "scenes", "cases", "median", "90 %", "95 %", "97 %", "max", "factor for 95 %, with the floor", "97 %",
           "100 %"],
          [[fluid, str(rung), kind, str(len(here)), *quantiles(r["t"]["Q"] / max(r["d"]["Q"], 1e-12) for r in here),
            *(factor_for(here, "Q", calibration_of(here[0])[1], share) for share in (0.95, 0.97, 1))]
           for (fluid, rung, kind), here in groups(rows, model_rung_and_kind)])


def print_coverage(rows):
    print("## Share of the runs whose stated error is not smaller than the true one\n")
    lines = []
    for (fluid, rung), here in groups(rows, model_and_rung):
        line = [fluid, str(rung), str(len(here))]
        for kind in KINDS:
            known = finite(here, kind)
            line.append(f"{sum(stated(r)[kind] >= r['t'][kind] for r in known)} of {len(known)}")
        ratios = [stated(r)["Q"] / r["t"]["Q"] for r in here if r["t"]["Q"] > 0]
        lines.append([*line, np.median(ratios) if ratios else math.nan])
    table(["model", "rung", "cases", "Q", "D_xy", "theta", "period", "median of stated over true error of Q"], lines)


def print_usual_errors(rows):
    print("## Usual errors of Q\n")
    lines = []
    for (fluid, rung), here in groups(rows, model_and_rung):
        lines.append([fluid, str(rung), *quantiles(r["t"]["Q"] for r in here)[:3], *quantiles(stated(r)["Q"] for r in here)[:3]])
    table(["model", "rung", "true: median", "90 %", "95 %", "stated: median", "90 %", "95 %"], lines)


def print_labels(rows):
    print("## Labels\n")
    lines, exceptions = [], []
    for (fluid, rung), here in groups(rows, model_and_rung):
        label = {r["index"]: [r["runs"][k].entry["motion"] for k in (companion(rung), rung, r["finest"])] for r in here}
        turning = [r for r in here if label[r["index"]][1] in ("tumbling", "tank_treading")]
        confirmed = [r for r in turning if label[r["index"]][0] == label[r["index"]][1] and stated(r)["Q"] < margin(r["runs"][rung])]
        differs = [r for r in turning if label[r["index"]][1] != label[r["index"]][2]]
        wrong = [r for r in confirmed if r in differs]
        lines.append([fluid, str(rung), str(len(here)), str(len(turning)), str(len(differs)), str(len(confirmed)), str(len(wrong))])
        exceptions += [[fluid, str(r["index"]), str(rung), " / ".join(map(str, label[r["index"]])), f"{margin(r['runs'][rung]):.3f}",
                        stated(r)["Q"], "yes" if r in wrong else "no"] for r in differs]
    table(["model", "rung", "cases", "tumbling or tank-treading", "of these another label on the finest rung", "confirmed",
           "confirmed, another label on the finest rung"], lines)
    table(["model", "case", "rung", "label of companion / run / finest", "margin", "stated error", "confirmed"], exceptions)


def print_costs(ladders):
    print("## Processor time of the companion over that of the run\n")
    shares = defaultdict(list)
    for (fluid, _), runs in ladders.items():
        for rung in runs:
            if companion(rung) in runs and runs[rung].ended() and runs[companion(rung)].ended():
                shares[fluid, rung].append(runs[companion(rung)].entry["seconds"] / runs[rung].entry["seconds"])
    table(["model", "rung", "cases", "median", "90 %"],
          [[fluid, str(rung), str(len(s)), *quantiles(s)[:2]] for (fluid, rung), s in sorted(shares.items())])


TICK = 0.01  # seconds, of the clock of processor time
RUNGS = (42, 92, 162, 362, 642, 1442, 2562)


def true_errors(fluid, runs):
    """Of Q. The error of the two finest rungs of boundary integrals, against which errors_of compares the others, follows from their
    distance: it is inversely proportional to the nodes."""
    errors = {nodes: error["Q"] for nodes, error in errors_of(runs).items()}
    if fluid == "stokes" and 1442 in runs and 2562 in runs and runs[1442].ended() and runs[2562].ended():
        errors[1442] = distance(runs[1442], runs[2562])["Q"] / (1 - 1442 / 2562)
        errors[2562] = errors[1442] * 1442 / 2562
    return errors


def print_asked(ladders, asked):
    print("## An error that is asked for\n")
    lines = []
    for name in sorted({name for runs in asked.values() for name in runs}, key=lambda name: -float(name.split()[1])):
        error = float(name.split()[1])
        cases, met, honoured, covered, costs = 0, 0, 0, 0, []
        for key, of_case in asked.items():
            true = true_errors(key[0], ladders[key])
            if name not in of_case or len(true) < len(RUNGS):
                continue
            cases += 1
            stated = of_case[name].entry["error"]
            if not stated.get("met") or stated["nodes"] > max(RUNGS):
                continue
            met += 1
            honoured += true[stated["nodes"]] <= error
            covered += true[stated["nodes"]] <= stated["Q"]
            enough = [nodes for nodes in RUNGS if true[nodes] <= error] or [max(RUNGS)]
            costs.append(of_case[name].entry["seconds"] / min(max(TICK, ladders[key][nodes].entry["seconds"]) for nodes in enough))
        lines.append([error, str(cases), str(met), str(honoured), str(covered), *quantiles(costs)[:2]])
    table(["error asked for", "cases", "met by 2562 nodes", "honoured", "at most the stated error", "cost over that of the cheapest run with this error: median", "90 %"], lines)


def write_errors(rows, path):
    with open(path, "w") as out:
        for r in rows:
            print(json.dumps({"fluid": r["fluid"], "rung": r["rung"], "index": r["index"], "case": r["case"], "kt": r["kt"],
                              "distance": round(r["d"]["Q"], 7), "stated": round(stated(r)["Q"], 7), "true": round(r["t"]["Q"], 7)}),
                  file=out)


if __name__ == "__main__":
    ladders, asked = read(sys.argv[1])
    rows = rows_of(ladders)
    print("<!-- made by evaluate.py -->\n")
    print_coverage(rows)
    print_coverage_from_next_rung(ladders)
    for print_part in (print_ratios, print_usual_errors, print_labels):
        print_part(rows)
    print_asked(ladders, asked)
    print_costs(ladders)
    write_errors(rows, sys.argv[2])
