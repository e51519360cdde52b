#!/bin/sh
# Measures the trade of speed against accuracy, then makes tables and figures: runs.csv, results.md, *.svg.
# Takes about a quarter of an hour on two cores. Needs python3 with numpy and matplotlib.
#   sh studies/tradeoff/run.sh [PROGRAM]
set -eu
capstan=$(realpath "${1:-build/release/capstan}")
cd "$(dirname "$0")"
export OMP_NUM_THREADS=1

"$capstan" tradeoff sphere_V1 sphere_V5 sphere_V0.2 small_Ca oblate stiff_bending > runs.csv &
"$capstan" tradeoff red_cell_0.25_4 red_cell_0.4_2 red_cell_0.4_4 > red_cells.csv
wait
tail -n +2 red_cells.csv >> runs.csv
rm red_cells.csv

/usr/bin/python3 tabulate.py runs.csv > results.md
/usr/bin/python3 plot.py runs.csv
