#!/bin/bash
# ahrs: an axis that reads exactly 0 gives NaN or ends the correction.
#
# Guess before the first run: with both filters a robot that stands level has a roll of 0, and one that is tilted by 0.5 rad a
# roll of 0.5. The sample interval is in Hz, as the README says.
# Seen: the Madgwick filter gives NaN from the first level reading on, whatever comes later. The Mahony filter ignores the
# accelerometer while one of its axes reads 0, as in each simulation of a tilt about one axis: the tilt stays 0. With 0.001 g
# instead of 0 both are right. The sample interval is in milliseconds: with 100, meant as 100 Hz, a turn is ten times too wide.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" ahrs@1.3.3 > /dev/null
echo "ahrs 1.3.3"
cat > roll.cjs <<'CODE'
const AHRS = require("ahrs");
// roll ALGORITHM TILT OTHER: the roll in rad after a minute at rest, tilted about x; OTHER is what the axis x reads, in g.
const [algorithm, tilt, other] = process.argv.slice(2);
const filter = new AHRS({ algorithm, sampleInterval: 20 });
const y = Math.sin(tilt) || Number(other), z = Math.cos(tilt);
for (let i = 0; i < 3000; i++) filter.update(0, 0, 0, Number(other), y, z);
console.log(Math.abs(filter.getEulerAngles().roll).toFixed(1));
CODE
cat > turn.cjs <<'CODE'
const AHRS = require("ahrs");
// turn ALGORITHM INTERVAL: the heading in rad after a turn of 0.1 rad/s for as many readings as INTERVAL says.
const [algorithm, interval] = process.argv.slice(2);
const filter = new AHRS({ algorithm, sampleInterval: Number(interval) });
for (let i = 0; i < interval; i++) filter.update(0, 0, 0.1, 0.001, 0.001, 1);
console.log(filter.getEulerAngles().heading.toFixed(2));
CODE
for algorithm in Madgwick Mahony; do
    case $algorithm in
    Madgwick) level=NaN tilted=0.5 ;;
    Mahony) level=0.0 tilted=0.0 ;;
    esac
    expect "$algorithm, roll at rest, level" "$(node roll.cjs $algorithm 0 0)" "$level"
    expect "$algorithm, roll at rest, tilted by 0.5" "$(node roll.cjs $algorithm 0.5 0)" "$tilted"
    expect "$algorithm, level with 0.001 g in x and y" "$(node roll.cjs $algorithm 0 0.001)" 0.0
    expect "$algorithm, tilted by 0.5 with 0.001 g in x" "$(node roll.cjs $algorithm 0.5 0.001)" 0.5
    expect "$algorithm, turn of 0.1 rad, sample interval 20" "$(node turn.cjs $algorithm 20)" 0.04
    expect "$algorithm, turn of 0.1 rad, sample interval 100" "$(node turn.cjs $algorithm 100)" 1.00
done
