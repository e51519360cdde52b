#!/bin/sh
# Fails if clang-format 14 would change any C++ file, and names the lines. To format all files:
#   sh tests/check_format.sh --fix
set -eu
cd "$(dirname "$0")/.."
sh runner/install_packages.sh clang-format-14
action="--dry-run --Werror"
[ "${1:-}" != --fix ] || action="-i"
files=$(find solver runner tests -name '*.cpp' -o -name '*.hpp')
# shellcheck disable=SC2086  # lists of words
clang-format-14 $action $files
echo "Format: $(echo "$files" | wc -l) files"
