"""The first moment of a run: the membrane has no tension, so the capsule is a spherical drop without surface tension. The strain rate
of its surface is 5/(2 V + 3) of that of the undisturbed flow (Taylor 1932)."""
import h5py
import numpy as np

from block import LATTICE, OURS, Block, figure
from solve import with_companions

V = [0.01, 0.1, 0.2, 0.5, 2, 5, 10, 20, 50, 100]


def case(V, fluid, fidelity):
    return {"shape": "sphere", "law": "neo-hookean", "Ca": 0.1, "V": V, "fluid": fluid, "fidelity": fidelity, "until": {"kt": 1e-3},
            "outputs": {"shapes_every": 1e-3, "history_every": 1e-3}}  # fmt: skip


def strain_rate(run):
    """xy component of the symmetric part of the velocity gradient that fits the vertices best, over 1/2."""
    with h5py.File(run.directory / "shapes/0000.h5") as frame:
        positions, velocities = frame["positions"][:], frame["velocities"][:]
    gradient = np.linalg.lstsq(positions, velocities, rcond=None)[0]
    return float(gradient[0, 1] + gradient[1, 0])


def block():
    rows = []
    fig, axes = figure(width=4.2)
    ax = axes[0][0]
    for fluid, fidelity, style in [("stokes", "fast", dict(color=OURS, marker="o")),
                                   ("quasisteady", "standard", dict(color=LATTICE, marker="s"))]:  # fmt: skip
        Vs = V if fluid == "stokes" else [v for v in V if v >= 0.1]  # below, the lattice refuses to start
        pairs = with_companions([case(v, fluid, fidelity) for v in Vs])
        theory = [5 / (2 * v + 3) for v in Vs]
        rates = [strain_rate(run) for run, _ in pairs]
        errors = [abs(strain_rate(run) - strain_rate(below)) for run, below in pairs]
        ax.errorbar(Vs, np.divide(rates, theory), np.divide(errors, theory), capsize=2, label=f"{fluid} {fidelity}", ls="none", **style)
        rows += [[fluid, fidelity, v, f"{r:.4f}", f"{e:.4f}", f"{x:.4f}", f"{100 * (r / x - 1):+.2f} %"]
                 for v, r, e, x in zip(Vs, rates, errors, theory)]  # fmt: skip
    ax.axhline(1, color="black", lw=0.7)
    ax.set(xscale="log", xlabel="V", ylabel="strain rate (2V + 3) / 5")
    ax.legend()
    return Block("drop", "Drop without tension", ["fluid", "fidelity", "V", "strain rate", "±", "5/(2V + 3)", "difference"], rows, fig)
