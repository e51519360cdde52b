#!/bin/sh
# Does ParaView read what a run writes? Usage: paraview_opens_shapes.sh WRITE_PULSATING_SPHERE
# Compares times, counts, bounds and fields of the pulsating sphere; any difference is an exit code other than 0.
set -eu
writer=$1
here=$(cd "$(dirname "$0")" && pwd)
directory=$(mktemp -d)
trap 'rm -r "$directory"' EXIT
"$writer" "$directory"
cd /  # the paths in the index are relative to it, wherever ParaView was started
pvpython "$here/paraview_opens_shapes.py" "$directory/shapes.xdmf2"
