#!/bin/bash
# ngspice: the cube of a negative number has another sign in a circuit than in a command.
#
# Guess before the first run: (-2)^3 is -8 everywhere.
# Seen: +8 in a source and in a parameter, -8 in the control language of the same file. In circuits ^ takes the absolute
# value of its base, so an odd power of a signal loses its sign without a message.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# Packages of Debian 12 as root/, without installing them; of the libraries only those that this system lacks.
fetch() {
    local lib
    for lib in libbsd0 libedit2 libexpat1 libfontconfig1 libfreetype6 libgomp1 libice6 libpng16-16 libsm6 libuuid1 libx11-6 libxau6 libxaw7 libxcb1 libxdmcp6 libxext6 libxft2 libxmu6 libxpm4 libxrender1 libxt6; do
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

fetch ngspice=39.3+ds-1
ngspice() { SPICE_LIB_DIR=$dir/root/usr/share/ngspice "$dir/root/usr/bin/ngspice" "$@"; }
echo "ngspice 39.3+ds-1"
cat > deck.cir <<'DECK'
cube
.param cube = {(-2)^3}
B1 source 0 V = (-2)^3
B2 product 0 V = (-2)*(-2)*(-2)
V3 parameter 0 {cube}
.control
op
let command = (-2)^3
print v(source) v(parameter) v(product) command
quit
.endc
.end
DECK
ngspice -b deck.cir > out 2> err
value() { awk -v name="$1" '$1 == name {print $3 + 0}' out; }
expect "(-2)^3 in a source" "$(value 'v(source)')" 8
expect "(-2)^3 in a parameter" "$(value 'v(parameter)')" 8
expect "(-2)*(-2)*(-2) in a source" "$(value 'v(product)')" -8
expect "(-2)^3 in the control language" "$(value command)" -8
