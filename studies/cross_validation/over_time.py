#!/usr/bin/python3
"""Compares the lattice with boundary integrals (2562 nodes) over kt = 0.5 to 10, without inertia and walls far away (box 51.2).

    studies/cross_validation/over_time.py [CAPSTAN] > over_time.md      ten minutes on two cores

The first group of capsules was used in the search for the profile of the viscosity (../flat_membrane), the second was not, and the third is
random. Per case: root mean square of the difference of D_xy relative to D_xy and of theta/pi, and the largest distance of Q.
"""
import cmath
import concurrent.futures
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

CAPSTAN = sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2] / "build/release/capstan"
LATTICES = ((0.2, 642), (0.1, 2562))
SKALAK = {"law": "skalak", "C": 1, "E_b": 0.01}


def red_cell(Ca, V):
    return {"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "Ca": Ca, "V": V}


def capsule(shape, aspect, Ca, V, **keys):
    return {"shape": shape, **({} if aspect == 1 else {"aspect": aspect}), "Ca": Ca, "V": V, **keys}


SEARCHED = [red_cell(Ca, V) for Ca, V in ((0.25, 4), (0.4, 4), (0.4, 10), (0.1, 7))] + [
    capsule("sphere", 1, 0.1, 5),
    capsule("sphere", 1, 0.3, 10),
    capsule("sphere", 1, 0.3, 5, law="skalak", C=1),
    capsule("oblate", 0.5, 0.2, 5, **SKALAK),
    capsule("oblate", 0.5, 0.3, 12, **SKALAK),
    capsule("prolate", 1.5, 0.3, 5, **SKALAK),
    capsule("oblate", 0.7, 0.1, 3, E_b=0.01),
]
OTHERS = [red_cell(Ca, V) for Ca, V in ((0.4, 2), (0.75, 4), (0.4, 5), (0.25, 0.2), (0.25, 1))] + [
    capsule("sphere", 1, 0.05, 0.2),
    capsule("sphere", 1, 0.1, 0.5),
    capsule("sphere", 1, 0.1, 2),
    capsule("oblate", 0.5, 0.2, 1),
    capsule("oblate", 0.6, 0.5, 0.3, law="skalak", C=2, E_b=0.01),
    capsule("prolate", 2, 0.2, 3),
]


def random_cases(count):
    generator = random.Random(77)
    cases = []
    for _ in range(count):
        V, Ca = round(10 ** generator.uniform(-0.7, 0.7), 2), round(10 ** generator.uniform(-1.7, -0.05), 3)
        shape, law = generator.choice(["sphere", "oblate", "prolate", "biconcave"]), generator.choice(["neo-hookean", "skalak"])
        case = {"shape": shape, "Ca": Ca, "V": V, "E_b": generator.choice([0.005, 0.01, 0.02])}
        if shape == "oblate":
            case["aspect"] = round(generator.uniform(0.4, 0.9), 2)
        if shape == "prolate":
            case["aspect"] = round(generator.uniform(1.2, 1.8), 2)
        if shape == "biconcave" or law == "skalak":
            case.update(law="skalak", C=generator.choice([1, 2, 5]))
        else:
            case["Ca"] = min(Ca, 0.4)
        cases.append(case)
    return cases


def history(case, **keys):
    """The records from kt = 0.5 on; None if the run did not reach its end."""
    with tempfile.TemporaryDirectory() as directory:
        file, out = Path(directory, "case.json"), Path(directory, "run")
        outputs = {"history_every": 0.1, "shapes_every": 0}
        file.write_text(json.dumps({**case, "companion": False, "until": {"kt": 10}, "outputs": outputs, **keys}))
        environment = {**os.environ, "OMP_NUM_THREADS": "1"}
        if subprocess.run([CAPSTAN, "solve", file, "--out", out], capture_output=True, env=environment).returncode != 0:
            return None
        return [r for r in map(json.loads, (out / "history.jsonl").read_text().splitlines()) if r["kt"] > 0.45]


def Q(record):
    return cmath.rect(record["D_xy"], 2 * record["theta"])


def difference(records, reference):
    if not records or not reference:
        return "no answer | |"
    pairs = list(zip(records, reference))
    D = math.sqrt(sum((a["D_xy"] - b["D_xy"]) ** 2 for a, b in pairs) / sum(b["D_xy"] ** 2 for _, b in pairs))
    turns = [((a["theta"] - b["theta"]) / math.pi + 0.5) % 1 - 0.5 for a, b in pairs]
    theta = math.sqrt(sum(t * t for t in turns) / len(turns))
    return f"{100 * D:.2f} % | {theta:.4f} | {max(abs(Q(a) - Q(b)) for a, b in pairs):.4f}"


def row(case):
    reference = history(case, fluid="stokes", fidelity={"nodes": 2562})
    cells = [difference(history(case, fluid="quasisteady", fidelity={"dx": dx, "nodes": nodes, "box": 51.2}), reference) for dx, nodes in LATTICES]
    return f"| {', '.join(f'{key} {value}' for key, value in case.items())} | " + " | ".join(cells) + " |"


def main():
    print("<!-- made by over_time.py -->")
    for title, cases in (("In the search", SEARCHED), ("Not in the search", OTHERS), ("Random", random_cases(16))):
        print(f"\n**{title}**\n\n| capsule | dx = 0.2: D_xy | θ/π | Q | dx = 0.1: D_xy | θ/π | Q |\n" + "|---" * 7 + "|")
        with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as cores:
            for line in cores.map(row, cases):
                print(line, flush=True)


if __name__ == "__main__":
    main()
