"""Neo-Hookean and Skalak spheres against the spherical-harmonic solution."""
import math

from block import LATTICE, OURS, THEIRS, Block, figure, percent, reference
from solve import error, with_companions

MODELS = [("stokes", "standard", OURS), ("quasisteady", "fast", LATTICE), ("quasisteady", "standard", "#7a3d10")]
END = 10  # kt at which the shape is steady


def key_of(row):
    return tuple(row[key] for key in ("law", "C", "Ca", "V"))


def case(key, fluid, fidelity):
    law, C, Ca, V = key
    return {"shape": "sphere", "law": law, "Ca": float(Ca), "V": float(V), **({"C": float(C)} if C else {}), "fluid": fluid,
            "fidelity": fidelity, "until": {"kt": END}}  # fmt: skip


def name(key):
    law, C, Ca, V = key
    return f"{law}{f' C = {C}' if C else ''}, Ca = {Ca}, V = {V}"


def block():
    table = {}
    for row in reference("spherical_harmonics"):
        kt = END if row["kt"] == "steady" else float(row["kt"])
        table.setdefault(key_of(row), []).append((kt, float(row["D_xy"]), float(row["theta"])))
    rows, covered = [], []
    fig, axes = figure(2, width=3.6)
    ax, error_ax = axes[0]
    for fluid, fidelity, color in MODELS:
        pairs = with_companions([case(key, fluid, fidelity) for key in table])
        for (key, values), (run, below) in zip(table.items(), pairs):
            ax.plot(run.history["kt"], run.history["D_xy"], color=color, label=f"{fluid} {fidelity}" if key == next(iter(table)) else None)
            error_ax.plot([kt for kt, _, _ in values], [100 * (run.at(kt) / D - 1) for kt, D, _ in values], color=color, lw=0.8, marker=".")
            for kt, D, theta in values:
                if fluid == "stokes":
                    covered.append(abs(run.at(kt) - D) <= error(run, below, "D_xy"))
                if kt not in (1, 2, 4, END):
                    continue
                rows.append([name(key), fluid, fidelity, "steady" if kt == END else f"{kt:g}", f"{run.at(kt):.4f}{run.mark}",
                             f"{error(run, below, 'D_xy'):.4f}", f"{D:.5f}", percent(run.at(kt), D),
                             f"{run.at(kt, 'theta') / math.pi:.4f}", f"{error(run, below, 'theta') / math.pi:.4f}", f"{theta:.4f}"])  # fmt: skip
    for values in table.values():
        ax.plot([kt for kt, _, _ in values], [D for _, D, _ in values], "o", color=THEIRS, mfc="none", ms=3.5)
    ax.set(xlabel="kt", ylabel="D_xy", title="circles: spherical harmonics")
    error_ax.axhline(0, color="black", lw=0.7)
    error_ax.set(xlabel="kt", ylabel="difference of D_xy, %", title="one line a sphere")
    ax.legend(loc="lower right", fontsize=7)
    rows.sort(key=lambda row: row[0])
    return Block("spheres", "Spheres against spherical harmonics",
                 ["sphere", "fluid", "fidelity", "kt", "D_xy", "±", "reference", "difference", "θ/π", "±", "reference"], rows, fig,
                 "`steady` is kt = 10 of our run. † The run warns that its membrane wrinkles. The lattice has walls at 12.8 a, the "
                 f"reference has none. With boundary integrals {sum(covered)} of {len(covered)} differences of D_xy are within ±.")  # fmt: skip
