#!/bin/sh
# Builds and draws again whenever a chapter's files, or an exercise's file, are saved: ./course watch NN [options], ./course watch NN.K.
# The page out/watch/index.html shows the picture before and after, and what the check or the compiler says. Ctrl-C ends it.
set -eu
what=$1
shift
folder=out/watch

wrong() {
  printf 'error: %s\n' "$*" >&2
  exit 2
}

case "$what" in
  [0-9] | [0-9].[0-9]) what=0$what ;;
esac
case "$what" in
  [0-9][0-9].[0-9])
    [ $# -eq 0 ] || wrong "watch takes no options for an exercise"
    program=exercise_$(printf '%s' "$what" | tr . _)
    picture=out/exercises/$what/yours.png
    watched="chapters/${what%.*}_*/exercises/${what#*.}_*.hpp"
    ;;
  00) wrong "watch takes the chapters from 01 on: 00 is one file, ./course run 00 draws it" ;;
  [0-9][0-9])
    for word in "$@"; do
      case "$word" in
        --number | --number=* | --budget | --budget=* | --instructions | --instructions=* | --trade | \
          --extremes)
          wrong "watch builds for learning, with double alone: leave out ${word%%=*}," \
            "or ./course run $what takes it"
          ;;
      esac
    done
    for chapter in chapters/"$what"_*; do program=${chapter#chapters/}; done
    picture=$PWD/$folder/drawn.png
    set -- --quiet --out "$picture" "$@"
    watched="chapters/${what}_*/*.hpp chapters/${what}_*/*.cpp"
    ;;
  *) wrong "watch takes a chapter's number or an exercise, such as 02 or 02.1" ;;
esac
# shellcheck disable=SC2086 # patterns
ls $watched >/dev/null 2>&1 || wrong "there is no '$what'; ./course list and ./course check name what there is"

mkdir -p "$folder"
rm -f "$folder"/before.png "$folder"/after.png "$folder"/drawn.png
cp common/tools/check/watch.html "$folder/index.html"
printf 'show(0, "", "building");\n' >"$folder/state.js"

# The sum of all watched files: saving the same text again is no change.
# shellcheck disable=SC2086 # patterns
sum() { cat $watched 2>/dev/null | cksum; }

# as_string: a text as JavaScript writes it.
as_string() {
  printf '"'
  sed -e 's/\\/\\\\/g' -e 's/"/\\"/g' -e 's/</\\x3c/g' -e 's/$/\\n/' | tr -d '\n\r'
  printf '"'
}

# draw OPTION...: builds, and draws. Of an exercise check limits the time, and remembers whether
# it is right.
draw() {
  case "$what" in
    *.*) sh common/tools/check/check.sh "$what" ;;
    *) # files are named from where the user stands
      ./course --build learn "$program" 1 && tree=$PWD &&
        (cd "${TEXMAP_HERE:-.}" && exec "$tree/build/learn/bin/$program" "$@")
      ;;
  esac
}

stop() {
  printf '\nThe last pictures are in %s/\n' "$folder"
  exit 0
}
trap stop INT TERM HUP

echo "Open $folder/index.html. It follows what you save; Ctrl-C ends this."
./course --build learn "$program" 1 || echo "Waiting until it compiles."
count=0
seen=
while :; do
  now=$(sum)
  if [ "$now" = "$seen" ]; then
    sleep 0.2
    continue
  fi
  seen=$now
  count=$((count + 1))
  status=0
  said=$(draw "$@" 2>&1) || status=$?
  said=$(printf "%s\n" "$said" | grep -vE "^\[ *[0-9]+%\] |^\+ ") || :
  # "before" is the last picture that was different, also after an error.
  if [ -f "$folder/after.png" ] && cmp -s "$picture" "$folder/after.png"; then
    [ -n "$said" ] || said="drawn; the picture is the same"
  elif [ -f "$picture" ]; then
    [ ! -f "$folder/after.png" ] || mv "$folder/after.png" "$folder/before.png"
    cp "$picture" "$folder/after.png" # the exercise's own page shows it, too
  fi
  [ -n "$said" ] || said="drawn"
  case $status in 0) word=good ;; *) word=bad ;; esac
  { printf 'show(%s, "%s", ' "$count" "$word" && printf '%s\n' "$said" | as_string && echo ');'; } >"$folder/state.new"
  mv "$folder/state.new" "$folder/state.js"
  printf '%s  %s\n' "$(date +%H:%M:%S)" "$said"
done
