#!/bin/sh
# The exercises: ./course check ... calls this in the course's folder. `--help` shows its use.
#
# A file chapters/NN_*/exercises/K_*.hpp is the student's. tests/exercises/NN_K.hpp has the whole exercise: its task, the solution between
# the marks `// solution` and `// start: ...` (what the student finds there instead), and hints.
set -eu
passed=out/exercises/passed.txt

usage() {
  cat <<'TEXT'
usage: ./course check                  all exercises, and how far you are
       ./course check 02               check your exercises of chapter 02
       ./course check 02.1             check one: words, a picture with your function, a page out/exercises/02.1/index.html
       ./course check 02.a 0.25        check your answer to a question; after the second wrong one it shows the right one; without a
                                       number it asks the question
       ./course check 02.1 --verbose   the same, with all of the compiler's text
       ./course check hint 02.1        a hint; ask again for the next one
       ./course check solution 02.1    a solution
       ./course check reset 02.1       begin again; your lines are kept in out/exercises/02.1/
Write into the files chapters/NN_*/exercises/K_*.hpp; only these are checked. The questions are on the pages of the chapters.
status: 0 right, or only shown; 1 not yet; 2 wrong command line, or the build failed for another reason than your file
TEXT
}

wrong() {
  printf 'error: %s\n' "$1" >&2
  usage >&2
  exit 2
}

# ids: of all exercises of the chapters that are there, in order.
ids() {
  for file in tests/exercises/[0-9][0-9]_[0-9].hpp; do
    id=$(basename "$file" .hpp | tr _ .)
    set -- chapters/"${id%.*}"_*/
    [ ! -d "$1" ] || echo "$id"
  done
}

whole_of() { printf 'tests/exercises/%s.hpp' "$(printf '%s' "$1" | tr . _)"; }

title_of() { sed -n '1s/^[^:]*: //p' "$(whole_of "$1")"; }

# head_of ID: how a line about it begins.
head_of() { printf '%s  %s' "$1" "$(title_of "$1" | sed 's/[^?]$/&:/')"; }

# name_of ID: sets file to the student's file, or to the name it should have if it is gone.
# Stops if there is no such exercise, or a second file of it.
name_of() {
  case "$1" in
    [0-9][0-9].[0-9]) ;;
    *) wrong "'$1' is no exercise; ./course check lists them" ;;
  esac
  [ -f "$(whole_of "$1")" ] || wrong "there is no exercise '$1'; ./course check lists them"
  set -- "$1" chapters/"${1%.*}"_*/exercises/"${1#*.}"_*.hpp
  [ $# -eq 2 ] || {
    printf 'error: two files of exercise %s: %s, %s; move one away\n' "$1" "$2" "$3" >&2
    exit 2
  }
  file=$2
  [ ! -f "$file" ] || return 0
  for file in chapters/"${1%.*}"_*; do :; done
  file=$file/exercises/${1#*.}_$(title_of "$1" | tr -cd '[:alnum:] ' | tr ' ' _).hpp
}

# file_of ID: the same, and stops if it is gone.
file_of() {
  name_of "$1"
  [ -f "$file" ] && return
  printf 'error: the file of exercise %s is gone; ./course check reset %s writes it again\n' "$1" "$1" >&2
  exit 2
}

# shown ID PART...: the exercise without its hints and with the line that says how to check it, after these parts of a sed script.
shown() {
  exercise=$1
  shift
  sed "$@" -e '/^\/\/ hint: /d' -e "/^#include \"exercise.hpp\"/i\\
//\\
// Check it:  ./course check $exercise" "$(whole_of "$exercise")"
}

# start_of ID: the file as students get it.
start_of() { shown "$1" -e '/^ *\/\/ solution$/,/^ *\/\/ start: /{' -e '/^ *\/\/ start: /!d' -e '}' -e 's/\/\/ start: //'; }

# remember ID STATUS: whether it is right, and for which lines.
remember() {
  mkdir -p out/exercises
  # A file of its own: another check may run beside this one.
  { grep -v "^$1 " "$passed" 2>/dev/null || :; } >"$passed.$$"
  [ "$2" != 0 ] || printf '%s %s\n' "$1" "$(cksum <"$file")" >>"$passed.$$"
  mv "$passed.$$" "$passed"
}

list() {
  done=0
  count=0
  next=
  for id in $(ids); do
    count=$((count + 1))
    mark='[ ]'
    if was=$(grep "^$id " "$passed" 2>/dev/null); then
      file_of "$id"
      mark='[?]'
      [ "$was" != "$id $(cksum <"$file")" ] || mark='[x]' done=$((done + 1))
    fi
    [ "$mark" = '[x]' ] || next=${next:-$id}
    printf '%s %s  %s\n' "$mark" "$id" "$(title_of "$id")"
  done
  printf '%s of %s right.' "$done" "$count"
  if [ -n "$next" ]; then
    file_of "$next"
    printf ' Next: write %s, then ./course check %s' "$file" "$next"
  fi
  printf '\n[?]: changed after it was right.\nQuestions: ./course check 02.a shows one; with a number it says whether it is right.\n'
}

# check ID: builds and runs one. Sets status.
check() {
  file_of "$1"
  program=exercise_$(printf '%s' "$1" | tr . _)
  ./course --build learn "$program" 1 "$file" "./course check $1 --verbose" || {
    [ $? = 1 ] || {
      printf '%s the build failed for another reason than your file; see above\n' "$(head_of "$1")"
      status=2
      return
    }
    printf '%s does not compile; see above\n' "$(head_of "$1")"
    remember "$1" 1
    status=1
    return
  }
  status=0
  # A file that loops forever ends after so many seconds of processor time; the script's test has a smaller limit.
  seconds=${TEXMAP_CHECK_SECONDS:-20}
  # shellcheck disable=SC3045  # dash, bash, zsh and BSD's sh all have ulimit -t
  (
    ulimit -t "$seconds" 2>/dev/null || :
    exec "build/learn/bin/$program" --title "$(title_of "$1")"
  ) || status=$?
  case $status in
    0 | 1 | 2) ;;
    152 | 137 | 158) printf '%s still running after %s s of processor time; is there a loop without an end?\n' "$(head_of "$1")" "$seconds" ;;
    *) printf '%s your function crashed (status %s)\n' "$(head_of "$1")" "$status" ;;
  esac
  remember "$1" "$status"
  [ "$status" -le 2 ] || status=1
}

# question ID [NUMBER]: asks it, or judges the number; the right one is shown after the second that is wrong.
question() {
  ids | grep -q "^${1%.*}[.]" || wrong "there is no chapter with a question '$1'"
  ./course --build learn "check_${1%.*}" 2 || exit 2
  program=build/learn/bin/check_${1%.*}
  [ $# -eq 2 ] || exec "$program" --question "$1"
  tried=out/exercises/$1/tried
  again=
  [ ! -f "$tried" ] || again=--again
  status=0
  "$program" --question "$1" --answer "$2" ${again:+"$again"} || status=$?
  mkdir -p "out/exercises/$1"
  case $status in 0) rm -f "$tried" ;; 1) : >"$tried" ;; esac
  exit "$status"
}

[ "$#-${2:-}" != 2---verbose ] || { export TEXMAP_VERBOSE=1 && set -- "$1"; }
# 2.1 means 02.1.
case "${1:-}" in
  [0-9] | [0-9].*) first=0$1 && shift && set -- "$first" "$@" ;;
  hint | solution | reset)
    [ $# -eq 2 ] || wrong "$1 takes one exercise"
    case "$2" in [0-9].*) set -- "$1" "0$2" ;; esac
    ;;
esac

case "${1:-}" in
  "") list ;;
  --help | -h) usage ;;
  hint)
    file_of "$2"
    shown=out/exercises/$2/hints
    mkdir -p "out/exercises/$2"
    n=$(($(cat "$shown" 2>/dev/null || echo 0) + 1))
    all=$(grep -c '^// hint: ' "$(whole_of "$2")" || :)
    [ "$n" -le "$all" ] || n=$all
    grep '^// hint: ' "$(whole_of "$2")" | sed -n "${n}s/^.. hint: //p"
    echo "$n" >"$shown"
    echo "(hint $n of $all)"
    ;;
  solution)
    file_of "$2"
    grep -q '^ *// solution$' "$(whole_of "$2")" || wrong "this copy of the course has no solutions"
    shown "$2" -e '/^ *\/\/ solution$/d' -e '/^ *\/\/ start: /d'
    ;;
  reset)
    name_of "$2"
    start=$(start_of "$2")
    if [ -f "$file" ] && [ "$(cat "$file")" != "$start" ]; then
      mkdir -p "out/exercises/$2"
      cp "$file" "out/exercises/$2/before_reset_$(date +%Y%m%d_%H%M%S).hpp"
      echo "Your lines are kept in out/exercises/$2/"
    fi
    mkdir -p "$(dirname "$file")"
    rm -f "build/learn/built/exercise_$(printf '%s' "$2" | tr . _)" # a build that was configured without the file has no such program
    printf '%s\n' "$start" >"$file"
    echo "$file is as it was."
    ;;
  start) # for the tests: start ID [FILE]
    start_of "$2" >"${3:-/dev/stdout}"
    ;;
  [0-9][0-9].[a-z])
    [ $# -le 2 ] || wrong "a question takes one number"
    question "$@"
    ;;
  [0-9][0-9])
    [ $# -eq 1 ] || wrong "check takes one chapter or one exercise, such as 02 or 02.1"
    all=$(ids | grep "^$1") || wrong "chapter '$1' has no exercises"
    worst=0
    for id in $all; do
      check "$id"
      [ "$status" -le "$worst" ] || worst=$status
    done
    exit "$worst"
    ;;
  *)
    [ $# -eq 1 ] || wrong "check takes one exercise"
    check "$1"
    exit "$status"
    ;;
esac
