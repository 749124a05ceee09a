# shellcheck shell=sh disable=SC2154  # the caller sets the two variables
# Draws with the chapters' programs and compares pictures. To be sourced; the caller sets $bin, the
# folder of the programs and of compare, and $work, a folder for what is drawn.

# draw FILE PROGRAM [OPTION...]: the program draws into the file; what it says goes to $work/log.
draw() {
  drawing=$1
  program=$2
  shift 2
  "$bin/$program" --quiet --out "$drawing" "$@" >"$work/log" 2>&1
}

# same_picture FILE FILE: no pixel of the two differs.
same_picture() { "$bin/compare" "$1" "$2" >>"$work/log" 2>&1; }

# is_drawn FILE PROGRAM [OPTION...]: true if the program draws what the file shows.
is_drawn() {
  expected=$1
  shift
  draw "$work/drawn.png" "$@" && same_picture "$work/drawn.png" "$expected"
}
