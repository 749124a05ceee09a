#!/bin/sh
# The script behind ./course watch, in a small folder: a stand-in "builds", and one for the
# chapter's program copies the lesson to the picture. So this takes seconds; it waits for what the
# page is told, at most 20 s for each save.
# usage: test_watch.sh ROOT
set -eu
root=$1
work=$(mktemp -d)
watcher=
trap '[ -z "$watcher" ] || kill "$watcher" 2>/dev/null || :; rm -rf "$work"' EXIT
mkdir -p "$work/common/tools/check" "$work/chapters/02_checkerboard_uv" "$work/build/learn/bin"
cp "$root"/common/tools/check/watch.* "$root/common/tools/check/check.sh" "$work/common/tools/check"
cd "$work"
lesson=chapters/02_checkerboard_uv/lesson.hpp
page=out/watch
: >chapters/02_checkerboard_uv/main.cpp

# ./course --build learn PROGRAM STATUS
cat >course <<'END'
#!/bin/sh
if grep -q SYNTAX chapters/*/lesson.hpp; then echo "lesson.hpp:1: error: what is SYNTAX?" >&2; exit "$4"; fi
END
# --quiet --out PICTURE; it stands where the user does
mkdir -p photos
cat >build/learn/bin/02_checkerboard_uv <<'END'
#!/bin/sh
cp ../chapters/*/lesson.hpp "$3"
END
chmod +x course build/learn/bin/02_checkerboard_uv

failed=0
# shows NAME COUNT WORD SAID BEFORE AFTER: after the save with this number the page is told so, and these are the pictures ("": none).
shows() {
  waited=0
  until grep -q "^show($2, " "$page/state.js" 2>/dev/null || [ "$waited" = 200 ] || ! kill -0 "$watcher"; do
    sleep 0.1
    waited=$((waited + 1))
  done
  said=$(cat "$page/state.js" 2>/dev/null || :)
  before=$(cat "$page/before.png" 2>/dev/null || :)
  after=$(cat "$page/after.png" 2>/dev/null || :)
  case "$said|$before|$after" in
    "show($2, \"$3\", \""*"$4"*"|$5|$6") ;;
    *)
      failed=$((failed + 1))
      printf 'FAIL: %s: %s|%s|%s\n' "$1" "$said" "$before" "$after"
      ;;
  esac
}

# save TEXT: at once, so that the script cannot meet an empty file.
save() { echo "$1" >saved && mv saved "$lesson"; }

save one
TEXMAP_HERE=$work/photos sh common/tools/check/watch.sh 2 >log 2>&1 &
watcher=$!
shows "the first picture" 1 good drawn "" one
save two
shows "a change" 2 good drawn one two
save SYNTAX
shows "an error: the pictures stay" 3 bad "error: what is SYNTAX?" one two
save two
shows "as it was before the error: the picture before the change is not lost" 4 good "the picture is the same" one two
save three
shows "another change" 5 good drawn two three
kill "$watcher" || cat log
status=0
wait "$watcher" || status=$?
watcher=
if [ "$status" != 0 ] || ! grep -q "The last pictures are in $page/" log; then
  failed=$((failed + 1))
  echo "FAIL: it does not end cleanly: status $status"
fi

# An exercise: its program draws, or runs without an end.
mkdir -p tests/exercises chapters/02_checkerboard_uv/exercises out/exercises/02.1
echo "// Exercise 02.1: where?" >tests/exercises/02_1.hpp
lesson=chapters/02_checkerboard_uv/exercises/1_where.hpp
cat >build/learn/bin/exercise_02_1 <<'END'
#!/bin/sh
if grep -q LOOP chapters/*/exercises/*.hpp; then while :; do :; done; fi
cp chapters/*/exercises/*.hpp out/exercises/02.1/yours.png
END
chmod +x build/learn/bin/exercise_02_1
save LOOP
TEXMAP_CHECK_SECONDS=1 sh common/tools/check/watch.sh 2.1 >log 2>&1 &
watcher=$!
shows "a loop without an end" 1 bad "still running after 1 s of processor time" "" ""
save one
shows "the save after it" 2 good drawn "" one
kill "$watcher"
wait "$watcher"
watcher=
grep -q "^02.1 " out/exercises/passed.txt || {
  failed=$((failed + 1))
  echo "FAIL: it does not remember that the exercise is right"
}
[ -f out/exercises/02.1/yours.png ] || {
  failed=$((failed + 1))
  echo "FAIL: the exercise's page has no picture"
}

printf '%s failed\n' "$failed"
[ "$failed" = 0 ]
