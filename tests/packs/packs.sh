#!/bin/sh
# Packs of every width draw the pictures that plain double draws, and the program's other functions run on every machine.
# usage: packs.sh BIN [CHAPTER...]      BIN holds the chapters' programs and compare; CHAPTER:functions looks at its functions alone
#        packs.sh --functions PROGRAM   looks at the functions of any program; 77 if there is no objdump
set -eu
if [ "${1:-}" = --functions ]; then
  functions=${2:?usage: packs.sh --functions PROGRAM}
  shift
fi
bin=${1:?usage: packs.sh BIN [CHAPTER...]}
shift
[ -n "${functions:-}" ] || [ -x "$bin/compare" ] || {
  echo "there is no $bin/compare: build compare_program" >&2
  exit 2
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
tried=0

fail() {
  echo "FAIL: $1" >&2
  failed=$((failed + 1))
}

draw() { "$bin/$1" --quiet --width 400 --height 300 --out "$2" --number "$3" --instructions "$4"; }

# wide_functions PROGRAM: functions with wide instructions that are not named after them, and whatever runs when the program starts.
wide_functions() {
  objdump -d --no-show-raw-insn "$1" |
    awk '/^[0-9a-f]+ </ { name = $2 }
      /%[yz]mm/ && (name !~ /avx|run_in_wide_packs|PackU32ILm(8|16)E/ || name ~ /_GLOBAL__sub_I|global_var_init/) { print name }' | sort -u
}

check_functions() {
  command -v objdump >/dev/null 2>&1 || return 0
  wide=$(wide_functions "$1")
  [ -z "$wide" ] || fail "$(basename "$1"): wide instructions where every machine goes: $wide"
}

if [ -n "${functions:-}" ]; then
  command -v objdump >/dev/null 2>&1 || exit 77
  check_functions "$functions"
  [ "$failed" -eq 0 ] && echo "wide instructions stay in functions that are named after them"
  exit "$failed"
fi

for chapter in "$@"; do
  case $chapter in
    *:functions)
      check_functions "$bin/${chapter%:functions}"
      continue
      ;;
  esac
  draw "$chapter" "$work/double.png" double baseline
  for instructions in baseline avx2 avx512; do
    draw "$chapter" "$work/packs.png" double-pack "$instructions" 2>"$work/refusal" || {
      grep -q "this machine does not have" "$work/refusal" || fail "$chapter with $instructions: $(cat "$work/refusal")"
      echo "$instructions: not on this machine"
      continue
    }
    "$bin/compare" "$work/double.png" "$work/packs.png" >/dev/null || fail "$chapter: packs of double with $instructions differ from double"
    draw "$chapter" "$work/float-$instructions.png" float-pack "$instructions"
    "$bin/compare" "$work/float-baseline.png" "$work/float-$instructions.png" >/dev/null ||
      fail "$chapter: packs of float with $instructions differ from those with baseline"
    tried=$((tried + 1))
  done
  check_functions "$bin/$chapter"
done
[ "$tried" -gt 0 ] || fail "nothing was tried"
echo "$tried pictures with packs, $failed failed"
[ "$failed" -eq 0 ]
