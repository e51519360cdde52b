#!/bin/sh
# Builds everything with warnings as errors and runs the unit, physics and system tests. Installs what is missing.
# More physics, slower: ctest --preset test -L slow
#
# slurmctld, slurmd, slurm-client, munge: a Slurm of the tests' own on this machine. chromium: the page in a browser,
# skipped if node with npm is missing. python3-numpy: the client for Python.
set -eu
cd "$(dirname "$0")/.."
sh runner/install_packages.sh slurmctld slurmd slurm-client munge procps chromium python3-numpy
cmake --preset test
cmake --build --preset test
ctest --preset test -LE slow -j "$(($(nproc) + 2))" "$@"  # two more than cores, as many tests wait
