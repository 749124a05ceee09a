#!/usr/bin/env bash
# The README's two commands on a bare Debian of another release, as on a new machine. Tries the last
# commit; needs debootstrap and root rights.
# usage: bare_root.sh SUITE [COMMAND...]     SUITE: bookworm | trixie | sid
# The bare root is kept packed in ${XDG_CACHE_HOME:-~/.cache}/texmap-roots, or in build/bare if that
# cannot be written; build/bare/SUITE has what the commands left.
# exit status: 0 no failure, no warning; 1 one of them; 77 not possible here; the last line says it
set -euo pipefail
suite=${1:?usage: bare_root.sh SUITE [COMMAND...]}
shift
[ $# -gt 0 ] || set -- ./course "./course test"
tree=$(cd "$(dirname "$0")/../.." && pwd)
root=$tree/build/bare/$suite
log=$root.log
stop() { # STATUS WORDS
  echo "$2"
  exit "$1"
}

# Mounts are seen by this process and its children alone: however it ends, they end with it.
alone=(unshare --mount --pid --fork --kill-child)
if [ "${TEXMAP_BARE_ROOT:-}" != inside ]; then
  [ "$(id -u)" = 0 ] || stop 77 "no root rights"
  command -v debootstrap >/dev/null || stop 77 "no debootstrap"
  "${alone[@]}" chroot / mount -t proc proc /proc 2>/dev/null || stop 77 "no right to mount or chroot"
  TEXMAP_BARE_ROOT=inside setpriv --pdeathsig KILL "${alone[@]}" bash "$0" "$suite" "$@" &
  trap 'kill -KILL $!' TERM INT HUP # which unshare does not obey
  wait $!
  exit
fi

in_root() {
  chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
    http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" sh -c "$1" </dev/null
}

began=$SECONDS
kept=${XDG_CACHE_HOME:-${HOME:-/root}/.cache}/texmap-roots
mkdir -p "$tree/build/bare"
{ mkdir -p "$kept" && [ -w "$kept" ]; } 2>/dev/null || kept=$tree/build/bare
exec 9>"$root.lock"
flock -n 9 || stop 1 "another run is in $root"
rm -rf --one-file-system "$root"
mkdir "$root"
find "$kept" -maxdepth 1 -name "$suite.tar" -mtime +30 -delete # unstable moves
if [ ! -f "$kept/$suite.tar" ]; then
  debootstrap --variant=minbase --include=git,ca-certificates "$suite" "$root"
  half=$kept/$suite.$RANDOM
  tar -C "$root" -cf "$half" .
  mv "$half" "$kept/$suite.tar" # half an archive never has this name
else
  tar -C "$root" -xf "$kept/$suite.tar"
fi
for file in /etc/apt/apt.conf.d /etc/resolv.conf /etc/hosts; do # how this machine gets its packages
  [ ! -e "$file" ] || cp -rL "$file" "$root$(dirname "$file")/"
done
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
in_root "apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get dist-upgrade -q -y"
git clone -q "$tree" "$root/src"

times="root $((SECONDS - began)) s"
said="no warning"
: >"$log"
for command in "$@"; do
  began=$SECONDS
  echo "== $suite: $command"
  in_root "cd /src && $command" 2>&1 | tee -a "$log" || said=$command
  times+=", $command $((SECONDS - began)) s"
  [ "$said" != "$command" ] || break
done
cat "$root/src/build/learn/gallery.log" >>"$log" || true # what the compiler said to ./course
in_root "dpkg-query -W libc6 g++ cmake doctest-dev libstb-dev libxsimd-dev libdeflate-dev" || true
warnings=$(grep -E 'warning:|CMake.* Warning' "$log" | grep -vE '^(dpkg|update-)[a-z-]*: ' | sort -u) || true
if [ "$said" != "no warning" ]; then
  said+=": $(grep -m 1 -E 'error:|CMake Error|^E: |FAIL|\*\*\*' "$log" || echo "see $log")"
elif [ -n "$warnings" ]; then
  said="a warning: ${warnings%%$'\n'*}"
fi
printf '%s\n' "== $suite: $times" ${warnings:+"$warnings"} "$said"
[ "$said" = "no warning" ]
