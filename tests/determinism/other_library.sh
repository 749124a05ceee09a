#!/bin/sh
# No picture depends on the C library's functions: every chapter draws the same with a library that is off by one ulp at random.
# usage: other_library.sh BIN [CHAPTER...]     BIN holds the chapters' programs and compare; without chapters, 01 to 12 and 14
# exit status: 0 the same pictures; 1 not so; 77 where this cannot be tried (no GNU C library, no shared one)
set -eu
bin=${1:?usage: other_library.sh BIN [CHAPTER...]}
shift
[ $# -gt 0 ] || set -- 01_plain_spheres 02_checkerboard_uv 03_image_texture 04_uv_conventions 05_y_rotation 06_phong_texture_blend \
  07_earth_by_sampling 08_triangle_uv 09_texture_filtering 10_projections 11_bump_and_normal_maps 12_environment_map 14_numerical_extremes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Each function asks the real one, and takes the number above or below in two of three cases.
cat >"$work/ulp.c" <<'C'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>
#include <stdint.h>
static uint64_t state = 88172645463325252ULL;
static int dice(void) { state ^= state << 13; state ^= state >> 7; state ^= state << 17; return (int)(state % 3) - 1; }
#define OFF(T, name, next, parameters, arguments)                             \
  T name parameters {                                                         \
    T(*real) parameters = (T(*) parameters)dlsym(RTLD_NEXT, #name);           \
    const int step = dice();                                                  \
    return step ? next(real arguments, (T)(step * INFINITY)) : real arguments; \
  }
#define ONE(name)                                       \
  OFF(double, name, nextafter, (double x), (x))         \
  OFF(float, name##f, nextafterf, (float x), (x))       \
  OFF(long double, name##l, nextafterl, (long double x), (x))
#define TWO(name)                                                  \
  OFF(double, name, nextafter, (double x, double y), (x, y))       \
  OFF(float, name##f, nextafterf, (float x, float y), (x, y))      \
  OFF(long double, name##l, nextafterl, (long double x, long double y), (x, y))
ONE(sin) ONE(cos) ONE(tan) ONE(asin) ONE(acos) ONE(atan) ONE(exp) ONE(exp2) ONE(expm1) ONE(log) ONE(log2) ONE(log10) ONE(log1p) ONE(cbrt)
TWO(atan2) TWO(pow) TWO(hypot)
void sincos(double x, double *s, double *c) { *s = sin(x); *c = cos(x); }
void sincosf(float x, float *s, float *c) { *s = sinf(x); *c = cosf(x); }
void sincosl(long double x, long double *s, long double *c) { *s = sinl(x); *c = cosl(x); }
C
printf '#include <math.h>\n#include <stdio.h>\nint main(int n, char **of) { volatile double x = n; for (int i = 0; i < 99; ++i) if (exp(x) != exp(x)) return puts("off"), 0; (void)of; }\n' >"$work/asks.c"
if ! cc -O0 -fno-builtin "$work/asks.c" -o "$work/asks" -lm 2>"$work/log" ||
  ! cc -shared -fPIC -O1 -fno-builtin "$work/ulp.c" -o "$work/ulp.so" -lm -ldl 2>>"$work/log" ||
  [ "$(LD_PRELOAD="$work/ulp.so" "$work/asks")" != off ]; then
  echo "skipped: no other C library can be put before this system's"
  exit 77
fi
compared=0
failed=0
# check PROGRAM OPTION...: draws with both libraries.
check() {
  program=$1
  shift
  "$bin/$program" --quiet --out "$work/right.png" "$@"
  LD_PRELOAD="$work/ulp.so" "$bin/$program" --quiet --out "$work/off.png" "$@"
  compared=$((compared + 1))
  cmp -s "$work/right.png" "$work/off.png" || {
    echo "FAIL: $program $* draws another picture with another C library" >&2
    failed=$((failed + 1))
  }
}
for chapter in "$@"; do
  case $chapter in 09*) size="--width 96 --height 72" ;; 1[02]*) size= ;; *) size="--width 192 --height 144" ;; esac
  check "$chapter" # its own picture
  # shellcheck disable=SC2086  # a list of options
  for number in $("$bin/$chapter" --help | sed -n 's/^ *--number \([a-z|-]*\)$/\1/p' | tr '|' ' '); do check "$chapter" $size --number "$number"; done
done
echo "$compared pictures compared, $failed differ"
[ "$failed" = 0 ]
