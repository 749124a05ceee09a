#!/bin/sh
# The programs, as fast as the compiler makes them, draw the golden pictures to the last bit.
# usage: programs.sh BIN [CHAPTER...]   BIN holds the chapters' programs and compare; without chapters, all that have a picture
set -eu
bin=${1:?usage: programs.sh BIN [CHAPTER...]}
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
  is_drawn "$folder/$picture.png" "$@" || {
    echo "FAIL: $1 does not draw tests/golden/$picture.png" >&2
    cat "$work/log" >&2
    failed=$((failed + 1))
  }
}

check 01_plain_spheres 01_plain_spheres
check 02_checkerboard_uv 02_checkerboard_uv
check 03_image_texture 03_image_texture
check 04_uv_conventions 04_uv_conventions
check 04_uv_daily 04_uv_conventions --convention daily --show uv --width 200 --height 150
check 05_y_rotation 05_y_rotation
check 06_phong_texture_blend 06_phong_texture_blend
for highlight in phong lecture; do
  sheet=06_lecture_phong
  [ "$highlight" = phong ] || sheet=06_lecture_slides
  check "$sheet" 06_phong_texture_blend --scene lecture --shininess 20 --blend 0.1 --highlight "$highlight" --width 400 --height 200
done
check 07_earth_by_sampling 07_earth_by_sampling
check 08_triangle_uv 08_triangle_uv
for wrap in repeat clamp; do
  check "08_$wrap" 08_triangle_uv --wrap "$wrap" --width 240 --height 180
done
check 09_texture_filtering 09_texture_filtering
check 10_projections 10_projections
check 11_bump_and_normal_maps 11_bump_and_normal_maps
check 11_bump_or_dent 11_bump_and_normal_maps --show sheet
check 11_poles 11_bump_and_normal_maps --show poles
check 11_daily_bricks 11_bump_and_normal_maps --show daily
check 11_normals 11_bump_and_normal_maps --show normal --width 150 --height 150
check 12_environment_map 12_environment_map
for light in cosine mis coefficients; do
  check "12_$light" 12_environment_map --light "$light" --samples 64 --width 256 --height 144
done
# Chapter 13 measures times: its own suite compares its sheet.
check 14_numerical_extremes 14_numerical_extremes
[ "$tried" -gt 0 ] || {
  echo "FAIL: nothing was tried" >&2
  exit 1
}
echo "$tried golden pictures, $failed not drawn"
[ "$failed" -eq 0 ]
