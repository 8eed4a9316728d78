#!/bin/bash
# crashcat: a world with a motor cannot be saved as JSON, and with that mended its motor has no force.
#
# Guess before the first run: a world goes on from its JSON exactly as the saved one, with its bodies and its constraints, as
# its manual says.
# Seen: that is so without a constraint. With one JSON.stringify raises a TypeError: each constraint has a BigInt as its user
# data. Where a number replaces it, the world is saved and loaded without a message, but the limits of the motor, infinite by
# default, are null in JSON and count as 0: the wheel that the motor keeps at 2 rad/s coasts. With a finite limit it does not.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" crashcat@0.0.5 > /dev/null
echo "crashcat 0.0.5"
cat > save.mjs <<'CODE'
import { addBroadphaseLayer, addObjectLayer, box, createWorld, createWorldSettings, enableCollision, hingeConstraint,
         motorSettings, MotorState, MotionType, registerAll, rigidBody, updateWorld } from "crashcat";
// save KIND: a wheel is at 2 rad/s; after 1 s the world is saved and loaded; both speeds in rad/s after 10 s more. KIND is
// "coast" without a constraint, or "motor" or "limited" with one. The latter two write a BigInt as a number.
const kind = process.argv[2];
registerAll();
const settings = createWorldSettings();
const layer = addObjectLayer(settings, addBroadphaseLayer(settings));
enableCollision(settings, layer, layer);
settings.gravity = [0, 0, 0];
const world = createWorld(settings);
const make = (motionType, z) => rigidBody.create(world, { motionType, shape: box.create({ halfExtents: [0.5, 0.5, 0.5] }),
                                                          objectLayer: layer, position: [0, 0, z] });
const wheel = make(MotionType.DYNAMIC, 0), frame = make(MotionType.STATIC, 3);
rigidBody.setAngularVelocity(world, wheel, [0, 2, 0]);
if (kind !== "coast") {
    const hinge = hingeConstraint.create(world, { bodyIdA: frame.id, bodyIdB: wheel.id, pointA: [0, 0, 0], pointB: [0, 0, 0],
                                                  hingeAxisA: [0, 1, 0], hingeAxisB: [0, 1, 0], normalAxisA: [1, 0, 0],
                                                  normalAxisB: [1, 0, 0] });
    hingeConstraint.setMotorState(hinge, MotorState.VELOCITY);
    hingeConstraint.setTargetAngularVelocity(hinge, 2);
    if (kind === "limited") motorSettings.setTorqueLimit(hinge.motorSettings, 1000);
}
const run = (one, seconds) => {
    for (let step = 0; step < 60 * seconds; step++) updateWorld(one, undefined, 1 / 60);
    return rigidBody.get(one, wheel.id).motionProperties.angularVelocity[1].toFixed(2);
};
run(world, 1);
let refused = "";
try {
    JSON.stringify(world);
} catch (error) {
    refused = error.name + " ";
}
const loaded = JSON.parse(JSON.stringify(world, (name, value) => (typeof value === "bigint" ? Number(value) : value)));
console.log(refused + run(world, 10), run(loaded, 10));
CODE
expect "speeds, saved and loaded: no constraint, it coasts" "$(node save.mjs coast)" "1.15 1.15"
expect "the same, a motor with a limit of 1000 Nm" "$(node save.mjs limited)" "TypeError 2.00 2.00"
expect "the same, a motor as it is made" "$(node save.mjs motor)" "TypeError 2.00 1.21"
