#!/bin/sh
# Checkouts from a student's folder to the tables, with the real builder: checkouts.sh GRADE WORK
# GRADE is the program; WORK is a folder for what is built, kept for the next time.
# Status 77: nothing can run checkouts here.
set -u
LC_ALL=C
export LC_ALL
[ $# -eq 2 ] || {
  echo 'usage: checkouts.sh GRADE WORK' >&2
  exit 2
}
tree=$(cd "$(dirname "$0")/../.." && pwd) || exit 2
command -v python3 >/dev/null 2>&1 || exit 77
T=$(mktemp -d "${TMPDIR:-/tmp}/texmap-checkouts-XXXXXX") || exit 2
trap 'rm -rf "$T"' EXIT

failed=0
# expect FILE TEXT: a line of the file has the text.
expect() {
  grep -q -F -e "$2" "$T/out/$1" || {
    echo "FAILED: $1 has no line with $2"
    failed=1
  }
}

# One that is right, packed as a site packs it; one that does not compile; one that crashes; one that
# has no chapter; and one that mirrors the texture.
for name in right/texmap-main broken crash swapped; do
  mkdir -p "$T/class/$name/chapters"
  cp -R "$tree/chapters/03_image_texture" "$T/class/$name/chapters/"
done
mkdir -p "$T/class/other/chapters/04_uv_conventions"
echo 'this does not compile' >>"$T/class/broken/chapters/03_image_texture/lesson.hpp"
echo 'int main() { __builtin_trap(); }' >"$T/class/crash/chapters/03_image_texture/main.cpp"
sed 's/= texture\.load()/= mirrored(texture.load())/; s/{texture\.load()}/{mirrored(texture.load())}/
  s|^struct Lesson|inline Image mirrored(Image image) {\
  for (int y = 0; y < image.height; ++y)\
    for (int x = 0; x < image.width / 2; ++x) {\
      const Rgb8 swapped = image.at(x, y);\
      image.at(x, y) = image.at(image.width - 1 - x, y);\
      image.at(image.width - 1 - x, y) = swapped;\
    }\
  return image;\
}\
\
&|' "$tree/chapters/03_image_texture/lesson.hpp" >"$T/class/swapped/chapters/03_image_texture/lesson.hpp"

"$1" --out "$T/out" --work "$2" --chapters 03 --no-tests --trust-students "$T/class" >"$T/table" || {
  echo "FAILED: status $?"
  exit 1
}
cat "$T/table"
expect points.csv '"right","1","1","1"'
for name in broken crash swapped other; do expect points.csv "\"$name\",\"0\",\"1\",\"1\""; done
expect grades.csv '"broken","03_image_texture","does not build"'
expect grades.csv '"crash","03_image_texture","ok","crashed SIG'
expect grades.csv '"other","03_image_texture","missing"'
expect grades.csv '"swapped","03_image_texture","ok","ok"'
# Where the program is that draws known mistakes, this one has its word.
[ ! -x "$(dirname "$1")/draw_mistakes" ] || expect grades.csv 'mirrored: u runs the other way'
expect broken.html 'error:'
[ ! -e "$T/out/right.html" ] || {
  echo 'FAILED: a page where nothing is to be seen'
  failed=1
}

# Exercise 02.1: right, under another name; mirrored; as it was at the start; one that ends with status 0 before its function is tried; one
# that has no end; one that does not compile. None has 02.2.
solution=$tree/tests/exercises/02_1.hpp
for name in right mirrored start ends loops broken; do
  mkdir -p "$T/exercises/$name/chapters/02_checkerboard_uv/exercises"
done
# put NAME: writes a student's file of 02.1.
put() { cat >"$T/exercises/$1/chapters/02_checkerboard_uv/exercises/1_mine.hpp"; }
put right <"$solution"
sed 's/atan2(-p\.z/atan2(p.z/' "$solution" | put mirrored
(cd "$tree" && sh common/tools/check/check.sh start 02.1) | put start
{
  echo '#include <unistd.h>'
  cat "$solution"
  echo 'const int ended = [] { _exit(0); return 0; }();'
} | put ends
sed 's/^  const double u/  for (volatile int i = 0;; i = 1 - i) {} &/' "$solution" | put loops
echo 'this does not compile' | put broken
# Right, too: in Chapters/, and without chapters/.
mkdir -p "$T/exercises/capital" "$T/exercises/bare"
cp -R "$T/exercises/right/chapters" "$T/exercises/capital/Chapters"
cp -R "$T/exercises/right/chapters/." "$T/exercises/bare"

"$1" --out "$T/out" --work "$2" --chapters 02.2,2.1 --seconds 2 --trust-students --format gradescope "$T/exercises" >"$T/table" || {
  echo "FAILED: status $?"
  exit 1
}
cat "$T/table"
for name in right capital bare; do expect points.csv "\"$name\",\"1\",\"2\",\"2\""; done
for name in mirrored start ends loops broken; do expect points.csv "\"$name\",\"0\",\"2\",\"2\""; done
expect grades.csv '"right","02.2","missing"'
expect grades.csv '"mirrored","02.1","ok","ok"'
expect grades.csv '"u runs the other way: your map is mirrored; tried: on +z'
expect grades.csv '"start","02.1","ok","ok"'
expect grades.csv '"not yet: '
expect grades.csv '"ends","02.1","ok","ok"'
expect grades.csv '"no verdict: the program ended'
expect grades.csv '"loops","02.1","ok","hang"'
expect grades.csv '"broken","02.1","does not build"'
expect index.html '3 right<br>'
expect mirrored.results.json '"number": "2.E1"'
[ ! -e "$T/out/right.html" ] || expect right.html 'there is no chapters/02_checkerboard_uv/exercises/2_which_square.hpp'
exit $failed
