#!/bin/bash
# ngspice: the exit status of a batch run says the opposite of what happened.
#
# Guess before the first run: ngspice -b exits with 0 after a run that succeeds and with another status after one that is aborted.
# Seen: 1 after an operating point that succeeds, because no .print line stands in the deck; 0 after a transient that is
# aborted, because the control block ends with quit. A script has to look for "aborted" and count points.
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
status() { local code=0; ngspice -b "$1" > out 2> err || code=$?; echo "$code"; }
cat > good.cir <<'DECK'
divider
V1 in 0 2
R1 in out 1k
R2 out 0 1k
.control
op
print v(out)
.endc
.end
DECK
cat > stopped.cir <<'DECK'
amplifier without delay that leaves its limit in a microsecond
V1 plus 0 PULSE(0 5 1m 1u 1u 2m 9m)
Bout out 0 V = 3.75 + 3.75 * tanh(10000 * (v(plus) - v(minus)))
R1 out minus 100k
R2 minus 0 100k
.control
tran 10u 6m
quit
.endc
.end
DECK
expect "status of a run that succeeds" "$(status good.cir)" 1
expect "  its result" "$(awk '$1 == "v(out)" {print $3 + 0}' out)" 1
expect "status of a run that is aborted" "$(status stopped.cir)" 0
expect "  its message" "$(cat out err | grep -o 'simulation(s) aborted')" "simulation(s) aborted"
