"""Ca at the boundary between tumbling and tank-treading, by bending model: bisection on the share of the shape in all half-turns."""
import math

from block import OURS, THEIRS, Block, figure, percent, plus_minus, reference
from blocks.red_cells import red_cell
from solve import BELOW, CORES, run

TUMBLES, TREADS = 0.03, 0.6
STEPS = 9  # to 0.001


def turns_over(bending, c0, V, Ca, fidelity):
    """None if the run fails."""
    c0 = float(c0) if c0 == "0" else c0
    cell = run(red_cell(Ca, V, fidelity, bending=bending, c0=c0))
    evidence = cell.result["evidence"]
    return None if cell.failed else evidence["n_theta"] > evidence["n_psi"]


def critical_Ca(bending, c0, V, fidelity):
    """NaN if a run fails."""
    tumbles, treads = TUMBLES, TREADS
    for _ in range(STEPS):
        middle = (tumbles + treads) / 2
        turns = turns_over(bending, c0, V, middle, fidelity)
        if turns is None:
            return math.nan
        if turns:
            tumbles = middle
        else:
            treads = middle
    return (tumbles + treads) / 2


def block():
    rows = []
    fig, axes = figure(width=4.6, height=3)
    ax = axes[0][0]
    points = reference("critical_Ca")
    arguments = [(p["bending"], p["c0"], float(p["V"])) for p in points]
    ours = list(CORES.map(lambda a: critical_Ca(*a, "fast"), arguments))
    coarse = list(CORES.map(lambda a: critical_Ca(*a, BELOW["stokes"]["fast"]), arguments))
    for p, Ca, below in zip(points, ours, coarse):
        rows.append([p["bending"], p["c0"], p["V"], f"{Ca:.3f}", plus_minus(abs(Ca - below), 3), p["Ca"], percent(Ca, float(p["Ca"]))])
    names = [f"{p['bending']}, c0 {p['c0']}, V = {p['V']}" for p in points]
    places = range(len(points))
    ax.errorbar(ours, places, xerr=[0 if math.isnan(b) else abs(a - b) for a, b in zip(ours, coarse)], fmt="o", color=OURS, capsize=2, label="stokes fast")
    ax.plot([float(p["Ca"]) for p in points], places, "x", color=THEIRS, label="the other code")
    ax.set(yticks=list(places), yticklabels=names, xlabel="critical Ca", xlim=(0, 0.5))
    ax.invert_yaxis()
    ax.legend(fontsize=7)
    return Block("bending_models", "The bending model decides where the boundary lies",
                 ["bending", "c0", "V", "critical Ca", "±", "reference", "difference"], rows, fig)  # fmt: skip
