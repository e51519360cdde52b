"""A sphere with bending stiffness, of which six groups have published D_xy(t)."""
from block import LATTICE, OURS, THEIRS, Block, figure, percent, reference
from solve import error, with_companions

MODELS = [("stokes", "standard", "variational", OURS, "-"), ("quasisteady", "standard", "variational", LATTICE, "-"),
          ("stokes", "standard", "helfrich_literal", OURS, ":")]  # fmt: skip


def case(fluid, fidelity, bending):
    return {"shape": "sphere", "law": "neo-hookean", "Ca": 0.05, "E_b": 0.0375, "c0": 0, "bending": bending, "fluid": fluid,
            "fidelity": fidelity, "until": {"kt": 4}}  # fmt: skip


def value_at_2(points):
    """The curve of Pozrikidis 2001 ends at kt = 1.83, and no longer changes there."""
    return float(next((p for p in points if p["kt"] == "2"), points[-1])["D_xy"])


def block():
    published = {}
    for row in reference("published_bending"):
        published.setdefault(row["paper"], []).append(row)
    fig, axes = figure(width=5, height=3)
    ax = axes[0][0]
    pairs = with_companions([case(*model[:3]) for model in MODELS])
    ours = pairs[0][0].at(2)
    rows = []
    for (fluid, fidelity, bending, color, line), (run, below) in zip(MODELS, pairs):
        label = f"Capstan, {fluid} {fidelity}, {bending}"
        ax.plot(run.history["kt"], run.history["D_xy"], line, color=color, label=label)
        rows.append([label, f"{run.at(2):.4f}", f"{error(run, below, 'D_xy'):.4f}", percent(run.at(2), ours)])
    for marker, (paper, points) in zip("^s<xDo", published.items()):
        ax.plot([float(p["kt"]) for p in points], [float(p["D_xy"]) for p in points], marker, color=THEIRS, mfc="none", label=paper)
        rows.append([paper, f"{value_at_2(points):.4f}", "not stated", percent(value_at_2(points), ours)])
    ax.set(xlabel="kt", ylabel="D_xy", ylim=(0.09, 0.195), xlim=(0, 4))
    ax.legend(fontsize=6, ncol=2, loc="upper right")
    return Block("bending_benchmark", "Six papers on one sphere with bending stiffness", ["source", "D_xy at kt = 2", "±", "against the first row"],
                 rows, fig)  # fmt: skip
