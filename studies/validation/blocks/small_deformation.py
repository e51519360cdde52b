"""A sphere that hardly deforms: D = 25/4 Ca (neo-Hookean, E_s = 3 G), whatever V; its membrane circulates at k/2."""
import numpy as np

from block import COARSE, LATTICE, OURS, Block, figure
from solve import error, with_companions

CA = [0.003125, 0.00625, 0.0125, 0.025]


def case(Ca, V, fluid, fidelity):
    # a little bending keeps the membrane from wrinkling
    return {"shape": "sphere", "law": "neo-hookean", "Ca": Ca, "V": V, "fluid": fluid, "fidelity": fidelity, "until": {"kt": 4},
            "E_b": 1e-4}  # fmt: skip


def tank_treading(run):
    """Rate at which the membrane's points turn, from kt = 3 on."""
    late = run.history["kt"] >= 2.999
    turned = run.history["theta"] + run.history["psi"]
    return -np.polyfit(run.history["kt"][late], turned[late], 1)[0]


def block():
    rows = []
    fig, axes = figure(width=4.2)
    ax = axes[0][0]
    for V, fluid, fidelity, style in [(1, "stokes", "standard", dict(color=OURS, marker="o")),
                                      (5, "stokes", "standard", dict(color=COARSE, marker="s")),
                                      (1, "quasisteady", "standard", dict(color=LATTICE, marker="o", mfc="none"))]:  # fmt: skip
        pairs = with_companions([case(Ca, V, fluid, fidelity) for Ca in CA])
        limit = [25 / 4 * Ca for Ca in CA]
        D = [run.at(4) for run, _ in pairs]
        errors = [error(*pair, "D_xy") for pair in pairs]
        ax.errorbar(CA, np.divide(D, limit), np.divide(errors, limit), capsize=2, label=f"{fluid} {fidelity}, V = {V}", **style)
        for Ca, exact, d, e, (run, _) in zip(CA, limit, D, errors, pairs):
            rows.append([fluid, fidelity, V, Ca, f"{d:.5f}", f"{e:.5f}", f"{exact:.5f}", f"{100 * (d / exact - 1):+.1f} %",
                         f"{tank_treading(run):.4f}"])  # fmt: skip
    ax.axhline(1, color="black", lw=0.7)
    ax.set(xscale="log", xlabel="Ca", ylabel="D / (25/4 Ca)")
    ax.legend()
    return Block("small_deformation", "Small deformation: D = 25/4 Ca",
                 ["fluid", "fidelity", "V", "Ca", "D", "±", "25/4 Ca", "difference", "membrane's angular velocity / k"], rows, fig,
                 "The difference must vanish with Ca, but for what mesh and bending stiffness leave, and the angular velocity must become 1/2.")  # fmt: skip
