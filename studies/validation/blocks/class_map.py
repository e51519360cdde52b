"""Kind of motion of red cells over Ca, at V = 1 and 4."""
from block import Block, figure, reference
from blocks.red_cells import red_cell
from solve import with_companions

COLOR = {"tumbling": "#1f5fa8", "transition": "#b0b0b0", "tank_treading": "#c8641e", "undecided": "white"}


def block():
    points = reference("class_map")
    pairs = with_companions([red_cell(float(p["Ca"]), float(p["V"]), "fast") for p in points])
    rows = []
    fig, axes = figure(width=5, height=2)
    ax = axes[0][0]
    seen = set()
    for p, (run, below) in zip(points, pairs):
        ours, coarse, evidence = run.result["motion"], below.result["motion"], run.result["evidence"]
        rows.append([p["V"], p["Ca"], ours, coarse, f"{evidence['margin']:.2f}", f"{evidence['D_min']:.3f}", p["motion"],
                     "yes" if ours == p["motion"] else "**no**"])  # fmt: skip
        x, y = float(p["Ca"]), 1 + (p["V"] == "4")
        for label, dy, motion in (("", 0.1, ours), ("", -0.1, p["motion"])):
            ax.plot(x, y + dy, "s" if dy > 0 else "o", color=COLOR[motion], ms=6, label=None if motion in seen else motion.replace("_", "-"))
            seen.add(motion)
    ax.set(xlabel="Ca", yticks=[1, 2], yticklabels=["V = 1", "V = 4"], ylim=(0.6, 3), title="squares: Capstan; circles: the other code")
    ax.legend(ncol=3, loc="upper center", fontsize=7)
    agree = sum(row[-1] == "yes" for row in rows)
    return Block("class_map", "Kind of motion", ["V", "Ca", "stokes fast", "at the rung below", "margin", "D_min", "reference", "the same"], rows, fig,
                 f"{agree} of {len(rows)} labels are those of the reference.")  # fmt: skip
