#!/usr/bin/env bash
# test_packages.sh DIST: installs the Debian package of this folder into a bare root, unpacks the archive in a folder with
# a long name, runs both programs of each, and removes the package. Fails if a program finds no data of its own, or if
# the package leaves a file.
set -euo pipefail
dist=$(cd "$1" && pwd)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
fail() { printf 'test_packages: %s\n' "$*" >&2; exit 1; }

# run_both PREFIX: both programs of this installation, with a home folder of their own.
run_both() {
    local prefix=$1 picture=$place/picture.png
    export HOME=$place/home
    mkdir -p "$HOME"
    (
        cd "$HOME"
        "$prefix/bin/braitenctl" run 2a-coward --seconds 1 --hash >/dev/null || fail "$prefix: braitenctl finds no scene"
        mv "$prefix/share/braitenlab/exercises" "$prefix/share/braitenlab/hidden"
        mkdir -p "$prefix/share/braitenlab/exercises/scenes"
        "$prefix/bin/braitenctl" run 2a-coward --seconds 1 >/dev/null 2>&1 &&
            fail "$prefix: braitenctl reads the scenes of another folder"
        rm -r "$prefix/share/braitenlab/exercises"
        mv "$prefix/share/braitenlab/hidden" "$prefix/share/braitenlab/exercises"
        xvfb-run -a -s '-screen 0 1280x1024x24' "$prefix/bin/braitenlab" 2a-coward --play --after 1 --screenshot "$picture"
    ) || exit 1
    [[ $(head -c 4 "$picture" | tail -c 3) == PNG ]] || fail "$prefix: braitenlab writes no picture"
    rm "$picture"
}

root=$place/root
mkdir -p "$root/var/lib/dpkg/info" "$root/var/lib/dpkg/updates"
touch "$root/var/lib/dpkg/status"
as_root() { dpkg --root="$root" --force-depends --force-not-root --log="$place/dpkg.log" "$@" >/dev/null 2>&1; }
as_root --install "$dist"/*.deb || fail "dpkg cannot install the package"
run_both "$root/usr"
as_root --purge braitenlab || fail "dpkg cannot remove the package"
left=$(find "$root" -path "$root/var" -prune -o -type f -print)
[[ -z $left ]] || fail "the removed package leaves $left"
printf 'The Debian package runs, and leaves no file.\n'

folder="$place/Zoë 学生"
mkdir "$folder"
tar -xzf "$dist"/*-linux.tar.gz -C "$folder"
run_both "$folder/$(ls "$folder")"
printf 'The archive runs in any folder.\n'
