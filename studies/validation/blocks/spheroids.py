"""Oblate spheroids without bending stiffness."""
from blocks.series import series_block


def case(aspect, Ca, V):
    return {"shape": "oblate", "aspect": float(aspect), "law": "neo-hookean", "Ca": float(Ca), "V": float(V), "fluid": "stokes",
            "fidelity": "standard", "until": {"kt": 10}}  # fmt: skip


def block():
    return series_block("spheroids", "Oblate spheroids, V = 1", "oblate", case, lambda aspect, Ca, V: f"b/a = {aspect}, Ca = {Ca}")
