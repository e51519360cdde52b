"""Runs of capstan. A run is kept in build/validation and computed once for each case and version of the numerics."""
import concurrent.futures
import dataclasses
import functools
import hashlib
import json
import math
import os
import pathlib
import subprocess

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS = ROOT / "build/validation"
CORES = concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0)))

# The rung of the ladder below that of a preset: a quarter of the nodes, twice the spacing of the lattice.
BELOW = {
    "stokes": {"fast": {"nodes": 162}, "standard": "fast", "fine": "standard"},
    "quasisteady": {"fast": {"dx": 0.4, "nodes": 162}, "standard": "fast", "fine": "standard"},
}

DIVERGED = 3  # exit code

capstan = ROOT / "build/release/capstan"  # report.py may name another


@functools.cache
def numerics():
    return subprocess.run([capstan, "--version"], check=True, capture_output=True, text=True).stdout.split("\n")[1]


@dataclasses.dataclass(frozen=True)
class Run:
    case: dict
    directory: pathlib.Path
    result: dict
    history: dict  # key of history.jsonl -> array

    def at(self, kt, key="D_xy"):
        """At a recorded kt."""
        record = int(np.argmin(abs(self.history["kt"] - kt)))
        assert abs(self.history["kt"][record] - kt) < 1e-6, f"no record at kt = {kt}"
        return float(self.history[key][record])

    @property
    def failed(self):
        return self.result["motion"] is None

    @property
    def mark(self):
        """A dagger if the run warns."""
        return " †" if self.result["trust"]["warnings"] else ""


def run(case):
    case = {**case, "outputs": {"history_every": 0.1, "shapes_every": 0, **case.get("outputs", {})}}
    text = json.dumps(case, sort_keys=True)
    directory = RUNS / hashlib.sha256((numerics() + text).encode()).hexdigest()[:16]
    if not (directory / "result.json").exists():
        RUNS.mkdir(parents=True, exist_ok=True)
        done = subprocess.run([capstan, "solve", "-", "--out", directory], input=text.encode(), capture_output=True)
        if done.returncode not in (0, DIVERGED):
            raise RuntimeError(f"{text}: {done.stderr.decode()}")
    records = [json.loads(line) for line in (directory / "history.jsonl").read_text().splitlines()]
    columns = {key: np.array([math.nan if r[key] is None else r[key] for r in records]) for key in records[0]}
    return Run(case, directory, json.loads((directory / "result.json").read_text()), columns)


def companion(case):
    """The same case at the rung below."""
    return run({**case, "fidelity": BELOW[case["fluid"]][case["fidelity"]]})


def with_companions(cases):
    """[(run, companion)] of all cases, on two cores. The companion is also there where the program states the error:
    labels and figures show it."""
    runs = list(CORES.map(run, cases))
    return list(zip(runs, CORES.map(companion, cases)))


def error(run, companion, key):
    """Of D_xy or theta (radians) over the whole run: what the program states of itself, else the largest difference to
    the rung below. NaN if that fails."""
    stated = run.result.get("error", {}).get(key)
    if stated is not None:
        return stated
    if companion.failed:
        return math.nan
    difference = abs(run.history[key] - companion.history[key])
    return float(difference[run.history["kt"] >= 0.5].max())
