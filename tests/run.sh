#!/bin/sh
# Builds everything with warnings as errors and runs the unit, physics and system tests. Installs what is missing.
# More physics, slower: ctest --preset test -L slow
set -eu
cd "$(dirname "$0")/.."
sh runner/install_packages.sh
cmake --preset test
cmake --build --preset test
ctest --preset test -LE slow -j "$(nproc)" "$@"
