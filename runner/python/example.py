"""Submits three red cells, waits, and prints how they move, how far they deform and how they are stretched.

    capstan serve &
    python3 runner/python/example.py
"""

import numpy as np

import capstan

study = capstan.submit({
    "name": "example",
    "base": {"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "V": 4,
             "fluid": "stokes", "until": {"kt": 30}, "fidelity": "fast"},
    "axes": {"Ca": [0.25, 0.4, 0.75]},
}).wait()

histories = study.histories()
for row, point in enumerate(study.points()):
    shapes = study.case(point["point"]).shapes()
    deformation = np.asarray(histories["D_xy"])[row]
    print(f"Ca = {point['asked']['Ca']}: {point['motion']}, "
          f"D_xy from {np.nanmin(deformation):.3f} to {np.nanmax(deformation):.3f}, "
          f"largest stretch {shapes['stretches'].max():.3f}")
