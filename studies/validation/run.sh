#!/bin/sh
# Computes the validation report: results.md and the figures of this folder. About ten minutes on two cores; a second
# call computes only what is missing. Needs the release build.
#   cmake --preset release && cmake --build --preset release
#   sh studies/validation/run.sh
set -eu
cd "$(dirname "$0")/../.."
packages="python3-numpy python3-matplotlib python3-h5py"
python3=/usr/bin/python3
$python3 -c "import numpy, matplotlib, h5py" 2>/dev/null ||
  $(if [ "$(id -u)" = 0 ]; then echo; else echo sudo; fi) apt-get install -y $packages
OMP_NUM_THREADS=1 exec $python3 -B studies/validation/report.py "${CAPSTAN:-build/release/capstan}"
