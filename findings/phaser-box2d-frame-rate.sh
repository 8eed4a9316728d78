#!/bin/bash
# Phaser Box2D: WorldStep slows down where frames are longer than its step, and gives the time of one world to another.
#
# Guess before the first run: WorldStep makes fixed steps of 1/60 s, so that one second in 30 frames, 60 frames or 120 frames
# is the same motion, 60 steps; two worlds that get the same frames move alike.
# Seen: a frame that is longer than a step makes one step. At 30 frames per second a world runs at half speed, at 50 at five
# sixths; a shorter fixedTimeStep makes it slower still. All worlds share one account of time: at 120 frames per second the
# first of two worlds never moves, and the second one runs at double speed. No message says so.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" phaser-box2d@1.1.0 > /dev/null
echo "phaser-box2d 1.1.0"
cat > frames.mjs <<'CODE'
import { b2Body_GetLinearVelocity, b2DefaultWorldDef, CreateCircle, CreateWorld, DYNAMIC, WorldStep }
    from "phaser-box2d/dist/PhaserBox2D.js";
// frames RATE STEP WORLDS: the speed in m/s after one second in RATE frames of a ball that falls with 10 m/s^2, for each world.
const [rate, step, worlds] = process.argv.slice(2).map(Number);
const made = Array.from({ length: worlds }, () => {
    const { worldId } = CreateWorld({ worldDef: b2DefaultWorldDef() });
    return { worldId, ball: CreateCircle({ worldId, type: DYNAMIC, radius: 0.5 }).bodyId };
});
for (let frame = 0; frame < rate; frame++)
    for (const { worldId } of made) WorldStep({ worldId, deltaTime: 1 / rate, fixedTimeStep: 1 / step });
console.log(...made.map(({ ball }) => Math.abs(b2Body_GetLinearVelocity(ball).y).toFixed(1)));
CODE
expect "speed after 1 s of free fall, 60 frames" "$(node frames.mjs 60 60 1)" 10.0
expect "the same, 120 frames" "$(node frames.mjs 120 60 1)" 10.0
expect "the same, 50 frames" "$(node frames.mjs 50 60 1)" 8.3
expect "the same, 30 frames" "$(node frames.mjs 30 60 1)" 5.0
expect "the same, 30 frames, steps of 1/120 s" "$(node frames.mjs 30 120 1)" 2.5
expect "the same, two worlds, 60 frames" "$(node frames.mjs 60 60 2)" "10.0 10.0"
expect "the same, two worlds, 120 frames" "$(node frames.mjs 120 60 2)" "0.0 20.0"
