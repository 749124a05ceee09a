#!/bin/sh
# How many lines of common/ the tests reach: builds everything with clang++'s counters, runs the tests, and prints the share, all in
# all and for each file below 95 %. A line counts as reached if it is reached with any number.
# usage: coverage.sh            builds in build/coverage; eight minutes of processor time
#        coverage.sh --report   of the last run
# Code for other systems and wider instructions is not counted. Not reached is what is computed at
# compile time alone (tables), and what only tests without counters reach: of faults on the
# programs, of the build for learning, against 50 digits, benchmarks.
# exit status: 0 at least 95 %; 1 less, or a test failed; 77 a program is missing
set -eu
cd "$(dirname "$0")/../.."
build=build/coverage
profdata=$(clang++ -print-prog-name=llvm-profdata || true)
cov=$(clang++ -print-prog-name=llvm-cov || true)
if ! command -v "$profdata" || ! command -v "$cov"; then
  echo "skipped: there is no clang++ with llvm-profdata and llvm-cov (Debian clang, llvm)"
  exit 77
fi >&2
if [ "${1:-}" != --report ]; then
  cmake --preset coverage
  cmake --build --preset coverage
  rm -rf "$build/profiles"
  LLVM_PROFILE_FILE=$PWD/$build/profiles/%4m.profraw ctest --preset coverage || exit 1
  "$profdata" merge -sparse -o "$build/all.profdata" "$build"/profiles/*.profraw
fi
set --
for program in "$build"/bin/* "$build"/tests/*; do
  if [ -f "$program" ] && [ -x "$program" ]; then set -- "$@" -object "$program"; fi
done
shift # the first is named without -object
"$cov" report -show-region-summary=false -show-branch-summary=false -instr-profile="$build/all.profdata" "$@" "$PWD/common" >"$build/report"
awk '$NF + 0 < 95 || NR == 1 || /^TOTAL/; /^TOTAL/ { exit $NF + 0 < 95 }' "$build/report"
