#!/bin/sh
# Searches for inputs that break the HTTP request parser or the study reader, with libFuzzer and the sanitizers.
#   sh tests/fuzz.sh [SECONDS EACH]
# Inputs that reach new code go to build/fuzz/found/; inputs that broke something are beside it. To keep the smallest set:
#   build/fuzz/tests/fuzz_request -merge=1 tests/fuzz/corpus/request build/fuzz/found/request
set -eu
cd "$(dirname "$0")/.."
sh runner/install_packages.sh clang libclang-rt-14-dev libomp-14-dev
cmake --preset fuzz
cmake --build --preset fuzz
for input in request study; do
  mkdir -p build/fuzz/found/$input
  build/fuzz/tests/fuzz_$input -max_total_time="${1:-60}" -timeout=20 -max_len=8192 -print_final_stats=1 \
    -dict=tests/fuzz/$input.dict -artifact_prefix=build/fuzz/found/$input- \
    build/fuzz/found/$input tests/fuzz/corpus/$input
done
