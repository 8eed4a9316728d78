#!/bin/bash
# Phaser Box2D: nothing bounces below 10 m/s.
#
# Guess before the first run: a ball with a restitution of 1 that falls from 4.9 m comes back to about that height, one with
# 0.5 to a quarter of it. Only impacts below 1 m/s do not bounce, the limit of other versions of Box2D.
# Seen: both stay on the floor. From 5.1 m they come back to 5.1 m and 1.2 m: restitutionThreshold of the default world is
# 10 m/s. With 1 m/s in its place the ball from 4.9 m bounces.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" phaser-box2d@1.1.0 > /dev/null
echo "phaser-box2d 1.1.0"
cat > drop.mjs <<'CODE'
import { b2Body_GetLinearVelocity, b2Body_GetPosition, b2DefaultWorldDef, b2Vec2, b2World_Step, CreateBoxPolygon, CreateCircle,
         CreateWorld, DYNAMIC, STATIC } from "phaser-box2d/dist/PhaserBox2D.js";
// drop HEIGHT RESTITUTION [THRESHOLD]: the height in m to which a ball comes back from a fall on a floor, gravity 10 m/s^2.
const [height, restitution, threshold] = process.argv.slice(2).map(Number);
const worldDef = b2DefaultWorldDef();
if (threshold !== undefined) worldDef.restitutionThreshold = threshold;
const { worldId } = CreateWorld({ worldDef });
CreateBoxPolygon({ worldId, type: STATIC, position: new b2Vec2(0, -0.5), size: new b2Vec2(50, 0.5) });
const ball = CreateCircle({ worldId, type: DYNAMIC, position: new b2Vec2(0, height + 0.5), radius: 0.5, density: 1,
                            restitution }).bodyId;
let top = 0;
for (let step = 0, rises = false; step < 240; step++) {
    b2World_Step(worldId, 1 / 60, 4);
    rises ||= b2Body_GetLinearVelocity(ball).y > 0.01;
    if (rises) top = Math.max(top, b2Body_GetPosition(ball).y - 0.5);
}
console.log(top.toFixed(1));
CODE
expect "height of the bounce from 4.9 m, restitution 1" "$(node drop.mjs 4.9 1)" 0.0
expect "the same, restitution 0.5" "$(node drop.mjs 4.9 0.5)" 0.0
expect "height of the bounce from 5.1 m, restitution 1" "$(node drop.mjs 5.1 1)" 5.1
expect "the same, restitution 0.5" "$(node drop.mjs 5.1 0.5)" 1.2
expect "from 4.9 m, restitution 1, a threshold of 1 m/s" "$(node drop.mjs 4.9 1 1)" 4.9
