"""Time histories beside those of another boundary integral code (reference/boundary_integrals.csv)."""
import math

from block import OURS, THEIRS, Block, figure, reference
from solve import error, with_companions


def series_of(shape):
    """{(aspect, Ca, V): [(kt, D_xy, theta/pi)]}"""
    series = {}
    for row in reference("boundary_integrals"):
        if row["shape"] == shape:
            key = tuple(row[k] for k in ("aspect", "Ca", "V"))
            series.setdefault(key, []).append(tuple(float(row[k]) for k in ("kt", "D_xy", "theta")))
    return series


def series_block(name, title, shape, case, label):
    """
    case:  (aspect, Ca, V) -> case
    label: the same -> words for table and figure
    """
    series = series_of(shape)
    rows = []
    fig, axes = figure(2, width=3.6)
    D_ax, theta_ax = axes[0]
    pairs = with_companions([case(*key) for key in series])
    for line, mark, (key, values), (run, below) in zip(["-", "--"], "os", series.items(), pairs):
        kt = [value[0] for value in values]
        D_ax.plot(run.history["kt"], run.history["D_xy"], line, color=OURS, label=label(*key))
        D_ax.plot(kt, [value[1] for value in values], mark, color=THEIRS, mfc="none")
        theta_ax.plot(run.history["kt"], run.history["theta"] / math.pi, line, color=OURS)
        theta_ax.plot(kt, [value[2] for value in values], mark, color=THEIRS, mfc="none")
        D_error, theta_error = error(run, below, "D_xy"), error(run, below, "theta") / math.pi
        for t, D, theta in values:
            ours, ours_theta = run.at(t), run.at(t, "theta") / math.pi
            rows.append([label(*key), f"{t:g}", f"{ours:.4f}{run.mark}", f"{D_error:.4f}", f"{D:.3f}", f"{ours - D:+.4f}", f"{ours_theta:.4f}",
                         f"{theta_error:.4f}", f"{theta:.3f}", f"{ours_theta - theta:+.4f}"])  # fmt: skip
    D_ax.set(xlabel="kt", ylabel="D_xy")
    theta_ax.set(xlabel="kt", ylabel="θ/π")
    D_ax.legend(fontsize=7)
    return Block(name, title, ["case", "kt", "D_xy", "±", "reference", "difference", "θ/π", "±", "reference", "difference"], rows, fig,
                 "† The run warns that its membrane wrinkles." if any(run.mark for run, _ in pairs) else "")
