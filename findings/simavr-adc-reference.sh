#!/bin/bash
# simavr: the converter has 3.3 V as its reference on a board of 5 V.
#
# Guess before the first run: the program simavr runs an ATmega328P at 16 MHz as an Arduino Uno does, at 5 V; or it asks for the supply.
# Seen: 1.1 V read against the supply give 341 of 1024, which is 3.3 V; 5 V would give 225. Only the code of the firmware
# (a section .mmcu) or a program of one's own can tell the voltage; no option does, and no message says 3.3 V.
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
cat > bandgap.c <<'CODE'
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
static void put(char c) {
    while (!(UCSR0A & 1 << UDRE0)) {}
    UDR0 = c;
}
int main(void) {
    UCSR0B = 1 << TXEN0;
    ADMUX = 1 << REFS0 | 14; /* the internal 1.1 V, measured against the supply */
    ADCSRA = 1 << ADEN | 7;
    for (char i = 0; i < 3; i++) {
        ADCSRA |= 1 << ADSC;
        while (ADCSRA & 1 << ADSC) {}
    }
    const int counts = ADC;
    for (int digit = 1000; digit; digit /= 10) put('0' + counts / digit % 10);
    put('\n');
    cli();
    sleep_enable();
    sleep_cpu();
    return 0;
}
CODE
PATH=$dir/root/usr/bin:$PATH
avr-gcc -mmcu=atmega328p -Os -isystem root/usr/lib/avr/include -B root/usr/lib/avr/lib/avr5 -L root/usr/lib/avr/lib/avr5 \
    bandgap.c -o bandgap.elf
counts=$(timeout 20 simavr -m atmega328p -f 16000000 bandgap.elf 2>&1 | grep -o '0[0-9][0-9][0-9]' | head -1)
expect "1.1 V against the supply, of 1024" "$counts" 0341
