"""A block of the report: a table and a figure."""
import csv
import dataclasses
import math
import pathlib

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as pyplot  # noqa: E402

FOLDER = pathlib.Path(__file__).resolve().parent

pyplot.rcParams.update({
    "svg.hashsalt": "capstan", "svg.fonttype": "none", "font.size": 8, "axes.spines.top": False, "axes.spines.right": False,
    "legend.frameon": False, "lines.markersize": 4, "lines.linewidth": 1.1, "figure.constrained_layout.use": True,
})  # fmt: skip
OURS, LATTICE, COARSE, THEIRS = "#1f5fa8", "#c8641e", "#9ab6d6", "black"


@dataclasses.dataclass
class Block:
    name: str  # of the figure's file
    title: str
    columns: list
    rows: list
    figure: object = None
    note: str = ""

    def markdown(self):
        lines = [f"## {self.title}", "", f"![{self.title}]({self.name}.svg)", ""]
        lines += ["| " + " | ".join(self.columns) + " |", "|" + "---|" * len(self.columns)]
        lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in self.rows]
        return "\n".join(lines + (["", self.note] if self.note else []) + [""])

    def save(self):
        # Without a date the file changes only where its content does.
        self.figure.savefig(FOLDER / f"{self.name}.svg", metadata={"Date": None})
        pyplot.close(self.figure)


def figure(columns=1, width=3.4, height=2.6, **options):
    return pyplot.subplots(1, columns, figsize=(width * columns, height), squeeze=False, **options)


def reference(name):
    """Rows of a file of reference/ as dictionaries; lines that start with # are comments."""
    lines = (FOLDER / "reference" / f"{name}.csv").read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def plus_minus(error, digits=4):
    return "the rung below fails" if math.isnan(error) else f"{error:.{digits}f}"


def percent(ours, theirs):
    return f"{100 * (ours / theirs - 1):+.2f} %"
