#!/bin/sh
# Faults of the Windows programs, run by wine: what tests/faults tries on every system, and names,
# NUL and a full disk as Windows has them. Left out are faults.py's parts that need signals, links,
# limits of memory or closed streams as POSIX has them.
# usage: windows_faults.sh BIN      BIN holds a command for each chapter
set -u
bin=${1:?usage: windows_faults.sh BIN}
tests=$(cd "$(dirname "$0")/.." && pwd)
LC_ALL=C.UTF-8 # wine takes names by the locale
export LC_ALL
work=$(mktemp -d)
disk=$work/disk
trap 'umount "$disk" 2>/dev/null; rm -rf "$work"' EXIT
failed=0
tried=0

# expect STATUS WORDS CHAPTER OPTION...: the program ends so, and says so.
expect() {
  status=$1 words=$2 chapter=$3
  shift 3
  tried=$((tried + 1))
  timeout 20 "$bin/$chapter" --width 40 --height 30 "$@" >"$work/said" 2>&1 </dev/null
  found=$?
  if [ "$found" -ne "$status" ] || ! grep -q -F -e "$words" "$work/said"; then
    failed=$((failed + 1))
    echo "FAIL: $chapter $*: status $found, expected $status and '$words'; it said: $(head -c 300 "$work/said")"
  fi
}

expect 0 'Erde äöü.png' 03_image_texture --texture "$tests/corpus/png_no_extension" --out "$work/Erde äöü.png"
cp "$tests/corpus/png_no_extension" "$work/地球.png"
expect 0 'a.png' 03_image_texture --texture "$work/地球.png" --out "$work/a.png"
expect 1 '地球 two.png' 03_image_texture --texture "$work/地球 two.png" --out "$work/b.png"
expect 0 'NUL' 01_plain_spheres --out NUL
expect 1 'a character that names cannot have' 01_plain_spheres --out "$work/what?.png"
if [ -e "$work/b.png" ]; then
  echo "FAIL: a picture of nothing was written"
  failed=$((failed + 1))
fi

# A disk with room for one small picture: the large one fails, and the old one stays.
mkdir "$disk"
if mount -t tmpfs -o size=64k tmpfs "$disk" 2>/dev/null; then
  expect 0 'x.png' 02_checkerboard_uv --out "$disk/x.png"
  cp "$disk/x.png" "$work/old.png"
  expect 1 'the disk is full' 02_checkerboard_uv --width 1200 --height 900 --out "$disk/x.png"
  cmp -s "$disk/x.png" "$work/old.png" || { echo "FAIL: a full disk cost the old picture" && failed=$((failed + 1)); }
  [ "$(find "$disk" -type f | wc -l)" -eq 1 ] || { echo "FAIL: a full disk keeps a part of a picture" && failed=$((failed + 1)); }
else
  echo "skipped: a full disk (only root may mount one)"
fi
echo "$tried faults as Windows has them, $failed not as they should be"

TEXMAP_SANITIZED=1 python3 "$tests/faults/faults.py" "$bin" "$tests/corpus" numbers words surroundings ||
  failed=$((failed + 1))
[ "$failed" -eq 0 ]
