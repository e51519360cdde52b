#!/bin/sh
# Builds the unit tests with clang, warnings as errors, and runs them under the address and undefined-behaviour
# sanitizers. The first finding of a sanitizer ends the test program that met it.
#   sh tests/sanitize.sh [ARGUMENT OF CTEST ...]
set -eu
cd "$(dirname "$0")/.."
sh runner/install_packages.sh clang libclang-rt-14-dev libomp-14-dev
cmake --preset sanitize
cmake --build --preset sanitize
# Two tests are left out, because they take minutes with the sanitizers. Other tests call the same functions.
long="SingleLayer.IsPositiveOnStretchedElements|Simulation.OfAStiffMembraneShortensAStepWhoseFlowIsNotFinite"
ctest --preset sanitize -j "$(nproc)" -E "$long" "$@"
