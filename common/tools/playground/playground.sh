#!/bin/sh
# Builds the chapters as WebAssembly for the book's live pictures: docs/live/. Needs Emscripten.
# usage: playground.sh [--check]     --check: builds elsewhere, and says which files in docs/live/ are not current (status 1)
# exit status: 0 done; 1 not current, or the build failed; 77 Emscripten is missing
set -eu
tree=$(cd "$(dirname "$0")/../../.." && pwd)
build=$tree/build/playground
case "${1:-}" in
  "") place=$tree/docs/live ;;
  --check) place=$build/live ;;
  *)
    echo "error: playground takes --check or nothing" >&2
    exit 2
    ;;
esac

for program in em++ node python3; do
  command -v "$program" >/dev/null 2>&1 || {
    echo "The live pictures need $program: Debian and Ubuntu apt-get install emscripten, Arch pacman -S emscripten, brew install emscripten." >&2
    echo "The book shows still pictures where docs/live/ is missing." >&2
    exit 77
  }
done
# Debian's Emscripten takes JavaScript packages from Debian's folders, which another node does not know.
[ ! -d /usr/share/nodejs ] || export NODE_PATH="/usr/share/nodejs:/usr/lib/nodejs${NODE_PATH:+:$NODE_PATH}"
toolchain=$(em++ --cflags 2>/dev/null | tr ' ' '\n' | sed -n 's|^--sysroot=\(.*\)/cache/sysroot$|\1|p')/cmake/Modules/Platform/Emscripten.cmake
[ -f "$toolchain" ] || toolchain=$(python3 -c 'import os, sys; print(os.path.dirname(os.path.realpath(sys.argv[1])))' \
  "$(command -v em++)")/cmake/Modules/Platform/Emscripten.cmake
[ -f "$toolchain" ] || {
  echo "error: Emscripten.cmake, which comes with em++, is not where it should be: $toolchain" >&2
  exit 1
}

# Emscripten must not see the system's headers: it is shown those of stb and xsimd alone.
mkdir -p "$build/headers" "$place"
for folder in /usr/include/stb /usr/local/include/stb /opt/homebrew/include/stb /usr/include /usr/local/include /opt/homebrew/include; do
  [ ! -f "$folder/stb_image.h" ] || ln -sf "$folder/stb_image.h" "$build/headers/"
  [ ! -f "$folder/xsimd/xsimd.hpp" ] || ln -sfn "$folder/xsimd" "$build/headers/xsimd"
done
for header in stb_image.h xsimd/xsimd.hpp; do
  [ -e "$build/headers/$header" ] || {
    echo "error: $header is missing (Debian libstb-dev libxsimd-dev)" >&2
    exit 1
  }
done

# stb_image's checks hold the path of its file: without -fmacro-prefix-map the modules would differ from folder to folder, and with a
# compiler cache, which may write that path in another way.
cmake -S "$tree" -B "$build" -D CMAKE_TOOLCHAIN_FILE="$toolchain" -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS_RELEASE=-Oz \
  -D TEXMAP_LEARN=ON -D CMAKE_CXX_COMPILER_LAUNCHER= -D stb_image_INCLUDE_DIR="$build/headers" -D xsimd_INCLUDE_DIR="$build/headers" \
  -D CMAKE_CXX_FLAGS="-fwasm-exceptions -fno-rtti \"-fmacro-prefix-map=$tree/=\" -include \"$tree/common/tools/playground/libcxx_13.hpp\""
cmake --build "$build" --target playground --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(getconf _NPROCESSORS_ONLN)}"
python3 "$tree/common/tools/playground/make_playground.py" "$build/bin" "$tree/assets" "$place"
python3 "$tree/common/tools/playground/make_microscope.py" "$build/bin/microscope.wasm" "$place"
[ "$place" != "$build/live" ] || {
  stale=""
  for file in "$place"/*; do
    cmp -s "$file" "$tree/docs/live/${file##*/}" || stale="$stale ${file##*/}"
  done
  [ -z "$stale" ] || {
    echo "FAIL: docs/live/ is not what the code makes:$stale. ./course playground makes it again." >&2
    exit 1
  }
  echo "docs/live/ is current"
}
