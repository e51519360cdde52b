"""The cases of the study: corners and edges of the ranges of all parameters, long runs, and random points (fixed seed)."""
import itertools
import math
import random

CA, V = [0.001, 0.03, 0.3, 4], [0.01, 0.1, 1, 10, 100]
SPHERE = {"shape": "sphere", "law": "neo-hookean"}
CELL = {"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015}


def duration(Ca):
    """Stiff membranes relax in kt of about Ca, and a unit of kt costs most."""
    return 10 if Ca >= 0.01 else 3


def of(base, part, **more):
    case = {**base, "part": part, **more}
    return {**case, "until": {"kt": duration(case["Ca"])}}


def plane_of_Ca_and_V():
    return [of(base, "plane", Ca=Ca, V=v) for base in (SPHERE, CELL) for Ca in CA for v in V]


def bending():
    values = [(base, E_b, Ca) for base in (SPHERE, CELL) for E_b in (0, 1e-4, 0.1, 1) for Ca in (0.05, 1)]
    return [of(base, "bending", E_b=E_b, Ca=Ca, V=2) for base, E_b, Ca in values]


def dilation():
    return [of(CELL, "dilation", C=C, Ca=Ca, V=V) for C in (0, 1000) for Ca in (0.01, 0.3, 4) for V in (1, 10)]


def aspects():
    shapes = [("oblate", 0.1), ("oblate", 0.4), ("prolate", 2.5), ("prolate", 5)]
    return [of({"shape": shape, "aspect": aspect, "law": "neo-hookean"}, "aspect", E_b=E_b, Ca=Ca, V=V)
            for (shape, aspect), (E_b, Ca, V) in itertools.product(shapes, [(0, 0.05, 1), (0, 0.5, 1), (0.01, 0.05, 10), (0.01, 0.5, 1), (0.01, 2, 0.1)])]  # fmt: skip


def inertia():
    return [of(base, "inertia", Ca=Ca, V=2, Re=Re) for base in (SPHERE, CELL) for Ca in (0.05, 0.5) for Re in (1e-4, 0.01, 1, 10)]


def long_runs():
    bases = [of(SPHERE, "long", Ca=0.1, V=1), of(SPHERE, "long", Ca=0.3, V=5), of(CELL, "long", Ca=0.25, V=4), of(CELL, "long", Ca=0.4, V=2),
             of(CELL, "long", Ca=0.75, V=4),
             of({"shape": "oblate", "aspect": 0.5, "law": "neo-hookean"}, "long", Ca=0.2, V=1, E_b=0.01)]  # fmt: skip
    return [{**case, "until": {"kt": 200}} for case in bases]


def log_between(generator, low, high):
    return float(f"{math.exp(generator.uniform(math.log(low), math.log(high))):.3g}")


def random_case(generator):
    shape = generator.choice(["sphere", "oblate", "prolate", "biconcave"])
    case = {"shape": shape, "law": generator.choice(["neo-hookean", "skalak"])}
    if shape == "oblate":
        case["aspect"] = log_between(generator, 0.1, 1)
    if shape == "prolate":
        case["aspect"] = log_between(generator, 1, 5)
    if case["law"] == "skalak":
        case["C"] = generator.choice([0, log_between(generator, 0.1, 1000)])
    case["E_b"] = generator.choice([0, log_between(generator, 1e-4, 1), log_between(generator, 1e-4, 1)])
    case["Ca"], case["V"] = log_between(generator, 0.001, 4), log_between(generator, 0.01, 100)
    case["Re"] = log_between(generator, 1e-4, 10)
    return of(case, "random")


def with_fluid(case, fluid):
    """Boundary integrals have no inertia; the lattice follows it by the fluid unsteady from Re = 0.1 on."""
    case = {**case, "fluid": fluid}
    Re = case.pop("Re", None)
    if fluid != "stokes" and Re is not None:
        case.update(Re=Re, fluid="unsteady" if Re >= 0.1 else "quasisteady")
    return case


def all_cases():
    designed = plane_of_Ca_and_V() + aspects() + bending() + dilation() + long_runs()
    both = [with_fluid(case, fluid) for case in designed for fluid in ("stokes", "quasisteady")]
    generator = random.Random(2024)
    drawn = [with_fluid(random_case(generator), fluid) for _ in range(50) for fluid in ("stokes", "quasisteady")]
    return drawn + [with_fluid(case, "quasisteady") for case in inertia()] + both
