#!/bin/sh
# Tries every fault that a chapter program must survive, on the programs themselves.
#
#   faults.sh BIN_DIR CORPUS_DIR   the chapter programs; the textures, good and bad, with their manifest.tsv
#   faults.sh --self-test          tries the checks on programs that are wrong on purpose
#
# With TEXMAP_SANITIZED=1 the programs are taken to be built with sanitizers: no limits on memory, more time.
# Needs coreutils, diffutils and grep. Everything happens in a temporary folder, which is removed.
# FAULTS_ONLY="signals memory" runs some parts only, FAULTS_VERBOSE=1 names the checks that pass.
# Prints a line for each failed and each skipped check. Status 0: at least 100 checks ran and all passed; 1: not so; 2: wrong usage.
set -u

fewest_checks=100
passed=0
failed=0
skipped=0
problems=
sanitized=${TEXMAP_SANITIZED:-0}

LC_ALL=C
export LC_ALL
unset TEXMAP_ASSETS LANGUAGE
# A sanitizer's report must never look like a clean refusal.
ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}exitcode=99
UBSAN_OPTIONS=${UBSAN_OPTIONS:+$UBSAN_OPTIONS:}exitcode=99:halt_on_error=1:print_stacktrace=1
TSAN_OPTIONS=${TSAN_OPTIONS:+$TSAN_OPTIONS:}exitcode=99
export ASAN_OPTIONS UBSAN_OPTIONS TSAN_OPTIONS

patience=5   # seconds for what should take one
if [ "$sanitized" = 1 ]; then patience=60; fi
most_memory=524288   # KiB
tab=$(printf '\t')

# --- Counting -------------------------------------------------------------------------------------------------------------

# complain PROBLEM: something is wrong in the check under way.
complain() { problems="$problems${problems:+; }$1"; }

# conclude CHECK: counts the check under way.
conclude() {
  if [ -z "$problems" ]; then
    passed=$((passed + 1))
    [ -z "${FAULTS_VERBOSE:-}" ] || printf 'passed %s\n' "$1"
  else
    failed=$((failed + 1))
    printf 'FAILED %s: %.500s\n' "$1" "$problems"
  fi
  problems=
}

# skip CHECK WHY
skip() {
  skipped=$((skipped + 1))
  printf 'skipped %s: %s\n' "$1" "$2"
}

summary() {
  printf '%s passed, %s failed, %s skipped\n' "$passed" "$failed" "$skipped"
  [ "$failed" = 0 ] || return 1
  [ $((passed + failed)) -ge "$fewest_checks" ] && return 0
  printf 'fewer than %s checks ran: something is missing\n' "$fewest_checks"
  return 1
}

# --- Running a program ------------------------------------------------------------------------------------------------------

# run COMMAND...: sets status, line1, line2 and line3 (of stderr).
run() {
  timeout -k 1 "$patience" "$@" >"$T/stdout" 2>"$T/stderr" </dev/null
  status=$?
  read_messages
}

read_messages() {
  line1='' line2='' line3=''
  {
    IFS= read -r line1
    IFS= read -r line2
    IFS= read -r line3
  } <"$T/stderr"
}

# run_within KIB COMMAND...: run, with so much address space.
run_within() (
  # shellcheck disable=SC3045 # not in POSIX, but in every sh that is used; limits_memory has tried it
  ulimit -v "$1"
  shift
  timeout -k 1 "$patience" "$@" >"$T/stdout" 2>"$T/stderr" </dev/null
)

# run_textured COMMAND...: run, with as much memory as a texture may cost.
run_textured() {
  if [ "$limits_memory" = 1 ]; then
    run_within "$most_memory" "$@"
    status=$?
    read_messages
  else
    run "$@"
  fi
}

# choose CHAPTER: sets program and name.
choose() {
  case $1 in
    1) name=01_plain_spheres ;;
    2) name=02_checkerboard_uv ;;
    3) name=03_image_texture ;;
    4) name=04_uv_conventions ;;
    5) name=05_y_rotation ;;
    6) name=06_phong_texture_blend ;;
    8) name=08_triangle_uv ;;
    12) name=12_environment_map ;;
  esac
  program=$bin/$name
}

# chapter N OPTIONS...: runs a chapter with what it needs to draw a single picture without the course's assets.
chapter() {
  choose "$1"
  case $1 in
    1 | 2) shift ;;
    4) shift && set -- --texture "$texture" --convention rtiow "$@" ;;
    *) shift && set -- --texture "$texture" "$@" ;;
  esac
  run "$program" "$@"
}

# --- Expecting ---------------------------------------------------------------------------------------------------------------

expect_status() { [ "$status" = "$1" ] || complain "status $1 expected, got $status ($line1)"; }

# shellcheck disable=SC2254 # these are patterns
expect_line1() { case $line1 in $1) ;; *) complain "a message like '$1' expected, got '$line1'" ;; esac; }

expect_one_line() { [ -z "$line2" ] || complain "one line on stderr expected, then came '$line2'"; }

expect_no_stdout() { [ ! -s "$T/stdout" ] || complain "nothing on stdout expected, got '$(head -n 1 "$T/stdout")'"; }

# The current folder is empty unless a check put something there.
expect_nothing_written() {
  [ -z "$(ls -A)" ] && return
  complain "nothing written expected, got $(ls -A)"
  rm -rf ./* ./.[!.]*
}

expect_same() { cmp -s "$1" "$2" || complain "$3"; }

# expect_only FOLDER NAME: no temporary file is left.
expect_only() {
  found=$(ls -A "$1")
  [ "$found" = "$2" ] || complain "only '$2' expected in its folder, got '$(printf '%s' "$found" | tr '\n' ' ')'"
}

# is_whole FILE: it is a picture that chapter 03 loads.
is_whole() {
  timeout -k 1 "$patience" "$bin/03_image_texture" --quiet --texture "$1" --width 1 --height 1 --out "$T/judge.png" \
    >/dev/null 2>&1 </dev/null
}

expect_whole() { is_whole "$1" || complain "${1##*/} is not a whole picture"; }

# refuses CHAPTER FLAG OPTIONS...: a wrong command line; the message names the flag.
refuses() {
  refused_chapter=$1 flag=$2
  shift 2
  chapter "$refused_chapter" "$@"
  expect_status 2
  expect_line1 "error: *$flag*"
  case $line2 in "usage: $name "*) ;; *) complain "then the usage line expected, got '$line2'" ;; esac
  [ -z "$line3" ] || complain "nothing after the usage line expected, got '$line3'"
  expect_no_stdout
  expect_nothing_written
}

# refuses_number CHAPTER FLAG VALUE: the message says the range, too.
refuses_number() {
  refuses "$1" "$2" "$2" "$3"
  expect_line1 "error: *$2*from [-0-9]*to [-0-9]*"
  conclude "$name $2 '$3'"
}

refuses_words() {
  refuses "$@"
  shift 2
  conclude "$name $*"
}

# takes KIND: what kind of file is read from now on. Sets good, a file that loads, and its ending.
takes() {
  kind=$1 noun=texture
  case $kind in
    texture) good=$texture ending=png ;;
    sky) good=$T/good.hdr ending=hdr ;;
    mesh) good=$T/good.obj ending=obj noun=mesh ;;
  esac
}

# reads FILE OUT: the chapter for files of this kind draws with it.
reads() {
  set -- "$1" --width 8 --height 6 --out "$2"
  case $kind in
    texture) $runner "$bin/03_image_texture" --texture "$@" ;;
    sky) $runner "$bin/12_environment_map" --samples 1 --sky "$@" ;;
    mesh) $runner "$bin/08_triangle_uv" --texture "$texture" --mesh "$@" ;;
  esac
}
runner=run_textured

# refuses_file FILE WHAT: the chapter cannot load it, says so in a line and writes nothing.
refuses_file() {
  reads "$1" never.png
  expect_refused_file "$2"
}

expect_refused_file() {
  expect_status 1
  expect_line1 "error: cannot load $noun '*': ?*"
  expect_one_line
  expect_no_stdout
  expect_nothing_written
  conclude "$kind: $1"
}

# loads_file FILE WHAT
loads_file() {
  reads "$1" "$T/loaded.png"
  expect_status 0
  [ -s "$T/loaded.png" ] || complain "a picture expected, got none"
  rm -f "$T/loaded.png"
  conclude "$kind: $2"
}

# --- The command line ----------------------------------------------------------------------------------------------------------

check_numbers() {
  for n in 1 2 3 4 5 6; do
    for value in 0 -1 nan 4.5 1e3 '' ' 4' 4x 0x10 99999999999999999999; do refuses_number $n --samples "$value"; done
    for value in 0 -5 2147483648 16385; do refuses_number $n --width "$value"; done
    for value in 0 -5 2147483648 16385; do refuses_number $n --height "$value"; done
    for value in -1 1025 nan 2.5 ''; do refuses_number $n --threads "$value"; done
    refuses $n --width --width 16384 --height 16384
    expect_line1 'error: *--height*67108864*'
    conclude "$name --width 16384 --height 16384"
    refuses_words $n --samples --samples=0
  done
  for value in nan 4.5 1e3 '' ' 4' '4 ' 4x 0x10 99999999999999999999 +4 -; do
    refuses_number 1 --width "$value"
    refuses_number 1 --height "$value"
  done
  for value in nan -nan inf -inf infinity 1e400 -1e400 abc '' ' 90' '90 ' 90x 0x10 1,5 1e . - 1.2.3 '1 2'; do
    refuses_number 5 --degrees "$value"
    refuses_number 6 --degrees "$value"
  done
  for value in -0.1 1.1 nan '' 0,5 1.0000001 -1e-9 inf; do refuses_number 6 --blend "$value"; done
  for value in -1 nan inf '' 1e31 5O; do refuses_number 6 --shininess "$value"; done
  for value in -1 10000 1.5 ''; do refuses_number 5 --turntable "$value"; done

  # What is right is not refused.
  for value in -1e300 1e-400 +90 .5 90. 1E2; do
    chapter 5 --degrees "$value" --width 4 --height 3 --out "$T/right.png"
    expect_status 0
    conclude "$name --degrees $value"
  done
}

check_words() {
  for n in 1 2 3 4 5 6; do
    refuses_words $n --nonsense --nonsense
    refuses_words $n --nonsense --nonsense=3
    refuses_words $n -x -x
    refuses_words $n stray stray
    refuses_words $n --sampl --sampl 4
    refuses_words $n --out --out ''
    refuses_words $n --out --out=
    refuses_words $n --number --number single
    refuses_words $n --quiet --quiet=yes
    for flag in --out --width --height --samples --threads --number; do refuses_words $n "$flag" "$flag"; done
  done
  for n in 3 4 5 6; do
    refuses_words $n --texture --texture ''
    refuses_words $n --texture --texture
  done
  for n in 4 5 6; do
    refuses_words $n --convention --convention upside-down
    refuses_words $n --rounding --rounding ''
  done
  refuses_words 6 --scene --scene moon
  refuses_words 6 --degrees --degrees

  # A chapter takes the options that it has a use for, and no others.
  for n in 1 2; do refuses_words $n --texture --texture "$texture"; done
  for n in 1 2 3; do refuses_words $n --convention --convention daily; done
  for n in 1 2 3; do refuses_words $n --rounding --rounding floor; done
  for n in 1 2 3 4; do refuses_words $n --degrees --degrees 1; done
  for n in 1 2 3 4 5; do
    refuses_words $n --blend --blend 0.5
    refuses_words $n --shininess --shininess 5
    refuses_words $n --scene --scene stage
  done

  for n in 1 2 3 4 5 6; do
    for word in --help --version; do
      choose $n
      run "$program" $word
      expect_status 0
      [ ! -s "$T/stderr" ] || complain "nothing on stderr expected, got '$line1'"
      grep -q -e "$name" "$T/stdout" || complain "the program's name expected on stdout"
      expect_nothing_written
      conclude "$name $word"
      timeout "$patience" "$program" $word >/dev/full 2>"$T/stderr"
      status=$?
      read_messages
      expect_status 1
      expect_line1 'error: ?*'
      conclude "$name $word on a full device"
    done
  done
}

# --- Files that are read -------------------------------------------------------------------------------------------------------

# check_places: files of the kind that are missing, or no files, or cut.
check_places() {
  loads_file "$good" 'a good file'
  refuses_file "$T/missing.$ending" 'missing'
  ln -s "$T/nowhere" "$T/dangling.$ending"
  refuses_file "$T/dangling.$ending" 'dangling link'
  refuses_file "$T/loop-a" 'link loop'
  refuses_file "$T/$long_name" 'name of 300 characters'
  refuses_file "$long_name" 'name of 300 characters, looked for in the assets'
  refuses_file "$T/$long_name$long_name$long_name$long_name$long_name$long_name$long_name$long_name$long_name$long_name$long_name$long_name$long_name$long_name" 'path of 4200 characters'
  invalid=$(printf 'no-\303\050-\377\376.%s' "$ending")
  refuses_file "$T/$invalid" 'missing, and its name is not UTF-8'
  if cp "$good" "$T/$invalid" 2>/dev/null; then
    loads_file "$T/$invalid" 'a name that is not UTF-8'
  else
    skip "$kind: a name that is not UTF-8" 'the disk takes no such name'
  fi
  for other in 'Erde-äöü' '地球' 'with space' "it's \"quoted\"" '-dash' '*'; do
    cp "$good" "$T/$other.$ending"
    loads_file "$T/$other.$ending" "$other.$ending"
  done
  refuses_file "$T" 'a folder'
  refuses_file "$good/" 'a file with a slash behind it'
  refuses_file "$good/inside.$ending" 'a path through a file'
  if mkfifo "$T/pipe.$ending"; then refuses_file "$T/pipe.$ending" 'a pipe'; else skip "$kind: a pipe" 'none can be made'; fi
  for device in /dev/zero /dev/urandom /dev/null /dev/full /dev/tty /proc/cpuinfo /proc/self/mem /proc/self/fd; do
    if [ -e "$device" ]; then refuses_file "$device" "$device"; else skip "$kind: $device" 'not on this system'; fi
  done
  : >"$T/empty.$ending"
  refuses_file "$T/empty.$ending" 'an empty file'
  if truncate -s 10G "$T/sparse.$ending" 2>/dev/null; then
    refuses_file "$T/sparse.$ending" 'a sparse file of 10 GiB'
  else
    skip "$kind: a sparse file of 10 GiB" 'the disk has none'
  fi
  rm -f "$T/sparse.$ending"
  # As long as may be, and nothing behind a good beginning.
  cp "$good" "$T/tail.$ending"
  truncate -s 64M "$T/tail.$ending"
  reads "$T/tail.$ending" "$T/loaded.png"
  case $status in 0 | 1) ;; *) complain "status 0 or 1 expected, got $status ($line1)" ;; esac
  conclude "$kind: 64 MiB, zeros behind a good file"
  rm -f "$T/tail.$ending" "$T/loaded.png"

  cp "$good" "$T/secret.$ending"
  chmod 000 "$T/secret.$ending"
  if [ "$have_user" = 1 ]; then
    runner=as_user
    refuses_file "$T/secret.$ending" 'unreadable'
    runner=run_textured
  else
    skip "$kind: unreadable" 'root may read everything, and no other user can run the programs'
  fi

  # Cut anywhere, it is no good file any more; and the picture that was there stays.
  size=$(wc -c <"$good")
  for length in 1 7 8 9 20 33 34 $((size / 2)) $((size - 13)) $((size - 12)) $((size - 8)) $((size - 1)); do
    head -c "$length" "$good" >"$T/cut.$ending"
    refuses_file "$T/cut.$ending" "the first $length bytes of a good file"
  done
  mkdir "$T/kept-$kind"
  cp "$T/old.png" "$T/kept-$kind/out.png"
  reads "$T/cut.$ending" "$T/kept-$kind/out.png"
  expect_status 1
  keeps_old "$T/kept-$kind"
  conclude "$kind: a bad file, and the old picture"
}

check_textures() {
  takes texture
  check_places
  for name_of_missing in 'missing.png' 'folder/missing.png'; do
    for n in 3 4 5 6; do
      choose $n
      run "$program" --texture "$name_of_missing" --width 8 --height 6 --out never.png
      expect_refused_file "$name $name_of_missing"
    done
  done
}

# bad_file WHAT TEXT: this text, with printf's escapes, is refused as a file of the kind.
bad_file() {
  printf '%b' "$2" >"$T/bad.$ending"
  refuses_file "$T/bad.$ending" "$1"
}

# has_reader N: the chapter that reads the files is here; not everywhere all are.
has_reader() {
  choose "$1"
  [ -x "$program" ] && return
  skip "$name" 'there is no such program'
  return 1
}

# Chapter 12's Radiance files.
check_skies() {
  has_reader 12 || return
  takes sky
  start='#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n'
  texels='\0200\0100\0040\0201\0220\0110\0044\0200\0240\0120\0050\0177\0260\0130\0054\0202'
  printf '%b' "$start-Y 2 +X 4\n$texels$texels" >"$good"
  check_places
  bad_file 'a mesh' 'v 0 0 0\n'
  bad_file 'another kind of picture' 'P6 4 2 255\n'
  bad_file 'no format' "#?RADIANCE\n\n-Y 2 +X 4\n$texels$texels"
  bad_file 'another format' "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 2 +X 4\n$texels$texels"
  bad_file 'an odd width' "$start-Y 2 +X 3\n$texels$texels"
  bad_file 'rows from below' "$start+Y 2 +X 4\n$texels$texels"
  bad_file 'no rows' "$start-Y 0 +X 4\n"
  bad_file 'a height of eleven digits' "$start-Y 99999999999 +X 4\n$texels"
  bad_file 'the largest sides' "$start-Y 16384 +X 16384\n$texels"
  bad_file 'twice as many texels as a sky may have' "$start-Y 4096 +X 4096\n$texels"
  bad_file 'a texel brighter than any sun' "$start-Y 2 +X 4\n$texels\0377\0377\0377\0377$texels"
  bad_file 'a run longer than its row' "$start-Y 2 +X 8\n\0002\0002\0000\0010\0211\0001"
}

# Chapter 08's meshes in OBJ format.
check_meshes() {
  has_reader 8 || return
  takes mesh
  corners='v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n'
  printf '%b' "${corners}f 1/1 2/2 3/3\n" >"$good"
  check_places
  refuses_file "$texture" 'a picture'
  bad_file 'no face' "$corners"
  bad_file 'a point that does not exist' "${corners}f 1/1 2/2 4/3\n"
  bad_file 'texture coordinates before the first' "${corners}f 1/1 2/2 3/-4\n"
  bad_file 'no texture coordinates' "${corners}f 1 2 3\n"
  bad_file 'a face of two corners' "${corners}f 1/1 2/2\n"
  bad_file 'a coordinate that is no number' "${corners}v 1 nan 0\nf 1/1 2/2 3/3\n"
  bad_file 'a coordinate that is too large' "${corners}v 1e31 0 0\nf 1/1 2/2 3/3\n"
  bad_file 'an index of twenty digits' "${corners}f 1/1 2/2 99999999999999999999/3\n"
  bad_file 'a word that is not known' "${corners}f 1/1 2/2 3/3\nfrom here on a text\n"
  bad_file 'a line of 70,000 bytes' "${corners}f$(yes ' 1/1' | head -n 17500 | tr -d '\n')\n"
  fan=$(yes ' 1/1' | head -n 16000 | tr -d '\n')
  {
    printf '%b' "$corners"
    for _ in $(seq 132); do printf 'f%s\n' "$fan"; done
  } >"$T/fans.obj"
  refuses_file "$T/fans.obj" '132 fans of 15,998 triangles, more than 2^21'
}

check_corpus() {
  takes texture
  files=0
  while IFS=$tab read -r file _ expected _ _ _ _ _ level _; do
    [ "$file" != file ] || continue
    files=$((files + 1))
    if [ "$level" = may ]; then
      reads "$corpus/$file" "$T/loaded.png"
      case $status in 0 | 1) ;; *) complain "status 0 or 1 expected, got $status ($line1)" ;; esac
      rm -f "$T/loaded.png"
      conclude "texture: corpus/$file, which may load"
    elif [ "$expected" = load ]; then
      loads_file "$corpus/$file" "corpus/$file"
    else
      refuses_file "$corpus/$file" "corpus/$file"
    fi
  done <"$corpus/manifest.tsv"
  [ "$files" -ge 50 ] || complain "at least 50 files expected in the corpus, got $files"
  conclude 'the corpus'
}

# --- Output -------------------------------------------------------------------------------------------------------------------

expect_cannot_write() {
  expect_status 1
  expect_line1 "error: cannot write '*': ?*"
  expect_one_line
  expect_no_stdout
  expect_nothing_written
}

# cannot_write FILE WHAT: each of the chapters gives up with status 1 and a line about it.
cannot_write() {
  for n in $chapters_that_write; do
    chapter "$n" --width 8 --height 6 --out "$1"
    expect_cannot_write
    conclude "output, $name: $2"
  done
}

# keeps_old FOLDER WHAT: after a failure, out.png in the folder is as it was, alone.
keeps_old() {
  expect_same "$1/out.png" "$T/old.png" 'the old picture is not as it was'
  expect_only "$1" out.png
}

check_output() {
  chapters_that_write='1 2 3 4 5 6'
  cannot_write "$T/no/such/folder/out.png" 'folder missing'
  cannot_write "$texture/out.png" 'the folder is a file'
  mkdir "$T/folder"
  cannot_write "$T/folder" 'it is a folder'
  expect_only "$T/folder" ''
  conclude 'output: the folder stays empty'
  chapters_that_write=1
  cannot_write "$T/folder/" 'a slash at the end'
  cannot_write "$T/new-folder/" 'a slash at the end, nothing there'
  cannot_write "$T/folder/." 'a folder with a dot'
  cannot_write "$T/folder/$long_name" 'name of 300 characters'
  cannot_write "$long_name" 'name of 300 characters, relative'
  cannot_write "$T/loop-a" 'link loop'
  ln -sf "$T/no/such/file.png" "$T/link-to-nowhere.png"
  cannot_write "$T/link-to-nowhere.png" 'link into a folder that does not exist'

  # A picture that fails to be written in the end, not in the beginning.
  mkdir "$T/small"
  cp "$T/old.png" "$T/small/out.png"
  choose 1
  (
    ulimit -f 1
    timeout "$patience" "$program" --width 320 --height 240 --out "$T/small/out.png" >"$T/stdout" 2>"$T/stderr"
  ) 2>/dev/null
  status=$?
  read_messages
  expect_cannot_write
  keeps_old "$T/small"
  conclude 'output: no file may grow so large'

  mkdir "$T/disk"
  if mount -t tmpfs -o size=16k none "$T/disk" 2>/dev/null; then
    mounted=$T/disk
    head -c 8192 "$T/big.png" >"$T/disk/out.png"
    cp "$T/disk/out.png" "$T/old-on-disk.png"
    run "$program" --width 320 --height 240 --out "$T/disk/out.png"
    expect_cannot_write
    expect_same "$T/disk/out.png" "$T/old-on-disk.png" 'the old picture is not as it was'
    expect_only "$T/disk" out.png
    conclude 'output: disk full'
    run "$program" --width 320 --height 240 --out "$T/disk/new.png"
    expect_cannot_write
    expect_only "$T/disk" out.png
    conclude 'output: disk full, no old picture'
    umount "$T/disk" && mounted=
  else
    skip 'output: disk full' 'a small disk cannot be mounted'
  fi

  mkdir "$T/read-only"
  cp "$T/old.png" "$T/read-only/out.png"
  cp "$T/old.png" "$T/folder/out.png"
  chmod 444 "$T/folder/out.png"
  chmod 555 "$T/read-only"
  chmod 777 "$T/folder"
  if [ "$have_user" = 1 ]; then
    for what in read-only/out.png read-only/new.png folder/out.png; do
      as_user "$program" --width 8 --height 6 --out "$T/$what"
      expect_cannot_write
      keeps_old "$T/${what%/*}"
      conclude "output: read-only $what"
    done
  else
    skip 'output: read-only' 'root may write everywhere, and no other user can run the programs'
  fi
  chmod 755 "$T/read-only"

  # Devices: never the real ones as root, who could rename a picture over them.
  full=/dev/full null=/dev/null
  if [ "$(id -u)" = 0 ]; then
    full=$T/full null=$T/null
    mknod "$full" c 1 7 2>/dev/null
    mknod "$null" c 1 3 2>/dev/null
    if ! { echo x >"$null"; } 2>/dev/null; then full='' null=''; fi
  fi
  if [ -c "$full" ]; then
    run "$program" --width 8 --height 6 --out "$full"
    expect_cannot_write
    [ -c "$full" ] || complain 'the device is gone'
    conclude 'output: a full device'
    run "$program" --width 8 --height 6 --out "$null"
    expect_status 0
    [ -c "$null" ] || complain 'the device is gone'
    conclude 'output: the null device'
  else
    skip 'output: devices' 'there are none that could not come to harm'
  fi
  if mkfifo "$T/out-pipe"; then
    run "$program" --width 8 --height 6 --out "$T/out-pipe"
    expect_cannot_write
    [ -p "$T/out-pipe" ] || complain 'the pipe is gone'
    conclude 'output: a pipe that nobody reads'
    cat "$T/out-pipe" >"$T/through-pipe.png" &
    reader=$!
    sleep 0.2
    run "$program" --width 60 --height 40 --out "$T/out-pipe"
    wait "$reader"
    expect_status 0
    expect_same "$T/through-pipe.png" "$T/reference-1.png" 'another picture came through the pipe'
    conclude 'output: a pipe with a reader'
  else
    skip 'output: a pipe' 'none can be made'
  fi

  # Links, names, permissions.
  mkdir "$T/links" "$T/links/far"
  cp "$T/old.png" "$T/links/far/target.png"
  ln -s far/target.png "$T/links/link.png"
  ln -s link.png "$T/links/link-to-link.png"
  ln -s far/fresh.png "$T/links/fresh-link.png"
  for link in link link-to-link fresh-link; do
    run "$program" --width 60 --height 40 --out "$T/links/$link.png"
    expect_status 0
    [ -L "$T/links/$link.png" ] || complain 'the link is gone'
    expect_same "$T/links/$link.png" "$T/reference-1.png" 'the picture is another one'
    conclude "output: $link"
    cp "$T/old.png" "$T/links/far/target.png"
  done
  mkdir "$T/it's a \"folder\" \$HOME * äöü"
  for other in "it's a \"folder\" \$HOME * äöü/pic ture.png" '日本.png' 'no-ending' '-dash.png' '.png'; do
    run "$program" --width 60 --height 40 --out "$T/$other"
    expect_status 0
    expect_same "$T/$other" "$T/reference-1.png" 'the picture is another one'
    grep -q -F -e "$T/$other: 60 x 40 pixels" "$T/stdout" || complain "a line about the file expected, got '$(cat "$T/stdout")'"
    [ "$(wc -l <"$T/stdout")" = 1 ] || complain 'one line on stdout expected'
    [ ! -s "$T/stderr" ] || complain "nothing on stderr expected, got '$line1'"
    conclude "output: $other"
  done
  run "$program" --quiet --width 60 --height 40 --out "$T/quiet.png"
  expect_status 0
  expect_no_stdout
  [ ! -s "$T/stderr" ] || complain "nothing on stderr expected, got '$line1'"
  conclude 'output: --quiet'
  (umask 027 && run "$program" --width 8 --height 6 --out "$T/masked.png")
  case $(ls -l "$T/masked.png") in -rw-r-----*) ;; *) complain "-rw-r----- expected, got $(ls -l "$T/masked.png")" ;; esac
  conclude 'output: a new file, umask 027'
  chmod 604 "$T/masked.png"
  run "$program" --width 8 --height 6 --out "$T/masked.png"
  case $(ls -l "$T/masked.png") in -rw----r--*) ;; *) complain "-rw----r-- expected, got $(ls -l "$T/masked.png")" ;; esac
  conclude 'output: a replaced file keeps its permissions'

  # A picture may be written over its own texture.
  cp "$texture" "$T/both.png"
  choose 3
  run "$program" --texture "$T/both.png" --width 60 --height 40 --out "$T/both.png"
  expect_status 0
  expect_same "$T/both.png" "$T/reference-3.png" 'the picture is another one'
  conclude 'output: over the texture'

  # Of several pictures, one that cannot be written is found before the first is drawn.
  mkdir -p "$T/turn/t_002.png"
  chapter 5 --turntable 3 --width 8 --height 6 --out "$T/turn/t.png"
  expect_cannot_write
  expect_only "$T/turn" t_002.png
  conclude 'output: the last of three pictures cannot be written'

  # The default place, made if missing.
  mkdir "$T/home"
  for n in 1 2 3 4 5 6; do
    cd "$T/home" || exit 1
    chapter $n --width 60 --height 40
    expect_status 0
    expect_same "out/$name.png" "$T/reference-$n.png" "out/$name.png expected"
    expect_only out "$name.png"
    rm -rf out
    : >out
    chapter $n --width 60 --height 40
    expect_status 1
    expect_line1 "error: cannot write 'out/$name.png': ?*"
    rm -f out
    cd "$T/cwd" || exit 1
    conclude "output: the default place of $name"
  done
}

# --- Signals ------------------------------------------------------------------------------------------------------------------

# expect_old_or_new SIGNAL: out.png in the folder for signals is one of the two, and alone.
expect_old_or_new() {
  if cmp -s "$T/signals/out.png" "$T/new.png"; then
    saw_new=$((saw_new + 1))
  elif cmp -s "$T/signals/out.png" "$T/old.png"; then
    saw_old=$((saw_old + 1))
  else
    complain 'neither the old picture nor the new one is there'
  fi
  # After SIGKILL nobody can clean up.
  if [ "$1" != KILL ]; then expect_only "$T/signals" out.png; fi
  rm -f "$T"/signals/.[!.]*
}

# signals_at SIGNAL WHAT MOMENTS OPTIONS...: the signal comes after so many seconds.
signals_at() {
  signal=$1 what=$2 moments=$3
  shift 3
  saw_old=0 saw_new=0
  for moment in $moments; do
    cp "$T/old.png" "$T/signals/out.png"
    timeout --foreground -s "$signal" "$moment" "$program" "$@" --out "$T/signals/out.png" >"$T/stdout" 2>"$T/stderr" </dev/null
    status=$?
    case $status in 0 | 124 | 137) ;; *) complain "status $status after $moment s" ;; esac
    [ ! -s "$T/stderr" ] || complain "nothing on stderr expected, got '$(head -n 1 "$T/stderr")'"
    expect_old_or_new "$signal"
  done
  conclude "SIG$signal at ${moments%% *} to ${moments##* } s, $what ($saw_old old, $saw_new new)"
}

# signals_while_writing SIGNAL: the signal comes as soon as there is a second file in the folder.
signals_while_writing() {
  saw_old=0 saw_new=0
  case $1 in HUP) ended=129 ;; INT) ended=130 ;; KILL) ended=137 ;; TERM) ended=143 ;; esac
  for _ in 1 2 3 4 5; do
    cp "$T/old.png" "$T/signals/out.png"
    : >"$T/said"
    # A command in the background of a script ignores SIGINT unless told otherwise.
    env --default-signal=INT,TERM,HUP "$program" --width 320 --height 240 --out "$T/signals/out.png" >"$T/said" 2>&1 </dev/null &
    drawing=$!
    turns=0
    while [ ! -s "$T/said" ] && [ "$turns" -lt 500000 ]; do
      set -- "$1" "$T"/signals/.[!.]*
      if [ -e "$2" ]; then
        writing=$((writing + 1))
        break
      fi
      turns=$((turns + 1))
    done
    kill -s "$1" "$drawing" 2>/dev/null
    { wait "$drawing"; } 2>/dev/null
    status=$?
    [ "$status" = 0 ] || [ "$status" = "$ended" ] || complain "status 0 or $ended expected, got $status"
    expect_old_or_new "$1"
    ! grep -q '^error' "$T/said" || complain "got '$(head -n 1 "$T/said")'"
  done
  conclude "SIG$1 while the picture is being written ($saw_old old, $saw_new new)"
}

check_signals() {
  mkdir "$T/signals"
  choose 1
  run "$program" --width 320 --height 240 --out "$T/new.png"
  early='0.001 0.002 0.003 0.004 0.005 0.006 0.007 0.008 0.009 0.010 0.011 0.012 0.013 0.014 0.016 0.018 0.020 0.023 0.026 0.030 0.035 0.040 0.045 0.050 0.060'
  for signal in TERM INT HUP KILL; do
    signals_at "$signal" 'a long render' '0.02 0.15 0.4' --width 320 --height 240 --samples 65536
    [ "$saw_new" = 0 ] || complain 'a picture that takes minutes cannot be there'
    conclude "SIG$signal ends a long render"
    signals_at "$signal" 'a small picture' "$early" --width 320 --height 240
  done
  writing=0
  if env --default-signal=INT true 2>/dev/null; then
    for signal in TERM INT HUP KILL; do signals_while_writing $signal; done
    [ "$writing" -gt 0 ] || skip 'signals while the picture is being written' 'the disk is too fast: none came in time'
  else
    skip 'signals while the picture is being written' 'env cannot set signals back'
  fi
  is_whole "$T/signals/out.png" || complain 'the last picture is not whole'
  conclude 'the picture after all signals'
}

# --- Many at once ---------------------------------------------------------------------------------------------------------------

check_crowd() {
  mkdir "$T/crowd"
  choose 1
  run "$program" --quiet --width 20 --height 15 --out "$T/crowd/out.png"
  : >"$T/crowd-failures"
  crowd=
  for writer in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do
    (
      for turn in 1 2 3 4 5 6 7 8 9 10 11 12; do
        timeout "$patience" "$program" --quiet --width $((20 * writer)) --height $((15 * writer)) --threads 1 --out "$T/crowd/out.png" \
          </dev/null >/dev/null 2>&1 || echo "run $turn of writer $writer: status $?" >>"$T/crowd-failures"
      done
      : >"$T/crowd-done-$writer"
    ) &
    crowd="$crowd $!"
  done
  reads=0
  torn=0
  while :; do
    set -- "$T"/crowd-done-*
    [ $# -lt 16 ] || break
    is_whole "$T/crowd/out.png" || torn=$((torn + 1))
    reads=$((reads + 1))
  done
  # shellcheck disable=SC2086 # a list of numbers
  wait $crowd
  [ "$reads" -gt 3 ] || complain "only $reads reads"
  [ "$torn" = 0 ] || complain "$torn of $reads reads found no whole picture"
  conclude "16 writers of one file, $reads reads"
  [ ! -s "$T/crowd-failures" ] || complain "$(head -n 1 "$T/crowd-failures")"
  conclude '16 writers of one file: all succeed'
  expect_whole "$T/crowd/out.png"
  expect_only "$T/crowd" out.png
  conclude '16 writers of one file: what is left'
}

# --- Standard streams ------------------------------------------------------------------------------------------------------------

# drew CHAPTER WHAT: the picture is there, whole, although the streams were not.
drew() {
  expect_same "$T/stream.png" "$T/reference-$1.png" 'the picture is another one'
  rm -f "$T/stream.png"
  conclude "$name: $2"
}

check_streams() {
  for n in 1 2 3 4 5 6; do
    choose $n
    case $n in
      1 | 2) set -- ;;
      4) set -- --texture "$texture" --convention rtiow ;;
      *) set -- --texture "$texture" ;;
    esac
    set -- timeout "$patience" "$program" "$@" --width 60 --height 40 --out "$T/stream.png"
    : >"$T/stderr"
    line1=''

    "$@" >&- 2>"$T/stderr"
    status=$?
    expect_status 0
    [ ! -s "$T/stderr" ] || complain "nothing on stderr expected, got '$(head -n 1 "$T/stderr")'"
    drew $n 'stdout closed'

    "$@" <&- >&- 2>&-
    status=$?
    expect_status 0
    drew $n 'descriptors 0, 1 and 2 closed'

    "$@" <&- >"$T/stdout" 2>&-
    status=$?
    expect_status 0
    drew $n 'descriptors 0 and 2 closed'

    if [ -c /dev/full ]; then
      "$@" >/dev/full 2>"$T/stderr"
      status=$?
      read_messages
      expect_status 1
      expect_line1 'error: ?*'
      expect_one_line
      drew $n 'stdout on a full device'
    else
      skip "$name: stdout on a full device" 'there is none'
    fi

    # A pipe with a reader that has gone for certain.
    mkfifo "$T/gone-$n"
    exec 3<>"$T/gone-$n"
    exec 4>"$T/gone-$n"
    exec 3>&-
    "$@" >&4 2>"$T/stderr"
    status=$?
    exec 4>&-
    read_messages
    expect_status 1
    expect_line1 'error: ?*'
    expect_one_line
    drew $n 'stdout is a pipe that nobody reads'
  done

  choose 1
  timeout "$patience" "$program" --samples nan >/dev/null 2>&-
  status=$?
  expect_status 2
  conclude "$name: a wrong command line, stderr closed"
  timeout "$patience" "$program" --out "$T/no/such/folder/x.png" >&- 2>/dev/full
  status=$?
  expect_status 1
  conclude "$name: a fault, stderr on a full device"
  # Messages must not end up in a texture or a picture that took a stream's number.
  choose 3
  timeout "$patience" "$program" --texture "$corpus/bad_one_byte.png" --out "$T/stream.png" <&- >&- 2>&-
  status=$?
  expect_status 1
  [ ! -e "$T/stream.png" ] || complain 'a picture was written'
  conclude "$name: a bad texture, descriptors 0, 1 and 2 closed"
}

# --- Memory ------------------------------------------------------------------------------------------------------------------

# starved KIB COMMAND...: whole picture or a line about memory.
starved() {
  cp "$T/old.png" "$T/starved/out.png"
  run_within "$@"
  status=$?
  read_messages
  if [ "$status" = 0 ]; then
    fed=$((fed + 1))
    expect_same "$T/starved/out.png" "$T/fed.png" "at $1 KiB: status 0, and another picture"
  else
    hungry=$((hungry + 1))
    [ "$status" = 1 ] || complain "at $1 KiB: status 1 expected, got $status"
    [ "$line1" = 'error: not enough memory' ] || complain "at $1 KiB: 'error: not enough memory' expected, got '$line1'"
    expect_one_line
    expect_same "$T/starved/out.png" "$T/old.png" "at $1 KiB: the old picture is not as it was"
  fi
  expect_only "$T/starved" out.png
}

check_memory() {
  if [ "$limits_memory" = 0 ]; then
    skip 'memory' 'it cannot be limited here (sanitizers, or this shell)'
    return
  fi
  mkdir "$T/starved"
  for n in 1 6; do
    choose $n
    set -- --threads 1
    if [ $n = 6 ]; then set -- "$@" --texture "$texture"; fi
    # The least that the program is loaded with: below, the system says 127 and the program never ran.
    low=0 start=131072
    while [ $((start - low)) -gt 4 ]; do
      middle=$(((low + start) / 2))
      run_within $middle "$program" --help 2>/dev/null
      if [ $? = 127 ]; then low=$middle; else start=$middle; fi
    done
    run "$program" "$@" --width 400 --height 300 --out "$T/fed.png"

    fed=0 hungry=0
    more=0
    while [ $more -lt 480 ]; do
      starved $((start + more)) "$program" "$@" --width 400 --height 300 --out "$T/starved/out.png" 2>/dev/null
      more=$((more + 12))
    done
    conclude "$name: hardly enough memory to start"

    fed=0 hungry=0
    for more in 500 600 700 800 900 1000 1100 1200 1300 1400 1500 1600 1800 2000 2300 2600 3000 4000 8000; do
      starved $((start + more)) "$program" "$@" --width 400 --height 300 --out "$T/starved/out.png"
    done
    [ "$hungry" -gt 0 ] || complain 'memory was never short'
    [ "$fed" -gt 0 ] || complain 'memory was never enough'
    conclude "$name: memory a little short ($hungry times, $fed times enough)"

    fed=0 hungry=0
    shift 2
    for more in 1000 4000 9000 9500 10000 17500 18000 26000 27000 40000 80000 150000; do
      starved $((start + more)) "$program" "$@" --threads 64 --width 400 --height 300 --out "$T/starved/out.png"
    done
    conclude "$name: memory short for 64 threads ($hungry times, $fed times enough)"
  done
  choose 1
  fed=0 hungry=0
  starved 150000 "$program" --width 8192 --height 8192 --threads 1 --out "$T/starved/out.png"
  [ "$hungry" = 1 ] || complain 'memory was enough'
  conclude "$name: a picture of 2^26 pixels in 150 MB"
}

# --- Surroundings ---------------------------------------------------------------------------------------------------------------

# same_picture CHAPTER WHAT COMMAND...: the command draws the chapter's reference picture to there.png.
same_picture() {
  n=$1 what=$2
  shift 2
  rm -f "$T/there.png"
  run "$@" --out "$T/there.png"
  expect_status 0
  expect_same "$T/there.png" "$T/reference-$n.png" 'the picture is another one'
  conclude "$name: $what"
}

check_surroundings() {
  comma_locale
  for n in 1 2 3 4 5 6; do
    choose $n
    set -- --width 60 --height 40
    case $n in
      1 | 2) ;;
      4) set -- "$@" --texture "$texture" --convention rtiow ;;
      *) set -- "$@" --texture "$texture" ;;
    esac
    for threads in 1 2 4 16 1024; do same_picture "$n" "--threads $threads" "$program" "$@" --threads $threads; done
    same_picture "$n" 'no TERM, C locale' env -u TERM -u LANG LC_ALL=C "$program" "$@"
    same_picture "$n" 'TERM is nonsense' env TERM=nonsense COLUMNS=0 "$program" "$@"
    same_picture "$n" 'a locale that does not exist' env LC_ALL=xx_YY.UTF-8 "$program" "$@"
    if [ "$sanitized" = 0 ]; then same_picture "$n" 'no environment' env -i "$program" "$@"; fi
    if [ -n "$comma" ]; then same_picture "$n" "locale $comma" env LOCPATH="$locales" LC_ALL="$comma" "$program" "$@"; fi
    if command -v setsid >/dev/null; then same_picture "$n" 'no terminal' setsid -w "$program" "$@"; fi
  done
  command -v setsid >/dev/null || skip 'no terminal' 'there is no setsid'

  choose 6
  set -- --texture "$texture" --width 60 --height 40
  run "$program" "$@" --blend 0.25 --degrees 12.5 --out "$T/point.png"
  if [ -n "$comma" ]; then
    run env LOCPATH="$locales" LC_ALL="$comma" "$program" "$@" --blend 0.25 --degrees 12.5 --out "$T/there.png"
    expect_status 0
    expect_same "$T/there.png" "$T/point.png" 'the picture is another one'
    conclude "$name: --blend 0.25 in locale $comma"
    run env LOCPATH="$locales" LC_ALL="$comma" "$program" "$@" --blend 0,25 --out "$T/there.png"
    expect_status 2
    expect_line1 'error: *--blend*'
    conclude "$name: --blend 0,25 in locale $comma"
  else
    skip 'a locale with a decimal comma' 'none is installed'
  fi

  # Progress is for terminals only. A slow machine has half a minute to show it on one; the others then run for twice what it took.
  choose 1
  mkdir "$T/progress"
  long='--width 40 --height 9000 --samples 16000'   # half a minute, in short rows: progress comes after each
  enough=2
  if script -qec true /dev/null >/dev/null 2>&1 </dev/null; then
    : >"$T/stdout"
    script -qefc "exec '$program' $long --out '$T/progress/out.png'" /dev/null >"$T/stdout" 2>&1 </dev/null &
    drawing=$!
    tenths=0
    until grep -q '%' "$T/stdout" || [ "$tenths" -ge 300 ] || ! kill -s 0 "$drawing" 2>/dev/null; do
      sleep 0.1
      tenths=$((tenths + 1))
    done
    kill "$drawing" 2>/dev/null
    wait "$drawing" 2>/dev/null
    grep -q '%' "$T/stdout" || complain "none came in $tenths tenths of a second"
    conclude 'progress on a terminal'
    enough=$((tenths / 5 + 1))
    script -qec "timeout $enough '$program' $long --quiet --out '$T/progress/out.png'" /dev/null >"$T/stdout" 2>&1 </dev/null
    ! grep -q '%' "$T/stdout" || complain 'some came'
    conclude 'no progress on a terminal with --quiet'
  else
    skip 'progress on a terminal' 'there is no program script to make one'
  fi
  # shellcheck disable=SC2086 # options
  timeout "$enough" "$program" $long --out "$T/progress/out.png" >"$T/stdout" 2>"$T/stderr" </dev/null
  [ ! -s "$T/stderr" ] || complain "got '$(head -c 60 "$T/stderr")'"
  expect_no_stdout
  conclude 'no progress in a file'
  # shellcheck disable=SC2086 # options
  { timeout "$enough" "$program" $long --out "$T/progress/out.png" 2>&1; } </dev/null | cat >"$T/stdout"
  expect_no_stdout
  conclude 'no progress in a pipe'
  expect_only "$T/progress" ''
  conclude 'renders cut short leave nothing'
}

# A locale that writes 0,5: one that is installed, or one made for this.
comma_locale() {
  locales=${LOCPATH:-}
  comma=
  for candidate in $(locale -a 2>/dev/null | grep -E '^(de|fr|it|es|pl|nl|pt|ru)_'); do
    [ "$(LC_ALL=$candidate locale decimal_point 2>/dev/null)" = , ] || continue
    comma=$candidate
    break
  done
  if [ -z "$comma" ] && command -v localedef >/dev/null && mkdir "$T/locales" &&
    localedef -i de_DE -f UTF-8 "$T/locales/de_DE.UTF-8" 2>/dev/null; then
    locales=$T/locales
    comma=de_DE.UTF-8
  fi
}

# --- Getting ready -----------------------------------------------------------------------------------------------------------------

# as_user COMMAND...: run, as somebody whom permissions bind.
as_user() {
  if [ "$(id -u)" = 0 ]; then
    run chroot --userspec=65534:65534 --skip-chdir / "$@"
  else
    run "$@"
  fi
}

mounted=
clean_up() {
  [ -z "$mounted" ] || umount "$mounted" 2>/dev/null
  cd / && chmod -R u+rwx "$T" 2>/dev/null
  rm -rf "$T"
}

make_folder() {
  T=$(mktemp -d "${TMPDIR:-/tmp}/texmap-faults.XXXXXX") || exit 1
  trap clean_up EXIT
  trap 'exit 130' INT
  trap 'exit 143' TERM HUP
  chmod 755 "$T"   # another user has to find the way
  mkdir "$T/cwd"
  cd "$T/cwd" || exit 1
}

get_ready() {
  long_name=$(printf '%0300d' 0).png
  texture=$corpus/png_rgb8_33x31_allfilters.png
  for n in 1 2 3 4 5 6; do
    choose $n
    [ -x "$program" ] || { printf 'faults.sh: there is no program %s\n' "$program" >&2 && exit 2; }
  done
  [ -r "$corpus/manifest.tsv" ] || { printf 'faults.sh: there is no %s\n' "$corpus/manifest.tsv" >&2 && exit 2; }

  ln -s "$T/loop-b" "$T/loop-a"
  ln -s "$T/loop-a" "$T/loop-b"

  limits_memory=0
  # shellcheck disable=SC3045 # see run_within
  if [ "$sanitized" = 0 ] && (ulimit -v $most_memory) 2>/dev/null; then limits_memory=1; fi
  have_user=1
  as_user "$bin/01_plain_spheres" --version
  [ "$status" = 0 ] || have_user=0

  for n in 1 2 3 4 5 6; do
    chapter $n --width 60 --height 40 --out "$T/reference-$n.png"
    expect_status 0
    expect_whole "$T/reference-$n.png"
    conclude "$name draws a picture"
  done
  chapter 2 --width 40 --height 30 --out "$T/old.png"
  chapter 1 --width 320 --height 240 --out "$T/big.png"
  # The judge of whole pictures can say no.
  head -c 1000 "$T/big.png" >"$T/half.png"
  ! is_whole "$T/half.png" || complain 'half a picture counts as whole'
  conclude 'chapter 03 refuses half a picture'
}

# --- Does it find anything? ---------------------------------------------------------------------------------------------------------

# fake SCRIPT: all chapter programs are this shell script from now on.
fake() {
  for n in 1 2 3 4 5 6; do
    choose $n
    printf '#!/bin/sh\n%s\n' "$1" >"$program"
    chmod 755 "$program"
  done
}

# caught FAILURES WHAT: so many checks have failed since the last time.
caught() {
  if [ "$failed" = "$1" ]; then
    self_passed=$((self_passed + 1))
  else
    self_failed=$((self_failed + 1))
    printf 'FAILED self-test, %s: %s failed checks expected, got %s:\n' "$2" "$1" "$failed" >&3
    cat "$T/log" >&3
  fi
  failed=0
  : >"$T/log"
}

self_test() {
  exec 3>&1 >>"$T/log"   # the failures that are wanted would only frighten
  bin=$T/bin corpus=$T/corpus
  mkdir "$bin" "$corpus"
  self_passed=0 self_failed=0
  limits_memory=0 have_user=0 patience=1
  texture=$corpus/some.png
  echo old >"$T/old.png"
  echo new >"$texture"
  takes texture

  # A program that does as it should.
  # shellcheck disable=SC2016 # for the program
  usage='echo "usage: ${0##*/} [options]" >&2; exit 2'
  fake "echo \"error: --samples takes a number from 1 to 9, not 'x'\" >&2; $usage"
  refuses_number 1 --samples x
  caught 0 'a clean refusal'
  fake "echo \"error: cannot load texture 'x': it is bad\" >&2; exit 1"
  refuses_file "$texture" 'bad'
  caught 0 'a clean refusal of a texture'
  chapters_that_write=1
  fake "echo \"error: cannot write 'x': the disk is full\" >&2; exit 1"
  cannot_write "$T/x.png" 'disk full'
  caught 0 'a clean failure to write'

  # Programs that do not.
  fake 'exit 0'
  refuses_number 1 --samples x
  refuses_words 1 --nonsense --nonsense
  refuses_file "$texture" 'bad'
  cannot_write "$T/x.png" 'disk full'
  loads_file "$texture" 'good'
  caught 5 'always content'
  fake 'exit 2'
  refuses_words 1 --nonsense --nonsense
  fake "echo 'error: something is wrong' >&2; $usage"
  refuses_words 1 --nonsense --nonsense
  fake "echo \"error: --samples takes something else\" >&2; $usage"
  refuses_number 1 --samples x
  fake 'echo "error: --nonsense" >&2; exit 2'
  refuses_words 1 --nonsense --nonsense
  fake "echo chatter; echo 'error: --nonsense' >&2; $usage"
  refuses_words 1 --nonsense --nonsense
  fake "mkdir -p out; echo half >out/x.png; echo 'error: --nonsense' >&2; $usage"
  refuses_words 1 --nonsense --nonsense
  caught 6 'refusals with something missing'
  fake "echo 'ERROR: AddressSanitizer: heap-buffer-overflow' >&2; exit 99"
  refuses_file "$texture" 'bad'
  fake "echo \"error: cannot load texture 'x': bad\" >&2; echo 'and more' >&2; exit 1"
  refuses_file "$texture" 'bad'
  fake "echo half >never.png; echo \"error: cannot load texture 'x': bad\" >&2; exit 1"
  refuses_file "$texture" 'bad'
  fake 'sleep 20'
  refuses_file "$texture" 'bad'
  # shellcheck disable=SC2016 # for the program
  fake 'kill -s SEGV $$'
  refuses_file "$texture" 'bad' 2>/dev/null
  caught 5 'textures taken badly'

  # Half a file, a file left behind, a file that is not whole.
  mkdir "$T/half"
  echo ha >"$T/half/out.png"
  keeps_old "$T/half"
  conclude 'half a file'
  cp "$T/old.png" "$T/half/out.png"
  : >"$T/half/.draft-1"
  keeps_old "$T/half"
  conclude 'a file left behind'
  rm "$T/half/.draft-1"
  keeps_old "$T/half"
  conclude 'all is well'
  caught 2 'old pictures'
  fake 'exit 1'
  expect_whole "$T/half/out.png"
  conclude 'not whole'
  caught 1 'not whole'

  # A program that writes slowly where the picture will be, and is stopped half-way.
  mkdir "$T/signals"
  echo whole >"$T/new.png"
  choose 1
  # shellcheck disable=SC2016 # for the program
  fake 'for word; do :; done; printf wh >"$word"; sleep 1; echo ole >>"$word"'
  signals_at TERM 'fake' '0.3' --samples 1
  caught 1 'killed in the middle of a file'
  # shellcheck disable=SC2016 # for the program
  fake 'for word; do :; done; : >"${word%/*}/.draft"; sleep 1; mv "${word%/*}/.draft" "$word"'
  signals_at TERM 'fake' '0.3' --samples 1
  caught 1 'killed with a file left behind'
  rm -f "$T/signals/.draft"
  fake 'exec sleep 1'
  signals_at TERM 'fake' '0.3' --samples 1
  caught 0 'killed before anything was written'

  # Too few checks, or one failed.
  passed=99 failed=0
  if summary >/dev/null; then failed=1; fi
  caught 0 'too few checks'
  passed=500 failed=1
  if summary >/dev/null; then failed=0; fi
  caught 1 'one failed'
  passed=100 failed=0
  summary >/dev/null || failed=1
  caught 0 'all passed'

  printf 'self-test: %s passed, %s failed\n' "$self_passed" "$self_failed" >&3
  [ "$self_failed" = 0 ]
}

# --- Main ---------------------------------------------------------------------------------------------------------------------------

if [ $# = 1 ] && [ "$1" = --self-test ]; then
  make_folder
  self_test
  exit
fi
if [ $# != 2 ] || [ ! -d "$1" ] || [ ! -d "$2" ]; then
  printf 'usage: faults.sh BIN_DIR CORPUS_DIR | faults.sh --self-test\n' >&2
  exit 2
fi
bin=$(cd "$1" && pwd) || exit 2
corpus=$(cd "$2" && pwd) || exit 2
make_folder
get_ready
for part in ${FAULTS_ONLY:-numbers words textures corpus skies meshes output signals crowd streams memory surroundings}; do
  check_"$part"
  expect_nothing_written
  conclude "$part: nothing in the current folder"
done
summary
