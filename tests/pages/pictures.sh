#!/bin/sh
# The pictures of docs/pictures are what the commands in its README draw.
# usage: pictures.sh ROOT BIN [--write]    BIN holds the chapters' programs, compare and mark_crops;
#        --write draws those out of date, and packs them and those of symptoms/, by ImageMagick
set -eu
root=$1
bin=$2
mode=${3:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
tried=0
cd "$root" # some commands name files
# shellcheck source=/dev/null
. "$root/tests/support/drawn.sh"

fail() {
  echo "FAIL: $1"
  cat "$work/log"
  failed=1
}

# keep DRAWN FILE: in 256 colors and without row filters it takes a third of the bytes. The grain of
# wood takes few colors; the README's large picture would show bands.
keep() {
  colors=256
  case $2 in
    */first.png) cp "$1" "$2" && return ;;
    */thumb_08.png) colors=96 ;;
  esac
  convert "$1" +dither -colors "$colors" -strip -define png:compression-filter=0 -define png:compression-level=9 \
    -define png:include-chunk=none "png8:$2"
}

# check DRAWN FILE: FILE of docs/pictures shows what is drawn, with few pixels far off (256 colors).
check() {
  tried=$((tried + 1))
  "$bin/compare" --pixels-off-by-more-than 24 --at-most 0.1% "$1" "$root/docs/pictures/$2" >>"$work/log" 2>&1 && return
  if [ "$mode" = --write ]; then
    keep "$1" "$root/docs/pictures/$2"
    echo "docs/pictures/$2 is new"
  else
    fail "docs/pictures/$2 is not what its rows say"
  fi
}

# shellcheck disable=SC2016  # the quotes are Markdown's
sed -n 's/^| \([0-9a-z_]*\.png\) | `\(.*\)` |$/\1 \2/p' "$root/docs/pictures/README.md" >"$work/rows"
while read -r file command; do
  # shellcheck disable=SC2086  # a command of several words
  draw "$work/drawn.png" $command || fail "$command"
  check "$work/drawn.png" "$file"
done <"$work/rows"

# Strips of marked crops: each row of the table is a crop.
# shellcheck disable=SC2016  # the quotes are Markdown's
sed -n 's/^| \([0-9a-z_]*\.png\) | `\(.*\)` | \([0-9,]*\) | \([0-9,:]*\) |$/\1 \3 \4 \2/p' "$root/docs/pictures/README.md" >"$work/crops"
for strip in $(cut -d ' ' -f 1 "$work/crops" | uniq); do
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
  if ! "$bin/mark_crops" "$work/strip.png" "$@" >"$work/log" 2>&1; then
    fail "the crops of $strip"
    continue
  fi
  check "$work/strip.png" "$strip"
done

for file in "$root"/docs/pictures/*.png; do
  cat "$work/rows" "$work/crops" | grep -q "^$(basename "$file") " || fail "no command draws $file"
done
for file in "$root"/docs/pictures/symptoms/*.png; do # byte 25 of a file with a palette is 3
  [ "$mode" != --write ] || [ "$(od -An -tu1 -j25 -N1 "$file")" -eq 3 ] || keep "$file" "$file"
done
echo "$tried pictures"
[ "$failed" -eq 0 ] && [ "$tried" -gt 10 ]
