"""Two red cells: one tumbles, one swings."""
from blocks.series import series_block


def case(_, Ca, V):
    return red_cell(float(Ca), float(V), "standard")


def red_cell(Ca, V, fidelity, **more):
    return {"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "Ca": Ca, "V": V, "fluid": "stokes", "fidelity": fidelity,
            "until": {"kt": 30}, **more}  # fmt: skip


def block():
    return series_block("red_cells", "Red cells, V = 4", "biconcave", case, lambda _, Ca, V: f"Ca = {Ca}")
