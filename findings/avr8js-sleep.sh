#!/bin/bash
# avr8js: a processor that sleeps for good goes on.
#
# Guess before the first run: with interrupts off, SLEEP in power-down mode stops the program, as on the chip: only a reset goes on.
# Seen: SLEEP is skipped and the next instruction runs, so a sketch that saves power never rests in a simulation.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" avr8js@0.21.1 > /dev/null
echo "avr8js 0.21.1"
cat > run.cjs <<'CODE'
const {CPU, avrInstruction} = require('avr8js');
// ldi r16, 5; out SMCR, r16 (sleep enabled, power-down); cli; sleep; ldi r16, 1; out GPIOR0, r16; rjmp to itself
const words = [0xe005, 0xbf03, 0x94f8, 0x9588, 0xe001, 0xbb0e, 0xcfff];
const program = new Uint16Array(0x4000);
program.set(words);
const cpu = new CPU(program);
for (let i = 0; i < 1000; i++) { avrInstruction(cpu); cpu.tick(); }
console.log(cpu.data[0x3e], cpu.data[0x53]);
CODE
read -r after mode < <(node run.cjs)
expect "mode of sleep (5: power-down, enabled)" "$mode" 5
expect "the instruction after SLEEP ran (1: yes)" "$after" 1
