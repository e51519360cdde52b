"""Where each flow model reaches its end, in the plane of (Ca, V)."""
import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as pyplot  # noqa: E402

pyplot.rcParams.update({"svg.hashsalt": "capstan", "svg.fonttype": "none", "font.size": 8, "legend.frameon": False})

STYLE = {  # ending: color, marker
    "done": ("#2f8f4e", "o"), "flagged": ("#d9a21b", "s"), "stopped": ("#c0392b", "X"), "refused": ("#777777", "D"),
    "left out: long": ("#9ab6d6", "d"), "wrong, not flagged": ("black", "*"), "no end in time": ("#7b3fa0", "P"), "crashed": ("#7b3fa0", "v"),
}  # fmt: skip
SHAPES = {"sphere": "spheres", "oblate": "oblate", "prolate": "prolate", "biconcave": "red cells"}


def draw_map(rows, file):
    fig, axes = pyplot.subplots(2, 4, figsize=(10, 5), sharex=True, sharey=True)
    for row_of_axes, lattice in zip(axes, (False, True)):
        for ax, (shape, title) in zip(row_of_axes, SHAPES.items()):
            ax.set(xscale="log", yscale="log", title=f"{title}, {'lattice' if lattice else 'stokes'}")
            for row in rows:
                if row["shape"] == shape and (row["fluid"] != "stokes") == lattice:
                    color, marker = STYLE[row["ending"]]
                    ax.plot(row["Ca"], row["V"], marker, color=color, ms=4.5, alpha=0.75, mew=0)
    for ax in axes[1]:
        ax.set_xlabel("Ca")
    for ax in axes[:, 0]:
        ax.set_ylabel("V")
    handles = [pyplot.Line2D([], [], ls="none", marker=marker, color=color, label=ending) for ending, (color, marker) in STYLE.items()]
    fig.legend(handles=handles, loc="lower center", ncol=len(STYLE))
    fig.subplots_adjust(left=0.06, right=0.99, top=0.94, bottom=0.16)
    fig.savefig(file, metadata={"Date": None})
    pyplot.close(fig)
