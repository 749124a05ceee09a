#!/bin/sh
# What ./course check says of files that do not compile: the slips of slips.txt, each in four lines, by the words of this compiler; what the
# linker misses; and nothing of an error in the course's own headers.
# usage: test_compiler_words.sh ROOT COMPILER
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
file=chapters/02_checkerboard_uv/exercises/1_f.hpp
mkdir -p "${file%/*}"
failed=0

told() { LC_ALL=C awk -v mine="$file" -v own=OWN -f "$root/common/tools/check/compiler_words.awk" "$root/common/tools/check/compiler_words.tsv" log; }
# says LINES: the words, and a line with one of these digits.
says() {
  said=$(told) || said="nothing"
  case "$(printf '%s\n' "$said" | wc -l) $said" in
    "4 $file:"[$1]:*"$words"*OWN\)) ;;
    *) failed=$((failed + 1)) && printf "FAIL: '%s', line '%s', is told as '%s':\n%s\n" "$words" "$1" "$said" "$(head -n 12 log)" ;;
  esac
}

# With what exercise_NN_K.cpp includes first compiled once.
set -- "$2" -std=c++20 "-I$root/common/tools/check" "-I$root/common" -Wall -Wextra -Werror=return-type
printf '#include "attempt.hpp"\n#include "exercise.hpp"\n' >all.hpp
"$@" -x c++-header all.hpp -o all.hpp.gch
printf '#include "%s"\nconst texmap::check::Attempt texmap::check::attempt{"02.1", std::function(&::f), ""};\n' "$work/$file" >exercise_02_1.cpp

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

printf '#include "exercise.hpp"\n\ndouble helper(double x);\ndouble f(double x) { return helper(x); }\n' >"$file"
# shellcheck disable=SC2016 # the linker's quotes
printf 'exercise_02_1.cpp:(.text+0x9): undefined reference to `helper(double)'"'\n" >log
words="helper(double) is declared, and its body is nowhere"
says 3
echo "$root/common/math/vec3.hpp:9:1: error: expected ';'" >log
! told || failed=$((failed + 1))
echo "$failed failed"
[ "$failed" = 0 ]
