#!/bin/bash
# ngspice: an operating point that contradicts the source that it prints the voltage of.
#
# Guess before the first run: an amplifier of 0 V to 7.5 V (V = 3.75 + 3.75 tanh(10000 d)) with a gain of 4 set by resistors and 2 V at its
# input ends at 7.5 V, its upper limit, or the run stops with an error of convergence.
# Seen: success, and 7.999 V at the output of a source that cannot exceed 7.5 V. The tolerance of a node is a thousandth
# of its voltage; the input is that near to its last value, so the output that belongs to it is not computed again.
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
amplifier with a gain of 4
V1 plus 0 2
Bout out 0 V = 3.75 + 3.75 * tanh(10000 * (v(plus) - v(minus)))
R1 out minus 300k
R2 minus 0 100k
.control
op
let high = v(out) gt 7.9
let law = 3.75 + 3.75 * tanh(10000 * (v(plus) - v(minus)))
let low = law lt 7.5
print v(out) law high low
quit
.endc
.end
DECK
ngspice -b deck.cir > out 2> err
grep '^v(out)\|^law' out
expect "the output is above 7.9 V (1: yes)" "$(awk '$1 == "high" {print $3 + 0}' out)" 1
expect "the source's own formula, of the printed voltages, is below 7.5 V" "$(awk '$1 == "low" {print $3 + 0}' out)" 1
expect "messages about convergence" "$(grep -ci 'converg\|abort\|error' err || true)" 0
