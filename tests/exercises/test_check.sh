#!/bin/sh
# The script behind ./course check, in a small copy of the course. A stand-in builds "programs" that
# do what a word in the student's file says, so this takes a second or two; the programs themselves
# have their tests in C++.
# usage: test_check.sh ROOT [--shipped]   --shipped: only, are the files in chapters/ what students
#                                         should find? For CI: a student's own are not.
set -eu
root=$1
script=common/tools/check/check.sh

if [ "${2:-}" = --shipped ]; then
  cd "$root"
  for whole in tests/exercises/[0-9][0-9]_[0-9].hpp; do
    id=$(basename "$whole" .hpp | tr _ .)
    for file in chapters/"${id%.*}"_*/exercises/"${id#*.}"_*.hpp; do
      sh "$script" start "$id" | cmp -s - "$file" || { echo "FAIL: $file is not as $whole says: ./course check reset $id"; exit 1; }
    done
  done
  exit 0
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$root"/tests/exercises/02_[12].hpp "$work"
mkdir -p "$work/course/common/tools/check" "$work/course/tests/exercises" "$work/course/chapters/02_checkerboard_uv/exercises"
cp "$root/$script" "$work/course/common/tools/check"
cd "$work/course"
mv ../02_[12].hpp tests/exercises
folder=chapters/02_checkerboard_uv/exercises
first=$folder/1_where_on_the_map.hpp
second=$folder/2_a_walk_on_the_map.hpp

# ./course --build PRESET PROGRAM STATUS FILE COMMAND: writes the program.
cat >course <<'END'
#!/bin/sh
mkdir -p build/learn/bin
file=$(echo chapters/02_checkerboard_uv/exercises/"${3##*_}"_*.hpp)
! grep -q FAULT "$file" 2>/dev/null || exit 2
! grep -q SYNTAX "$file" 2>/dev/null || {
  echo "$5:1: error: what is SYNTAX? ${TEXMAP_VERBOSE:-$6}" >&2
  exit "$4"
}
cat >"build/learn/bin/$3" <<PROGRAM
#!/bin/sh
if grep -q LOOP $file; then while :; do :; done; fi
if grep -q CRASH $file; then kill -s SEGV \$\$; fi
if grep -q TROUBLE $file; then echo "error: no space"; exit 2; fi
echo "ran \$*."
grep -q 'std::' $file
PROGRAM
chmod +x "build/learn/bin/$3"
END
chmod +x course

failed=0
fail() {
  failed=$((failed + 1))
  printf 'FAIL: %s\n' "$1"
}
# expect NAME STATUS TEXT ARGUMENT...: ./course check ARGUMENT... ends with STATUS and says TEXT.
expect() {
  name=$1 wanted=$2 text=$3
  shift 3
  status=0
  said=$(TEXMAP_CHECK_SECONDS=1 sh "$script" "$@" 2>&1) || status=$?
  case "$status:$said" in
    "$wanted":*"$text"*) ;;
    *) fail "$name: status $status, not $wanted, or it does not say '$text':
$said" ;;
  esac
}
holds() { # NAME COMMAND...
  name=$1
  shift
  "$@" || fail "$name"
}

expect "a file that is gone is named" 2 "02.1 is gone; ./course check reset 02.1" 02.1
expect "reset writes it again" 0 "$first is as it was" reset 02.1
expect "reset writes the other" 0 "$second is as it was" reset 02.2
holds "a start has no solution" sh -c "! grep -qE 'solution|start:|hint:|std::acos' $first"
holds "a start has its task and lines to replace" grep -q 'return {p.x, p.y};' "$first"

expect "the list begins" 0 "[ ] 02.1  where on the map?
[ ] 02.2  a walk on the map
0 of 2 right. Next: write $first, then ./course check 02.1"
expect "a start is not right" 1 "ran --title where on the map?" 2.1
sh "$script" solution 02.1 >"$first"
expect "the solution is right" 0 "ran" 02.1
expect "the list shows it" 0 "[x] 02.1  where on the map?
[ ] 02.2  a walk on the map
1 of 2 right. Next: write $second"
echo "// one more line" >>"$first"
expect "a change is seen" 0 "[?] 02.1"
echo SYNTAX >>"$first"
expect "a file that does not compile" 1 \
  "$first:1: error: what is SYNTAX? ./course check 02.1 --verbose
02.1  where on the map? does not compile" 02.1
expect "the same with all that the compiler says" 1 "error: what is SYNTAX? 1
02.1  where on the map? does not compile" 2.1 --verbose
expect "then it is open again" 0 "[ ] 02.1"
expect "reset keeps the student's lines" 0 "Your lines are kept in out/exercises/02.1/" reset 02.1
holds "all of them" grep -q SYNTAX out/exercises/02.1/before_reset_*.hpp
expect "a reset of a start keeps nothing" 0 "$first is as it was" reset 02.1
holds "one file is kept" [ "$(find out/exercises/02.1 -name 'before_reset_*' | grep -c .)" = 1 ]

cp "$first" "$folder/1_where copy.hpp"
expect "a second file" 2 \
  "two files of exercise 02.1: $folder/1_where copy.hpp, $first; move one away" 02.1
rm "$folder/1_where copy.hpp"

echo "// CRASH" >>"$first"
expect "a crash" 1 "your function crashed (status 139)" 02.1
sh "$script" reset 02.1 >/dev/null
echo "// LOOP" >>"$first"
expect "a loop without an end" 1 "still running after 1 s of processor time; is there a loop without an end?" 02.1
sh "$script" reset 02.1 >/dev/null
echo "// TROUBLE" >>"$first"
expect "trouble that is not the student's" 2 "no space" 02.1
sh "$script" reset 02.1 >/dev/null

echo "// wrong" >"$folder/02_answer.hpp"
expect "a wrong answer" 1 "ran --question 02.a --answer 5." 02.a 5
expect "a second wrong answer" 1 "ran --question 02.a --answer 6 --again." 2.a 6
echo "std::" >"$folder/02_answer.hpp"
expect "a question alone is no answer" 0 "ran --question 02.a." 02.a
expect "a right answer" 0 "ran --question 02.a --answer 7 --again." 02.a 7
expect "after a right answer one begins again" 0 "ran --question 02.a --answer 5." 02.a 5
rm "$folder/02_answer.hpp"

expect "the first hint" 0 "(hint 1 of 3)" hint 02.1
expect "the second hint" 0 "(hint 2 of 3)" hint 2.1
expect "the third hint" 0 "Divide by what the angles run over.
(hint 3 of 3)" hint 02.1
expect "the last hint stays" 0 "(hint 3 of 3)" hint 02.1
expect "one wrong exercise of a chapter" 1 "ran --title a walk on the map" 2
for id in 02.1 02.2; do sh "$script" solution "$id" >"$(echo $folder/"${id#*.}"_*.hpp)"; done
expect "a chapter that is right" 0 "ran" 02
echo "// FAULT" >>"$second"
expect "a build that fails for another reason" 2 "for another reason than your file" 02
sh "$script" solution 02.2 >"$second"
expect "all are right" 0 "2 of 2 right.
"
expect "no such exercise" 2 "there is no exercise '02.9'" 02.9
expect "no such chapter" 2 "chapter '09' has no exercises" 09
expect "no such word" 2 "check takes one exercise" 02.1 02.2
expect "a word too many" 2 "check takes one chapter or one exercise, such as 02 or 02.1" 02 03
expect "a question of no chapter" 2 "there is no chapter with a question '99.a'" 99.a
expect "a word" 2 "'twelve' is no exercise" twelve
expect "reset of a word" 2 "'../x' is no exercise" reset ../x
expect "help" 0 "usage: ./course check" --help

printf '%s failed\n' "$failed"
[ "$failed" = 0 ]
