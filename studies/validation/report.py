"""Writes results.md and the figures of this folder: sh studies/validation/run.sh"""
import pathlib
import sys

import solve
from block import FOLDER
from blocks import (bending_benchmark, bending_models, class_map, drop, jeffery, published_spheres, red_cell_angles, red_cells,
                    small_deformation, spheres, spheroids)  # fmt: skip

BLOCKS = [small_deformation, jeffery, drop, spheres, published_spheres, bending_benchmark, spheroids, red_cells, class_map,
          bending_models, red_cell_angles]  # fmt: skip

HEAD = """# Results of `sh studies/validation/run.sh`

Version of the {numerics}. [README.md](README.md) says what each block is and where its reference comes from. `±` is the error of our own number:
the one that the program states, or the largest difference over the run to the rung below (a quarter of the nodes, twice the spacing).
`standard` is 2562 nodes (lattice: dx = 0.1), `fast` 642 (0.2).
"""

if __name__ == "__main__":
    solve.capstan = pathlib.Path(sys.argv[1]).resolve()
    parts = [HEAD.format(numerics=solve.numerics())]
    for block in (module.block() for module in BLOCKS):
        block.save()
        parts.append(block.markdown())
        print(block.markdown(), flush=True)
    (FOLDER / "results.md").write_text("\n".join(parts))
