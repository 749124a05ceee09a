#!/bin/sh
# What wide instructions must not do to a program. There are none in functions that are not named
# after them: not every machine has them. (Functions of target_clones end in .arch_x86_64_v3: the
# loader chooses them. A compiler's clone of a plain function, .isra, .constprop, .part, is local to
# its file: it may have them where all of its callers are wide functions.) And where plain code goes
# on, the upper halves of the vector registers are clean: until vzeroupper has run every plain
# instruction pays, up to eight times, and what is timed next to wide code is timed wrong.
# usage: wide.sh PROGRAM      77 if there is no objdump, or nothing to find
set -eu
program=${1:?usage: wide.sh PROGRAM}
command -v objdump >/dev/null 2>&1 || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# For each instruction with a name that begins with v, as those of AVX and later do: its function;
# so too for registers with an upper half (16 to 31 cost nothing). For each call: both functions.
# Functions go by their address: clones in several files may have one name.
objdump -d --no-show-raw-insn "$program" >"$work/code"
awk '/^[0-9a-f]+ </ { at = $1; sub(/^0+/, "", at); gsub(/[<>:]/, "", $2); print "name", at, $2 }
    $2 ~ /^v[a-z0-9]+$/ { print "wide", at }
    $2 ~ /^vzero/ { print "cleans", at }
    /%[yz]mm([0-9]|1[0-5])([^0-9]|$)/ { print "upper", at }
    $2 ~ /^(call|jmp)/ && $3 ~ /^[0-9a-f]+$/ && $3 != at { print "call", at, $3 }' "$work/code" |
  sort -u >"$work/all"
grep -q '^wide' "$work/all" || exit 77
awk '
  function is_wide(name) {
    return name ~ /avx|RegistersILm(32|64)E|run_in_wide_packs|PackU32ILm(8|16)E|\.arch_x86_64_v3$/ && name !~ /_GLOBAL__sub_I|global_var_init/
  }
  $1 == "call" { caller[++calls] = $2; called[calls] = $3 }
  $1 == "name" { name[$2] = $3 }
  $1 == "wide" { wide[$2] = 1 }
  $1 == "upper" { upper[$2] = 1 }
  $1 == "cleans" { cleans[$2] = 1 }
  END {
    for (at in wide) if (is_wide(name[at])) recognized = 1
    if (!recognized) print "no wide functions are recognized"
    for (i = 1; i <= calls; i++) {
      if (!is_wide(name[caller[i]])) called_by_plain[called[i]] = 1
      # A compiler cleans where it must or, without that pass, nowhere: calls by plain code show it.
      if (called[i] in upper && !(caller[i] in upper) && !(called[i] in cleans)) print name[called[i]] ", which leaves upper halves in use"
    }
    for (at in wide) {
      if (!is_wide(name[at]) && (name[at] !~ /\.(isra|constprop|part)\./ || at in called_by_plain)) print name[at] ", where every machine goes"
    }
  }' "$work/all" >"$work/found"
if [ -s "$work/found" ]; then
  echo "FAIL: $program: wide instructions:"
  cat "$work/found"
  exit 1
fi
echo "$(grep -c '^wide' "$work/all") functions with wide instructions, all named after them, and clean where plain code goes on"
