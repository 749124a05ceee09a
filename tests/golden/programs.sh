#!/bin/sh
# The programs, as fast as the compiler makes them, draw the golden pictures to the last bit.
# usage: programs.sh BIN [CHAPTER...]   BIN: the programs, compare; by default all with a picture
#        programs.sh --collect BIN      writes those that have changed. Look before you commit them
set -eu
mode=exact
case ${1:-} in --*) mode=${1#--} && shift ;; esac
bin=${1:?usage: programs.sh [--collect] BIN [CHAPTER...]}
shift
[ -x "$bin/compare" ] || {
  echo "there is no $bin/compare: build compare_program" >&2
  exit 2
}
folder=$(dirname "$0")
chosen=" $* "
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
tried=0

# shellcheck source=/dev/null
. "$folder/../support/drawn.sh"
# check PICTURE PROGRAM [OPTION...]: counts whether the program draws tests/golden/PICTURE.png.
check() {
  if [ "$chosen" != "  " ]; then
    case $chosen in *" $2 "*) ;; *) return 0 ;; esac
  fi
  tried=$((tried + 1))
  picture=$1
  shift
  rm -f "$work/drawn.png"
  is_drawn "$folder/$picture.png" "$@" || {
    if [ "$mode" = collect ]; then
      echo "wrote tests/golden/$picture.png"
      cp "$work/drawn.png" "$folder/$picture.png"
      return 0
    fi
    echo "FAIL: $1 does not draw tests/golden/$picture.png" >&2
    cat "$work/log" >&2
    failed=$((failed + 1))
  }
}

# Chapter 13 measures times: test_golden draws its sheet without them.
for drawn in "$folder"/[0-9][0-9]_*.png; do
  picture=$(basename "$drawn" .png)
  [ -d "$folder/../../chapters/$picture" ] || continue
  case $picture in 13_*) ;; *) check "$picture" "$picture" ;; esac
done
check 02_objects 02_checkerboard_uv --show object --width 160 --height 120
check 05_close_up 05_y_rotation --zoom 3 --at 130,40 --width 200 --height 150
check 08_triangles 08_triangle_uv --show object --width 160 --height 120
check 09_uv 09_texture_filtering --show uv --filter nearest --width 160 --height 120
check 04_uv_daily 04_uv_conventions --convention daily --show uv --width 200 --height 150
for sheet in phong slides; do
  highlight=$sheet
  [ "$sheet" = phong ] || highlight=lecture
  check "06_lecture_$sheet" 06_phong_texture_blend --scene lecture --shininess 20 --blend 0.1 --highlight "$highlight" --width 400 --height 200
done
for wrap in repeat clamp; do
  check "08_$wrap" 08_triangle_uv --wrap "$wrap" --width 240 --height 180
done
check 11_bump_or_dent 11_bump_and_normal_maps --show sheet
check 11_poles 11_bump_and_normal_maps --show poles
check 11_daily_bricks 11_bump_and_normal_maps --show daily
check 11_normals 11_bump_and_normal_maps --show normal --width 150 --height 150
for light in cosine mis coefficients; do
  check "12_$light" 12_environment_map --light "$light" --samples 64 --width 256 --height 144
done
[ "$tried" -gt 0 ] || {
  echo "FAIL: nothing was tried" >&2
  exit 1
}
echo "$tried golden pictures, $failed not drawn"
[ "$failed" -eq 0 ]
