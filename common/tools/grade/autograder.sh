#!/bin/sh
# Makes the zip that Gradescope takes as an autograder: autograder.sh FILE.zip
# It holds setup.sh, run_autograder and, in course/, this course: what it is built from, and nothing
# that lies beside it, such as students' work.
set -eu
tree=$(cd "$(dirname "$0")/../../.." && pwd)
[ $# -eq 1 ] || {
  echo 'usage: autograder.sh FILE.zip' >&2
  exit 2
}
mkdir -p "$(dirname "$1")"
zip=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
work=$(mktemp -d "${TMPDIR:-/tmp}/texmap-autograder-XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir "$work/course"
for part in assets chapters common course docs tests \
  CMakeLists.txt CMakePresets.json LICENSE README.md vcpkg.json; do
  cp -R "$tree/$part" "$work/course/"
done
cp "$tree/common/tools/grade/gradescope/setup.sh" "$tree/common/tools/grade/gradescope/run_autograder" "$work/"
chmod +x "$work/setup.sh" "$work/run_autograder"
rm -f "$zip"
(cd "$work" && cmake -E tar cf "$zip" --format=zip course run_autograder setup.sh)
echo "Upload $zip as the autograder of an assignment"
