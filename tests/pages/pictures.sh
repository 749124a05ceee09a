#!/bin/sh
# The pictures of docs/pictures are what the commands in its README draw.
# usage: pictures.sh ROOT BIN [--self-test]    BIN holds the chapters' programs and compare
set -eu
root=$1
bin=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
tried=0

# is_drawn FILE PROGRAM [OPTION...]: true if the program draws docs/pictures/FILE.
is_drawn() {
  file=$1
  program=$2
  shift 2
  "$bin/$program" --quiet --out "$work/drawn.png" "$@" >"$work/log" 2>&1 &&
    "$bin/compare" "$work/drawn.png" "$root/docs/pictures/$file" >>"$work/log" 2>&1
}

if [ "${3:-}" = --self-test ]; then
  if is_drawn 05_turned_0.png 05_y_rotation --degrees 1 --width 400 --height 300 --samples 16; then
    echo "FAIL: another picture is taken for the one of the page"
    exit 1
  fi
  echo "another picture is noticed"
  exit 0
fi

# shellcheck disable=SC2016  # the quotes are Markdown's
sed -n 's/^| \([0-9a-z_]*\.png\) | `\(.*\)` |$/\1 \2/p' "$root/docs/pictures/README.md" >"$work/rows"
while read -r file command; do
  tried=$((tried + 1))
  # shellcheck disable=SC2086  # a command of several words
  is_drawn "$file" $command || {
    echo "FAIL: docs/pictures/$file is not what its command draws: $command"
    cat "$work/log"
    failed=1
  }
done <"$work/rows"
for file in "$root"/docs/pictures/*.png; do
  grep -q "^$(basename "$file") " "$work/rows" || {
    echo "FAIL: no command draws $file"
    failed=1
  }
done
echo "$tried pictures"
[ "$failed" -eq 0 ] && [ "$tried" -gt 10 ]
