#!/bin/sh
# Builds Capstan, starts its server, computes a small study and shows which capsules tumble and which tank-tread.
#   sh runner/quickstart.sh [DATA_DIRECTORY]
# The server keeps running. If a server of the data directory already runs, that one is used.
set -eu
cd "$(dirname "$0")/.."
mkdir -p "${1:-capstan-data}"
data=$(cd "${1:-capstan-data}" && pwd -P)
capstan=build/release/capstan
study=studies/quickstart/study.json

build() {
  sh runner/install_packages.sh
  mkdir -p build
  log=build/quickstart.log
  cmake --preset release >$log 2>&1 && cmake --build --preset release >>$log 2>&1 && return
  tail -n 40 $log >&2
  echo "The build failed; see $log." >&2
  exit 1
}

# Prints what answers at the port: "ours" (a server of the data directory), "starting" (the same, not ready yet),
# "other" or "nothing".
listener_at() {
  code=0
  answer=$(curl -s --max-time 3 "http://127.0.0.1:$1/healthz") || code=$?
  case "$code,$answer" in
    7,*) echo nothing ;; # connection refused
    *'"status": "starting"'*"\"data\": \"$data\""*) echo starting ;;
    *'"program": "capstan"'*"\"data\": \"$data\""*) echo ours ;;
    *) echo other ;;
  esac
}

start_server() {
  nohup "$capstan" serve --data "$data" --listen "127.0.0.1:$port" >>"$data/server.log" 2>&1 &
  pid=$!
  until [ "$(listener_at "$port")" = ours ]; do
    if ! kill -0 "$pid" 2>/dev/null; then
      tail -n 5 "$data/server.log" >&2
      exit 1
    fi
    sleep 0.1
  done
  echo "Started the server at port $port, data in $data"
}

# Sets `port` to the first one from 8017 on where our server answers or can be started.
find_or_start_server() {
  port=8017
  while :; do
    case "$(listener_at "$port")" in
      starting) sleep 0.1 && continue ;;
      ours) echo "Using the server that runs at port $port" && return ;;
      nothing) start_server && return ;;
    esac
    port=$((port + 1))
  done
}

echo "Building (the first time takes a few minutes) ..."
build
find_or_start_server
server=http://127.0.0.1:$port
option=""
[ "$port" = 8017 ] || option=" --server $server"

echo "Computing $study: red cells at four points of (Ca, V), each by boundary integrals and on a lattice"
id=$("$capstan" submit "$study" --watch --server "$server") || [ $? = 3 ]
echo
"$capstan" results "$id" --server "$server"
echo
diagram() { "$capstan" phase-diagram "$id" --at "fluid=$1" --server "$server"; }
diagram stokes
echo
diagram quasisteady
echo
# The rows of both diagrams, whether or not a motion is confirmed.
motions() { diagram "$1" | grep "|" | tr "[:lower:]" "[:upper:]"; }
if [ "$(motions stokes)" = "$(motions quasisteady)" ]; then
  echo "Both flow models give every cell the same kind of motion."
else
  echo "The flow models differ: compare the two diagrams."
fi
pid=$(curl -s "$server/healthz" | sed -n 's/.*"pid": \([0-9]*\).*/\1/p')
cat <<END

Try:
  curl '$server/v1/studies/$id/cases?motion=tumbling'
  curl '$server/v1/studies/$id/phase-diagram'
  $capstan results $id --format csv$option
  $capstan submit studies/fig16a/study.json --watch$option

The server keeps running. Stop it:   kill $pid
Start it again, nothing is lost:     $capstan serve --data $data --listen 127.0.0.1:$port
END
