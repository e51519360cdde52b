#!/bin/sh
# Runs clang-tidy on C++ files; every finding is an error.
#   sh tests/tidy.sh           the files that differ from where this branch left origin/main, uncommitted changes
#                              included; on main itself, from the commit before
#   sh tests/tidy.sh REVISION  the files that differ from REVISION
#   sh tests/tidy.sh --all     all files (also where there is no git history to compare with): about an hour
# With --minutes N in front no file is begun after N minutes; the last line says how many were checked.
set -eu
cd "$(dirname "$0")/.."
minutes=600
if [ "${1:-}" = --minutes ]; then
  minutes=$2
  shift 2
fi
sh runner/install_packages.sh clang clang-tidy-14 libclang-rt-14-dev libomp-14-dev
# For its compile_commands.json; clang-tidy reads each file by itself, with the headers that it includes.
cmake --preset sanitize -B build/tidy -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON -D CMAKE_UNITY_BUILD=OFF >/dev/null

fail() {
  echo "tidy: $1" >&2
  exit 1
}

# Prints the revision to compare with; nothing if there is none.
base_revision() {
  if [ -n "${1:-}" ]; then
    git rev-parse --verify --quiet "$1^{commit}"
    return
  fi
  base=$(git merge-base HEAD origin/main 2>/dev/null) || base=""
  [ "$base" != "$(git rev-parse HEAD)" ] || base=""
  echo "${base:-$(git rev-parse --verify --quiet HEAD~1)}"
}

all_files() { find solver runner tests -name '*.cpp' -o -name '*.hpp'; }

changed_files() {
  { git diff --name-only --diff-filter=d "$1" && git ls-files --others --exclude-standard; } |
    grep -E '^(solver|runner|tests)/.*\.[ch]pp$' || true
}

if [ "${1:-}" = --all ]; then
  files=$(all_files) what="all files"
elif base=$(base_revision "${1:-}") && [ -n "$base" ]; then
  files=$(changed_files "$base") what="changed since $(git log -1 --format='%h (%s)' "$base")"
elif [ -n "${1:-}" ]; then
  fail "there is no revision $1"
else
  files=$(all_files) what="all files, because there is no earlier revision"
fi

# Checks that clang-tidy finds a name that breaks the rules. If not, it has not read its settings and finds nothing.
echo 'int BadName() { return 0; }' >build/tidy/finding.cpp
if clang-tidy-14 --quiet --config-file=.clang-tidy build/tidy/finding.cpp -- -std=c++20 >build/tidy/log 2>&1 ||
  ! grep -q 'readability-identifier-naming' build/tidy/log; then
  cat build/tidy/log >&2
  fail "clang-tidy does not find what it should"
fi

count=$(printf '%s' "$files" | grep -c . || true)
echo "clang-tidy: $count files, $what"
[ "$count" = 0 ] && exit 0
: >build/tidy/checked
end=$(($(date +%s) + 60 * minutes))
export end
# shellcheck disable=SC2016  # expanded by the shell that xargs starts
printf '%s\n' "$files" | xargs -P "$(nproc)" -n 1 sh -c '
  [ "$(date +%s)" -lt "$end" ] || exit 0
  clang-tidy-14 --quiet -p build/tidy "$1" && echo "$1" >>build/tidy/checked' sh
echo "clang-tidy: $(wc -l <build/tidy/checked) of $count files checked, no finding"
