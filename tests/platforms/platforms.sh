#!/bin/sh
# Builds the course for another system, on Debian, and tries it: golden pictures, suites of tests.
# usage: platforms.sh SYSTEM [CMAKE_OPTION...]   needs build/release; makes build/platforms/SYSTEM
#        SYSTEM: windows (mingw, wine) | arm64 | armhf (qemu) | libcxx (clang++, macOS's library)
# exit status: 0 all is well; 1 something is not; 77 a package is missing
set -eu
system=${1:?usage: platforms.sh windows|arm64|armhf|libcxx [CMAKE_OPTION...]}
shift
tree=$(cd "$(dirname "$0")/../.." && pwd)
build=$tree/build/platforms/$system
native=$tree/build/release/bin/compare
[ "$system" != libcxx ] || native=$build/bin/compare # that one runs here, too
[ -x "$native" ] || [ "$system" = libcxx ] || {
  echo "there is no $native: cmake --build build/release --target compare_program" >&2
  exit 1
}

# need PROGRAM PACKAGE...: ends with 77 unless the program is there.
need() {
  command -v "$1" >/dev/null 2>&1 || {
    echo "skipped: $system needs $1 (Debian $2)"
    exit 77
  }
}

# Another system's compiler must not see /usr/include: it is shown these folders alone.
headers=$tree/build/platforms/headers
mkdir -p "$headers/include" "$build"
for package in stb doctest xsimd boost; do
  [ ! -d "/usr/include/$package" ] || ln -sfn "/usr/include/$package" "$headers/include/$package"
done

# configure NAME PROCESSOR COMPILER ROOT: for another machine, whose programs $run runs.
configure() {
  name=$1 processor=$2 compiler=$3 root=$4 emulator=$(echo "$run" | tr ' ' ';')
  shift 4
  cmake -S "$tree" -B "$build" -D CMAKE_BUILD_TYPE=Release -D CMAKE_SYSTEM_NAME="$name" -D CMAKE_SYSTEM_PROCESSOR="$processor" \
    -D CMAKE_CXX_COMPILER="$compiler" -D CMAKE_FIND_ROOT_PATH="$root;$headers" -D CMAKE_CROSSCOMPILING_EMULATOR="$emulator" \
    -D CMAKE_FIND_ROOT_PATH_MODE_PROGRAM=NEVER -D CMAKE_FIND_ROOT_PATH_MODE_INCLUDE=ONLY -D CMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY "$@"
}

images="test_damaged_images test_load_image test_save_png test_stroke_font"
numbers="test_number test_pack test_pack_u32 test_interval test_rotation"
o1=-DCMAKE_CXX_FLAGS_RELEASE=-O1 # half the time to compile, and the same pictures
run=""
ending=""
case $system in
  windows)
    need x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
    need wine wine
    chapters="01 02 03 04 05 06 07 08 12 14"
    # None that starts programs: wine's cmd now and then starts none. What is below needs no cmd.
    suites="$numbers $images test_files test_windows_files test_command_line"
    export WINEPREFIX="$tree/build/platforms/wine" WINEDEBUG=-all
    # One server for all programs. If each starts its own, one in 250 meets the end of the last one
    # and ends with status 1, without a word.
    mkdir -p "$WINEPREFIX"
    timeout 10 wineserver -k || true
    wineserver -p
    trap 'timeout 10 wineserver -k || true' EXIT
    timeout 120 wineboot -i >/dev/null 2>&1 </dev/null || true
    run=wine
    ending=.exe
    configure Windows x86_64 x86_64-w64-mingw32-g++-posix /usr/x86_64-w64-mingw32 "$@"
    ;;
  arm64)
    need aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
    need qemu-aarch64 qemu-user
    chapters="01 03 06 07 08"
    suites="$numbers test_image_texture test_conventions test_checkerboard test_bilinear test_sphere
      test_edge_function test_directions test_double_pair test_dual"
    run="qemu-aarch64 -L /usr/aarch64-linux-gnu"
    configure Linux aarch64 aarch64-linux-gnu-g++ /usr/aarch64-linux-gnu "$o1" "$@"
    ;;
  armhf)
    need arm-linux-gnueabihf-g++ g++-arm-linux-gnueabihf
    need qemu-arm qemu-user
    chapters="01 14"
    suites="test_number test_pack test_double_pair test_light_tables test_film"
    run="qemu-arm -L /usr/arm-linux-gnueabihf"
    configure Linux arm arm-linux-gnueabihf-g++ /usr/arm-linux-gnueabihf "$o1" "$@"
    ;;
  libcxx)
    need clang++ clang
    printf '#include <__config>\n' | clang++ -stdlib=libc++ -x c++ -E - >/dev/null 2>&1 || {
      echo "skipped: libcxx needs libc++ (Debian libc++-dev libc++abi-dev)"
      exit 77
    }
    chapters="01 02 03 04 05 06 07 08 09 10 11 12 14"
    # Those that use the library; what only calculates, clang++ compiles with sanitizers as well.
    suites="$numbers $images test_mesh test_filters test_render test_command_line test_files"
    cmake -S "$tree" -B "$build" -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=clang++ -D CMAKE_CXX_FLAGS=-stdlib=libc++ "$o1" "$@"
    ;;
  *)
    echo "there is no system '$system': windows, arm64, armhf or libcxx" >&2
    exit 1
    ;;
esac
chapters=$(cd "$tree/chapters" && for number in $chapters; do echo "$number"_*; done)

jobs=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
# shellcheck disable=SC2086  # lists of targets
cmake --build "$build" --parallel "$jobs" --target $chapters compare_program $suites
ctest --test-dir "$build" -R "^($(printf '%s' "$suites" | tr -s ' \n' '|'))\$" \
  --output-on-failure --no-tests=error --parallel "$jobs"

# The golden pictures are asked of programs by their bare names, and compared here.
wrapped=$build/wrapped
rm -rf "$wrapped"
mkdir -p "$wrapped"
ln -s "$native" "$wrapped/compare"
for chapter in $chapters; do
  printf '#!/bin/sh\nexec %s "%s" "$@"\n' "$run" "$build/bin/$chapter$ending" >"$wrapped/$chapter"
  chmod +x "$wrapped/$chapter"
done
# shellcheck disable=SC2086
sh "$tree/tests/golden/programs.sh" "$wrapped" $chapters
# Its own program compare, too: a picture is itself, and not another one.
golden=$tree/tests/golden
status=0
same() { $run "$build/bin/compare$ending" --quiet "$golden/01_plain_spheres.png" "$golden/$1.png"; }
same 02_checkerboard_uv || status=$?
if [ "$status" -ne 1 ] || ! same 01_plain_spheres; then
  echo "FAIL: compare does not tell two pictures apart, or one from itself"
  exit 1
fi
if [ "$system" = arm64 ]; then # packs of float, which no golden picture shows, as this machine draws them
  for chapter in $chapters; do
    "$wrapped/$chapter" --quiet --number float-pack --out "$build/there.png"
    "$tree/build/release/bin/$chapter" --quiet --number float-pack --out "$build/here.png"
    "$native" --quiet "$build/here.png" "$build/there.png" || {
      echo "FAIL: $chapter draws another picture with packs of float"
      exit 1
    }
  done
  echo "packs of float draw the same pictures"
fi
if [ "$system" = windows ]; then
  sh "$tree/tests/platforms/windows_faults.sh" "$wrapped"
fi
