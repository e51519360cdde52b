"""Runs every case of cases.py within three times the time that the program estimates for it, and writes results.csv and map.svg.

OMP_NUM_THREADS=1 python3 studies/extremes/extremes.py [CAPSTAN]   about an hour of one core; runs that have been made are kept in
                                                                   build/extremes
"""
import concurrent.futures
import csv
import functools
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from cases import all_cases
from figure import draw_map

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
CAPSTAN = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/capstan").resolve()
RUNS = ROOT / "build/extremes"

PARAMETERS = ["part", "fluid", "shape", "aspect", "law", "C", "Ca", "V", "Re", "E_b", "kt"]
OUTCOME = ["ending", "exit_code", "stop", "kt_reached", "motion", "margin", "D_xy", "stated_error", "volume_drift", "largest_dihedral", "smallest_angle", "folded_from",
           "lost_from", "estimate", "seconds", "finer_D_xy", "finer_difference", "warnings", "message"]  # fmt: skip
WRONG = 0.05  # difference of D_xy to the finer run, at any time, that should not go unmentioned
AFFORDABLE = 0.5  # seconds; cases that take longer are not repeated at the rung above, where they cost about ten times as much
LONG = 40  # seconds; cases that are estimated to take longer are left out
SHORT = 2  # seconds; of shorter runs the cost is not estimated: the estimate itself takes two seconds


def solver_case(case, fidelity):
    """With `companion`, the run at the rung below, the program states the error of D_xy."""
    return {**{key: value for key, value in case.items() if key != "part"}, "fidelity": fidelity, "outputs": {"history_every": 0.1, "shapes_every": 0}}


def estimate(case):
    """Seconds, or None where the case is refused."""
    axes = {"Ca": [case["Ca"]]}
    study = {"name": "one", "base": {key: value for key, value in case.items() if key != "Ca"}, "axes": axes}
    done = subprocess.run([CAPSTAN, "estimate", "--json", "--cores", "1", "-"], input=json.dumps(study), capture_output=True, text=True)
    return json.loads(done.stdout)["core_seconds"] if done.returncode == 0 else None


def solve(case, directory):
    """Exit code, standard error, seconds of processor time, and the estimate of a run that took longer than SHORT. The exit code is None if
    the run was left out, or stopped after three times its estimate and 20 s of processor time."""
    limit, expected = SHORT, None
    shutil.rmtree(directory, ignore_errors=True)  # what a run left that was stopped with this script
    directory.mkdir(parents=True)
    (directory / "asked.json").write_text(json.dumps(case))
    with open(directory / "stderr", "w") as stderr:
        process = subprocess.Popen([CAPSTAN, "solve", directory / "asked.json", "--out", directory], stdout=subprocess.DEVNULL, stderr=stderr)
        killed = False
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            ticks = [int(x) for x in pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()[11:13]]
            used = sum(ticks) / os.sysconf("SC_CLK_TCK")
            if used > limit and expected is None:
                expected = estimate(case) or 0
                limit = 0 if expected > LONG else 20 + 3 * expected
            if used > limit and not killed:
                os.kill(process.pid, signal.SIGKILL)  # send_signal would take the exit status of a process that has just ended
                killed = True
            time.sleep(0.05)
        process.returncode = os.waitstatus_to_exitcode(status)
    return None if killed else process.returncode, (directory / "stderr").read_text(), usage.ru_utime + usage.ru_stime, expected


def history(directory):
    file = directory / "history.jsonl"
    return [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []


def largest_difference(a, b):
    """Of D_xy over the common records."""
    other = {round(record["kt"], 6): record["D_xy"] for record in b}
    pairs = [(record["D_xy"], other.get(round(record["kt"], 6))) for record in a]
    return max((abs(x - y) for x, y in pairs if x is not None and y is not None), default=None)


def outcome_of(case, directory):
    code, stderr, seconds, expected = solve(case, directory)
    record = {"exit_code": "killed" if code is None else code, "estimate": expected, "seconds": round(seconds, 2), "message": ""}
    records = history(directory)
    record["kt_reached"] = records[-1]["kt"] if records else 0
    file = directory / "result.json"
    if not file.exists():
        record["message"] = "" if code is None else " ".join(stderr.split("asked.json: ")[1:])[-400:]
        return record
    result = json.loads(file.read_text())
    error = result.get("error", {})
    warnings = result["trust"]["warnings"] + ([error["unknown"]] if "unknown" in error else [])
    trust, surface = result["trust"], result["trust"]["surface"]
    record.update({key: surface[key] for key in ("largest_dihedral", "smallest_angle", "folded_from", "lost_from")})
    record.update(stop=result["stop"], message=result["message"], motion=result["motion"], margin=result["evidence"]["margin"],
                  D_xy=result.get("final", {}).get("D_xy"), stated_error=error.get("D_xy"), volume_drift=trust["volume_drift"], warnings=" | ".join(warnings))  # fmt: skip
    return record


def compare_with_finer(case, directory, record):
    """The same case at the rung above."""
    record["finer_D_xy"] = record["finer_difference"] = None
    if record["exit_code"] != 0 or record["seconds"] > AFFORDABLE:
        return
    finer = directory / "finer"
    code, *_ = solve({**case, "fidelity": "standard"}, finer)
    if code == 0:
        record["finer_difference"] = largest_difference(history(directory), history(finer))
        record["finer_D_xy"] = json.loads((finer / "result.json").read_text())["final"]["D_xy"]


def ending_of(record):
    """One word for how the case ended."""
    code = record["exit_code"]
    if code == "killed":
        return "left out: long" if record["estimate"] > LONG else "no end in time"
    if code not in (0, 2, 3):
        return "crashed"
    if code == 2:
        return "refused"
    if code == 3:
        return "stopped"
    difference = record.get("finer_difference") or 0
    if difference > WRONG and not record["warnings"] and difference > (record["stated_error"] or 0):
        return "wrong, not flagged"
    return "flagged" if record["warnings"] else "done"


@functools.cache
def numerics():
    return subprocess.run([CAPSTAN, "--version"], capture_output=True, text=True).stdout.split("\n")[1]


def run(case, with_finer):
    asked = solver_case(case, "fast")
    directory = RUNS / hashlib.sha256((numerics() + json.dumps(asked, sort_keys=True)).encode()).hexdigest()[:16]
    file = directory / "record.json"
    record = json.loads(file.read_text()) if file.exists() else outcome_of(asked, directory)
    if with_finer and "finer_D_xy" not in record:
        compare_with_finer(asked, directory, record)
    file.write_text(json.dumps(record))
    return {**case, "kt": case["until"]["kt"], **record, "ending": ending_of(record)}


def shown(value):
    return f"{value:.4g}" if isinstance(value, float) else value


def write_table(rows):
    with open(FOLDER / "results.csv", "w", newline="") as file:
        table = csv.DictWriter(file, PARAMETERS + OUTCOME, extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        table.writerows({key: shown(value) for key, value in row.items()} for row in rows)


def main():
    cases = all_cases()
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as cores:
        for with_finer in (False, True):
            rows = []
            for row in cores.map(lambda case: run(case, with_finer), cases):
                rows.append(row)
                print(len(rows), "of", len(cases), *(row.get(key, "") for key in ("part", "fluid", "shape", "Ca", "V", "ending", "seconds")), flush=True)
            write_table(rows)
            draw_map(rows, FOLDER / "map.svg")


if __name__ == "__main__":
    main()
