#!/bin/sh
# What ./course check says of files that do not compile: each slip of slips.txt, in the words of this compiler, is named by the student's line
# and a sentence. Of an error behind the linker, and of one that is not the student's.
# usage: test_compiler_words.sh ROOT COMPILER
set -eu
root=$1
compiler=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
file=chapters/02_checkerboard_uv/exercises/1_f.hpp
mkdir -p "$work/${file%/*}"
cd "$work"

failed=0
fail() {
  failed=$((failed + 1))
  printf 'FAIL: %s\n' "$1"
}

# says WORDS LINE: the log is told in four lines: the student's file with this line (empty: any), the line, the words, where all of it is.
says() {
  said=$(LC_ALL=C awk -v mine="$file" -v own="OWN" -f "$root/common/tools/check/compiler_words.awk" \
    "$root/common/tools/check/compiler_words.tsv" log) || said="nothing"
  case "$said" in
    "$file:$2"*"$1"*OWN\)) [ "$(printf '%s\n' "$said" | wc -l)" = 4 ] || fail "more than four lines: $said" ;;
    *) fail "'$1', line '$2', is told as '$said':
$(head -n 12 log)" ;;
  esac
}

options="-std=c++20 -I$root/common/tools/check -I$root/common -Wall -Wextra -Werror=return-type"
printf '#include "attempt.hpp"\n#include "exercise.hpp"\n' >all.hpp
# shellcheck disable=SC2086  # a list of options
"$compiler" $options -x c++-header all.hpp -o all.hpp.gch
cat >exercise_02_1.cpp <<END
#include "$work/$file"
const texmap::check::Attempt texmap::check::attempt{"02.1", std::function(&::f), ""};
END
# compile: the student's file, as exercise_NN_K.cpp does it.
compile() {
  # shellcheck disable=SC2086
  ! LC_ALL=C "$compiler" $options -include all.hpp -fsyntax-only exercise_02_1.cpp >log 2>&1 || fail "'$words' compiles"
  says "$words" "$(sed -n '\,//!,=' "$file")"
}

words=
while IFS= read -r line; do
  case "$line" in
    "-- "*)
      [ -z "$words" ] || compile
      words=${line#-- }
      echo '#include "exercise.hpp"' >"$file"
      ;;
    *) printf '%s\n' "$line" >>"$file" ;;
  esac
done <"$root/tests/exercises/slips.txt"
compile

printf '#include "exercise.hpp"\n\ndouble helper(double x);\ndouble f(double x) { return helper(x); }\n' >"$file"
cat >log <<'END'
/usr/bin/ld: exercise_02_1.cpp.o: in function `f(double)':
exercise_02_1.cpp:(.text+0x9): undefined reference to `helper(double)'
collect2: error: ld returned 1 exit status
END
says "helper(double) is declared, and its body is nowhere" 3:
echo "$root/common/math/vec3.hpp:9:1: error: expected ';'" >log
said=$(awk -v mine="$file" -f "$root/common/tools/check/compiler_words.awk" "$root/common/tools/check/compiler_words.tsv" log) &&
  fail "an error that is not the student's is told as $said"

printf '%s failed\n' "$failed"
[ "$failed" = 0 ]
