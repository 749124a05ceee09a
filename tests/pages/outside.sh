#!/bin/sh
# A program outside the course uses the textbook: what docs/architecture.md tells, word for word.
# usage: outside.sh ROOT WORK      WORK: a folder for the program, made anew
set -eu
rm -rf "$2"
mkdir -p "$2"
ln -s "$1" "$2/course"
cd "$2"
sed -n '/^## In a program of your own$/,/^## Two/p' course/docs/architecture.md >section

# block WORD: the lines of the section's block of that language.
block() { sed -n '/^```'"$1"'$/,/^```$/p' section | grep -v '^```'; }
fail() {
  echo "FAIL: $1" >&2
  exit 1
}
# pixel PICTURE COLUMN ROW
pixel() {
  tail -c +$((16 + 3 * (400 * $3 + $2))) "$1" | head -c 3 | od -An -tu1 | tr -s ' ' | sed 's/ *$//'
}

block cpp >globe.cpp
block cmake >CMakeLists.txt
[ "$(wc -l <globe.cpp)" -le 25 ] || fail "the program has more than 25 lines"
drawn=0
# shellcheck disable=SC2016 # marks of Markdown
sed -e '/^```./,/^```$/d' section | sed -n 's/^    //p' >commands
while read -r command; do
  sh -euxc "$command"
  [ ! -f globe.ppm ] || mv globe.ppm "drawn_$((drawn += 1)).ppm"
done <commands
cmp drawn_1.ppm drawn_2.ppm || fail "two programs should have drawn the same picture"
# The globe's middle, (u, v) = (0.25, 0.60), is in column 2 and row 6 of 10: even squares are blue.
[ "$(pixel drawn_1.ppm 200 150)" = " 51 51 204" ] || fail "the middle is$(pixel drawn_1.ppm 200 150)"
[ "$(pixel drawn_1.ppm 0 0)" = " 127 178 255" ] || fail "the corner is$(pixel drawn_1.ppm 0 0)"
! grep -E 'stb|doctest|xsimd|TEXMAP' build/CMakeCache.txt || fail "the course asks for packages or has options"

# The course may be added twice, and no header needs exceptions.
(
  cd course/common
  for header in [mnpst]*[a-z]/*.hpp; do echo "#include \"$header\""; done | grep -v tools
) >all.cpp
cat >>CMakeLists.txt <<'END'
add_subdirectory(course again)
add_library(every_header OBJECT all.cpp)
target_link_libraries(every_header PRIVATE texmap::textbook)
target_compile_options(every_header PRIVATE -fno-exceptions)
END
{ cmake -B build && cmake --build build; } ||
  fail "the course cannot be added twice, or a header needs exceptions"

# The tables of light are linked by who reads them, and by nobody else.
[ -z "$(find build -name '*light_tables*.o*')" ] || fail "the tables of light were built"
cat >light.cpp <<'END'
#include "texture/light_texture.hpp"
int main() { return texmap::light_of_bytes<double>(texmap::TexelLight::linear)[255] == 1 ? 0 : 1; }
END
sed 's/globe/light/g; s/texmap::textbook/texmap::light_tables/' CMakeLists.txt >with_light && mv with_light CMakeLists.txt
cmake -B build
cmake --build build
build/light || fail "a white byte is not all of the light"
