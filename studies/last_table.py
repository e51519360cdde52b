"""The last table of `capstan bench NAME --json` as CSV."""
import csv
import json
import sys

rows = json.load(sys.stdin)["tables"][-1]["rows"]
writer = csv.DictWriter(sys.stdout, rows[0].keys(), lineterminator="\n")
writer.writeheader()
writer.writerows(rows)
