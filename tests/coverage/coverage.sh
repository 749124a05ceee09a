#!/bin/sh
# How many lines of common/ the tests reach: builds everything with clang++'s counters, runs the tests, and prints the share, all in
# all and for each file below 95 %. A line counts as reached if it is reached with any number.
# usage: coverage.sh            builds in build/coverage; eight minutes of processor time
#        coverage.sh --report   of the last run
# Code for other systems and wider instructions is not counted. Not reached is what is computed at compile time alone (tables), and what
# only tests without counters reach: of faults on the programs, of the build for learning, against 50 digits, benchmarks.
# exit status: 0 at least 95 %; 1 less, or a test failed; 77 a program is missing
set -eu
cd "$(dirname "$0")/../.."
least=95
build=build/coverage
command -v clang++ >/dev/null 2>&1 || {
  echo "skipped: there is no clang++ (Debian clang)"
  exit 77
}
profdata=$(clang++ -print-prog-name=llvm-profdata)
cov=$(clang++ -print-prog-name=llvm-cov)
if ! "$profdata" merge --help >/dev/null 2>&1 || ! "$cov" export --help >/dev/null 2>&1; then
  echo "skipped: clang++ has no llvm-profdata and llvm-cov (Debian llvm)"
  exit 77
fi

if [ "${1:-}" != --report ]; then
  mkdir -p build
  if ! cmake --preset coverage >"$build.log" 2>&1 || ! cmake --build --preset coverage >>"$build.log" 2>&1; then
    tail -n 30 "$build.log"
    exit 1
  fi
  rm -rf "$build/profiles"
  status=0
  LLVM_PROFILE_FILE=$PWD/$build/profiles/%4m.profraw ctest --preset coverage >>"$build.log" 2>&1 || status=$?
  grep -E 'tests passed|^[[:space:]]+[0-9]+ - .*(Failed|Timeout)' "$build.log"
  [ "$status" = 0 ] || exit 1
  "$profdata" merge -sparse -o "$build/all.profdata" "$build"/profiles/*.profraw
fi

set --
for program in "$build"/bin/* "$build"/tests/*; do
  if [ -f "$program" ] && [ -x "$program" ]; then set -- "$@" -object "$program"; fi
done
shift # the first is named without -object
# It warns of functions that one program has and another has not.
"$cov" export -format=lcov -instr-profile="$build/all.profdata" "$@" "$PWD/common" >"$build/lines.info" 2>"$build/export.log" || {
  cat "$build/export.log"
  exit 1
}
awk -v root="$PWD/" -v least="$least" -F '[:,]' '
  /^SF:/ { ++files; file = substr($0, length(root) + 4) }
  /^DA:/ {
    ++lines[file]
    ++all
    if ($3 > 0) { ++reached[file]; ++all_reached }
    else missed[file] = missed[file] " " $2
  }
  END {
    for (file in lines)
      if (100 * reached[file] < least * lines[file])
        printf "%5.1f %%  %d of %d lines not reached: %s, lines%s\n", 100 * reached[file] / lines[file],
          lines[file] - reached[file], lines[file], file, missed[file] | "sort -n"
    close("sort -n")
    printf "%.2f %% of %d lines of common/ in %d files\n", 100 * all_reached / all, all, files
    exit !(all > 0 && 100 * all_reached >= least * all)
  }' "$build/lines.info"
