#!/bin/sh
# Packs of every width draw the pictures of plain double; other functions run on every machine.
# usage: packs.sh BIN CHAPTER...      BIN holds the chapters' programs and compare
set -eu
bin=${1:?usage: packs.sh BIN CHAPTER...}
shift
[ -x "$bin/compare" ] || {
  echo "there is no $bin/compare: build compare_program" >&2
  exit 2
}
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
tried=0

fail() {
  echo "FAIL: $1" >&2
  failed=$((failed + 1))
}

draw() { "$bin/$1" --quiet --width 400 --height 300 --out "$2" --number "$3" --instructions "$4"; }

for chapter in "$@"; do
  draw "$chapter" "$work/double.png" double baseline
  for instructions in baseline avx2 avx512; do
    draw "$chapter" "$work/packs.png" double-pack "$instructions" 2>"$work/refusal" || {
      grep -q "this machine does not have" "$work/refusal" || fail "$chapter with $instructions: $(cat "$work/refusal")"
      # Linux tells what there is, too.
      flag=$(echo "$instructions" | sed 's/512/512bw/')
      if [ "$(uname -m)" = x86_64 ] && grep -qsw "$flag" /proc/cpuinfo; then
        fail "$chapter: $instructions are refused, and /proc/cpuinfo has them"
      fi
      echo "$instructions: not on this machine"
      continue
    }
    "$bin/compare" "$work/double.png" "$work/packs.png" >/dev/null || fail "$chapter: packs of double with $instructions differ from double"
    draw "$chapter" "$work/float-$instructions.png" float-pack "$instructions"
    "$bin/compare" "$work/float-baseline.png" "$work/float-$instructions.png" >/dev/null ||
      fail "$chapter: packs of float with $instructions differ from those with baseline"
    tried=$((tried + 1))
  done
  sh "$here/wide.sh" "$bin/$chapter" || [ $? -eq 77 ] || fail "$chapter: its instructions"
done
[ "$tried" -gt 0 ] || fail "nothing was tried"
echo "$tried pictures with packs, $failed failed"
[ "$failed" -eq 0 ]
