"""A spheroid that hardly deforms turns by pi in kt = pi (r + 1/r), r = b/a (Jeffery 1922)."""
import math

import numpy as np

from block import LATTICE, OURS, Block, figure
from solve import with_companions

ASPECTS = [0.3, 0.5, 0.7, 1.5, 2, 3]


def exact(aspect):
    return math.pi * (aspect + 1 / aspect)


def case(aspect, fluid, fidelity):
    return {"shape": "oblate" if aspect < 1 else "prolate", "aspect": aspect, "law": "neo-hookean", "Ca": 0.002, "E_b": 0.005,
            "fluid": fluid, "fidelity": fidelity, "until": {"kt": 1.08 * exact(aspect)}}  # fmt: skip


def half_period(run):
    theta, kt = run.history["theta"], run.history["kt"]
    return float(np.interp(-(theta[0] - math.pi), -theta, kt))


def block():
    rows = []
    fig, axes = figure(width=4.2)
    ax = axes[0][0]
    for fluid, fidelity, style in [("stokes", "fast", dict(color=OURS, marker="o")),
                                   ("quasisteady", "fast", dict(color=LATTICE, marker="s"))]:  # fmt: skip
        pairs = with_companions([case(aspect, fluid, fidelity) for aspect in ASPECTS])
        T = [half_period(run) for run, _ in pairs]
        errors = [abs(half_period(run) - half_period(below)) for run, below in pairs]
        theory = [exact(aspect) for aspect in ASPECTS]
        ax.errorbar(ASPECTS, np.divide(T, theory), np.divide(errors, theory), capsize=2, label=f"{fluid} {fidelity}", ls="none", **style)
        rows += [[fluid, fidelity, a, f"{t:.3f}", f"{e:.3f}", f"{x:.3f}", f"{100 * (t / x - 1):+.2f} %"]
                 for a, t, e, x in zip(ASPECTS, T, errors, theory)]  # fmt: skip
    ax.axhline(1, color="black", lw=0.7)
    ax.set(xlabel="b/a", ylabel="half period / Jeffery's")
    ax.legend()
    return Block("jeffery", "Jeffery's period", ["fluid", "fidelity", "b/a", "kt of a half-turn", "±", "π (r + 1/r)", "difference"],
                 rows, fig)  # fmt: skip
