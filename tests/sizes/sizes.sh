#!/bin/sh
# The largest pictures and textures: memory as docs/architecture.md states it, Ctrl-C, progress.
# usage: sizes.sh [--part] BIN   BIN: the programs' folder. --part: smaller, more patient, for CI
# exit status: 0 all is well; 1 something is not; 77 no way to tell (no /proc, no GNU env or date)
# Ctrl-C should end a program within 0.2 s. More than 0.5 s is a failure: others may use the
# machine, and to free the memory takes the system up to half a millisecond for each MiB.
set -eu
part=no
patience=500 # ms that Ctrl-C may take
if [ "${1:-}" = --part ]; then
  part=yes
  patience=5000
  shift
fi
bin=${1:?usage: sizes.sh [--part] BIN}
if ! grep -q '^VmHWM:' /proc/self/status 2>/dev/null || ! env --default-signal=INT true 2>/dev/null || [ "$(date +%N)" = N ]; then
  echo "skipped: no VmHWM in /proc, or no GNU env and date"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
failed=0

fail() {
  echo "FAIL: $1"
  failed=1
}

# --- Memory ---------------------------------------------------------------------------------------

# draw PROGRAM OPTION...: begins to draw measured.png.
draw() {
  program=$1
  shift
  "$bin/$program" --out "$work/measured.png" "$@" >"$work/said" 2>&1 &
  running=$!
}

# finish: waits for the end, and sets the four times that the program prints, in ms.
finish() {
  wait "$running" || fail "$program: $(cat "$work/said")"
  ! grep -q '% done' "$work/said" || fail "$program shows its progress to a file"
  times=$(sed -n 's/.*(load \([0-9]*\).*, render \([0-9]*\).*, encode \([0-9]*\).*, write \([0-9]*\).*/\1 \2 \3 \4/p' "$work/said")
  read -r load render encode write <<END
$times
END
}

# measure PROGRAM OPTION...: draws it and sets peak, in KiB.
measure() {
  draw "$@"
  peak=0
  while kill -0 "$running" 2>/dev/null; do
    while read -r key value _; do
      if [ "$key" = VmHWM: ] && [ "$value" -gt "$peak" ]; then peak=$value; fi
    done 2>/dev/null <"/proc/$running/status" || true
    sleep 0.01
  done
  finish
}

# expect_memory WHAT PIXELS BYTES PROGRAM OPTION...: BYTES for each of PIXELS or texels, and 16 MiB.
expect_memory() {
  what=$1 pixels=$2 bytes=$3
  shift 3
  measure "$@"
  stated=$((pixels * bytes / 1024))
  most=$((stated + 16384 + 2 * $(wc -c <"$work/measured.png") / 1024))
  tenths=$((peak * 10 / (pixels / 1024)))
  printf '%s: %s MiB at most, %s.%s bytes each of %s; load %s, render %s, encode %s, write %s ms\n' \
    "$what" "$((peak / 1024))" "$((tenths / 10))" "$((tenths % 10))" "$pixels" "$load" "$render" "$encode" "$write"
  [ "$peak" -le "$most" ] || fail "$what: $peak KiB, and $most KiB are stated"
  [ "$peak" -ge $((stated - pixels / 1024)) ] || fail "$what: $peak KiB, which is less than what is stated: correct the statement"
}

if [ "$part" = yes ]; then
  width=8192 height=2048
else
  width=16384 height=4096
fi
all=$((width * height))
size="$width x $height"
set -- --width "$width" --height "$height"
expect_memory "01, $size pixels" $all 6 01_plain_spheres "$@"
expect_memory "03, $size pixels" $all 6 03_image_texture "$@"
cp "$work/measured.png" "$work/texture.png"
expect_memory "03, a texture of $size texels" $all 3 03_image_texture --texture "$work/texture.png" --width 64 --height 48
set -- "$work/texture.png" --width 64 --height 48
expect_memory "09, a texture of $size texels" $all 7 \
  09_texture_filtering --filter anisotropic --texture "$@"
expect_memory "10, a texture of $size texels, converted" $all 6 \
  10_projections --projection octahedral --texture "$@"
expect_memory "11, heights of $size texels" $all 3 11_bump_and_normal_maps --relief-image "$@"
set -- --width "$width" --height "$height"
if [ "$part" = yes ]; then
  expect_memory "07, 2048 x 1024 pixels, 1 sample" $((2 << 20)) 6 07_earth_by_sampling --width 2048 --height 1024 --samples 1
else
  expect_memory "07, $size pixels, 1 sample" $all 6 07_earth_by_sampling "$@" --samples 1
  expect_memory "07, 4096 x 1024 pixels with a limit of time" $((4 << 20)) 72 07_earth_by_sampling --width 4096 --height 1024 \
    --samples 48 --time-limit 10000 --number float-pack
  expect_memory "07, a texture of $size texels, as roots" $all 7 07_earth_by_sampling --texture "$work/texture.png" --width 800 \
    --height 450 --samples 1000 --scene book --budget levels=1
fi
expect_memory "07, 64 x 48 pixels, 4096 samples" $((64 * 48)) 6 07_earth_by_sampling --width 64 --height 48 --samples 4096
cp "$work/measured.png" "$work/samples.png"
measure 07_earth_by_sampling --width 64 --height 48 --samples 4096 --threads 1
cmp -s "$work/samples.png" "$work/measured.png" || fail "07, 4096 samples: one thread draws another picture"

# --- Ctrl-C ---------------------------------------------------------------------------------------

mkdir "$work/there"

# interrupt MS WHAT PROGRAM OPTION...: Ctrl-C after MS. tests/faults looks at the files it leaves.
interrupt() {
  when=$1 what=$2 program=$3
  shift 3
  env --default-signal=INT "$bin/$program" --quiet --out "$work/there/out.png" "$@" 2>"$work/said" &
  running=$!
  sleep "$((when / 1000)).$(printf '%03d' $((when % 1000)))"
  before=$(date +%s%N)
  kill -s INT "$running" 2>/dev/null || true
  status=0
  wait "$running" || status=$?
  waited=$((($(date +%s%N) - before) / 1000000))
  case $status in
    0) return ;; # too late
    130) interrupted=$((interrupted + 1)) ;;
    *) fail "$program, $what: status $status, $(cat "$work/said")" ;;
  esac
  [ "$waited" -le "$longest" ] || longest=$waited
  [ "$waited" -le "$patience" ] || fail "$program, $what: Ctrl-C takes $waited ms"
}

# interrupt_often PROGRAM OPTION...: in each part of a run.
interrupt_often() {
  draw "$@"
  finish
  interrupted=0 longest=0
  for eighths in 1 4 7; do
    interrupt $((load * eighths / 8)) loading "$@"
    interrupt $((load + render * eighths / 8)) rendering "$@"
    interrupt $((load + render + encode * eighths / 8)) encoding "$@"
    interrupt $((load + render + encode + write * eighths / 8)) writing "$@"
  done
  echo "Ctrl-C, $1: ended it $interrupted times of 12, after $longest ms at most"
  [ "$interrupted" -gt 0 ] || fail "$1: no Ctrl-C ends it"
}

interrupt_often 03_image_texture --texture "$work/texture.png" --width "$width" --height "$height"
interrupt_often 07_earth_by_sampling --texture "$work/texture.png" --width "$width" --height "$((height / 4))" --samples 2

# --- Progress -------------------------------------------------------------------------------------

if script -qec true /dev/null >/dev/null 2>&1; then
  samples=4
  [ "$part" = no ] || samples=12
  script -qec "'$bin/07_earth_by_sampling' --width $width --height $height --samples $samples --out '$work/measured.png'" /dev/null \
    </dev/null >"$work/terminal"
  # Each progress line begins with a carriage return. The last is overwritten by as many spaces, and
  # the next text begins at the left. How soon the first comes, and how near to the end the last,
  # depends on the machine: that counts for large pictures alone.
  tr '\r' '\n' <"$work/terminal" | awk -v part="$part" '
    / % done/ {
      if ($1 < last) falls = 1
      if (!lines++) first = $1
      last = $1
      if (length($0) > longest) longest = length($0)
      cleared = 0
      next
    }
    lines && /^ +$/ { cleared = length($0) >= longest }
    END {
      printf "progress: %d lines, from %d %% to %d %%\n", lines, first, last
      if (!lines || falls || !cleared || part == "no" && (first > 50 || last < 75)) exit 1
    }' || fail "progress is not as it should be, or the line is not cleared"
  [ -z "$(find "$work/there" -name '.*' -type f)" ] || fail "a temporary file is left"
else
  echo "no progress: there is no program script to make a terminal"
fi
exit "$failed"
