#!/usr/bin/env bash
# The README's two commands on a bare Debian of another release, as on a machine that is new: tries the last commit.
# usage: bare_root.sh SUITE [COMMAND...]     SUITE: bookworm | trixie | sid; COMMAND: others than the README's
# Needs debootstrap and root rights. The bare root is kept as an archive in ${XDG_CACHE_HOME:-~/.cache}/texmap-roots, or in build/bare if
# nothing can be written there; build/bare/SUITE has what the commands left.
# exit status: 0 all is well; 1 a command failed, or a compiler or CMake warned; 77 not possible here. The last line says which.
set -euo pipefail
suite=${1:?usage: bare_root.sh SUITE [COMMAND...]}
shift
[ $# -gt 0 ] || set -- ./course "./course test"
tree=$(cd "$(dirname "$0")/../.." && pwd)
root=$tree/build/bare/$suite
log=$tree/build/bare/$suite.log

# Mounts are made where only this process and its children see them: they end with it, however it ends.
if [ "${TEXMAP_BARE_ROOT:-}" != inside ]; then
  reason=""
  [ "$(id -u)" = 0 ] || reason="no root rights"
  command -v debootstrap >/dev/null || reason=${reason:-"no debootstrap"}
  unshare --mount --pid --fork chroot / mount -t proc proc /proc 2>/dev/null || reason=${reason:-"mount or chroot is not allowed"}
  [ -z "$reason" ] || {
    echo "$reason"
    exit 77
  }
  TEXMAP_BARE_ROOT=inside setpriv --pdeathsig KILL unshare --mount --pid --fork --kill-child bash "$0" "$suite" "$@" &
  trap 'kill -KILL $!' TERM INT HUP # which unshare does not obey
  wait $!
  exit
fi

in_root() {
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 http_proxy="${http_proxy:-}" \
    https_proxy="${https_proxy:-}" sh -c "$1" </dev/null
}

began=$SECONDS
kept=${XDG_CACHE_HOME:-${HOME:-/root}/.cache}/texmap-roots
{ mkdir -p "$kept" && [ -w "$kept" ]; } 2>/dev/null || kept=$tree/build/bare
mkdir -p "$tree/build/bare"
exec 9>"$root.lock"
flock -n 9 || {
  echo "another run is in $root"
  exit 1
}
rm -rf --one-file-system "$root"
mkdir -p "$root"
if [ ! -f "$kept/$suite.tar" ]; then
  debootstrap --variant=minbase --include=git,ca-certificates "$suite" "$root"
  tar -C "$root" -cf "$kept/$suite.tar.$$" . # half an archive never has the archive's name
  mv "$kept/$suite.tar.$$" "$kept/$suite.tar"
else
  tar -C "$root" -xf "$kept/$suite.tar"
fi
for file in /etc/apt/apt.conf.d /etc/resolv.conf /etc/hosts; do # how this machine gets its packages
  [ ! -e "$file" ] || cp -rL "$file" "$root$(dirname "$file")/"
done
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
in_root "apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get dist-upgrade -q -y --no-install-recommends"
git clone -q "$tree" "$root/src"

times="root $((SECONDS - began)) s"
failed=""
: >"$log"
for command in "$@"; do
  began=$SECONDS
  echo "== $suite: $command"
  in_root "cd /src && $command" 2>&1 | tee -a "$log" || failed=$command
  times+=", $command $((SECONDS - began)) s"
  [ -z "$failed" ] || break
done
cat "$root/src/build/learn/gallery.log" >>"$log" 2>/dev/null || true # what the compiler said to ./course
in_root "dpkg-query -W -f '\${Package} \${Version}\n' libc6 g++ cmake doctest-dev libstb-dev libxsimd-dev libdeflate-dev" 2>/dev/null || true
warnings=$(grep -E 'warning:|CMake.* Warning' "$log" | grep -vE '^(update-alternatives|dpkg[a-z-]*): ' | sort -u || true)
echo "== $suite: $times"
if [ -n "$failed" ]; then
  echo "$failed: $(grep -m 1 -E 'error:|CMake Error|^E: |FAIL|\*\*\*' "$log" || echo "see $log")"
elif [ -n "$warnings" ]; then
  printf '%s\n' "$warnings"
  echo "$(printf '%s\n' "$warnings" | wc -l) warnings: $(printf '%s\n' "$warnings" | head -n 1)"
else
  echo "no warning"
fi
[ -z "$failed$warnings" ]
