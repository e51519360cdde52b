#!/bin/sh
# Checks that ParaView reads the shapes of a run. Usage: paraview_opens_shapes.sh WRITE_PULSATING_SPHERE
# Compares times, counts, bounds and fields of the pulsating sphere. The exit code is 0 if they are equal.
set -eu
writer=$1
here=$(cd "$(dirname "$0")" && pwd)
directory=$(mktemp -d)
trap 'rm -r "$directory"' EXIT
"$writer" "$directory"
cd /  # the paths in the index are relative to the index, not to the current directory
pvpython "$here/paraview_opens_shapes.py" "$directory/shapes.xdmf2"
