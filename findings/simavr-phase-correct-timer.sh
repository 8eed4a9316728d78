#!/bin/bash
# simavr: timer 1 in a phase-correct mode counts past its top, to 65535.
#
# Guess before the first run: in each mode the timer counts as on the chip: up to its top in the fast modes, up to its top and
# down again in the phase-correct ones, with an overflow in each period.
# Seen: the fast modes do. In mode 1, that of analogWrite, and in mode 10, usual for drivers of motors, the top is ignored: the
# timer counts to 65535 and goes on at 0 without an overflow. In mode 8 it goes on at 0 after the top, so it overflows twice as
# often. No message says so. avr8js 0.21.1 counts up and down in all three.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# Packages of Debian 12 as root/, without installing them; of the libraries only those that this system lacks.
fetch() {
    local lib
    for lib in libelf1; do
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

fetch simavr=1.6+dfsg-3 libsimavr2=1.6+dfsg-3 libsimavrparts1=1.6+dfsg-3 gcc-avr=1:5.4.0+Atmel3.6.2-3 \
    binutils-avr=2.26.20160125+Atmel3.6.2-4 avr-libc=1:2.0.0+Atmel3.6.2-3
echo "simavr 1.6+dfsg-3"
cat > timer.c <<'CODE'
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
static void put(char c) {
    while (!(UCSR0A & 1 << UDRE0)) {}
    UDR0 = c;
}
static void number(unsigned n) {
    for (unsigned digit = 10000; digit; digit /= 10) put('0' + n / digit % 10);
    put(' ');
}
/* For each mode of timer 1: the highest count that is read, and how often it overflows meanwhile. ICR1 is 999. */
int main(void) {
    static const char modes[] = {14, 5, 1, 10, 8};
    UCSR0B = 1 << TXEN0;
    for (char k = 0; k < 5; k++) {
        TCCR1B = 0;
        TCCR1A = 0;
        TCNT1 = 0;
        ICR1 = 999;
        TIFR1 = 0xff;
        TCCR1A = modes[k] & 3;
        TCCR1B = modes[k] >> 2 << 3 | 1 << CS10;
        unsigned highest = 0, overflows = 0;
        for (unsigned i = 0; i < 5000; i++) {
            const unsigned count = TCNT1;
            if (count > highest) highest = count;
            if (TIFR1 & 1 << TOV1) {
                overflows++;
                TIFR1 = 1 << TOV1;
            }
        }
        put('m');
        number(modes[k]);
        number(highest);
        number(overflows);
        put('\n');
    }
    cli();
    sleep_enable();
    sleep_cpu();
    return 0;
}
CODE
PATH=$dir/root/usr/bin:$PATH
avr-gcc -mmcu=atmega328p -Os -isystem root/usr/lib/avr/include -B root/usr/lib/avr/lib/avr5 -L root/usr/lib/avr/lib/avr5 \
    timer.c -o timer.elf
timeout 20 simavr -m atmega328p -f 16000000 timer.elf > seen.txt 2>&1
# top MODE TOP: whether the highest count is within the top; overflows MODE: for 100 of mode 14, which has one in 1000 cycles.
top() { grep -o "m000$1 [0-9]*" seen.txt | awk -v top="$2" '{print ($2 <= top ? "no" : $2 < 60000 ? "yes" : "to the end")}'; }
overflows() {
    awk -v mode="m000$1" '{sub(/.*m/, "m")} $1 == "m00014" {of_14 = $3} $1 == mode {n = $3} 
        END {print 10 * int(10 * n / of_14 + 0.5)}' seen.txt
}
expect "mode 14, fast, top 999: counts past its top" "$(top 14 999)" no
expect "mode 5, fast, top 255: counts past its top" "$(top 05 255)" no
expect "mode 1, phase-correct, top 255: counts past its top" "$(top 01 255)" "to the end"
expect "mode 10, phase-correct, top 999: counts past its top" "$(top 10 999)" "to the end"
expect "mode 8, phase-correct, top 999: counts past its top" "$(top 08 999)" no
expect "overflows of mode 10, 50 on the chip" "$(overflows 10)" 0
expect "overflows of mode 8, 50 on the chip" "$(overflows 08)" 100
