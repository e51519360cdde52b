"""Inclination of tank-treading red cells beside measurements of single cells."""
import math

import numpy as np

from block import OURS, THEIRS, Block, figure, plus_minus, reference
from blocks.red_cells import red_cell
from solve import error, with_companions

# Assumed, not measured on these cells: radius of the sphere of equal volume, shear modulus, viscosity of the haemoglobin solution.
RADIUS = 2.8e-6  # m
MODULUS = 2 * 4e-6  # N/m; E_s = 2 G
INSIDE = 6e-3  # Pa s


def case(row):
    outside, rate = float(row["viscosity"]) * 1e-3, float(row["shear_rate"])
    return red_cell(round(outside * rate * RADIUS / MODULUS, 4), round(INSIDE / outside, 4), "standard")


def swing(run):
    """Mean, lowest and highest inclination in degrees over the second half of the run."""
    theta = np.degrees(run.history["theta"][run.history["kt"] >= 15])
    return theta.mean(), theta.min(), theta.max()


def block():
    measured = reference("red_cells")
    rows = []
    fig, axes = figure(width=4.2)
    ax = axes[0][0]
    for place, (row, (run, below)) in enumerate(zip(measured, with_companions([case(row) for row in measured]))):
        mean, low, high = swing(run)
        rows.append([row["viscosity"], row["shear_rate"], run.case["Ca"], run.case["V"], f"{mean:.1f}", plus_minus(math.degrees(error(run, below, "theta")), 1),
                     f"{low:.1f} to {high:.1f}", f"{float(row['lowest']):.1f} to {float(row['highest']):.1f}", row["cells"]])  # fmt: skip
        ax.plot([place - 0.1] * 2, [low, high], color=OURS, lw=3, label="Capstan, swing" if place == 0 else None)
        ax.plot([place + 0.1] * 2, [float(row["lowest"]), float(row["highest"])], color=THEIRS, lw=3, label="measured cells" if place == 0 else None)
    ax.set(xticks=range(len(measured)), xticklabels=[f"{row['viscosity']} mPa s\n{float(row['shear_rate']):.0f}/s" for row in measured],
           ylabel="inclination, degrees")  # fmt: skip
    ax.legend()
    return Block("red_cell_angles", "Inclination of tank-treading red cells",
                 ["outer viscosity, mPa s", "shear rate, 1/s", "Ca", "V", "θ, degrees", "±", "swing", "measured", "cells"], rows, fig)  # fmt: skip
