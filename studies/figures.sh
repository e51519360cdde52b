#!/bin/sh
# Computes every figure and table of the paper again and replaces result.csv and the pictures of their folders. It
# starts a daemon of its own in a temporary directory. Needs the release build, gnuplot and python3.
#   sh studies/figures.sh [PROGRAM [FOLDER...]]      such as: sh studies/figures.sh build/release/capstan fig06 fig14
# About ten minutes on two quiet cores; fig02, fig05b, fig10 and fig17 take most of it.
set -eu
capstan=$(realpath "${1:-build/release/capstan}")
[ $# -eq 0 ] || shift
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'kill "$daemon" 2>/dev/null; wait; rm -rf "$scratch"' EXIT
export OMP_NUM_THREADS=1 CAPSTAN_SERVER=http://127.0.0.1:18018
"$capstan" serve --data "$scratch/data" --listen 127.0.0.1:18018 >"$scratch/daemon.log" 2>&1 &
daemon=$!
until "$capstan" studies >/dev/null 2>&1; do sleep 0.2; done

# compute STUDY.json: prints the study's id when all of its cases have ended.
compute() {
  "$capstan" submit "$1" --watch 2>>"$scratch/progress.log"
}

# result FOLDER ID...: FOLDER/result.csv
result() {
  folder=$1 && shift
  for id in "$@"; do "$capstan" results "$id" --format csv; done | python3 -B main_columns.py >"$folder/result.csv"
}

# picture FILE.svg ARGUMENTS...: what capstan figure draws, without its script.
picture() {
  file=$1 && shift
  "$capstan" figure "$@" -o "$file" && rm -f "$file.gp"
}

# draw FOLDER NAME ARGUMENTS...: computes FOLDER/study.json and draws FOLDER/NAME.svg.
draw() {
  folder=$1 file=$2 && shift 2
  id=$(compute "$folder/study.json")
  result "$folder" "$id"
  picture "$folder/$file.svg" "$id" "$@"
}

# histories FOLDER [ARGUMENTS...]: the curves of FOLDER/study.json.
histories() {
  folder=$1 && shift
  draw "$folder" "$folder" --of history "$@"
}

# benchmark FOLDER NAME: the last table of capstan bench NAME as FOLDER/result.csv.
benchmark() {
  "$capstan" bench "$2" --json 2>/dev/null | python3 -B last_table.py >"$1/result.csv"
}

published() {
  printf '%s\n' "--published validation/reference/$1.csv"
}

fig02() {
  benchmark fig02 cavity
  gnuplot fig02/plot.gp
}
fig05a() { histories fig05a; }
fig05b() {
  steps=$(compute fig05b/study.json)
  transient=$(compute fig05b/transient.json)
  result fig05b "$steps" "$transient"
  picture fig05b/fig05b.svg "$steps" "$transient" --of history
}
# shellcheck disable=SC2046
fig06() { histories fig06 $(published published_spheres) $(published spherical_harmonics); }
fig07a() { draw fig07a fig07a --of profile; }
fig07b() { draw fig07b fig07b --of trajectory; }
# shellcheck disable=SC2046
fig08() { histories fig08 $(published published_bending); }
# shellcheck disable=SC2046
fig09() { histories fig09 $(published spherical_harmonics); }
fig10() {
  ours=$(compute fig10/study.json)
  papers=$(compute fig10/paper_scheme.json)
  transient=$(compute fig10/transient.json)
  result fig10 "$ours" "$papers" "$transient"
  picture fig10/fig10a.svg "$ours" "$papers" "$transient" --of history --at Re=0.05
  picture fig10/fig10b.svg "$ours" "$papers" "$transient" --of history --at Re=0.1
  picture fig10/fig10c.svg "$ours" "$papers" "$transient" --of history --at Re=0.25
}
# shellcheck disable=SC2046
fig11() { histories fig11 $(published boundary_integrals); }
# shellcheck disable=SC2046
fig12() { histories fig12 $(published boundary_integrals); }
fig13() {
  draw fig13 fig13a --of trajectory --at aspect=0.9
  draw fig13 fig13b --of trajectory --at aspect=0.5
}
fig14() { draw fig14 fig14 --of profile --kt 5,8,11,15,18,21; }
fig15() { draw fig15 fig15 --of profile --kt 4,10,16,22,28,30; }
# shellcheck disable=SC2046
fig16a() { histories fig16a $(published boundary_integrals); }
fig16b() { histories fig16b; }
fig17() {
  id=$(compute fig17/study.json)
  result fig17 "$id"
  # shellcheck disable=SC2046
  picture fig17/phase_diagram.svg "$id" $(published boundary_of_fig17)
  picture fig17/path_of_Q_V4.svg "$id" --of path --at V=4
}
fig18() {
  benchmark fig18 fig18
  gnuplot fig18/plot.gp
}
table1() { benchmark table1 table1; }
# shellcheck disable=SC2046
boundary() {
  id=$(compute boundary/study.json)
  "$capstan" boundary "$id" --format csv >boundary/boundary.csv
  picture boundary/boundary.svg "$id" $(published boundary_of_fig17)
}

[ $# -gt 0 ] || set -- fig02 fig05a fig05b fig06 fig07a fig07b fig08 fig09 fig10 fig11 fig12 fig13 fig14 fig15 \
  fig16a fig16b fig17 boundary fig18 table1
for folder in "$@"; do
  "$folder"
  echo "studies/$folder"
done
