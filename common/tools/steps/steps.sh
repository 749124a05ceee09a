#!/bin/sh
# The step in each chapter's README is the exact difference to the lesson before it. Lessons and
# steps have a largest size.
# usage: steps.sh ROOT --check|--write|--self-test
set -eu
root=${1:?usage: steps.sh ROOT --check|--write|--self-test}
mode=${2:---check}
longest_lesson=80
largest_step=25
largest_new_scene=60 # where the chapter opens a new scene, and may be another kind of lesson
new_scenes=" 07 08 09 11 12 "
begin='<!-- step: made by ./course steps --write -->'
begin_from='<!-- step from NN: made by ./course steps --write -->' # from another chapter than the one before
end='<!-- end of step -->'
alone='<!-- no step: this chapter stands on its own -->'

# The changed lines of two lessons, with a blank line between hunks.
step_of() {
  diff -d -U 0 "$1" "$2" | sed -e '1,2d' -e 's/^@@.*@@.*$//' | sed '1{/^$/d;}' || true
}

# The README on standard input with the step from file $1 between its marks.
with_step() {
  from=$(printf '%s' "$begin_from" | sed 's/NN/[0-9][0-9]/')
  awk -v begin="$begin" -v from="^$from\$" -v end="$end" -v step="$1" '
    $0 == begin || $0 ~ from {
      print
      print "```diff"
      while ((getline line < step) > 0) print line
      print "```"
      skipping = 1
      seen++
    }
    $0 == end { skipping = 0; seen++ }
    !skipping { print }
    END { if (seen != 2) exit 3 }'
}

check() {
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  faults=0
  before=""
  next=""
  : >"$work/sizes"
  echo "lesson                        lines  changed"
  for folder in "$1"/chapters/[0-9][0-9]_*/; do
    name=$(basename "$folder")
    [ -f "$folder/lesson.hpp" ] || continue # 00 is a file of its own
    lines=$(wc -l <"$folder/lesson.hpp")
    changed=-
    number=${name%%_*}
    # A chapter without such a mark has no step if its README says so or if the chapter before is missing.
    other=$(sed -n 's/^<!-- step from \([0-9][0-9]\): .*/\1/p' "$folder/README.md")
    if [ -n "$other" ]; then
      before=$(echo "$1"/chapters/"$other"_*/lesson.hpp)
      [ -f "$before" ] || continue # that chapter was deleted
    fi
    if [ -n "$other" ] || { [ "$number" = "$next" ] && ! grep -q -x -F -e "$alone" "$folder/README.md"; }; then
      step_of "$before" "$folder/lesson.hpp" >"$work/step"
      changed=$(grep -c '^[-+]' "$work/step" || true)
      echo "$changed" >>"$work/sizes"
      most=$largest_step
      case $new_scenes in *" $number "*) most=$largest_new_scene ;; esac
      if [ "$changed" -gt "$most" ]; then
        echo "FAIL: the step to $name changes $changed lines of the lesson, more than $most" >&2
        faults=$((faults + 1))
      fi
      if ! with_step "$work/step" <"$folder/README.md" >"$work/readme"; then
        echo "FAIL: $name/README.md lacks the marks of its step: $begin (or $begin_from) and $end" >&2
        faults=$((faults + 1))
      elif ! cmp -s "$work/readme" "$folder/README.md"; then
        if [ "$2" = --write ]; then
          cp "$work/readme" "$folder/README.md"
        else
          echo "FAIL: $name/README.md shows another step than the lessons have:" \
            "run ./course steps --write" >&2
          faults=$((faults + 1))
        fi
      fi
    fi
    printf '%-28s %6d %8s\n' "$name" "$lines" "$changed"
    if [ "$lines" -gt "$longest_lesson" ]; then
      echo "FAIL: $name/lesson.hpp has $lines lines, more than $longest_lesson" >&2
      faults=$((faults + 1))
    fi
    before="$folder/lesson.hpp"
    next=$(printf '%02d' "$((${number#0} + 1))")
  done
  count=$(wc -l <"$work/sizes")
  if [ "$count" -eq 0 ]; then
    echo "FAIL: no steps found" >&2
    return 1
  fi
  [ "$faults" -eq 0 ]
}

# A tree with a changed lesson and an unchanged README must be refused.
self_test() {
  copy=$(mktemp -d)
  mkdir "$copy/chapters"
  cp -R "$root"/chapters/0[12]_* "$copy/chapters/"
  lesson=$copy/chapters/02_checkerboard_uv/lesson.hpp
  said=""
  (check "$copy" --check) >/dev/null || said="the untouched copy is refused"
  echo '// one more line' >>"$lesson"
  ! (check "$copy" --check) >/dev/null 2>&1 || said="a changed lesson is not noticed"
  yes '// a line' | head -n 25 >>"$lesson"
  ! (check "$copy" --write) >/dev/null 2>&1 || said="a step that is too large is not noticed"
  rm -rf "$copy"
  echo "${said:-a changed lesson and a step that is too large are noticed}"
  [ -z "$said" ]
}

case "$mode" in
  --check | --write) check "$root" "$mode" ;;
  --self-test) self_test ;;
  *) echo "usage: steps.sh ROOT --check|--write|--self-test" >&2; exit 2 ;;
esac
