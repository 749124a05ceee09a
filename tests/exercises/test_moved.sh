#!/bin/sh
# In a course that was copied elsewhere with its build/, the build that a command needs is made anew, with a line that says so; the other
# builds stay, and --help deletes none. One that stayed keeps its build. A stand-in for cmake makes a program that prints a word.
# usage: test_moved.sh ROOT
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/tools" "$work/first home/chapters/01_plain_spheres"
cp "$root/course" "$work/first home"
cat >"$work/tools/cmake" <<'END'
#!/bin/sh
case "$*" in
  --preset*) mkdir -p build/learn/bin && echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >build/learn/CMakeCache.txt && : >build/learn/Makefile ;;
  --build*) printf '#!/bin/sh\necho drawn\n' >build/learn/bin/01_plain_spheres && chmod +x build/learn/bin/01_plain_spheres ;;
  --version) echo "cmake version 3.25.1" ;;
esac
END
chmod +x "$work/tools/cmake"
export PATH="$work/tools:$PATH"

# expect NAME KEPT SAID: ./course run 01 draws; a file in build/learn is kept or gone; the line about the folder is said or not.
expect() {
  said=$(./course run 01 2>&1) || { echo "FAIL: $1: it stopped: $said"; exit 1; }
  case "$said" in *drawn*) ;; *) echo "FAIL: $1: nothing was drawn: $said"; exit 1 ;; esac
  [ "$2" = "$([ -f build/learn/mark ] && echo kept || echo gone)" ] || { echo "FAIL: $1: the build is not $2"; exit 1; }
  [ "$3" = "$(case "$said" in *"was made in"*) echo said ;; *) echo silent ;; esac)" ] || { echo "FAIL: $1: not $3: $said"; exit 1; }
}

cd "$work/first home"
expect "the first time" gone silent
: >build/learn/mark
expect "the second time" kept silent
for other in grade/build release; do
  mkdir -p "build/$other"
  cp build/learn/CMakeCache.txt "build/$other"
done
cp -R "$work/first home" "$work/copy"
cd "$work/copy"
# help STATUS WORDS: what ./course run 01 --help says; the build stays.
help() {
  status=0
  said=$(./course run 01 --help 2>&1) || status=$?
  case "$status $said" in "$1"*"$2"*) ;; *) echo "FAIL: help in a copy: status $status, $said"; exit 1 ;; esac
  [ -f build/learn/mark ] || { echo "FAIL: help deleted the build"; exit 1; }
}
help 0 drawn
mv build/learn/bin/01_plain_spheres program
help 1 "without --help it is built anew"
mv program build/learn/bin/01_plain_spheres
expect "in a copy beside the first" gone said
for other in grade/build release; do
  [ -e "build/$other" ] || { echo "FAIL: build/$other, which run does not use, is gone"; exit 1; }
done
: >build/learn/mark
expect "in the copy again" kept silent
mv "$work/copy" "$work/renamed"
cd "$work/renamed"
expect "under another name" gone said
