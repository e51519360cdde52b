"""Neo-Hookean spheres beside published curves."""
from block import OURS, THEIRS, Block, figure, percent, reference
from blocks.spheres import END, case
from solve import error, with_companions

MARKERS = {"Pozrikidis 1995": "^", "Ramanujan & Pozrikidis 1998": "s", "Doddi & Bagchi 2008": "x"}


def block():
    published = reference("published_spheres")
    exact = {(row["Ca"], row["kt"]): float(row["D_xy"]) for row in reference("spherical_harmonics")
             if (row["law"], row["V"]) == ("neo-hookean", "1")}  # fmt: skip
    Cas = list(dict.fromkeys(row["Ca"] for row in published))
    rows = []
    fig, axes = figure(width=5, height=3)
    ax = axes[0][0]
    for Ca, (run, below) in zip(Cas, with_companions([case(("neo-hookean", "", Ca, "1"), "stokes", "standard") for Ca in Cas])):
        ax.plot(run.history["kt"], run.history["D_xy"], color=OURS, label="stokes standard" if Ca == Cas[0] else None)
        for paper, marker in MARKERS.items():
            points = [row for row in published if (row["paper"], row["Ca"]) == (paper, Ca)]
            ax.plot([END if p["kt"] == "steady" else float(p["kt"]) for p in points], [float(p["D_xy"]) for p in points], marker, color=THEIRS,
                    mfc="none", label=paper if Ca == "0.05" else None)  # fmt: skip
            for p in points:
                ours = run.at(END if p["kt"] == "steady" else float(p["kt"]))
                rows.append([Ca, p["kt"], paper, p["D_xy"], f"{ours:.4f}{run.mark}", f"{error(run, below, 'D_xy'):.4f}",
                             exact.get((Ca, p["kt"]), ""), percent(float(p["D_xy"]), ours)])  # fmt: skip
    ax.set(xlabel="kt", ylabel="D_xy")
    ax.legend(loc="lower right", fontsize=7)
    rows.sort(key=lambda row: (float(row[0]), 99 if row[1] == "steady" else float(row[1])))
    return Block("published_spheres", "Spheres beside published curves",
                 ["Ca", "kt", "paper", "theirs", "stokes standard", "±", "spherical harmonics", "theirs over ours"], rows, fig,
                 "† The run warns that its membrane wrinkles.")  # fmt: skip
