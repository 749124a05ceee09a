#!/bin/sh
# The programs, as fast as the compiler makes them, draw the golden pictures to the last bit.
# usage: programs.sh BIN [CHAPTER...]         BIN holds the chapters' programs and compare; without chapters, all that have a picture
#        programs.sh --near BIN [CHAPTER...]  as another compiler or C library may round: 0.02 % of the pixels are free, others by one level
#        programs.sh --collect BIN            writes the golden pictures that have changed. Look at them before you commit them
#        programs.sh --self-test BIN          shows that a picture drawn in another way is noticed
set -eu
mode=exact
case ${1:-} in --*) mode=${1#--} && shift ;; esac
bin=${1:?usage: programs.sh [--near | --collect | --self-test] BIN [CHAPTER...]}
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
near() { "$bin/compare" --pixels-off-by-more-than 1 --at-most 0.02% "$1" "$2" >>"$work/log" 2>&1; }
if [ "$mode" = near ]; then
  same_picture() { near "$@"; }
fi

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

if [ "$mode" = self-test ]; then
  if is_drawn "$folder/02_checkerboard_uv.png" 02_checkerboard_uv --number float; then
    echo "FAIL: a picture drawn in float is taken for the golden one"
    exit 1
  fi
  is_drawn "$folder/02_checkerboard_uv.png" 02_checkerboard_uv
  # Where rounding may differ, neighbouring chapters, a convention and half a texel are noticed all the same.
  differ() {
    status=0
    near "$1" "$2" || status=$?
    [ "$status" -eq 1 ] || {
      echo "FAIL: $1 and $2 are taken for the same, or are not there"
      exit 1
    }
  }
  for pair in 01_plain_spheres:02_checkerboard_uv 03_image_texture:05_y_rotation 05_y_rotation:06_phong_texture_blend \
    06_lecture_phong:06_lecture_slides 08_repeat:08_clamp; do
    differ "$folder/${pair%:*}.png" "$folder/${pair#*:}.png"
  done
  draw "$work/daily.png" 04_uv_conventions --convention daily
  draw "$work/rounded.png" 04_uv_conventions --rounding lecture
  differ "$work/daily.png" "$folder/03_image_texture.png"
  differ "$work/rounded.png" "$folder/03_image_texture.png"
  echo "a difference of rounding is noticed"
  exit 0
fi

check 01_plain_spheres 01_plain_spheres
check 02_checkerboard_uv 02_checkerboard_uv
check 02_objects 02_checkerboard_uv --show object --width 160 --height 120
check 03_image_texture 03_image_texture
check 04_uv_conventions 04_uv_conventions
check 04_uv_daily 04_uv_conventions --convention daily --show uv --width 200 --height 150
check 05_y_rotation 05_y_rotation
check 05_close_up 05_y_rotation --zoom 3 --at 130,40 --width 200 --height 150
check 06_phong_texture_blend 06_phong_texture_blend
for highlight in phong lecture; do
  sheet=06_lecture_phong
  [ "$highlight" = phong ] || sheet=06_lecture_slides
  check "$sheet" 06_phong_texture_blend --scene lecture --shininess 20 --blend 0.1 --highlight "$highlight" --width 400 --height 200
done
check 07_earth_by_sampling 07_earth_by_sampling
check 08_triangle_uv 08_triangle_uv
check 08_triangles 08_triangle_uv --show object --width 160 --height 120
for wrap in repeat clamp; do
  check "08_$wrap" 08_triangle_uv --wrap "$wrap" --width 240 --height 180
done
check 09_texture_filtering 09_texture_filtering
check 09_uv 09_texture_filtering --show uv --filter nearest --width 160 --height 120
check 10_projections 10_projections
check 11_bump_and_normal_maps 11_bump_and_normal_maps
check 11_bump_or_dent 11_bump_and_normal_maps --show sheet
check 11_poles 11_bump_and_normal_maps --show poles
check 11_daily_bricks 11_bump_and_normal_maps --show daily
check 11_normals 11_bump_and_normal_maps --show normal --width 150 --height 150
# Chance takes another path where a last bit is another.
[ "$mode" = near ] || check 12_environment_map 12_environment_map
for light in cosine mis coefficients; do
  [ "$mode" = near ] || check "12_$light" 12_environment_map --light "$light" --samples 64 --width 256 --height 144
done
# Chapter 13 measures times: test_golden draws its sheet without them.
check 14_numerical_extremes 14_numerical_extremes
[ "$tried" -gt 0 ] || {
  echo "FAIL: nothing was tried" >&2
  exit 1
}
echo "$tried golden pictures, $failed not drawn"
[ "$failed" -eq 0 ]
