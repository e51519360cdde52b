#!/bin/sh
# Installs the Debian packages Capstan is built with, and those in the arguments, if any is missing (as root, or
# through sudo).
set -eu
packages="g++ cmake ninja-build pkg-config libeigen3-dev libhdf5-dev zlib1g-dev libsqlite3-dev libcpp-httplib-dev nlohmann-json3-dev
 libssl-dev libcli11-dev libgtest-dev libgmock-dev libbenchmark-dev curl gnuplot-nox fonts-dejavu-core $*"
missing=""
for package in $packages; do
  case "$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null)" in *"ok installed") ;; *) missing="$missing $package" ;; esac
done
[ -n "$missing" ] || exit 0
as_root=""
[ "$(id -u)" = 0 ] || as_root="sudo"
echo "Installing:$missing"
$as_root apt-get update -qq
# shellcheck disable=SC2086  # a list of words
DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing
