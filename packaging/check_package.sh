#!/usr/bin/env bash
# Installs a package on a clean Debian 12 in a directory of its own, looks for all that belongs to its programs, runs the
# shipped example there with both, removes the package and looks whether anything is left. As root; needs debootstrap and
# a mirror.
#   packaging/check_package.sh [PACKAGE.deb]
# BASE: a directory that debootstrap has made, of which a copy is used. MIRROR: where packages come from.
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
if [ -n "${BASE:-}" ]; then
    cp -a "$BASE/." "$root/"
else
    debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || { cat "$root.log"; exit 1; }
fi
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
say "Installed in $(($(date +%s) - begin)) s; what belongs to the programs"
for file in bin/analogon bin/analogon-cli share/man/man1/analogon.1.gz share/man/man1/analogon-cli.1.gz \
    share/bash-completion/completions/analogon-cli share/zsh/vendor-completions/_analogon-cli \
    share/fish/vendor_completions.d/analogon-cli.fish share/applications/org.analogon.Analogon.desktop \
    share/mime/packages/org.analogon.Analogon.xml share/metainfo/org.analogon.Analogon.metainfo.xml \
    share/icons/hicolor/scalable/apps/org.analogon.Analogon.svg share/doc/analogon/copyright \
    share/doc/analogon/changelog.gz share/doc/analogon/analogon.spdx.json; do
    [ -s "$root/usr/$file" ] || { echo "error: the package brings no /usr/$file" >&2; exit 1; }
    case "$file" in *.gz) gzip -t "$root/usr/$file" ;; esac
done
python3 - "$root/usr/share/doc/analogon/analogon.spdx.json" <<'PYTHON'
import json, sys
parts = [p["name"] for p in json.load(open(sys.argv[1]))["packages"]]
assert "libc6" in parts and any("qt6" in p for p in parts), f"the list of what is linked lacks the libraries: {parts}"
print(f"{len(parts)} packages in the list of what is linked")
PYTHON
# shellcheck disable=SC2016  # for the shell inside
inside bash -c 'source /usr/share/bash-completion/completions/analogon-cli
    COMP_WORDS=(analogon-cli "") COMP_CWORD=1
    _analogon_cli
    printf "%s\n" "${COMPREPLY[@]}" | grep -qx discover'

say "Running the example"
example=/usr/share/analogon/examples/water-pump
begin=$(date +%s)
inside analogon-cli fit $example --out /root/fit | tee "$root/root/said"
grep -q 'motor.R' "$root/root/said"
inside analogon-cli discover $example --out /root/out | tee "$root/root/said"
grep -q 'friction.coulomb' "$root/root/said"
inside env QT_QPA_PLATFORM=offscreen analogon --version
status=0
inside env QT_QPA_PLATFORM=offscreen timeout 20 analogon $example || status=$?
[ $status -eq 124 ] || { echo "error: the window ended with $status" >&2; exit 1; }
say "The example took $(($(date +%s) - begin)) s; removing the package"
inside env DEBIAN_FRONTEND=noninteractive apt-get purge -y -qq analogon >/dev/null
listed >"$root/root/after"
if ! diff "$root/root/before" "$root/root/after"; then
    say "The removal left or took the files above"
    exit 1
fi
say "Nothing is left"
