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
cp "$root"/common/tools/check/watch.* "$work/common/tools/check"
cd "$work"
lesson=chapters/02_checkerboard_uv/lesson.hpp
page=out/watch
: >chapters/02_checkerboard_uv/main.cpp

# ./course --build learn PROGRAM STATUS
cat >course <<'END'
#!/bin/sh
if grep -q SYNTAX chapters/*/lesson.hpp; then echo "lesson.hpp:1: error: what is SYNTAX?" >&2; exit "$4"; fi
END
# --quiet --out PICTURE
cat >build/learn/bin/02_checkerboard_uv <<'END'
#!/bin/sh
cp chapters/*/lesson.hpp "$3"
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
sh common/tools/check/watch.sh 2 >log 2>&1 &
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

printf '%s failed\n' "$failed"
[ "$failed" = 0 ]
