#!/bin/sh
# The pictures of docs/pictures are what the commands in its README draw.
# usage: pictures.sh ROOT BIN [--write]    BIN holds the chapters' programs, compare and mark_crops;
#        --write draws the strips of marked crops that are out of date, with ImageMagick's convert
set -eu
root=$1
bin=$2
mode=${3:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
tried=0
# shellcheck source=/dev/null
. "$root/tests/support/drawn.sh"

fail() {
  echo "FAIL: $1"
  cat "$work/log"
  failed=1
}

# shellcheck disable=SC2016  # the quotes are Markdown's
sed -n 's/^| \([0-9a-z_]*\.png\) | `\(.*\)` |$/\1 \2/p' "$root/docs/pictures/README.md" >"$work/rows"
while read -r file command; do
  [ "$mode" != --write ] || continue
  tried=$((tried + 1))
  # shellcheck disable=SC2086  # a command of several words
  is_drawn "$root/docs/pictures/$file" $command || fail "docs/pictures/$file is not what its command draws: $command"
done <"$work/rows"

# Strips of marked crops: each row of the table is a crop.
# shellcheck disable=SC2016  # the quotes are Markdown's
sed -n 's/^| \([0-9a-z_]*\.png\) | `\(.*\)` | \([0-9,]*\) | \([0-9,:]*\) |$/\1 \3 \4 \2/p' "$root/docs/pictures/README.md" >"$work/crops"
for strip in $(cut -d ' ' -f 1 "$work/crops" | uniq); do
  tried=$((tried + 1))
  set --
  grep "^$strip " "$work/crops" >"$work/strip"
  while read -r _ corner marks command; do
    source=$root/$command
    case $command in
      *.png) ;;
      *)
        source=$work/crop$#.png
        # shellcheck disable=SC2086  # a command of several words
        draw "$source" $command || fail "$command"
        ;;
    esac
    set -- "$@" "$source" "$corner" "$marks"
  done <"$work/strip"
  "$bin/mark_crops" "$work/strip.png" "$@" >"$work/log" 2>&1 || fail "the crops of $strip"
  # The file has 256 colors: few pixels are far from what is drawn.
  "$bin/compare" --pixels-off-by-more-than 24 --at-most 0.1% "$work/strip.png" "$root/docs/pictures/$strip" >>"$work/log" 2>&1 && continue
  if [ "$mode" = --write ]; then
    # A palette, and no row filters: a third of the bytes. The grain of wood takes few colors.
    colors=256
    [ "$strip" != thumb_08.png ] || colors=96
    convert "$work/strip.png" +dither -colors "$colors" -strip -define png:compression-filter=0 -define png:compression-level=9 \
      -define png:include-chunk=none "png8:$root/docs/pictures/$strip"
    echo "docs/pictures/$strip is new"
  else
    fail "docs/pictures/$strip is not what its rows say"
  fi
done

for file in "$root"/docs/pictures/*.png; do
  cat "$work/rows" "$work/crops" | grep -q "^$(basename "$file") " || fail "no command draws $file"
done
echo "$tried pictures"
[ "$failed" -eq 0 ] && [ "$tried" -gt 10 ]
