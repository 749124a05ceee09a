#!/bin/sh
# Every build draws the same picture of a chapter in a number: whatever compiler, optimisation, machine code and number of threads.
#
#   determinism.sh [COMPILER[:FLAGS]...]   builds chapters 01 to 12 for each, in build/determinism, and compares all pictures with those
#                                          of the first; without arguments: g++ and clang++ with -O0, -O2, -O3 and -O2 -march=native
#   determinism.sh --part                  for CI: the programs in build/release, those that there are in build/clang and build/no-xsimd,
#                                          and chapter 06 built with -O0 -march=native
#
# A build without its compiler is skipped.
# exit status: 0 one picture everywhere; 1 not so; 77 there are no two builds to compare
set -eu
tree=$(cd "$(dirname "$0")/../.." && pwd)
builds=$tree/build/determinism
all_threads="1 2 3 8"
chapters="01_plain_spheres 02_checkerboard_uv 03_image_texture 04_uv_conventions 05_y_rotation 06_phong_texture_blend
  07_earth_by_sampling 08_triangle_uv 09_texture_filtering 10_projections 11_bump_and_normal_maps 12_environment_map"
small_texture=$tree/tests/golden/06_lecture_slides.png
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
mkdir "$work/first"
compare=
compared=0
failed=0

# check_pictures NAME BIN: draws all that BIN's programs offer. A picture that is new is kept; it is what later ones are compared with.
check_pictures() {
  name=$1 bin=$2
  drawn=0
  against=0
  differing=
  for chapter in $chapters; do
    [ -x "$bin/$chapter" ] || continue
    "$bin/$chapter" --help >"$work/help"
    numbers=$(sed -n 's/^ *--number \([a-z|-]*\)$/\1/p' "$work/help" | tr '|' ' ')
    [ -n "$numbers" ] || {
      echo "FAIL: $name: $chapter offers no --number"
      failed=1
    }
    # Many pixels: a number's last bit changes few bytes. Chapter 07 smooths pixels from 12 samples on, without its ground.
    # 09 and 10 would draw sheets, and work on their whole texture first: a small one is enough.
    ways=plain size="--width 192 --height 144 --samples 2" texture=
    ! grep -q '^ *--budget ' "$work/help" || ways="plain budget:levels=1"
    case $chapter in
      07*) size="--width 64 --height 48 --samples 32" ;;
      09*) ways="filter:anisotropic filter:stochastic budget:levels=1" size="--width 96 --height 72" texture=$small_texture ;;
      10*) ways=projection:equal-area texture=$small_texture ;;
      12*) ways="plain light:mis" size="--width 64 --height 48 --samples 32" ;;
    esac
    for number in $numbers; do
      for way in $ways; do
        picture=$chapter-$number
        # shellcheck disable=SC2086  # a list of options
        set -- $size ${texture:+--texture "$texture"} --number "$number"
        if [ "$way" != plain ]; then
          picture=$picture-${way#*:}
          set -- "$@" "--${way%%:*}" "${way#*:}"
          case $picture in 07*) set -- "$@" --scene book ;; esac
        fi
        for threads in $all_threads; do
          drawn=$((drawn + 1))
          timeout 300 "$bin/$chapter" --quiet --out "$work/drawn.png" --threads "$threads" "$@" 2>"$work/log" || {
            differing="$differing $picture(threads=$threads: $(head -n 1 "$work/log"))"
            continue
          }
          if [ ! -e "$work/first/$picture.png" ]; then
            mv "$work/drawn.png" "$work/first/$picture.png"
            continue
          fi
          against=$((against + 1))
          # A picture has one PNG, unless another encoder wrote it.
          cmp -s "$work/first/$picture.png" "$work/drawn.png" || "$compare" --quiet "$work/first/$picture.png" "$work/drawn.png" ||
            differing="$differing $picture(threads=$threads)"
        done
      done
    done
  done
  printf '%s: %s pictures drawn, %s compared, differing:%s\n' "$name" "$drawn" "$against" "${differing:- none}"
  [ -z "$differing" ] || failed=1
  compared=$((compared + against))
}

# build NAME COMPILER FLAGS TARGET...: in build/determinism/NAME.
build() {
  name=$1 compiler=$2 flags=$3
  shift 3
  mkdir -p "$builds"
  if ! cmake -S "$tree" -B "$builds/$name" -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER="$compiler" \
    -D CMAKE_CXX_FLAGS="$flags" -D CMAKE_CXX_FLAGS_RELEASE= >"$builds/$name.log" 2>&1 ||
    ! cmake --build "$builds/$name" --parallel 2 --target "$@" >>"$builds/$name.log" 2>&1; then
    tail -n 30 "$builds/$name.log"
    echo "FAIL: $name cannot be built"
    exit 1
  fi
  # A fused a*b+c rounds once: no program may have them, neither by the compiler's choice nor by a library's.
  for chapter in $chapters; do
    if [ -x "$builds/$name/bin/$chapter" ] && command -v objdump >/dev/null 2>&1 &&
      objdump -d --no-show-raw-insn "$builds/$name/bin/$chapter" | grep -q 'vfn\{0,1\}m\(add\|sub\)'; then
      echo "FAIL: $name: $chapter has fused multiplications and additions"
      failed=1
    fi
  done
}

take_compare() {
  compare=$1/compare
  [ -x "$compare" ] || {
    echo "there is no $compare: build compare_program" >&2
    exit 1
  }
}

case ${1:-} in
  --part)
    release=$tree/build/release/bin
    all_threads="1 3 8"
    take_compare "$release"
    check_pictures release "$release"
    for built in clang no-xsimd; do
      [ ! -d "$tree/build/$built/bin" ] || check_pictures "$built" "$tree/build/$built/bin"
    done
    build part g++ "-O0 -march=native" 06_phong_texture_blend
    check_pictures "g++ -O0 -march=native" "$builds/part/bin"
    ;;
  -*)
    echo "usage: determinism.sh [--part | COMPILER[:FLAGS]...]" >&2
    exit 1
    ;;
  *)
    if [ $# = 0 ]; then
      for compiler in g++ clang++; do
        set -- "$@" "$compiler:-O0" "$compiler:-O2" "$compiler:-O3" "$compiler:-O2 -march=native"
      done
    fi
    tried=0
    for wanted in "$@"; do
      compiler=${wanted%%:*}
      flags=${wanted#"$compiler"}
      flags=${flags#:}
      command -v "$compiler" >/dev/null 2>&1 || {
        echo "$compiler $flags: skipped, there is no $compiler"
        continue
      }
      name=$(printf '%s' "${compiler##*/} $flags" | tr -cs 'A-Za-z0-9+.\n' -)
      # shellcheck disable=SC2086  # a list of targets
      build "$name" "$compiler" "$flags" $chapters compare_program
      [ -n "$compare" ] || compare=$builds/$name/bin/compare
      check_pictures "$compiler $flags" "$builds/$name/bin"
      tried=$((tried + 1))
    done
    [ "$tried" -ge 2 ] || {
      echo "skipped: no two builds to compare"
      exit 77
    }
    ;;
esac
[ "$failed" = 0 ] && [ "$compared" -gt 0 ] || exit 1
echo "$compared pictures compared: one for each chapter and number"
