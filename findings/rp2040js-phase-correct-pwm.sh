#!/bin/bash
# rp2040js: a pin of a phase-correct PWM is never high.
#
# Guess before the first run: bit PH_CORRECT halves the frequency and keeps the duty, as on the RP2040 (datasheet, 4.5.2.1), so
# that a motor driver that uses it turns its wheels in the emulator, too.
# Seen: the pin stays low at each duty, and the interrupt of the wrap comes as often as without the bit. Without it each duty is
# right.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" rp2040js@1.4.1 > /dev/null
echo "rp2040js 1.4.1"
cat > duty.mjs <<'CODE'
import { GPIOPinState, Simulator } from "rp2040js";
// duty CSR: the share of time in which pin 0 is high, in per cent, for compare values of 250, 500 and 750 of 1000; then the
// number of wraps. Addresses and bits: RP2040 datasheet, 2.19.6.1 and 4.5.3.
const IO_BANK0 = 0x40014000, PWM = 0x40050000, csr = Number(process.argv[2]);
const seen = [];
let wraps = 0;
for (const compare of [250, 500, 750]) {
    const { clock, rp2040 } = new Simulator();
    rp2040.writeUint32(IO_BANK0 + 4, 4);  // GPIO0: function PWM
    rp2040.writeUint32(PWM + 0x04, 1 << 4);
    rp2040.writeUint32(PWM + 0x0c, compare);
    rp2040.writeUint32(PWM + 0x10, 999);
    rp2040.writeUint32(PWM, csr);
    const ticks = 40_000, tick = 8;  // 125 MHz, in ns
    const one = () => {
        clock.tick(tick);
        if (rp2040.readUint32(PWM + 0xa4)) ++wraps, rp2040.writeUint32(PWM + 0xa4, 1);
        return rp2040.gpio[0].value === GPIOPinState.High ? 1 : 0;
    };
    for (let i = 0; i < 2000; i++) one();  // the first period
    wraps = 0;
    let high = 0;
    for (let i = 0; i < ticks; i++) high += one();
    seen.push(Math.round((100 * high) / ticks));
}
console.log(seen.join(" "), wraps);
CODE
expect "duties of 25, 50, 75 %, wraps: enabled" "$(node duty.mjs 1)" "25 50 75 40"
expect "the same: enabled and phase-correct" "$(node duty.mjs 3)" "0 0 0 40"
