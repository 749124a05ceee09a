#!/bin/sh
# Every build draws the same picture of a chapter in a number: whatever compiler, optimisation,
# machine code, number of threads and C library.
# usage: determinism.sh [BUILD...]   compares the programs in these build folders; without them, in
#   build/release, build/clang and build/no-xsimd, and chapter 06 built here with -O0 -march=native
# exit status: 0 one picture everywhere; 1 not so
set -eu
tree=$(cd "$(dirname "$0")/../.." && pwd)
compare=$tree/build/release/bin/compare
all_threads="1 3 8"
chapters=$(cd "$tree/chapters" && echo 0[1-9]_* 1[0-2]_*)
small_texture=$tree/tests/golden/06_lecture_slides.png
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
mkdir "$work/first"
compared=0
failed=0

# check_pictures BUILD [LIBRARY]: draws all that its programs offer, with a library put before the
# system's. A picture that is new is kept; it is what later ones are compared with.
check_pictures() {
  name=$1 bin=$1/bin library=${2:-}
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
    # Many pixels: a last bit changes few bytes. 07 smooths from 12 samples on, without its ground.
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
          LD_PRELOAD=$library timeout 300 "$bin/$chapter" --quiet --out "$work/drawn.png" --threads "$threads" "$@" 2>"$work/log" || {
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
  printf '%s: %s pictures drawn, %s compared, differing:%s\n' "$name${library:+ with another C library}" "$drawn" "$against" "${differing:- none}"
  [ -z "$differing" ] || failed=1
  compared=$((compared + against))
}

[ -x "$compare" ] || {
  echo "there is no $compare: build compare_program" >&2
  exit 1
}
if [ $# = 0 ]; then
  for build in release clang no-xsimd; do
    [ ! -d "$tree/build/$build/bin" ] || set -- "$@" "$tree/build/$build"
  done
  native=$tree/build/determinism
  jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
  if ! cmake -S "$tree" -B "$native" -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS="-O0 -march=native" \
    -D CMAKE_CXX_FLAGS_RELEASE= >"$native.log" 2>&1 ||
    ! cmake --build "$native" --parallel "$jobs" --target 06_phong_texture_blend \
      >>"$native.log" 2>&1; then
    tail -n 30 "$native.log"
    exit 1
  fi
  # A fused a*b+c rounds once: no program may have it, by the compiler's choice or by a library's.
  if command -v objdump >/dev/null 2>&1 &&
    objdump -d --no-show-raw-insn "$native/bin/06_phong_texture_blend" | grep -q 'vfn\{0,1\}m\(add\|sub\)'; then
    echo "FAIL: there are fused multiplications and additions"
    failed=1
  fi
  set -- "$@" "$native"
fi
for build in "$@"; do check_pictures "$build"; done
# No picture depends on the C library; a program that asks it for exp sees that it is another one.
other=$work/off_by_an_ulp.so
printf '%s\n' '#include <math.h>' 'int main(int n, char **words) {' '  volatile double x = n; (void)words;' \
  '  for (int i = 0; i < 99; ++i) if (exp(x) != exp(x)) return 0;' '  return 1;' '}' >"$work/asks.c"
cc -fno-builtin "$work/asks.c" -o "$work/asks" -lm
cc -shared -fPIC -fno-builtin "$tree/tests/determinism/off_by_an_ulp.c" -o "$other" -lm -ldl
if LD_PRELOAD=$other "$work/asks"; then
  all_threads=1
  check_pictures "$1" "$other"
else
  echo "FAIL: no other C library can be put before the system's"
  failed=1
fi
[ "$failed" = 0 ] && [ "$compared" -gt 0 ] || exit 1
echo "$compared pictures compared: one for each chapter and number"
