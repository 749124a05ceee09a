#!/bin/sh
# A student's copy, made and used: ./course export, check, test, the book, a chapter of one's own.
# usage: test_export.sh ROOT WORK      WORK: a folder for the copy, made anew
set -eu
root=$1
rm -rf "$2"
mkdir -p "$2"
cd "$2"

fail() {
  echo "FAIL: $1" >&2
  exit 1
}
# says STATUS TEXT COMMAND...: the command ends with the status and says the text.
says() {
  wanted=$1 text=$2 status=0
  shift 2
  said=$("$@" 2>&1) || status=$?
  case "$status:$said" in
    "$wanted":*"$text"*) ;;
    *) fail "$*: status $status, not $wanted, or it does not say '$text':
$said" ;;
  esac
}

says 2 "there is no chapter 77" "$root/course" export --chapters 77 kit
says 2 "'all' names no chapters" "$root/course" export --chapters all kit
says 2 "outside of the course" "$root/course" export --chapters 02 "$root/kit"
says 0 "chapters 00, 01, 02, 03, 04, 05 with 15 exercises" "$root/course" export --chapters 00-05 kit
# Any chapters: the suites of 00, 03 and 06 read the lessons of 02 and 05.
says 0 "chapters 00, 03, 06" "$root/course" export --chapters 00,03,06 gaps
(cd gaps && cmake --preset learn >gaps.log &&
  cmake --build build/learn --parallel 2 --target chapter_suites) >build.log ||
  fail "gaps: it does not build"
[ "$(cd gaps && ctest --preset learn -N -R '^test_0[036]_' | grep -c ' #')" = 3 ] ||
  fail "gaps: a suite is left out"
(cd gaps && ctest --preset learn -R '^test_0[036]_') >>build.log || fail "gaps: a test fails"
says 2 "not empty" "$root/course" export --chapters 00-05 kit
# What an editor or somebody left beside the files stays there.
mkdir own
for part in assets chapters common course docs tests CMakeLists.txt CMakePresets.json README.md; do
  cp -R "$root/$part" own/
done
for name in 1_where_on_the_map.hpp~ 1_mine.hpp 2_a_walk_on_the_map.hpp.orig .3_bricks.hpp.swp; do
  echo mine >"own/chapters/02_checkerboard_uv/exercises/$name"
done
says 0 "with 3 exercises" own/course export --chapters 02 mine
exercises=chapters/02_checkerboard_uv/exercises
[ "$(ls -A "mine/$exercises")" = "$(ls "kit/$exercises")" ] ||
  fail "an editor's copy of an answer is in the copy"
rm -r own
cd kit
! grep -rlE '^ *// solution$|<summary>Answer' tests chapters || fail "a solution or an answer is in the copy"
[ -z "$(find . -name '*06_*' -o -name teaching.md)" ] || fail "what should not be there is in the copy"
grep -q 'command: ./course check 05.3' .github/workflows/classroom.yml || fail "the workflow does not check 05.3"

cmake --preset release >release.log || fail "it does not configure for all numbers"
says 1 "where on the map? not yet" ./course check 02.1
says 2 "no solutions" ./course check solution 02.1
(cd "$root" && sh common/tools/check/check.sh solution 02.1) >chapters/02_checkerboard_uv/exercises/1_where_on_the_map.hpp
says 0 "where on the map? right" ./course check 02.1
says 1 "151867 of 480000 pixels" ./course diff tests/golden/01_plain_spheres.png tests/golden/02_checkerboard_uv.png
says 2 "there is no exercise '06.1'" ./course check 06.1
says 1 "'grade' is not in this copy" ./course grade .
says 1 "'playground' is not in this copy" ./course playground
says 0 "this text" ./course help
! { ./course help && cat docs/commands.md docs/packages.md; } |
  grep -E "course (grade|export|pages|playground|bench|numbers|assets|steps)" ||
  fail "the help or a page names a command that is not there"
says 0 "100% tests passed" ./course test 02
! cmake --build build/learn --target book >book.log || says 0 "pages" build/learn/bin/book . out # stops at a link that leads nowhere

# A chapter of one's own: known at once, gone at once.
says 2 "no chapter's name" ./course new marble --from 05
says 2 "chapter 05 is there" ./course new 05_marble --from 04
says 2 "there is no chapter '06'" ./course new 15_marble --from 06
says 0 "under a new name" ./course new 15_marble --from 05
says 0 "100% tests passed, 0 tests failed out of 2" ./course test 15
sed 's/\.squares = 10/.squares = 20/' chapters/15_marble/lesson.hpp >lesson && mv lesson chapters/15_marble/lesson.hpp
says 8 "test_15_marble (Failed)" ./course test 15
says 0 "15_marble" ./course list
rm -r chapters/15_marble chapters/03_image_texture
says 2 "there is no chapter '15'" ./course run 15
says 0 "100% tests passed" ./course test 02
says 0 "1 of 12 right" ./course check
[ ! -x build/learn/bin/book ] || says 0 "pages" build/learn/bin/book . out
