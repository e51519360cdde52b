#!/bin/sh
# Tests the daemon's page in Chromium. Usage: tests/browser.sh CAPSTAN CAPSTAN_WITH_FAKE_SOLVER. Exit code 77: skipped.
# Needs chromium and node with npm, which installs playwright-core (tests/browser/package-lock.json) for the test.
set -eu
BROWSER=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  echo "skipped: there is no chromium (apt-get install chromium)"
  exit 77
}
command -v npm >/dev/null || {
  echo "skipped: there is no npm (apt-get install npm)"
  exit 77
}
CAPSTAN=$1
FAKE_CAPSTAN=$2
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
export BROWSER CAPSTAN FAKE_CAPSTAN WORK
cp "$(dirname "$0")"/browser/* "$WORK"
cd "$WORK"
npm ci --silent --no-audit --no-fund
node --test page_test.mjs
