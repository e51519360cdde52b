"""Of the CSV of `capstan results`: the parameters that vary, and what came of the cases. The CSVs of several studies
may follow each other."""
import csv
import sys

RESULTS = ["state", "motion", "final.kt", "final.D_xy", "final.theta", "evidence.margin", "confirmed", "error.Q",
           "error.D_xy", "error.theta", "cost.steps", "cost.flow_iterations"]  # fmt: skip


def read(lines):
    """The rows, each with the names of its own header, which begins with `id`."""
    rows, header = [], None
    for cells in csv.reader(lines):
        if cells[0] == "id":
            header = cells
        else:
            rows.append(dict(zip(header, cells)))
    return rows


def parameters(rows):
    """The columns of the cases that differ between rows."""
    columns = list(rows[0])
    of_cases = columns[columns.index("shape") : columns.index("outputs.history_every")]
    return [column for column in of_cases if len({row[column] for row in rows}) > 1]


rows = read(sys.stdin)
columns = parameters(rows) + RESULTS
writer = csv.writer(sys.stdout, lineterminator="\n")
writer.writerow([column.removeprefix("final.") for column in columns])
for row in rows:
    writer.writerow([row.get(column, "") for column in columns])
