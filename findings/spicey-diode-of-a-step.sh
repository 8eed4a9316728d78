#!/bin/bash
# spicey: a diode and a resistor need eight time steps to settle, however short a step is.
#
# Guess before the first run: a circuit without capacitors and inductors has no memory. In a transient each point obeys the
# curve of the diode, and the time step only says how many points there are.
# Seen: at a constant source the voltage creeps to its value in eight steps, 1 us or 10 us long. The output of a half-wave
# rectifier lags its input and is below zero while the input falls: there is one step of Newton's method at each point. A
# source of the form SIN(…), which the program does not know, gives 0 V without a message.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" spicey@0.0.14 > /dev/null
echo "spicey 0.0.14"
cat > run.mjs <<'CODE'
import { simulate } from "spicey";
// run SOURCE STEP POINT: volts at the resistor at this point of time.
const [source, step, point] = process.argv.slice(2);
const { tran } = simulate(`diode and resistor
v1 in 0 ${source}
d1 in out dm
.model dm D
r1 out 0 1k
.tran ${step} 100u
.end
`);
const i = tran.times.findIndex((time) => time > Number(point) * 1e-6 - 1e-9);
console.log(tran.nodeVoltages.out[i].toFixed(2));
CODE
expect "V at 50 us, source of 1 V, steps of 1 us" "$(node run.mjs 'dc 1' 1u 50)" "0.37"
expect "the same, steps of 10 us" "$(node run.mjs 'dc 1' 10u 50)" "0.33"
expect "the same, steps of 25 us" "$(node run.mjs 'dc 1' 25u 50)" "0.25"
pulse='PULSE(-5 5 0 10u 10u 40u 100u)'  # from 5 V at 50 us to -5 V at 60 us
expect "V of a rectifier at 48 us, input 5 V" "$(node run.mjs "$pulse" 1u 48)" "4.31"
expect "the same at 55 us, input 0 V" "$(node run.mjs "$pulse" 1u 55)" "-0.60"
expect "the same at 25 us of a sine of 5 V and 10 kHz" "$(node run.mjs 'SIN(0 5 10k)' 1u 25)" "0.00"
