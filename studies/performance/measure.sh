#!/bin/sh
# Measures every figure of this folder and writes them to results.md. About ten minutes on a quiet machine with two
# cores; the load at the start is part of the result. Needs the release build; with the test build the queue, too.
#   cmake --preset release && cmake --build --preset release
#   sh studies/performance/measure.sh
set -eu
cd "$(dirname "$0")/../.."
capstan=$PWD/build/release/capstan
scratch=$(mktemp -d)
server=""
trap '[ -z "$server" ] || kill "$server"; rm -rf "$scratch"' EXIT

# verbatim COMMAND...: the command and what it prints.
verbatim() {
  printf '\n```\n$ %s\n' "$*" | sed "s|$PWD/||g"
  "$@" 2>/dev/null
  printf '```\n'
}

header() {
  cat <<END
# Results of \`sh studies/performance/measure.sh\`

| | |
|---|---|
| date | $(date -u '+%Y-%m-%d %H:%M') UTC |
| machine | $(lscpu | sed -n 's/^Model name: *//p'), $(nproc --all) cores, $(free -g | awk '/^Mem/ {print $2}') GB |
| load at the start | $(cut -d' ' -f1 /proc/loadavg) |
| program | $("$capstan" --version | tr '\n' ' ') |
END
}

# red_cell NAME FLUID FIDELITY KT: one row: processor seconds, elapsed seconds, flow iterations, megabytes.
red_cell() {
  cat >"$scratch/case.json" <<END
{"shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015, "Ca": 0.25, "V": 4, "fluid": "$2",
 "fidelity": $3, "until": {"kt": $4}, "outputs": {"shapes_every": 0}}
END
  rm -rf "$scratch/run"
  python3 - "$1" "$capstan" "$scratch" <<'END'
import json, os, resource, subprocess, sys, time
name, capstan, scratch = sys.argv[1:]
start = time.monotonic()
subprocess.run([capstan, "solve", f"{scratch}/case.json", "--out", f"{scratch}/run"], check=True,
               capture_output=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
elapsed = time.monotonic() - start
usage = resource.getrusage(resource.RUSAGE_CHILDREN)
result = json.load(open(f"{scratch}/run/result.json"))
print(f"| {name} | {usage.ru_utime + usage.ru_stime:.2f} | {elapsed:.2f} | {result['cost']['flow_iterations']} |"
      f" {usage.ru_maxrss / 1024:.0f} | {result['motion']} |")
END
}

single_cases() {
  printf '\n## One red cell, Ca = 0.25, V = 4, one core\n\n'
  echo '| fluid, fidelity, stepper if not the default, kt | processor s | elapsed s | flow iterations | peak MB | motion |'
  echo '|---|---|---|---|---|---|'
  red_cell 'stokes, fast, 30' stokes '"fast"' 30
  red_cell 'stokes, standard, 30' stokes '"standard"' 30
  red_cell 'quasisteady, fast, 30' quasisteady '"fast"' 30
  red_cell 'quasisteady, standard, 30' quasisteady '"standard"' 30
  red_cell 'stokes, fast, rkc2, 10' stokes '{"preset": "fast", "stepper": "rkc2"}' 10
  red_cell 'stokes, fast, ab2, 10' stokes '{"preset": "fast", "stepper": "ab2"}' 10
  red_cell 'quasisteady, fast, rkc2, 4' quasisteady '{"preset": "fast", "stepper": "rkc2"}' 4
  red_cell 'quasisteady, fast, ab2, 4' quasisteady '{"preset": "fast", "stepper": "ab2"}' 4
}

phase_diagram() {
  printf '\n## fig17: 96 red cells through the daemon, all cores\n'
  "$capstan" serve --data "$scratch/data" --listen 127.0.0.1:18017 >/dev/null 2>&1 &
  server=$!
  export CAPSTAN_SERVER=http://127.0.0.1:18017
  until curl -sf "$CAPSTAN_SERVER/readyz" >/dev/null; do sleep 0.1; done
  begin=$(date +%s.%N)
  id=$("$capstan" submit studies/fig17/study.json --watch 2>/dev/null)
  end=$(date +%s.%N)
  printf '\n%s s from submission to the last result.\n' "$(echo "$begin $end" | awk '{printf "%.1f", $2 - $1}')"
  verbatim "$capstan" phase-diagram "$id"
}

{
  header
  single_cases
  phase_diagram
  for name in cycle scaling; do
    printf '\n## capstan bench %s, one core\n' "$name"
    OMP_NUM_THREADS=1 verbatim "$capstan" bench "$name"
  done
  printf '\n## capstan bench kernel, all cores\n'
  verbatim "$capstan" bench kernel
  if [ -x build/test/tests/queue_benchmark ]; then
    printf '\n## The queue, through HTTP and the disk\n'
    verbatim build/test/tests/queue_benchmark
  fi
} >"$scratch/results.md"
mv "$scratch/results.md" studies/performance/results.md
echo "studies/performance/results.md"
