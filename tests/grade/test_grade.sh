#!/bin/sh
# Grades students of every kind with grade.sh and holds the rows against what they must be.
#
#   test_grade.sh COMPARE WRONG_PICTURES BUILD_DIR [--self-test]
#
# COMPARE and WRONG_PICTURES are the programs of these names; BUILD_DIR is where students' chapters are built, kept for the next time.
# With --self-test the checks are tried on graders that are wrong on purpose: each must be caught.
# GRADE_ONLY="pictures many" runs some parts only, GRADE_VERBOSE=1 names the checks that pass.
# Status 0: all checks passed; 1: not so; 2: wrong usage.
set -u

LC_ALL=C
export LC_ALL
unset TEXMAP_ASSETS

passed=0
failed=0
pass() {
  passed=$((passed + 1))
  [ -z "${GRADE_VERBOSE:-}" ] || printf 'passed %s\n' "$1"
}
fail() {
  failed=$((failed + 1))
  printf 'FAILED %s: %.400s\n' "$1" "$2"
}

again= # a grading that is taken once more instead of a new one: the self-test's, to save time
# --- Grading --------------------------------------------------------------------------------------------------------------------------

# grade ARGS...: sets status; the table is in T/table, what went to stderr in T/stderr, the results in T/out.
grade() {
  rm -rf "$T/out"
  if [ -n "$again" ]; then
    cp -R "$again" "$T/out"
    status=0
    sabotage
    return
  fi
  timeout -k 1 400 sh "$here/../../common/tools/grade/grade.sh" --out "$T/out" "$@" >"$T/table" 2>"$T/stderr" </dev/null
  status=$?
  sabotage
}

# sabotage: what --self-test does to a grading that was right.
sabotage() { :; }

# --- Expecting ------------------------------------------------------------------------------------------------------------------------

expect_status() { if [ "$status" = "$1" ]; then pass "$2"; else fail "$2" "status $1 expected, got $status ($(head -n 1 "$T/stderr"))"; fi; }

# expect_row STUDENT CHAPTER PATTERN: the row after these two, as a pattern of the shell. The columns:
# build,run,seconds,pixels_off,share_off,rmse,ssim,picture_ok,tests,note
expect_row() {
  found=$(tr -d '\r' <"$T/out/grades.csv" | grep -F -e "$1,$2," | sed -n '1p')
  # shellcheck disable=SC2254 # a pattern
  case $found in
    "$1,$2,"$3) pass "$1 $2" ;;
    *) fail "$1 $2" "'$3' expected, got '${found#"$1,$2,"}'" ;;
  esac
}

# expect_table STUDENT PATTERN: the student's row on the terminal.
expect_table() {
  found=$(grep -F -e " $1 " "$T/table" | sed -n '1p')
  # shellcheck disable=SC2254 # a pattern
  case $found in *" $1 "$2) pass "table: $1" ;; *) fail "table: $1" "'$2' expected, got '$found'" ;; esac
}

# expect_rows COUNT: so many rows of students, each with 12 cells and an end, by the rules of RFC 4180.
expect_rows() {
  rows=$(awk -v RS='\r\n' '
    {
      cells = 1; quoted = 0
      for (i = 1; i <= length($0); ++i) {
        c = substr($0, i, 1)
        if (c == "\"") quoted = !quoted
        if (c == "," && !quoted) ++cells
      }
      if (cells != 12 || quoted) bad = 1
    }
    END { print bad ? "bad" : NR - 1 }' "$T/out/grades.csv")
  if [ "$rows" = "$1" ]; then pass "$1 rows"; else fail "$1 rows" "got $rows"; fi
}

# expect_page NAME: the page is whole, complete in itself, and the index links it.
expect_page() {
  page=$T/out/$1.html
  if [ "$(tail -n 1 "$page" 2>/dev/null)" != '</html>' ]; then
    fail "page $1" 'it is not whole'
  elif grep -q -E '(src|href)="(https?:|/|file:)' "$page"; then
    fail "page $1" 'it points to something outside'
  elif [ "$(grep -c '<img ' "$page")" != "$(grep -c '<img src="data:image/png;base64,[A-Za-z0-9+/=]*" alt="[^"][^"]*">' "$page")" ]; then
    fail "page $1" 'a picture has no data or no alternative text'
  elif ! grep -q -F "href=\"$1.html\"" "$T/out/index.html"; then
    fail "page $1" 'the index does not link it'
  else
    pass "page $1"
  fi
}

# expect_on_page NAME COUNT TEXT
expect_on_page() {
  count=$(grep -c -F -e "$3" "$T/out/$1.html" 2>/dev/null)
  if [ "$count" = "$2" ]; then pass "page $1: $3"; else fail "page $1: $3" "$2 times expected, got $count"; fi
}

# --- Folders of pictures ----------------------------------------------------------------------------------------------------------------

# student NAME: a folder with all the golden pictures.
student() {
  mkdir -p "$T/students/$1" && cp "$golden"/[0-9][0-9]_*.png "$T/students/$1/" && rm -f "$T/students/$1"/06_lecture*
}

check_pictures() {
  chapters=$(find "$tree"/chapters -name lesson.hpp | wc -l)
  rm -rf "$T/students" "$T/more"
  for name in perfect mirrored shifted stray missing text cut small folder pipe '=1+1' '<b>"&' index; do student "$name"; done
  mkdir "$T/students/more"
  student more/perfect
  student more/Perfect
  mv "$T/students/more" "$T/more"
  for name in mirrored shifted stray small; do cp "$T/wrong/$name.png" "$T/students/$name/03_image_texture.png"; done
  rm "$T/students/missing/03_image_texture.png"
  echo 'not a picture' >"$T/students/text/03_image_texture.png"
  head -c 20000 "$golden/03_image_texture.png" >"$T/students/cut/03_image_texture.png"
  for name in folder pipe; do rm "$T/students/$name/03_image_texture.png"; done
  mkdir "$T/students/folder/03_image_texture.png"
  mkfifo "$T/students/pipe/03_image_texture.png"
  mkdir "$T/students/nothing"
  echo 'a stray file' >"$T/students/read me.txt"

  grade "$T/students"/* "$T/more/perfect/" "$T/more/Perfect"
  expect_status 0 'folders of pictures are graded'
  expect_rows "$((16 * chapters))"
  right=',,,0,0,0,1,yes,,'
  expect_row perfect 01_plain_spheres "$right"
  expect_row perfect 03_image_texture "$right"
  expect_row perfect 06_phong_texture_blend "$right"
  expect_row mirrored 01_plain_spheres "$right"
  expect_row mirrored 03_image_texture ',,,1????,0.02??????,?*.*,0.98*,no,,????? pixels are off by more than one level'
  expect_row shifted 03_image_texture ',,,[1-9]???,0.00??????,?*.*,0.99*,no,,???? pixels are off by more than one level'
  expect_row stray 03_image_texture ',,,1,0.00000208,?*.*,0.99*,yes,,as few as the rule allows: 1 pixel is off by more than one level'
  expect_row missing 03_image_texture ',,,,,,,no,,there is no picture 03_image_texture.png'
  expect_row missing 04_uv_conventions "$right"
  expect_row text 03_image_texture ',,,,,,,no,,*cannot be read: it is not a PNG or JPEG file*'
  expect_row cut 03_image_texture ',,,,,,,no,,*cannot be read: ?*'
  expect_row small 03_image_texture ',,,,,,,no,,*wrong size*400 x 300*'
  expect_row folder 03_image_texture ',,,,,,,no,,*is not a file*'
  expect_row pipe 03_image_texture ',,,,,,,no,,*is not a file*'
  expect_row nothing 01_plain_spheres ',,,,,,,no,,there is no picture 01_plain_spheres.png'
  expect_row perfect-2 01_plain_spheres "$right"
  expect_row "'=1+1" 01_plain_spheres "$right"
  expect_row '"<b>""&"' 01_plain_spheres "$right"
  expect_table perfect "*ok *ok *ok *ok *ok *ok *- *$chapters/$chapters"
  expect_table mirrored "*ok *ok *differs 2.5 % *ok *ok *ok *- *$((chapters - 1))/$chapters"
  expect_table small "*wrong size*$((chapters - 1))/$chapters"
  expect_table text "*unreadable*$((chapters - 1))/$chapters"
  expect_table nothing "*missing*missing*missing*missing*missing*missing*0/$chapters"
  for name in perfect mirrored missing text perfect-2 Perfect-3 _1_1 _b___ index-2; do expect_page "$name"; done
  expect_on_page mirrored "$((chapters + 2))" '<img '
  expect_on_page mirrored 1 'Difference map'
  expect_on_page perfect "$chapters" '<img '
  expect_on_page _b___ 0 '<b>'
  if grep -q 'skipped, not a folder: .*read me.txt' "$T/stderr"; then pass 'a file'; else fail 'a file' "$(head -n 1 "$T/stderr")"; fi
}

# Two hundred students, some with a mistake, to the end.
check_many() {
  rm -rf "$T/students"
  mkdir "$T/students"
  number=0
  while [ $number -lt 200 ]; do
    number=$((number + 1))
    folder=$T/students/student-$number
    mkdir "$folder"
    ln -s "$golden/01_plain_spheres.png" "$golden/03_image_texture.png" "$folder"
    case $number in
      *3) ln -sf "$T/wrong/mirrored.png" "$folder/03_image_texture.png" ;;
      *5) rm "$folder/01_plain_spheres.png" ;;
      *7) rm "$folder/03_image_texture.png" && echo text >"$folder/03_image_texture.png" ;;
      *9) ln -sf nowhere "$folder/03_image_texture.png" ;;
    esac
  done
  grade --chapters 01,03 "$T/students"/*
  expect_status 0 'two hundred students are graded'
  expect_rows 400
  counted=$(tr -d '\r' <"$T/out/grades.csv" | awk -F, '{ ++n[$10] } END { print n["yes"], n["no"] }')
  if [ "$counted" = '320 80' ]; then pass 'two hundred students'; else fail 'two hundred students' "320 right and 80 wrong pictures expected, got $counted"; fi
  expect_row student-13 03_image_texture ',,,1????,*,no,,*'
  expect_row student-200 03_image_texture ',,,0,0,0,1,yes,,'
  pages=$(find "$T/out" -name 'student-*.html' | wc -l)
  if [ "$pages" -eq 200 ]; then pass '200 pages'; else fail '200 pages' "got $pages"; fi

  # Stopped on the way, what is done stays.
  rm -rf "$T/out"
  sh "$here/../../common/tools/grade/grade.sh" --out "$T/out" --chapters 01,03 "$T/students"/* >"$T/table" 2>"$T/stderr" </dev/null &
  grading=$!
  while kill -s 0 $grading 2>/dev/null && [ "$(grep -c / "$T/table")" -lt 10 ]; do sleep 0.1; done
  kill -s TERM $grading
  wait $grading
  status=$?
  expect_status 130 'stopped on the way'
  done_rows=$(grep -c '^student-' "$T/out/grades.csv")
  expect_rows "$done_rows"
  if [ "$done_rows" -ge 18 ] && [ "$done_rows" -lt 400 ]; then pass 'some rows'; else fail 'some rows' "got $done_rows"; fi
  expect_page student-1
  left=$(find "$T/out" -name '.*part')
  if [ -z "$left" ] || [ "$(find "$T/out" -name '.*part' | wc -l)" -le 1 ]; then pass 'no pieces'; else fail 'no pieces' "$left"; fi
}

# --- Checkouts --------------------------------------------------------------------------------------------------------------------------

# checkout NAME: a student's checkout with all that the grading could take from it.
checkout() {
  mkdir -p "$T/students/$1/chapters" && cp -R "$tree/chapters/01_plain_spheres" "$tree/chapters/02_checkerboard_uv" "$T/students/$1/chapters/"
}

# program NAME CHAPTER: the student's main.cpp is what comes in.
program() { cat >"$T/students/$1/chapters/$2/main.cpp"; }

check_checkouts() {
  rm -rf "$T/students"
  for name in good crash hang no-build misuse; do checkout "$name"; done
  mkdir -p "$T/students/good/common/engine/render"
  echo '#error this is not used' >"$T/students/good/common/engine/render/render.hpp"
  program crash 01_plain_spheres <<'CODE'
int main() {
  volatile int* nothing = nullptr;
  return *nothing;
}
CODE
  program hang 01_plain_spheres <<'CODE'
int main() {
  for (volatile int i = 0;; i = 1 - i) {
  }
}
CODE
  echo 'this does not compile' >>"$T/students/no-build/chapters/01_plain_spheres/lesson.hpp"
  rm -r "$T/students/no-build/chapters/02_checkerboard_uv"
  # Leaves a child in a session of its own, heeds no signal, prints what a page and a terminal must not get and more than a log
  # may hold, needs more memory than it may have, and takes its own folder away.
  program misuse 01_plain_spheres <<'CODE'
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

int main() {
  signal(SIGTERM, SIG_IGN);
  if (fork() == 0) {
    setsid();
    for (;;) sleep(1);
  }
  std::puts("<script>alert(1)</script> \033[31mred \a&");
  const std::string line(1 << 20, 'x');
  for (int i = 0; i < 500; ++i) std::fwrite(line.data(), 1, line.size(), stdout);
  if (std::malloc(std::size_t{3} << 30) != nullptr) return 9;
  std::filesystem::remove_all(std::filesystem::current_path());
  return 7;
}
CODE
  # Not a picture of its own.
  program misuse 02_checkerboard_uv <<CODE
#include <unistd.h>
int main() { return symlink("$golden/02_checkerboard_uv.png", "02_checkerboard_uv.png"); }
CODE

  grade --no-tests --seconds 3 --megabytes 1024 --chapters 01,02 "$T/students"/*
  expect_status 0 'checkouts are graded'
  expect_rows 10
  expect_row good 01_plain_spheres 'ok,ok,?*,*,yes,,*'
  expect_row good 02_checkerboard_uv 'ok,ok,?*,*,yes,,*'
  expect_row crash 01_plain_spheres 'ok,crashed SIGSEGV,*,,,,,no,,*SIGSEGV*'
  expect_row crash 02_checkerboard_uv 'ok,ok,?*,*,yes,,*'
  expect_row hang 01_plain_spheres 'ok,hang,3.??,,,,,no,,it was stopped after 3 s*'
  expect_row hang 02_checkerboard_uv 'ok,ok,?*,*,yes,,*'
  expect_row no-build 01_plain_spheres 'does not build,,,,,,,no,,*chapters/01_plain_spheres/lesson.hpp:*error:*'
  expect_row no-build 02_checkerboard_uv 'missing,missing,,,,,,no,,there is no chapters/02_checkerboard_uv/lesson.hpp'
  expect_row misuse 01_plain_spheres 'ok,failed (7),*,,,,,no,,it ended with status 7*'
  expect_row misuse 02_checkerboard_uv 'ok,ok,*,,,,,no,,the picture is a link'
  expect_table crash '*crashed SIGSEGV *ok *- *1/2'
  expect_table no-build '*does not build *missing *0/2'
  for name in good crash hang no-build misuse; do expect_page "$name"; done
  expect_on_page misuse 0 '<script'
  expect_on_page misuse 1 '&lt;script&gt;'
  expect_on_page misuse 0 "$(printf '\033')"
  expect_on_page good 1 'common/ differs'
  expect_on_page no-build 0 "$T"
  expect_on_page no-build 0 "$tree"
  if [ "$(wc -c <"$T/out/misuse.html")" -lt 1000000 ]; then pass 'a short page'; else fail 'a short page' 'the log is not cut'; fi
  # Only its own kind of program is looked for: the one in the grading's build.
  left=$(find /proc -maxdepth 2 -name exe -lname "$TEXMAP_GRADE_BUILD/bin/*" 2>/dev/null)
  if [ -z "$left" ]; then pass 'no process is left'; else fail 'no process is left' "$left"; fi

  # With tests: a right chapter passes them all, one with another red does not.
  rm -rf "$T/students"
  checkout good
  checkout pink
  sed 's/Solid{red}/Solid{{1.0, 0.4, 0.4}}/' "$tree/chapters/01_plain_spheres/lesson.hpp" >"$T/students/pink/chapters/01_plain_spheres/lesson.hpp"
  grade --chapters 1 "$T/students"/*
  expect_status 0 'the tests are run'
  expect_row good 01_plain_spheres 'ok,ok,?*,yes,3 of 3,'
  expect_row pink 01_plain_spheres 'ok,ok,*,no,[0-2] of 3,*pixels are off*'
  expect_table good '*ok *3/3 *2/2'
  expect_on_page pink 1 'What the tests said'
}

# --- The command line -------------------------------------------------------------------------------------------------------------------

# refuses WORDS...: status 2, and the first line of stderr is an error.
refuses() {
  grade "$@"
  expect_status 2 "refused: $*"
  case $(head -n 1 "$T/stderr") in 'error: '?*) pass "refused: $*" ;; *) fail "refused: $*" "$(head -n 1 "$T/stderr")" ;; esac
  [ ! -e "$T/out" ] || fail "refused: $*" 'something was written'
}

check_words() {
  student perfect
  refuses
  refuses --no-tests
  refuses --nonsense "$T/students/perfect"
  refuses "$T/no such folder" "$T/students/perfect"
  refuses "$golden/01_plain_spheres.png"
  for value in 0 -1 x '' 1.5 999999999; do
    refuses --seconds "$value" "$T/students/perfect"
    refuses "--megabytes=$value" "$T/students/perfect"
  done
  for value in '' 99 '*' '01;02' 1,,x; do refuses --chapters "$value" "$T/students/perfect"; done
  refuses "$T/students/perfect" --seconds
  refuses --out '' "$T/students/perfect"
  grade --help
  expect_status 0 '--help'
  grade --chapters 3,01 -- "$T/students/perfect"
  expect_status 0 'chapters by number'
  expect_rows 2
}

# --- Self-test --------------------------------------------------------------------------------------------------------------------------

# must_catch WHAT PART: the part under way must have failed.
must_catch() {
  passed=0 failed=0
  "check_$2" >/dev/null
  if [ "$failed" -gt 0 ]; then caught=$((caught + 1)); else missed="$missed; $1"; fi
}

# shellcheck disable=SC2317,SC2016 # sabotage is called by grade; $d is for sed
self_test() {
  caught=0 missed=''
  edit() { sed "$1" "$T/out/grades.csv" >"$T/edited" && mv "$T/edited" "$T/out/grades.csv"; }
  passed=0 failed=0
  check_pictures
  right_failed=$failed
  cp -R "$T/out" "$T/again"
  again=$T/again
  check_pictures # once more, and nothing done to it
  right_failed=$((right_failed + failed))
  sabotage() { edit 's/,no,/,yes,/'; }
  must_catch 'every picture is right' pictures
  sabotage() { edit '$d'; }
  must_catch 'a row is missing' pictures
  sabotage() { edit 's/"//g'; }
  must_catch 'nothing is quoted' pictures
  sabotage() { edit "s/^'=/=/"; }
  must_catch 'a formula' pictures
  sabotage() { status=1; }
  must_catch 'another status' pictures
  sabotage() { rm -f "$T/out/mirrored.html"; }
  must_catch 'a page is missing' pictures
  sabotage() { [ ! -e "$T/out/_b___.html" ] || echo '<b>' >>"$T/out/_b___.html"; }
  must_catch 'a name is not escaped' pictures
  sabotage() { :; }
  printf '#!/bin/sh\nexit 0\n' >"$T/compare"
  chmod +x "$T/compare"
  again=
  TEXMAP_COMPARE=$T/compare
  must_catch 'a comparison that cannot fail' pictures
  printf 'self-test: %s of 8 wrong graders caught%s\n' "$caught" "$missed"
  [ "$caught" = 8 ] && [ "$right_failed" = 0 ]
}

# --- Main -------------------------------------------------------------------------------------------------------------------------------

if [ $# -lt 3 ] || [ $# -gt 4 ] || [ ! -x "$1" ] || [ ! -x "$2" ] || [ "${4:---self-test}" != --self-test ]; then
  printf 'usage: test_grade.sh COMPARE WRONG_PICTURES BUILD_DIR [--self-test]\n' >&2
  exit 2
fi
here=$(cd "$(dirname "$0")" && pwd) || exit 2
tree=$(cd "$here/../.." && pwd) || exit 2
golden=$tree/tests/golden
TEXMAP_COMPARE=$1
TEXMAP_GRADE_BUILD=$3
export TEXMAP_COMPARE TEXMAP_GRADE_BUILD
T=$(mktemp -d "${TMPDIR:-/tmp}/texmap-test-grade-XXXXXX") || exit 2
trap 'rm -rf "$T"' EXIT
trap 'exit 1' INT TERM HUP
mkdir "$T/wrong"
"$2" "$T/wrong" || exit 2

if [ $# = 4 ]; then
  self_test
  exit
fi
for part in ${GRADE_ONLY:-pictures many words checkouts}; do "check_$part"; done
printf '%s passed, %s failed\n' "$passed" "$failed"
[ "$failed" = 0 ] && [ "$passed" -ge 1 ]
