#!/bin/bash
# ngspice: two files that each define a subcircuit of one name.
#
# Guess before the first run: an error, because the name is taken; or the later definition counts, as for a parameter.
# Seen: the first one counts, also where the names differ by case, and the run succeeds. Of two parameters of one name
# the later one counts.
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
printf '.subckt part a b\nR1 a b 1k\n.ends\n.param ohms = 1k\n' > first.cir
printf '.subckt Part a b\nR1 a b 3k\n.ends\n.param Ohms = 3k\n' > second.cir
cat > deck.cir <<'DECK'
two files
.include first.cir
.include second.cir
I1 0 one 1m
X1 one 0 Part
I2 0 two 1m
R2 two 0 {ohms}
.control
op
print v(one) v(two)
quit
.endc
.end
DECK
code=0; ngspice -b deck.cir > out 2> err || code=$?
expect "status" "$code" 0
expect "volts at 1 mA: the first definition has 1 V, the second 3 V" "$(awk '$1 == "v(one)" {print $3 + 0}' out)" 1
expect "the same with a parameter" "$(awk '$1 == "v(two)" {print $3 + 0}' out)" 3
