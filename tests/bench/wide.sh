#!/bin/sh
# Functions of a program that have instructions which not every machine has, and are not named after them: there must be none.
# usage: wide.sh PROGRAM      77 if there is no objdump, or nothing to find
set -eu
program=${1:?usage: wide.sh PROGRAM}
command -v objdump >/dev/null 2>&1 || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# One line for each instruction whose name begins with v, as those of AVX and later do: its function.
objdump -d --no-show-raw-insn "$program" |
  awk '/^[0-9a-f]+ </ { name = $2 } $2 ~ /^v[a-z0-9]+$/ { print name }' >"$work/all"
[ -s "$work/all" ] || exit 77
grep -E 'avx|draw_wide_packs|run_wide_packs' "$work/all" | grep -qvE '_GLOBAL__sub_I|global_var_init' || {
  echo "FAIL: no wide functions are recognized"
  exit 1
}
found=$(awk '!/avx|draw_wide_packs|run_wide_packs|LaneBitsILm(8|16)E/ || /_GLOBAL__sub_I|global_var_init/' "$work/all" |
  sort -u)
if [ -n "$found" ]; then
  echo "FAIL: wide instructions where every machine goes:"
  echo "$found"
  exit 1
fi
echo "$(wc -l <"$work/all") wide instructions, all in functions named after them"
