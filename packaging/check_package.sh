#!/usr/bin/env bash
# Installs a package on a clean Debian 12 in a directory of its own, runs the shipped example there with both programs,
# removes the package and looks whether anything is left. As root; needs debootstrap and a mirror.
#   packaging/check_package.sh [PACKAGE.deb]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
package=$(realpath "${1:-$(ls build/package/analogon_*.deb)}")
mirror=${MIRROR:-http://deb.debian.org/debian}
root=$(mktemp -d "${TMPDIR:-/var/tmp}/analogon-clean-XXXXXX")
trap 'umount "$root/proc" 2>/dev/null || true; rm -rf --one-file-system "$root"' EXIT
say() { printf '\n==> %s\n' "$*"; }
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"; }
# Files, but what apt and dpkg keep for themselves and caches that belong to other packages.
listed() {
    (cd "$root" && find . -xdev \( -path ./proc -o -path ./var/cache -o -path ./var/lib -o -path ./var/log -o -path ./tmp \
        -o -path ./root \) -prune -o -type f -print | sort)
}

say "A clean Debian 12 in $root"
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || { cat "$root.log"; exit 1; }
rm -f "$root.log"
for setting in /etc/apt/apt.conf.d/*proxy* /etc/apt/apt.conf.d/99*; do
    [ ! -f "$setting" ] || cp "$setting" "$root/etc/apt/apt.conf.d/"
done
mount -t proc proc "$root/proc"
cp "$package" "$root/root/"
inside apt-get update -qq

# What the package depends on comes first, so that what it brings and leaves is its own.
depends=$(dpkg-deb -f "$package" Depends | tr ',' '\n' | sed 's/(.*//; s/|.*//; s/ //g' | grep .)
say "Installing what it depends on, then the package"
begin=$(date +%s)
inside env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $depends >/dev/null
listed >"$root/root/before"
inside env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    "/root/$(basename "$package")" >/dev/null
say "Installed in $(($(date +%s) - begin)) s; running the example"
begin=$(date +%s)
inside analogon-cli discover /usr/share/analogon/examples/water-pump --out /root/out | tee "$root/root/said"
grep -q 'friction.coulomb' "$root/root/said"
inside env QT_QPA_PLATFORM=offscreen analogon --version
say "The example took $(($(date +%s) - begin)) s; removing the package"
inside env DEBIAN_FRONTEND=noninteractive apt-get purge -y -qq analogon >/dev/null
listed >"$root/root/after"
if ! diff "$root/root/before" "$root/root/after"; then
    say "The removal left or took the files above"
    exit 1
fi
say "Nothing is left"
