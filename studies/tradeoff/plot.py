#!/usr/bin/python3
"""Work-precision diagrams of `capstan tradeoff`, and stated against true errors of studies/calibration.

    studies/tradeoff/plot.py runs.csv
"""
import csv
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = Path(__file__).parent
COLOURS = {"stokes": "tab:blue", "quasisteady": "tab:orange"}
LABELS = {"stokes": "boundary integrals", "quasisteady": "lattice"}
PRESETS = {"642": "fast", "2562": "standard", "10242": "fine"}
plt.rcParams.update({"svg.fonttype": "none", "font.size": 8, "axes.spines.top": False, "axes.spines.right": False})


def read(path):
    rows = list(csv.DictReader(open(path)))
    for row in rows:
        for key in ("seconds", "memory_mb", "error_Q", "error_D", "error_theta"):
            row[key] = float(row[key]) if row[key] else None
    return rows


def nodes(row):
    return row["setting"].split("nodes ")[1].split(",")[0]


def pareto(points):
    """Those that no other one beats in both time and error."""
    hull = []
    for seconds, error in sorted(points):
        if not hull or error < hull[-1][1]:
            hull.append((seconds, error))
    return hull


def draw(axes, scene, rows):
    measured = [r for r in rows if r["seconds"] and r["error_Q"]]
    hull = pareto([(r["seconds"], r["error_Q"]) for r in measured])
    axes.plot(*zip(*hull), color="0.8", linewidth=4, zorder=0, solid_capstyle="round")
    for fluid, colour in COLOURS.items():
        knobs = [r for r in measured if r["fluid"] == fluid and r["knob"] not in ("rung", "model")]
        axes.plot([r["seconds"] for r in knobs], [r["error_Q"] for r in knobs], ".", color=colour, markersize=3, alpha=0.6)
        rungs = sorted((r for r in measured if r["fluid"] == fluid and r["knob"] == "rung"), key=lambda r: int(nodes(r)))
        axes.plot([r["seconds"] for r in rungs], [r["error_Q"] for r in rungs], "o-", color=colour, markersize=4,
                  label=LABELS[fluid])
        for rung in rungs:
            axes.annotate(PRESETS.get(nodes(rung), ""), (rung["seconds"], rung["error_Q"]), xytext=(4, 3),
                          textcoords="offset points", fontsize=7, color=colour)
    axes.set(xscale="log", yscale="log", title=scene.replace("_", " "))


def work_precision(rows):
    scenes = list(dict.fromkeys(r["scene"] for r in rows))
    figure, all_axes = plt.subplots(3, 3, figsize=(9, 8), constrained_layout=True)
    for axes, scene in zip(all_axes.flat, scenes):
        draw(axes, scene, [r for r in rows if r["scene"] == scene])
    for axes in all_axes.flat[len(scenes):]:
        axes.set_visible(False)
    for axes in all_axes[-1]:
        axes.set_xlabel("processor time, s")
    for axes in all_axes[:, 0]:
        axes.set_ylabel("error of Q")
    all_axes[0, 0].legend(frameon=False)
    figure.savefig(HERE / "work_precision.svg")


def red_cell(rows):
    """One scene alone, for the README of the project."""
    scene = "red_cell_0.25_4"
    figure, axes = plt.subplots(figsize=(4.2, 3.2), constrained_layout=True)
    draw(axes, scene, [r for r in rows if r["scene"] == scene])
    axes.set(xlabel="processor time, s", ylabel="error of Q", title="red cell, Ca = 0.25, V = 4, to kt = 15")
    axes.legend(frameon=False)
    figure.savefig(HERE / "red_cell.svg")


def calibration(path):
    """\\param path  lines {"fluid", "rung", "stated", "true"} of calibration/evaluate.py"""
    rows = [json.loads(line) for line in open(path)]
    figure, all_axes = plt.subplots(1, 2, figsize=(7, 3.5), constrained_layout=True, sharex=True, sharey=True)
    for axes, fluid in zip(all_axes, COLOURS):
        for rung, marker in ((162, "^"), (362, "v"), (642, "o"), (1442, "D"), (2562, "s")):
            points = [r for r in rows if r["fluid"] == fluid and r["rung"] == rung]
            if points:
                axes.plot([r["stated"] for r in points], [r["true"] for r in points], marker, markersize=2.5, alpha=0.6,
                          label=f"{rung} nodes")
        axes.plot([1e-4, 1], [1e-4, 1], color="0.6", linewidth=0.8)
        axes.set(xscale="log", yscale="log", xlim=(1e-4, 2), ylim=(1e-6, 2), title=LABELS[fluid], xlabel="stated error of Q")
        axes.legend(frameon=False)
    all_axes[0].set_ylabel("true error of Q")
    figure.savefig(HERE / "calibration.svg")


if __name__ == "__main__":
    measured = read(sys.argv[1])
    work_precision(measured)
    red_cell(measured)
    stated_and_true = HERE.parent / "calibration" / "errors.jsonl"
    if stated_and_true.exists():
        calibration(stated_and_true)
