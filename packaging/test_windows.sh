#!/usr/bin/env bash
# test_windows.sh DIST: unpacks the archive for Windows into a folder with characters of several scripts and runs both
# programs under wine (WINEPREFIX is set, see ./dev windows): the hashes of all shipped runs, files with such names, the
# window, driven by the window tests of this system.
set -euo pipefail
# One display for all programs: the desktop of wine belongs to the display of its first program.
if [[ ${1:-} != --here ]]; then
    wineserver -k 2>/dev/null || true
    exec xvfb-run -a -s '-screen 0 1920x1200x24' "$0" --here "$1"
fi
shift
archive=$(ls "$(cd "$1" && pwd)"/*-windows.zip)
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")/../build/release" && pwd)/braitenlab_window_tests
hashes=$(cd "$(dirname "${BASH_SOURCE[0]}")/../tests/golden" && pwd)/hashes.json
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
fail() { printf 'test_windows: %s\n' "$*" >&2; exit 1; }

folder="$place/Zoë 学生"
mkdir "$folder"
cd "$folder"
cmake -E tar xf "$archive"
cd braitenlab-*
unset BRAITENLAB_DATA
export LC_ALL=C.UTF-8  # wine converts names of files by the locale
wine braitenctl.exe hashes --compare "$hashes" || fail "the hashes differ"
wine braitenctl.exe run 2a-coward --seconds 1 --csv "Tabelle ö 表.csv" >/dev/null || fail "braitenctl runs no scene"
[[ -s "Tabelle ö 表.csv" ]] || fail "braitenctl writes no table of this name"
cp share/braitenlab/exercises/scenes/2a-coward.toml "Szene ü 景.toml"
wine braitenctl.exe run "Szene ü 景.toml" --seconds 1 --hash >/dev/null || fail "braitenctl opens no scene of this name"
wine braitenlab.exe "Szene ü 景.toml" --size 1280x800 --play --after 2 \
    --screenshot "Bild ö 図.png" || fail "the window does not open"
[[ $(head -c 4 "Bild ö 図.png" | tail -c 3) == PNG ]] || fail "braitenlab writes no picture"
[[ -z ${KEEP_PICTURE:-} ]] || cp "Bild ö 図.png" "$KEEP_PICTURE"
# By mouse and keyboard: open, play, drag a slider and a wire, save, open again, offer the work after a crash.
BRAITENLAB_WINDOWS_PROGRAM=$PWD/braitenlab.exe BRAITENLAB_TEST_DISPLAY=$DISPLAY "$tests" --gtest_brief=1 --gtest_filter="$(
    printf '%s:' LabWindow.OpensTheFirst\* LabWindow.TogglesPlay\* LabWindow.ChangesAWeight\* \
        LabWindow.OpensTheLastFile\* LabWindow.OpensWithABrokenScene\* BrainWindow.Predicts\* WiringWindow.Dragging\* \
        UnsavedWindow.\* CrashWindow.\*)" || fail "the window does not do what its user asks"
printf 'The archive for Windows runs in any folder.\n'
