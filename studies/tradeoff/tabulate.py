#!/usr/bin/python3
"""Tables of `capstan tradeoff` in Markdown.

    studies/tradeoff/tabulate.py runs.csv > results.md
"""
import math
import statistics
import sys

from plot import LABELS, read


def shown(value, digits=2):
    if value is None:
        return "–"
    return f"{value:.{digits}g}" if value else "0"


def table(head, rows):
    print("| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def scenes_of(rows):
    return list(dict.fromkeys(r["scene"] for r in rows))


def print_rungs(rows):
    print("## Rungs\n\nSeconds of processor time; largest error of Q, of D_xy and of θ/π. The finest rung is the reference.\n")
    for fluid, label in LABELS.items():
        rungs = [r for r in rows if r["fluid"] == fluid and r["knob"] == "rung"]
        settings = sorted({r["setting"] for r in rungs}, key=lambda s: int(s.split("nodes ")[1].split(",")[0]))
        print(f"### {label.capitalize()}\n")
        lines = []
        for scene in scenes_of(rungs):
            cells = {r["setting"]: r for r in rungs if r["scene"] == scene}
            lines.append([scene] + [cell(cells.get(s)) for s in settings])
        table(["scene"] + [s.split(", tolerance")[0] for s in settings], lines)


def cell(row):
    if row is None:
        return "not run"
    if row["stop"] != "reached_end":
        return row["stop"]
    if row["error_Q"] is None:
        return f"{shown(row['seconds'])} s (reference), {row['memory_mb']:.0f} MB"
    theta = row["error_theta"] / math.pi if row["error_theta"] is not None else None
    return (f"{shown(row['seconds'])} s: {shown(row['error_Q'])} / {shown(row['error_D'])} / {shown(theta)}, "
            f"{row['memory_mb']:.0f} MB")


def print_knobs(rows):
    print("## What each setting buys\n\nOne setting changed from rung 2. Times and errors relative to rung 2 of the same scene: "
          "median and range over the scenes.\n")
    for fluid, label in LABELS.items():
        here = [r for r in rows if r["fluid"] == fluid]
        rung_2 = {r["scene"]: r for r in here if r["knob"] == "rung" and "nodes 642" in r["setting"]}
        base = parts(next(iter(rung_2.values()))["setting"])
        settings = list(dict.fromkeys((r["knob"], r["setting"]) for r in here if r["knob"] not in ("rung", "model")))
        lines = []
        for knob, setting in settings:
            runs = [r for r in here if r["setting"] == setting and r["knob"] == knob]
            done = [r for r in runs if r["stop"] == "reached_end" and rung_2[r["scene"]]["error_Q"]]
            times = [r["seconds"] / rung_2[r["scene"]]["seconds"] for r in done]
            errors = [r["error_Q"] / rung_2[r["scene"]]["error_Q"] for r in done]
            changed = ", ".join(p for p in parts(setting) if p not in base)
            lines.append([changed, spread(times), spread(errors), f"{len(done)} of {len(runs)}"])
        print(f"### {label.capitalize()}\n")
        table(["changed", "time", "error of Q", "reached the end"], lines)


def parts(setting):
    return setting.split(", ")


def spread(values):
    return f"{shown(statistics.median(values))} ({shown(min(values))}–{shown(max(values))})" if values else "–"


def print_models(rows):
    lines = [[r["scene"], r["setting"], r["reference"], shown(r["error_Q"]), shown(r["error_D"]),
              shown(r["error_theta"] / math.pi if r["error_theta"] is not None else None)] for r in rows if r["knob"] == "model"]
    if lines:
        print("## The two models\n\nDistance of their references: walls and what is left of both errors.\n")
        table(["scene", "lattice", "boundary integrals", "Q", "D_xy", "θ/π"], lines)


def print_omissions(rows):
    lines = [[r["scene"], LABELS[r["fluid"]], r["setting"], r["stop"], r["message"]] for r in rows if r["stop"] != "reached_end"]
    print("## Omissions\n\nRuns that did not reach their end, and settings that a case cannot have.\n")
    table(["scene", "model", "setting", "stop", "reason"], lines)


if __name__ == "__main__":
    rows = read(sys.argv[1])
    print("<!-- made by tabulate.py -->\n")
    print_rungs(rows)
    print_knobs(rows)
    print_models(rows)
    print_omissions(rows)
