#!/bin/sh
# The first ./course: what the build beside the first chapters says comes into the log, and where a chapter fails that build ends at once.
# A stand-in for cmake; its second build takes two seconds, or two minutes.
# usage: test_first.sh ROOT
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/tools"
cp "$root/course" "$work"
for chapter in 01_plain_spheres 02_checkerboard_uv; do mkdir -p "$work/chapters/$chapter" && : >"$work/chapters/$chapter/main.cpp"; done
cat >"$work/tools/cmake" <<'END_OF_TOOL'
#!/bin/sh
case "$*" in
  --preset*) mkdir -p build/learn && echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/learn/CMakeCache.txt && echo gallery: >build/learn/Makefile ;;
  *13_speed*) sh -c 'n=0; while [ $((n += 1)) -le "$BESIDE" ]; do : >alive; sleep 0.1; done' && echo "measure.cpp:1:1: warning: beside" ;;
  *draw_02*) sleep 0.5 && echo "lesson.hpp: drawn or not" && exit "$LESSON" ;;
  --version) echo "cmake version 3.25.1" ;;
esac
END_OF_TOOL
chmod +x "$work/tools/cmake"
export PATH="$work/tools:$PATH"
cd "$work"
cmake --preset learn

fail() {
  echo "FAIL: $1"
  exit 1
}
BESIDE=20 LESSON=0 ./course >said || fail "it stopped: $(cat said)"
grep -q "warning: beside" build/learn/gallery.log || fail "the log lacks what the build beside said"
rm build/learn/gallery.log
begin=$(date +%s)
! BESIDE=1200 LESSON=1 ./course >said 2>&1 || fail "a chapter that fails is no failure"
grep -q "drawn or not" said || fail "it does not say what failed"
! grep -qi terminated said || fail "it speaks of the build that it ended: $(cat said)"
[ $(($(date +%s) - begin)) -lt 60 ] || fail "it waited for the build beside"
rm alive
sleep 0.5
[ ! -e alive ] || fail "the build beside still runs"
