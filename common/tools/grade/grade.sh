#!/bin/sh
# Grades students' chapters: ./course grade DIR... calls it. Run with --help for its use; docs/grading.md tells more.
#
# Environment, for the tests of this script:
#   TEXMAP_COMPARE      the program compare; default build/release/bin/compare
#   TEXMAP_GRADE_BUILD  where the students' chapters are built; default build/grade
# Needs the coreutils of GNU, sed, awk, and for a checkout cmake. A checkout is built in the instructor's tree: only its chapters/ is
# the student's. What a student's files and programs do ends in a row of the table.
set -u

LC_ALL=C
export LC_ALL
umask 022

tree=$(cd "$(dirname "$0")/../../.." && pwd) || exit 2
compare=${TEXMAP_COMPARE:-$tree/build/release/bin/compare}
build=${TEXMAP_GRADE_BUILD:-$tree/build/grade}
golden=$tree/tests/golden

out=$tree/out/grades
seconds=60          # a program or a suite of tests may take
megabytes=2048      # of address space it may have
only=               # chapters asked for, empty for all
with_tests=1
compile_seconds=300 # one file may take to compile
compile_kib=6291456 # of memory the compiler may have
file_blocks=1048576 # of 512 bytes: the largest file that a student's program may write
log_bytes=65536     # kept of what a program prints
source_kib=1024     # the largest file taken from a student's chapters/
picture_kib=65536   # the largest picture looked at
nl='
'
tab=$(printf '\t')

usage() {
  cat <<'TEXT'
usage: ./course grade [options] DIR...
  DIR                 a student's checkout (with chapters/NN_name/lesson.hpp) or a folder of pictures NN_name.png
  --chapters 01,03    grade these chapters only
  --no-tests          compare the pictures, do not run the chapters' tests
  --seconds N         time that a program or a suite of tests may take, 1 to 86400; default 60
  --megabytes N       memory that it may have, 64 to 1048576; default 2048
  --out FOLDER        where grades.csv, index.html and a page for each student go; default out/grades
  --help              this text
status: 0 all were graded, whatever the grades; 2 wrong command line, or nothing could be graded
TEXT
}

wrong() {
  printf 'error: %s\n' "$1" >&2
  usage >&2
  exit 2
}

trouble() {
  printf 'error: %s\n' "$1" >&2
  exit 2
}

# --- Text -----------------------------------------------------------------------------------------------------------------------

# What no terminal and no page should get: control characters, also those that begin with 0302, and marks that turn writing round.
c1=$(printf '\302[\200-\237]')
turn=$(printf '\342\200[\216\217\252-\256]\\|\342\201[\246-\251]')
clean() { tr '\011' ' ' | tr -d '\000-\010\013-\037\177' | sed -e "s/$c1//g" -e "s/$turn//g" | as_utf8; }

# as_utf8: leaves out what is not UTF-8, where there is a program for it.
if command -v iconv >/dev/null 2>&1; then
  as_utf8() { iconv -c -f UTF-8 -t UTF-8 2>/dev/null || :; }
else
  as_utf8() { cat; }
fi

escape_html() { clean | sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g' -e 's/"/\&quot;/g' -e "s/'/\&#39;/g"; }

# html TEXT: the text, to be put into a page.
html() {
  case $1 in
    *[!A-Za-z0-9\ .,:\;%/_+-]*) printf '%s\n' "$1" | escape_html ;;
    *) printf '%s\n' "$1" ;;
  esac
}

# cell TEXT: sets cell to the text as one cell of a table in RFC 4180; a formula for a spreadsheet becomes text.
cell() {
  cell=$1
  case $cell in [=+@-]* | "$tab"*) cell="'$cell" ;; esac
  case $cell in
    *[\",]* | *"$nl"*) cell="\"$(printf '%s' "$cell" | sed 's/"/""/g')\"" ;;
  esac
}

# csv_row TEXT...: appends a row in one piece.
csv_row() {
  row=
  for text; do
    cell "$text"
    row="$row${row:+,}$cell"
  done
  printf '%s\r\n' "$row" >>"$out/grades.csv" || trouble "cannot write '$out/grades.csv'"
}

# first_lines: the beginning of what a program said, a few short lines.
first_lines() { head -n 12 | cut -c 1-240; }

# without_chatter: without the lines in which make and ninja tell what they do.
without_chatter() { grep -a -v -E '^(\[ *[0-9]+(%|/[0-9]+)\]|g?make(\[[0-9]+\])?:|FAILED:|ninja: build stopped)'; }

# without_paths: what a compiler said, with this machine's paths taken out.
without_paths() { sed -e "s|$build_pattern/graded/|chapters/|g" -e "s|$tree_pattern/||g"; }
as_pattern() { printf '%s\n' "$1" | sed 's/[][\\.*^$|]/\\&/g'; }

# --- Running what a student wrote -------------------------------------------------------------------------------------------------

child=
# limited SECONDS KIB FOLDER LOG COMMAND...: runs a command as its own session in a folder, with limits, nothing to read and an
# environment of its own. LOG gets the beginning of what it prints, LOG.end the end. Then nothing of it runs any more.
# Sets status, and ms, how long it took.
limited() {
  limit=$1 kib=$2 folder=$3 log=$4
  shift 4
  rm -f "$state/pipe"
  mkfifo "$state/pipe" || trouble 'cannot make a pipe'
  # What it prints is drained, so that gigabytes of it neither fill the disk nor stop the program.
  # shellcheck disable=SC2016 # for the inner shell
  timeout -k 1 $((limit + 10)) sh -c 'head -c "$1" >"$2"; tail -c 4096 >"$2.end"' sh "$log_bytes" "$log" <"$state/pipe" 2>/dev/null &
  drain=$!
  begun=$(date +%s%N)
  # shellcheck disable=SC3045,SC2086 # ulimit -v and -c: in every sh that is used; $detach: a word or none
  (
    cd "$folder" || exit 126
    ulimit -c 0
    ulimit -f "$file_blocks"
    ulimit -v "$kib"
    exec env -i PATH="$PATH" HOME="$PWD" TMPDIR="$PWD" LC_ALL=C LD_LIBRARY_PATH="${LD_LIBRARY_PATH:-}" "$mark" $detach timeout --kill-after=2 "$limit" "$@"
  ) </dev/null >"$state/pipe" 2>&1 &
  child=$!
  wait "$child" 2>/dev/null
  status=$?
  ms=$((($(date +%s%N) - begun) / 1000000))
  end_child
  wait "$drain" 2>/dev/null
}

# end_child: ends the command under way with all its children, also those that went into a session of their own.
end_child() {
  [ -n "$child" ] || return 0
  [ -z "$detach" ] || kill -s KILL -- "-$child" 2>/dev/null
  kill -s KILL "$child" 2>/dev/null
  child=
  [ -r /proc/self/environ ] || return 0
  rounds=0
  while [ $rounds -lt 20 ]; do
    found=$(grep -l -s -a -F -e "$mark" /proc/[0-9]*/environ)
    [ -n "$found" ] || return 0
    for process in $found; do
      process=${process#/proc/}
      kill -s KILL "${process%/environ}" 2>/dev/null
    done
    rounds=$((rounds + 1))
  done
}

# say_how_it_ended: sets ended to 'ok' or why the last command did not end well.
say_how_it_ended() {
  if [ "$ms" -ge $((limit * 1000)) ] && { [ "$status" = 124 ] || [ "$status" = 137 ]; }; then
    ended=hang
  elif [ "$status" = 0 ]; then
    ended=ok
  elif [ "$status" -gt 128 ] && signal=$(kill -l $((status - 128)) 2>/dev/null); then
    ended="crashed SIG${signal#SIG}"
  else
    ended="failed ($status)"
  fi
}

# explain_end: sets why to a sentence about it.
explain_end() {
  case $ended in
    ok) why= ;;
    hang) why="it was stopped after $limit s" ;;
    'crashed SIGKILL') why='it was killed, perhaps for want of memory' ;;
    'crashed SIGXFSZ') why='it wrote a file that is too large' ;;
    crashed*) why="it ended by signal ${ended#crashed }" ;;
    *) why="it ended with status $status" ;;
  esac
}

seconds_of() { printf '%d.%02d\n' $(($1 / 1000)) $(($1 % 1000 / 10)); }

# empty_folder: sets place to an empty folder for a student's program, of which nothing is kept.
empty_folder() {
  [ -z "$place" ] || { chmod -R u+rwx "$place" && rm -rf "$place"; } 2>/dev/null
  place=$(mktemp -d "${TMPDIR:-/tmp}/texmap-run-XXXXXX") || trouble 'cannot make a temporary folder'
}

# --- Building ----------------------------------------------------------------------------------------------------------------------

# take_sources: puts the student's chapters where the build finds them. What is as it was keeps its time, so that it need not be
# compiled again. Only plain files of moderate size are taken; a missing main.cpp is the instructor's, a missing lesson does not
# compile.
take_sources() {
  mkdir -p "$build/graded" "$state/taken"
  rm -rf "$state/taken"
  for chapter in $all_chapters; do
    mkdir -p "$state/taken/$chapter"
    [ -d "$student_dir/chapters/$chapter" ] || continue
    # shellcheck disable=SC2016 # for the inner shell
    (cd "$student_dir/chapters/$chapter" && find . -type f -size "-${source_kib}k" \( -name '*.[ch]pp' -o -name '*.[ch]' -o -name '*.inc' -o -name '*.inl' \) \
      -exec sh -c 'for f; do mkdir -p "$0/${f%/*}" && cp "$f" "$0/$f"; done' "$state/taken/$chapter" {} +) 2>/dev/null
  done
  # shellcheck disable=SC2016 # for the inner shell
  (cd "$student_dir/chapters" && find . ! -name . -prune -type f -size "-${source_kib}k" -name '*.h*' -exec sh -c 'cp "$@" "$0"' "$state/taken" {} +) 2>/dev/null
  for chapter in $all_chapters; do
    [ -f "$state/taken/$chapter/main.cpp" ] || cp "$tree/chapters/$chapter/main.cpp" "$state/taken/$chapter/main.cpp"
  done
  # Takes away what this student does not have, then brings what is new.
  (cd "$build/graded" && find . ! -type d -exec sh -c 'for f; do [ -e "$0/$f" ] || rm -f "$f"; done' "$state/taken" {} +)
  (cd "$state/taken" && find . -type f -exec sh -c 'for f; do
      cmp -s "$f" "$0/$f" || { rm -rf "$0/$f"; mkdir -p "$0/${f%/*}" && cp "$f" "$0/$f"; }
    done' "$build/graded" {} +)
}

# make_targets LOG TARGET...: builds what it can of the targets.
make_targets() {
  make_log=$1
  shift
  targets=
  for target; do targets="$targets --target $target"; done
  # shellcheck disable=SC3045,SC2086 # ulimit -v: in every sh that is used; $targets, $detach: words
  (
    ulimit -c 0
    ulimit -v "$compile_kib"
    exec env "$mark" $detach timeout --kill-after=2 $((compile_seconds * 13)) cmake --build "$build" --config Release --parallel "$jobs" $targets -- -k $keep_going
  ) </dev/null >"$make_log" 2>&1 &
  child=$!
  wait "$child" 2>/dev/null
  made=$?
  end_child
  return $made
}

# prepare_build: configures the build and compiles what all students share.
prepare_build() {
  [ -z "$prepared" ] || return 0
  mkdir -p "$build" || trouble "cannot make the folder '$build'"
  take_build
  take_sources
  progress 'building what all students share'
  # A compiler that does not end is ended.
  if ! cmake -S "$tree" -B "$build" -D CMAKE_BUILD_TYPE=Release -D "TEXMAP_CHAPTERS=$build/graded" -D "TEXMAP_INSTRUMENT=" \
    -D "CMAKE_CXX_COMPILER_LAUNCHER=timeout;--kill-after=2;$compile_seconds" >"$state/configure.log" 2>&1; then
    cat "$state/configure.log" >&2
    trouble 'the build could not be configured'
  fi
  keep_going=
  grep -q '^CMAKE_GENERATOR:INTERNAL=Ninja' "$build/CMakeCache.txt" && keep_going=0
  shared='texture measure kernels picture render app'
  [ "$with_tests" = 0 ] || shared="$shared doctest_main"
  # shellcheck disable=SC2086 # words
  if ! make_targets "$state/shared.log" $shared; then
    cat "$state/shared.log" >&2
    trouble 'the common code could not be built'
  fi
  prepared=yes
}

# take_build: two gradings in one build folder would mix their students.
take_build() {
  if ! mkdir "$build/busy" 2>/dev/null; then
    other=$(cat "$build/busy/pid" 2>/dev/null)
    if [ -n "$other" ] && kill -s 0 "$other" 2>/dev/null; then trouble "another grading is under way (process $other) in $build"; fi
  fi
  printf '%s\n' $$ >"$build/busy/pid"
  busy=$build/busy
}

# first_error LOG: the line that says what is wrong.
first_error() {
  line=$(grep -m 1 -E '(error|Error):' "$1")
  [ -n "$line" ] || line=$(grep -m 1 -E 'undefined reference|multiple definition|out of memory|Error 124|Error 137|error' "$1")
  case $line in *'Error 124'* | *'Error 137'*) line="the compiler took more than $compile_seconds s or too much memory" ;; esac
  [ -n "$line" ] || line=$(grep -m 1 . "$1")
  printf '%.300s\n' "$line" | clean | without_paths
}

# build_student: compiles what the student's checkout has of the chapters.
build_student() {
  prepare_build
  take_sources
  wanted=
  for chapter in $all_chapters; do rm -f "$build/bin/$chapter" "$build/tests/test_$chapter"; done
  for chapter in $chapters; do
    [ -f "$build/graded/$chapter/lesson.hpp" ] || continue
    wanted="$wanted $chapter"
    [ "$with_tests" = 0 ] || wanted="$wanted test_$chapter"
  done
  [ -n "$wanted" ] || return 0
  # shellcheck disable=SC2086 # words
  make_targets "$state/all.log" $wanted && return 0
  # Once more one by one, for each one's messages.
  for target in $wanted; do
    [ -x "$build/bin/$target" ] || [ -x "$build/tests/$target" ] && continue
    make_targets "$state/$target.build" "$target"
  done
}

# note_other_changes: what the student changed outside the chapters is not graded, but said.
note_other_changes() {
  [ -d "$student_dir/common" ] || return 0
  changed=$(timeout -k 1 20 diff -rq --no-dereference "$tree/common" "$student_dir/common" 2>/dev/null </dev/null | head -n 5 |
    sed -e 's/^Files .* and \(.*\) differ$/\1/' -e "s|$(as_pattern "$student_dir")/||g" -e "s|Only in $tree_pattern/|missing from |g")
  [ -n "$changed" ] || return 0
  student_note="common/ differs from the instructor's and was not used: $(printf '%s\n' "$changed" | sed '$!s/$/;/' | tr '\n' ' ' | clean)"
}

# --- One chapter -------------------------------------------------------------------------------------------------------------------

# add_note TEXT
add_note() { note="$note${note:+; }$1"; }

# say_message WHAT LOG: puts the beginning of what the compiler or the program said on the page.
say_message() {
  [ -s "$2" ] || return 0
  {
    printf '<p class="what">%s</p>\n<pre>' "$1"
    without_chatter <"$2" | first_lines | without_paths | escape_html
    printf '</pre>\n'
  } >>"$state/messages"
}

# compare_picture: compares $picture with the golden. Sets off, share, rmse, ssim, picture_ok, and result when there is a reason.
# The rule is that of tests/golden/test_golden.cpp.
compare_picture() {
  rm -f "$state/map.png" "$state/figures.json"
  reference=$golden/$chapter.png
  readable=1
  if cmp -s "$picture" "$reference"; then
    off=0 share=0 rmse=0 ssim=1 picture_ok=yes same_bytes=1
    return 0
  fi
  timeout -k 1 60 "$compare" "$reference" "$picture" --pixels-off-by-more-than 1 --at-most 0.02% --map "$state/map.png" \
    --json "$state/figures.json" >"$state/compare.log" 2>"$state/compare.err" </dev/null
  compared=$?
  if [ "$compared" -gt 1 ]; then
    message=$(head -n 1 "$state/compare.err" | clean)
    case $message in
      *' differ in size'*)
        result='wrong size'
        add_note "the picture has the wrong size; golden and student: ${message#*size: }"
        ;;
      *)
        result=unreadable readable=0
        message=${message##*\': }
        [ -n "$message" ] || message="compare ended with status $compared"
        add_note "the picture cannot be read: $message"
        ;;
    esac
    return 0
  fi
  IFS=' ' read -r off share rmse ssim <<FIGURES
$(awk '
    /^off by more than/ { sub(/^[^:]*: /, ""); off = $1 + 0 }
    /"pixels_compared"/ { all = $2 + 0 }
    /"root_mean_square_error"/ { rmse = $2 + 0 }
    /"ssim"/ { ssim = $2 + 0 }
    END { if (all > 0) printf "%d %.8f %.6f %.6f\n", off, off / all, rmse, ssim }' "$state/compare.log" "$state/figures.json")
FIGURES
  if [ "$compared" = 0 ]; then
    picture_ok=yes
    [ "$off" = 0 ] || add_note "as few as the rule allows: $(pixels_off)"
  else
    result="differs $(percent "$share")"
    add_note "$(pixels_off)"
  fi
}

pixels_off() {
  if [ "$off" = 1 ]; then echo '1 pixel is off by more than one level'; else echo "$off pixels are off by more than one level"; fi
}

percent() { printf '%s\n' "$1" | awk '{ p = 100 * $1; printf (p >= 10 ? "%.0f %%\n" : p >= 1 ? "%.1f %%\n" : "%.2g %%\n"), p }'; }

# take_picture FILE: makes the file the picture to compare, or says why not.
take_picture() {
  if [ ! -e "$1" ] && [ ! -L "$1" ]; then
    result=missing
    add_note "there is no picture $chapter.png"
  elif [ ! -f "$1" ]; then
    result=unreadable
    add_note "$chapter.png is not a file"
  elif [ ! -r "$1" ]; then
    result=unreadable
    add_note "$chapter.png may not be read"
  elif [ -n "$(find -L "$1" -prune -size "+${picture_kib}k" 2>/dev/null)" ]; then
    result=unreadable
    add_note "$chapter.png is too large to be a picture"
  else
    picture=$1
    compare_picture
  fi
}

# run_program: draws the chapter's picture with the student's program.
run_program() {
  empty_folder
  limited "$seconds" $((megabytes * 1024)) "$place" "$state/run.log" "$build/bin/$chapter" --out "$chapter.png"
  say_how_it_ended
  explain_end
  run=$ended
  spent=$(seconds_of "$ms")
  rm -f "$state/drawn.png"
  drawn=$place/$chapter.png
  [ -e "$drawn" ] || drawn=$place/out/$chapter.png
  if [ -L "$drawn" ]; then
    result=missing
    add_note 'the picture is a link'
  elif [ -f "$drawn" ] && cp "$drawn" "$state/drawn.png" 2>/dev/null; then
    take_picture "$state/drawn.png"
  else
    take_picture "$place/$chapter.png"
  fi
  if [ "$run" != ok ]; then
    result=$run
    picture_ok=no
    note="$why${note:+; $note}"
  fi
  say_message 'What the program said' "$state/run.log"
}

# run_suite: runs the chapter's tests on the student's lesson. Sets tests, tests_ok.
run_suite() {
  if [ ! -x "$build/tests/test_$chapter" ]; then
    tests='does not build'
    suites_not_run=$((suites_not_run + 1))
    suite_error=$(first_error "$state/test_$chapter.build")
    case $note in *"$suite_error"*) suite_error='for the same reason' ;; esac
    add_note "the tests do not compile: $suite_error"
    [ "$build_word" = ok ] && say_message 'What the compiler said about the tests' "$state/test_$chapter.build"
    return 0
  fi
  empty_folder
  limited "$seconds" $((megabytes * 1024)) "$place" "$state/tests.log" "$build/tests/test_$chapter" --no-colors=true
  say_how_it_ended
  explain_end
  # The last line with the figures counts: "[doctest] test cases: 5 | 4 passed | 1 failed | 0 skipped".
  IFS=' ' read -r cases cases_passed <<FIGURES
$(cat "$state/tests.log.end" "$state/tests.log" | awk '/^\[doctest\] test cases: / && !seen { seen = 1; print $4 + 0, $6 + 0 }')
FIGURES
  if [ -z "$cases" ]; then
    suites_not_run=$((suites_not_run + 1))
    case $ended in ok | failed*) tests='no result' ;; *) tests=$ended ;; esac
    add_note "the tests: ${why:-they ended without a result}"
  else
    tests="$cases_passed of $cases"
    if [ "$ended" = ok ] && [ "$cases_passed" = "$cases" ] && [ "$cases" -gt 0 ]; then
      tests_ok=yes
    else
      case $ended in ok | failed*) ;; *) add_note "the tests: $why" ;; esac
    fi
  fi
  [ $tests_ok = yes ] || {
    # What failed is said; doctest's first lines are not news.
    grep -v -E '^\[doctest\] (doctest version|run with)' "$state/tests.log" | grep -v '^===' | sed '/./,$!d' >"$state/tests.short"
    say_message 'What the tests said' "$state/tests.short"
  }
}

# grade_chapter: grades $chapter of the student, and writes its row and its part of the page.
grade_chapter() {
  build_word='' run='' spent='' off='' share='' rmse='' ssim='' picture_ok=no tests='' tests_ok=no note='' result='' picture=''
  same_bytes=0 readable=0
  : >"$state/messages"
  rm -f "$state/map.png"
  if [ "$kind" = pictures ]; then
    take_picture "$student_dir/$chapter.png"
  elif [ ! -f "$build/graded/$chapter/lesson.hpp" ]; then
    result=missing build_word=missing run=missing
    add_note "there is no chapters/$chapter/lesson.hpp"
    [ "$with_tests" = 0 ] || suites_not_run=$((suites_not_run + 1))
  else
    if [ -x "$build/bin/$chapter" ]; then
      build_word=ok
      progress "$student: running $chapter"
      run_program
    else
      build_word='does not build' result='does not build'
      add_note "$(first_error "$state/$chapter.build")"
      say_message 'What the compiler said' "$state/$chapter.build"
    fi
    if [ "$with_tests" = 1 ]; then
      progress "$student: testing $chapter"
      run_suite
    fi
  fi
  [ -n "$result" ] || result=ok
  [ "$picture_ok" = yes ] && points=$((points + 1))
  [ "$tests_ok" = yes ] && points=$((points + 1))
  most_points=$((most_points + 1))
  if [ "$kind" = checkout ] && [ "$with_tests" = 1 ]; then most_points=$((most_points + 1)); fi
  case $tests in
    [0-9]*)
      tests_passed=$((tests_passed + ${tests% of *}))
      tests_run=$((tests_run + ${tests#* of }))
      ;;
  esac
  case $note in *[!A-Za-z0-9\ .,:\;/_-]*) note=$(printf '%s' "$note" | tr '\n' ' ' | clean) ;; esac
  csv_row "$student" "$chapter" "$build_word" "$run" "$spent" "$off" "$share" "$rmse" "$ssim" "$picture_ok" "$tests" "$note"
  results="$results$result$nl"
  chapter_of_page
}

# --- Pages -------------------------------------------------------------------------------------------------------------------------

page_head() {
  cat <<TEXT
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<title>$1</title>
<style>
:root { color-scheme: light dark; --ink: #1b1f24; --soft: #57606a; --paper: #ffffff; --card: #f4f6f8; --line: #d0d7de; --good: #1a6b32; --bad: #a4262c; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e9ec; --soft: #a3adb7; --paper: #15181c; --card: #1f242a; --line: #3a424b; --good: #6fd08c; --bad: #ff9a94; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 1rem; font: 1rem/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); }
h1 { font-size: 1.5rem; line-height: 1.25; margin: .5rem 0; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 0 0 .5rem; overflow-wrap: anywhere; }
a { color: inherit; }
section { border: 1px solid var(--line); border-radius: .5rem; padding: 1rem; margin: 1rem 0; }
.good { color: var(--good); font-weight: 600; }
.bad { color: var(--bad); font-weight: 600; }
.note, .what, figcaption { color: var(--soft); overflow-wrap: anywhere; }
.what { margin: .75rem 0 .25rem; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(20rem, 100%), 1fr)); gap: .75rem; }
figure { margin: 0; }
figure img { display: block; width: 100%; height: auto; border: 1px solid var(--line); }
pre { margin: 0; padding: .75rem; background: var(--card); overflow-x: auto; white-space: pre-wrap; overflow-wrap: anywhere; font: .85rem/1.4 ui-monospace, monospace; }
dl { display: grid; grid-template-columns: repeat(auto-fit, minmax(9rem, 1fr)); gap: .25rem 1rem; margin: .75rem 0 0; }
dt { color: var(--soft); font-size: .85rem; }
dd { margin: 0; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: .35rem .6rem; border-bottom: 1px solid var(--line); vertical-align: top; }
td, thead th { white-space: nowrap; }
th:first-child { min-width: 8rem; white-space: normal; overflow-wrap: anywhere; }
</style>
</head>
<body>
<main>
TEXT
}

# class_of RESULT
class_of() { case $1 in ok | yes) printf 'class="good"' ;; *) printf 'class="bad"' ;; esac; }

# figure FILE CAPTION ALT: a picture with its bytes in the page; "-" takes the golden's, which are encoded once.
figure() {
  printf '<figure><img src="data:image/png;base64,'
  if [ "$1" = - ]; then
    [ -f "$state/$chapter.base64" ] || base64 -w 0 "$golden/$chapter.png" >"$state/$chapter.base64"
    cat "$state/$chapter.base64"
  else
    base64 -w 0 "$1"
  fi
  printf '" alt="%s"><figcaption>%s</figcaption></figure>\n' "$3" "$2"
}

# entry NAME VALUE: one of the figures, if there is a value.
entry() { [ -z "$2" ] || printf '<div><dt>%s</dt><dd>%s</dd></div>\n' "$1" "$(html "$2")"; }

# chapter_of_page: the chapter's part of the student's page.
chapter_of_page() {
  {
    printf '<section id="%s">\n<h2>%s: <span %s>%s</span></h2>\n' "$chapter" "$chapter" "$(class_of "$result")" "$(html "$result")"
    [ -z "$note" ] || printf '<p class="note">%s</p>\n' "$(html "$note")"
    printf '<div class="pictures">\n'
    if [ "$same_bytes" = 1 ]; then
      figure - 'The golden picture; the student'"'"'s file has the same bytes' "The golden picture of $chapter, which the student's equals"
    elif [ -n "$picture" ] && [ "$readable" = 1 ]; then
      figure - 'The golden picture' "The golden picture of $chapter"
      figure "$picture" 'The student'"'"'s picture' "The student's picture of $chapter: $(html "$result")"
      [ ! -s "$state/map.png" ] ||
        figure "$state/map.png" 'Where they differ, with a scale in levels' "Difference map of $chapter: $(pixels_off)"
    else
      figure - 'The golden picture' "The golden picture of $chapter; the student has none that can be shown"
    fi
    printf '</div>\n<dl>\n'
    entry Build "$build_word"
    entry Run "$run"
    [ -z "$spent" ] || entry Time "$spent s"
    entry 'Pixels off' "$off"
    [ -z "$share" ] || entry 'Share off' "$(percent "$share")"
    [ -z "$rmse" ] || entry RMSE "$rmse levels"
    entry SSIM "$ssim"
    entry Picture "$(case $picture_ok in yes) echo right ;; *) echo 'not right' ;; esac)"
    entry 'Tests passed' "$tests"
    printf '</dl>\n'
    cat "$state/messages"
    printf '</section>\n'
  } >>"$state/sections"
}

# write_page: the student's page, in one piece.
write_page() {
  {
    page_head "Grades of $student_html"
    printf '<p><a href="index.html">All students</a></p>\n<h1>Grades of <bdi>%s</bdi></h1>\n<p>%s of %s points%s</p>\n' \
      "$student_html" "$points" "$most_points" "$([ "$tests_run" = 0 ] || printf '; %s of %s tests passed' "$tests_passed" "$tests_run")$([ "$suites_not_run" = 0 ] || printf '; tests of %s chapters not run' "$suites_not_run")"
    [ -z "$student_note" ] || printf '<p class="note">%s</p>\n' "$(html "$student_note")"
    cat "$state/sections"
    printf '</main>\n</body>\n</html>\n'
  } >"$out/.$page.part" || trouble "cannot write '$out/$page.html'"
  mv "$out/.$page.part" "$out/$page.html" || trouble "cannot write '$out/$page.html'"
}

# write_index: the table of all students graded so far.
write_index() {
  {
    page_head 'Grades'
    printf '<h1>Grades</h1>\n<p>%s of %s folders graded. All figures: <a href="grades.csv">grades.csv</a></p>\n' "$graded" "$asked"
    printf '<div class="wide" role="region" aria-label="Grades" tabindex="0"><table>\n<thead><tr><th scope="col">Student</th>'
    for chapter in $chapters; do printf '<th scope="col">%s</th>' "$chapter"; done
    printf '<th scope="col">Tests</th><th scope="col">Points</th></tr></thead>\n<tbody>\n'
    cat "$state/index_rows"
    printf '</tbody>\n</table></div>\n</main>\n</body>\n</html>\n'
  } >"$out/.index.part" || trouble "cannot write '$out/index.html'"
  mv "$out/.index.part" "$out/index.html" || trouble "cannot write '$out/index.html'"
}

# --- One student ---------------------------------------------------------------------------------------------------------------------

progress() { [ ! -t 2 ] || printf '\r\033[K[%s/%s] %s' "$number" "$asked" "$1" >&2; }
end_progress() { [ ! -t 2 ] || printf '\r\033[K' >&2; }

# name_student: sets student, what the tables call it, and page, the name of its file; each once.
name_student() {
  base=$(printf '%s' "${student_dir##*/}" | tr '\n' ' ' | clean)
  [ -n "$base" ] || base=student
  file=$(printf '%s' "$base" | tr -c 'A-Za-z0-9_-' '_' | cut -c 1-80)
  student=$base page=$file
  suffix=1
  while [ "$page" = index ] || grep -q -i -x -F -e "$page" "$state/pages"; do
    suffix=$((suffix + 1))
    student=$base-$suffix page=$file-$suffix
  done
  printf '%s\n' "$page" >>"$state/pages"
  student_html=$(html "$student")
}

# in_table: the student's row on the terminal.
in_table() {
  end_progress
  printf '%-9s %-20s' "[$number/$asked]" "$student"
  printf '%s' "$results" | while IFS= read -r result; do printf ' %-15.15s' "$result"; done
  tests_text=-
  [ "$tests_run" = 0 ] || tests_text=$tests_passed/$tests_run
  [ "$suites_not_run" = 0 ] || tests_text="$tests_text, $suites_not_run not run"
  printf ' %-16s %s/%s\n' "$tests_text" "$points" "$most_points"
}

# in_index: the student's row of the page of all.
in_index() {
  {
    printf '<tr><th scope="row"><a href="%s.html"><bdi>%s</bdi></a></th>' "$page" "$student_html"
    printf '%s' "$results" | while IFS= read -r result; do
      printf '<td %s>%s</td>' "$(class_of "$result")" "$(html "$result")"
    done
    printf '<td>%s</td><td>%s/%s</td></tr>\n' "$tests_text" "$points" "$most_points"
  } >>"$state/index_rows"
}

# grade_student DIR
grade_student() {
  student_dir=$(cd "$1" 2>/dev/null && pwd) || student_dir=${1%/}
  name_student
  points=0 most_points=0 tests_passed=0 tests_run=0 suites_not_run=0 results='' student_note=''
  : >"$state/sections"
  kind=pictures
  if [ -d "$student_dir/chapters" ]; then
    kind=checkout
    progress "$student: building"
    build_student
    note_other_changes
  elif [ ! -r "$student_dir" ] || [ ! -x "$student_dir" ]; then
    student_note='the folder may not be read'
  fi
  for chapter in $chapters; do grade_chapter; done
  graded=$((graded + 1))
  in_table
  in_index
  write_page
  write_index
}

# --- Main ----------------------------------------------------------------------------------------------------------------------------

state='' place='' busy='' drain=''
tidy() {
  end_child
  [ -z "$state" ] || rm -rf "$state"
  [ -z "$place" ] || { chmod -R u+rwx "$place" && rm -rf "$place"; } 2>/dev/null
  [ -z "$busy" ] || rm -rf "$busy"
}

interrupted() {
  trap '' INT TERM HUP
  end_progress
  printf 'interrupted: %s of %s folders graded; they are in %s\n' "$graded" "$asked" "$out" >&2
  tidy
  trap - EXIT
  exit 130
}

# whole FLAG VALUE LEAST MOST
whole() {
  case $2 in
    '' | *[!0-9]* | ????????*) ;;
    *) [ "$2" -ge "$3" ] && [ "$2" -le "$4" ] && return ;;
  esac
  wrong "$1 takes a whole number from $3 to $4, not '$2'"
}

all_chapters=
for readme in "$tree"/chapters/[0-9][0-9]_*/lesson.hpp; do
  chapter=${readme%/lesson.hpp}
  chapter=${chapter##*/}
  [ -f "$golden/$chapter.png" ] && all_chapters="$all_chapters $chapter"
done

# The options, wherever they stand; what remains are the folders.
rest=$#
while [ "$rest" -gt 0 ]; do
  word=$1
  shift
  rest=$((rest - 1))
  case $word in
    --out | --seconds | --megabytes | --chapters)
      [ "$rest" -gt 0 ] || wrong "$word needs a value"
      value=$1
      shift
      rest=$((rest - 1))
      ;;
    --out=* | --seconds=* | --megabytes=* | --chapters=*)
      value=${word#*=}
      word=${word%%=*}
      ;;
  esac
  case $word in
    --help | -h)
      usage
      exit 0
      ;;
    --no-tests) with_tests=0 ;;
    --out)
      [ -n "$value" ] || wrong '--out needs a folder'
      out=$value
      ;;
    --seconds)
      whole --seconds "$value" 1 86400
      seconds=$value
      ;;
    --megabytes)
      whole --megabytes "$value" 64 1048576
      megabytes=$value
      ;;
    --chapters)
      [ -n "$value" ] || wrong '--chapters needs numbers such as 01,03'
      only=$value
      ;;
    --)
      while [ "$rest" -gt 0 ]; do
        word=$1
        shift
        set -- "$@" "$word"
        rest=$((rest - 1))
      done
      ;;
    -*) wrong "there is no option '$word'" ;;
    *) set -- "$@" "$word" ;;
  esac
done

chapters=$all_chapters
if [ -n "$only" ]; then
  chapters=
  words=$(printf "%s\n" "$only" | tr ",*?[" " ...")
  for word in $words; do
    case "$all_chapters " in *" ${word}_"* | *" 0${word}_"* | *" $word "*) ;; *) wrong "there is no chapter '$word'" ;; esac
  done
  for chapter in $all_chapters; do
    of_chapter=${chapter%%_*}
    case " $(printf "%s" "$words" | tr "\n" " ") " in *" $of_chapter "* | *" ${of_chapter#0} "* | *" $chapter "*) chapters="$chapters $chapter" ;; esac
  done
  [ -n "$chapters" ] || wrong "--chapters needs numbers such as 01,03, not '$only'"
fi

[ $# -gt 0 ] || wrong 'name the folders to grade'
asked=0
for folder; do
  [ -e "$folder" ] || wrong "there is no folder '$folder'"
  [ ! -d "$folder" ] || asked=$((asked + 1))
done
[ "$asked" -gt 0 ] || trouble 'there is nothing to grade: none of these is a folder'
for program in timeout base64 mktemp mkfifo awk; do
  command -v "$program" >/dev/null 2>&1 || trouble "the program $program is missing (GNU coreutils and awk are needed)"
done
[ -x "$compare" ] || trouble "the program compare is missing; ./course grade builds it"

number=0 graded=0 prepared=''
jobs=$(nproc 2>/dev/null || echo 2)
detach=
if command -v setsid >/dev/null 2>&1; then detach=setsid; fi
mark=TEXMAP_GRADED=$$-$(date +%s%N)
tree_pattern=$(as_pattern "$tree")

trap tidy EXIT
trap interrupted INT TERM HUP
state=$(mktemp -d "${TMPDIR:-/tmp}/texmap-grade-XXXXXX") || trouble 'cannot make a temporary folder'
: >"$state/pages"
: >"$state/index_rows"
mkdir -p "$out" || trouble "cannot make the folder '$out'"
case $build in /*) ;; *) build=$PWD/$build ;; esac
build_pattern=$(as_pattern "$build")
: >"$out/grades.csv" || trouble "cannot write '$out/grades.csv'"
csv_row student chapter build run seconds pixels_off share_off rmse ssim picture_ok tests note

printf '%-9s %-20s' '' student
for chapter in $chapters; do printf ' %-15.15s' "chapter ${chapter%%_*}"; done
printf ' %-16s %s\n' tests points
write_index
for folder; do
  if [ ! -d "$folder" ]; then
    printf 'skipped, not a folder: %s\n' "$(printf '%s' "$folder" | clean)" >&2
    continue
  fi
  number=$((number + 1))
  case $folder in -*) folder=./$folder ;; esac
  grade_student "$folder"
done
printf 'Look at %s/index.html\n' "${out#"$PWD/"}"
