#!/bin/sh
# Searches for inputs that break a claim, with libFuzzer and sanitizers. Builds in build/fuzz.
# usage: fuzz.sh [SECONDS] [TARGET...]     60 s for each target by default, two targets at a time
#        TARGET: fuzz_load_image | fuzz_read_hdr | fuzz_read_obj; all unless told otherwise
# What a run learns stays in build/fuzz/corpus, so the next one goes on from there. Inputs that
# break a claim stay in build/fuzz/finds. Once the fault is fixed, such an input belongs into
# tests/fuzz/finds/TARGET, where every run and ctest try it first.
# exit status: 0 nothing found; 1 something found, or no target compiles; 77 a package is missing
set -eu
usage='usage: fuzz.sh [SECONDS] [fuzz_load_image|fuzz_read_hdr|fuzz_read_obj ...]'
tree=$(cd "$(dirname "$0")/../.." && pwd)
build=$tree/build/fuzz
finds=$build/finds
fail() {
  echo "$1" >&2
  exit 1
}

seconds=60
case ${1-} in
  [0-9]*)
    seconds=$1
    shift
    ;;
esac
case $seconds in *[!0-9]* | 0*) fail "$usage" ;; esac
[ $# -gt 0 ] || set -- fuzz_load_image fuzz_read_hdr fuzz_read_obj
for target in "$@"; do
  if [ "$target" = "${target#fuzz_}" ] || [ ! -f "$tree/tests/fuzz/$target.cpp" ]; then
    fail "there is no target '$target'; $usage"
  fi
done

mkdir -p "$build/logs" "$finds"
probe='#include <cstddef>
extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, std::size_t) { return 0; }'
if ! printf '%s\n' "$probe" | clang++ -fsanitize=fuzzer,address,undefined -x c++ - -o "$build/probe" >"$build/logs/probe" 2>&1; then
  echo "skipped: fuzzing needs clang++ and libFuzzer (Debian clang libclang-rt-14-dev)"
  exit 77
fi

jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
if ! { cmake -S "$tree" --preset fuzz && cmake --build "$build" --parallel "$jobs" --target "$@"; } \
  >"$build/logs/build" 2>&1; then
  tail -n 40 "$build/logs/build"
  echo "FAILED: the targets do not compile"
  exit 1
fi
export UBSAN_OPTIONS=print_stacktrace=1
limits="-timeout=20 -rss_limit_mb=1024 -seed=1"

# search TARGET: writes logs/TARGET; libFuzzer tries the seeds and the former finds first.
search() {
  corpus=$build/corpus/$1
  seeds=$tree/tests/fuzz/seeds/$1
  [ "$1" != fuzz_load_image ] || seeds=$tree/tests/corpus
  mkdir -p "$corpus"
  for input in "$seeds"/* "$tree/tests/fuzz/finds/$1"/*; do
    [ ! -f "$input" ] || cp "$input" "$corpus"
  done
  # shellcheck disable=SC2086  # a list of options
  "$build/tests/$1" $limits -max_total_time="$seconds" -print_final_stats=1 -artifact_prefix="$finds/$1-" "$corpus" \
    >/dev/null 2>"$build/logs/$1" || echo "search ended with status $?" >>"$build/logs/$1"
}

# report TARGET: one line of figures; after a find, what it is, how to see it again, and status 1.
report() {
  log=$build/logs/$1
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  speed=$(sed -n 's/^stat::average_exec_per_sec: *//p' "$log")
  cover=$(sed -n 's/^#.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)
  count=$(find "$finds" -name "$1-*" -newer "$build/started" | wc -l)
  printf '%-20s %9s runs %7s a second   cov: %-6s finds: %d\n' "$1" "${runs:-?}" "${speed:-?}" "${cover:-?}" "$count"
  grep -q '^search ended' "$log" || return 0
  grep -E 'this claim|runtime error:|SUMMARY:|ERROR:' "$log" | head -n 4
  find "$finds" -name "$1-*" -newer "$build/started" | while read -r input; do
    echo "  again: $build/tests/$1 $limits $input"
  done
  echo "  all that it said: $log"
  return 1
}

: >"$build/started"
status=0
while [ $# -gt 0 ]; do
  search "$1" &
  [ $# -eq 1 ] || search "$2"
  wait
  for target in "$1" ${2+"$2"}; do
    report "$target" || status=1
    shift
  done
done
exit "$status"
