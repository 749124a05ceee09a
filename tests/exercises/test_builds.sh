#!/bin/sh
# What ./course does with its builds, with a stand-in for cmake. In a course that was copied
# elsewhere, the build that a command needs is made anew, with a line that says so; the others stay,
# and --help deletes none. What the build beside the first chapters says comes into the log; a
# chapter that fails ends it. Where nothing was saved since a build there is none.
# usage: test_builds.sh ROOT
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/tools" "$work/first home/chapters/01_plain_spheres" "$work/first home/chapters/02_a"
cp "$root/course" "$work/first home"
mkdir -p "$work/first home/common/tools/check"
cp "$root"/common/tools/check/compiler_words.* "$work/first home/common/tools/check"
: >"$work/first home/chapters/02_a/main.cpp"
cat >"$work/tools/cmake" <<'END_OF_TOOL'
#!/bin/sh
case "$*" in
  --preset*) mkdir -p build/learn/bin && echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/learn/CMakeCache.txt && echo gallery: >build/learn/Makefile ;;
  *13_speed*) sh -c 'n=0; while [ $((n += 1)) -le "$BESIDE" ]; do : >alive; sleep 0.1; done' && echo "warning: beside" ;;
  *draw_02*) sleep 0.5 && echo "drawn or not" && exit "$LESSON" ;;
  *exercise_01_1*) [ "$LC_ALL" = C ] && cat error && exit 1 ;;
  --build*)
    : >made
    printf '#!/bin/sh\necho drawn\n' >build/learn/bin/01_plain_spheres && chmod +x build/learn/bin/01_plain_spheres
    ;;
  --version) echo "cmake version 3.25.1" ;;
esac
END_OF_TOOL
chmod +x "$work/tools/cmake"
export PATH="$work/tools:$PATH"

fail() {
  echo "FAIL: $1"
  exit 1
}

# expect NAME kept|gone said|silent: ./course run 01 draws; a file in build/learn, and the line.
expect() {
  said=$(./course run 01 2>&1) || fail "$1: it stopped: $said"
  case "$said" in *drawn*) ;; *) fail "$1: nothing was drawn: $said" ;; esac
  [ "$2" = "$([ -f build/learn/mark ] && echo kept || echo gone)" ] || fail "$1: the build is not $2"
  line=silent
  case "$said" in *"was made in"*) line=said ;; esac
  [ "$3" = "$line" ] || fail "$1: not $3: $said"
}

cd "$work/first home"
expect "the first time" gone silent
BESIDE=1200 LESSON=1 ./course >said 2>&1 && fail "a chapter that fails is no failure"
rm alive
! grep -q warning build/learn/beside.log || fail "it waited for the build beside"
[ "$(sed 1d said)" = "drawn or not
error: the build stopped; see above" ] || fail "where a chapter fails it says: $(cat said)"
sleep 0.5
[ ! -e alive ] || fail "the build beside still runs"
BESIDE=20 LESSON=0 ./course >said || fail "it stopped: $(cat said)"
grep -q "warning: beside" build/learn/gallery.log || fail "the log lacks what the build beside said"
: >build/learn/mark
expect "the second time" kept silent
mkdir tests assets
: >CMakeLists.txt
expect "with all folders" kept silent
rm made
expect "where nothing was saved" kept silent
[ ! -e made ] || fail "it was built again, and nothing was saved"
: >chapters/02_a/main.cpp
expect "where a file was saved" kept silent
[ -e made ] || fail "a file was saved, and it was not built again"
# While another terminal builds.
: >chapters/02_a/main.cpp
if command -v flock >/dev/null 2>&1; then
  exec 8>build/learn.lock
  flock 8
  ./course run 01 >said 2>&1 8>&- &
  until grep -q "^waiting for the build in another" said || ! kill -0 $!; do sleep 0.1; done
  exec 8>&-
  wait $! || fail "after another build it stopped: $(cat said)"
  grep -q "^waiting for the build in another" said ||
    fail "it does not say that it waits: $(cat said)"
fi
# A file that does not compile: the first time, later, and with all that the compiler says.
file=chapters/01_plain_spheres/f.hpp
echo 'double f(double x) { return g(x); }' >"$file"
printf "%s:1:29: error: 'g' was not declared in this scope\n note: more\n" "$file" >error
for told in "known here" "known here" "note: more"; do
  said=$(./course --build learn exercise_01_1 1 "$file" HOW 2>&1) && fail "an error is no failure"
  case "$said" in *"$told"*) ;; *) fail "of an error it says: $said" ;; esac
  [ ! -e build/learn/built/exercise_01_1 ] || export TEXMAP_VERBOSE=1
  : >build/learn/built/exercise_01_1
done
unset TEXMAP_VERBOSE
{ echo "common/f.hpp:1:1: error: other" && echo "make: *** [exercise_01_1.cpp.o] Error 1"; } >error
status=0
./course --build learn exercise_01_1 1 "$file" HOW 2>said || status=$?
[ "$status" = 2 ] || fail "an error in another file has the status $status: $(cat said)"
for other in grade/build release; do
  mkdir -p "build/$other"
  cp build/learn/CMakeCache.txt "build/$other"
done
cp -R "$work/first home" "$work/copy"
cd "$work/copy"
./course run 01 --help 2>&1 | grep -q drawn || fail "help in a copy does not say what it said"
mv build/learn/bin/01_plain_spheres program
./course run 01 --help 2>&1 | grep -q "without --help it is built anew" || fail "help in a copy without the program does not say why"
[ -f build/learn/mark ] || fail "help deleted the build"
expect "in a copy beside the first" gone said
[ "$(ls build)" = "$(ls "$work/first home/build")" ] || fail "a build that run does not use is gone"
: >build/learn/mark
expect "in the copy again" kept silent
mv "$work/copy" "$work/renamed"
cd "$work/renamed"
expect "under another name" gone said
# The address of a page, in a folder whose name has what addresses have.
mkdir -p common/tools/playground
echo '{option: "--degrees", label: ' >common/tools/playground/live.js
mv "$work/renamed" "$work/50% #2?"
cd "$work/50% #2?"
said=$(./course run 01 --degrees 3 --link 2>/dev/null) || fail "--link stopped"
case "$said" in
  file://*"/50%25%20%232%3F/out/01_plain_spheres.html#degrees=3") ;;
  *) fail "the address is $said" ;;
esac
! ./course run 01 --texture a.jpg --link >said 2>&1 || fail "an address has a file: $(cat said)"
