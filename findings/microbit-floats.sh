#!/bin/bash
# MicroPython on a micro:bit: the last digit of a product is cut, not rounded.
#
# Guess before the first run: floats have 32 bits there, so 0.7 * 10 is 7.0 as on every computer, and whole numbers are exact up to 16,777,216.
# Seen: a float has 30 bits (two mark the type of the object) and every result is cut towards 0: int(0.7 * 10) is 6,
# int(1.1 * 10) is 10, the mean of ten equal readings is below them, and 4,194,304.0 + 1 is 4,194,304.0.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# Packages of Debian 12 as root/, without installing them; of the libraries only those that this system lacks.
fetch() {
    local lib
    for lib in libaio1 libbpf1 libcapstone4 libdaxctl1 libelf1 libfdt1 libfuse3-3 libglib2.0-0 libgnutls30 libhogweed6 libibverbs1 libidn2-0 libjpeg62-turbo libkmod2 libndctl6 libnettle8 libnl-3-200 libnl-route-3-200 libnuma1 libp11-kit0 libpixman-1-0 libpmem1 libpng16-16 librdmacm1 libsasl2-2 libslirp0 libtasn1-6 libunistring2 liburing2 libvdeplug2; do
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

fetch firmware-microbit-micropython=1.0.1-4 qemu-system-arm=1:7.2+dfsg-7+deb12u18+b3 \
    qemu-system-common=1:7.2+dfsg-7+deb12u18+b3 qemu-system-data
echo "firmware-microbit-micropython 1.0.1-4 on qemu 7.2"
cat > ask.py <<'CODE'
import subprocess, sys, time
command = [sys.argv[1], "-M", "microbit", "-display", "none", "-monitor", "none", "-serial", "stdio",
           "-device", "loader,file=" + sys.argv[2]]
board = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
def read_until(mark):
    seen = b""
    while not seen.endswith(mark):
        byte = board.stdout.read(1)
        if not byte:
            sys.exit("the emulator ended")
        seen += byte
    return seen.decode()
read_until(b">>> ")
for expression in sys.argv[3:]:
    for c in ("print(" + expression + ")").encode():  # one byte, then its echo: the receive buffer is short
        board.stdin.write(bytes([c])), board.stdin.flush()
        read_until(bytes([c]))
    board.stdin.write(b"\r"), board.stdin.flush()
    print(read_until(b">>> ").splitlines()[1])
board.kill()
CODE
mapfile -t seen < <(timeout 50 python3 ask.py root/usr/bin/qemu-system-arm \
    root/usr/share/firmware-microbit-micropython/firmware.hex \
    "int(0.7 * 10)" "int(1.1 * 10)" "sum([0.1] * 10) / 10 < 0.1" "4194304.0 + 1 == 4194304.0")
expect "int(0.7 * 10)" "${seen[0]}" 6
expect "int(1.1 * 10)" "${seen[1]}" 10
expect "sum([0.1] * 10) / 10 < 0.1" "${seen[2]}" True
expect "4194304.0 + 1 == 4194304.0" "${seen[3]}" True
