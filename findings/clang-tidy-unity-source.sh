#!/bin/bash
# clang-tidy: the static analyzer does not read the functions of a source that a unity source includes.
#
# Guess before the first run: a finding of clang-analyzer in a .cpp file is reported as well when a unity source, which includes
# that file, is checked instead; --header-filter decides alone what is shown. The checks that are no part of the analyzer do so.
# Seen: the analyzer reads the functions of the main file only, and says nothing of the others. It makes one exception, by the
# name of the main file: one that contains "UnifiedSource" has its included sources read. CMake calls its own unity_0_cxx.cxx.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# Packages of Debian 12 as root/, without installing them; of the libraries only those that this system lacks.
fetch() {
    local lib
    for lib in libedit2 libxml2 libbsd0 libicu72 libmd0 libz3-4; do
        dpkg-query -W -f '${Status}' "$lib" 2>/dev/null | grep -q 'ok installed' || set -- "$@" "$lib"
    done
    apt-get download -qq "$@" 2>/dev/null
    for lib in *.deb; do dpkg -x "$lib" root; done
    LD_LIBRARY_PATH=$(find "$dir/root" -name '*.so*' -printf '%h\n' | sort -u | paste -sd:)
    export LD_LIBRARY_PATH
}

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

fetch clang-tidy-14=1:14.0.6-12 libclang-cpp14=1:14.0.6-12 libclang1-14=1:14.0.6-12 libllvm14=1:14.0.6-12
echo "clang-tidy 14.0.6"
cat > part.cpp <<'CODE'
int value(int* pointer) {
    if (!pointer) return *pointer;
    return 0;
}
bool same(float* pointer) {
    return sizeof(pointer) / sizeof(float) == 4;
}
CODE
echo '#include "part.cpp"' | tee unity_0_cxx.cxx UnifiedSource_0.cxx >/dev/null
findings() {
    root/usr/lib/llvm-14/bin/clang-tidy --quiet --header-filter='.*' --checks="-*,$1" "$2" -- -std=c++20 2>/dev/null |
        grep -c '^.*warning:' || true
}
expect "null pointer, clang-analyzer, part.cpp itself:" "$(findings 'clang-analyzer-*' part.cpp)" 1
expect "the same in unity_0_cxx.cxx, which includes it:" "$(findings 'clang-analyzer-*' unity_0_cxx.cxx)" 0
expect "the same in UnifiedSource_0.cxx, the same text:" "$(findings 'clang-analyzer-*' UnifiedSource_0.cxx)" 1
expect "size of a pointer, bugprone, unity_0_cxx.cxx:" "$(findings 'bugprone-sizeof-expression' unity_0_cxx.cxx)" 1
