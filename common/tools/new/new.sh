#!/bin/sh
# Makes a chapter from another one: ./course new 15_marble --from 06 calls this in the course's folder.
set -eu
name=${1:-}
number=${name%%_*}
from=${3:-}

wrong() {
  echo "error: $1" >&2
  exit 2
}

[ "$#-${2:-}" = 3---from ] || wrong "new takes a name and a chapter to begin from: ./course new 15_marble --from 06"
case $name in
  *[!a-z0-9_]* | *_ | [0-9][0-9]) name= ;;
  [0-9][0-9]_[a-z]*) ;;
  *) name= ;;
esac
[ -n "$name" ] || wrong "'$1' is no chapter's name: two digits, then words in small letters with underscores, such as 15_marble"
for folder in chapters/"$number"_*; do
  [ ! -e "$folder" ] || wrong "chapter $number is there: $folder"
done
case $from in [0-9]) from=0$from ;; esac
for old in chapters/"$from"_*; do :; done
old=${old#chapters/}
[ -d "chapters/$old" ] || wrong "there is no chapter '$from' to begin from; ./course list shows them"
if [ ! -f "chapters/$old/lesson.hpp" ] || grep -q '^<!-- no step:' "chapters/$old/README.md"; then
  wrong "chapter $from stands on its own; begin from one that is a step, such as 06"
fi

mkdir "chapters/$name"
for file in "chapters/$old"/*.hpp "chapters/$old"/*.cpp; do
  case $file in */one_file.cpp) continue ;; esac
  sed -e "s/chapter_$from/chapter_$number/g" -e "s/$old/$name/g" \
    -e "s/\.idea = \".*\"/.idea = \"what this chapter adds to chapter $from\"/" "$file" >"chapters/$name/${file##*/}"
done
title=$(printf '%s' "${name#*_}" | tr _ ' ')
cat >"chapters/$name/README.md" <<TEXT
# $number · $(printf '%s' "$title" | cut -c1 | tr '[:lower:]' '[:upper:]')$(printf '%s' "$title" | cut -c2-)

What does this chapter ask?

![What the picture shows](../../tests/golden/$name.png)

\`\`\`
./course run $number
\`\`\`

## The idea

## The step from chapter $from

<!-- step from $from: made by ./course steps --write -->
<!-- end of step -->
TEXT
[ ! -f "tests/golden/$old.png" ] || cp "tests/golden/$old.png" "tests/golden/$name.png"
if grep -q '^enum ObjectIndex { middle, left, right, ground }' "chapters/$name/lesson.hpp"; then
  cat >"tests/chapters/test_$name.cpp" <<TEXT
// Chapter $number: what its step changes.
#include <doctest.h>

#include "$old/lesson.hpp"
#include "$name/lesson.hpp"
#include "support/lesson_laws.hpp"

using namespace texmap;
using namespace texmap::test;

TEST_CASE("only the objects that the lesson declares change from chapter $from") {
  check_step(prepared<chapter_$from::Lesson>(), prepared<chapter_$number::Lesson>(),
             chapter_$number::ground);
}
TEXT
else
  echo "There is no test of its step: chapter $from has other objects than the stage." \
    "Write tests/chapters/test_$name.cpp."
fi
sh common/tools/steps/steps.sh . --write >/dev/null || :
cat <<TEXT
chapters/$name is chapter $from under a new name. Change its lesson.hpp; ./course run $number draws it.
When its picture is right: ./course run $number --out tests/golden/$name.png
What comes next: docs/architecture.md, "A chapter of your own"
TEXT
