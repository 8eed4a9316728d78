#!/bin/bash
# Phaser Box2D: a body that has been static never moves again.
#
# Guess before the first run: b2Body_SetType releases a static body as in Box2D; it has its mass, falls and obeys a speed.
# Seen: it reports the dynamic type and its mass, but hangs in the air, asleep, whatever speed it is given, and
# b2Body_SetAwake does not wake it. A kinematic body is released as expected. No message says so.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" phaser-box2d@1.1.0 > /dev/null
echo "phaser-box2d 1.1.0"
cat > release.mjs <<'CODE'
import { b2Body_GetMass, b2Body_GetPosition, b2Body_GetType, b2Body_IsAwake, b2Body_SetAwake, b2Body_SetLinearVelocity,
         b2Body_SetType, b2DefaultWorldDef, b2Vec2, b2World_Step, CreateCircle, CreateWorld, DYNAMIC, KINEMATIC, STATIC }
    from "phaser-box2d/dist/PhaserBox2D.js";
// release TYPE...: a ball is made with the first type and set to the next ones, with a step between; then it gets 3 m/s in x.
// Its way in x and its fall in m after 1 s, its type, its mass and whether it is awake.
const types = process.argv.slice(2).map((name) => ({ static: STATIC, kinematic: KINEMATIC, dynamic: DYNAMIC })[name]);
const { worldId } = CreateWorld({ worldDef: b2DefaultWorldDef() });
const ball = CreateCircle({ worldId, type: types[0], radius: 0.5, density: 1 }).bodyId;
for (const type of types.slice(1)) {
    b2World_Step(worldId, 1 / 60, 4);
    b2Body_SetType(ball, type);
}
b2Body_SetLinearVelocity(ball, new b2Vec2(3, 0));
b2Body_SetAwake(ball, true);
for (let step = 0; step < 60; step++) b2World_Step(worldId, 1 / 60, 4);
const { x, y } = b2Body_GetPosition(ball);
console.log(x.toFixed(1), (0 - y).toFixed(1), b2Body_GetType(ball) === DYNAMIC ? "dynamic" : "not dynamic",
            b2Body_GetMass(ball).toFixed(2), b2Body_IsAwake(ball) ? "awake" : "asleep");
CODE
expect "after 1 s: dynamic" "$(node release.mjs dynamic)" "3.0 5.0 dynamic 0.79 awake"
expect "the same, kinematic, then dynamic" "$(node release.mjs kinematic dynamic)" "3.0 5.0 dynamic 0.79 awake"
expect "the same, static, then dynamic" "$(node release.mjs static dynamic)" "0.0 0.0 dynamic 0.79 asleep"
expect "the same, dynamic, static, dynamic" "$(node release.mjs dynamic static dynamic)" "0.0 0.0 dynamic 0.79 asleep"
