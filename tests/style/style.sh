#!/bin/sh
# What formatters do not hold: lines of at most 100 columns, comments too, and docstrings of at most
# six lines.
# usage: style.sh FILE...
set -eu
LC_ALL=C awk '
  function end_docstring() {
    if (lines > 6 && file ~ /\.hpp$/ && file ~ /^(.*\/)?common\//) {
      print file ":" first ": a docstring of " lines " lines, more than 6"
      faults++
    }
    lines = 0
  }
  FNR == 1 { end_docstring(); file = FILENAME }
  length($0) > 100 && $0 !~ /https?:/ {
    letters = $0
    gsub(/[\200-\277]/, "", letters)  # of a letter in UTF-8 all bytes but the first
    if (length(letters) > 100) { print FILENAME ":" FNR ": " length(letters) " columns"; faults++ }
  }
  /^ *\/\/\/ ?[^<]/ || /^ *\/\/\/$/ { if (lines == 0) first = FNR; lines++; next }
  { end_docstring() }
  END { end_docstring(); if (faults > 0) { print faults " faults"; exit 1 } }
' "$@"
