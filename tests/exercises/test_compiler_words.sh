#!/bin/sh
# What ./course check says of files that do not compile: of each slip of slips.txt, and of what the
# linker misses, four lines. usage: test_compiler_words.sh ROOT COMPILER
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
file=chapters/02_checkerboard_uv/exercises/1_f.hpp
mkdir -p "${file%/*}"
failed=0

words_of=$root/common/tools/check/compiler_words
# says LINES: the words, and a line with one of these digits.
says() {
  said=$(LC_ALL=C awk -v mine="$file" -v own=OWN -f "$words_of.awk" "$words_of.tsv" log) || :
  case "$(($(printf '%s\n' "$said" | wc -l))) $said" in
    "4 $file:"[$1]:*"$words"*OWN\)) ;;
    *) failed=$((failed + 1)) && echo "FAIL: '$words', line '$1', is '$said':" && head -n 12 log ;;
  esac
}

set -- "$2" -std=c++20 "-I$root/common/tools/check" "-I$root/common" -Wall -Werror=return-type
printf '#include "attempt.hpp"\n#include "exercise.hpp"\n' >all.hpp
"$@" -x c++-header all.hpp -o all.hpp.gch
cat >exercise_02_1.cpp <<END
#include "$work/$file"
const texmap::check::Attempt texmap::check::attempt{"02.1", std::function(&::f), ""};
END

{ cat "$root/tests/exercises/slips.txt" && echo "-- end"; } >slips
words=
while IFS= read -r line; do
  case "$line" in
    "-- "*)
      if [ -n "$words" ]; then
        LC_ALL=C "$@" -include all.hpp -fsyntax-only exercise_02_1.cpp >log 2>&1 || :
        says "$(sed -n '\,//!,=' "$file" | tr -d '\n')"
      fi
      words=${line#-- }
      echo '#include "exercise.hpp"' >"$file"
      ;;
    *) printf '%s\n' "$line" >>"$file" ;;
  esac
done <slips

printf 'double helper(double x);\ndouble f(double x) { return helper(x); }\n' >"$file"
echo "exercise_02_1.cpp:(.text+0x9): undefined reference to \`helper(double)'" >log
words="helper(double) is declared, and its body is nowhere"
says 1
printf 'double f(double x) { return x; }\nint main() {}\n' >"$file"
first="a/exercise_02_1.cpp.o:exercise_02_1.cpp:(.text+0x9): first defined here"
echo "main.cpp:(.text+0x4): multiple definition of \`main'; $first" >log
words="your file has a main"
says 2
echo "$failed failed"
[ "$failed" = 0 ]
