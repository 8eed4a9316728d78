#!/bin/bash
# planck.js: a saved world loses the damping of its bodies.
#
# Guess before the first run: what Serializer.toJson has written goes on after Serializer.fromJson as the saved world does; at
# most a few last digits differ. It keeps places, speeds, shapes, friction, restitution and sensors.
# Seen: linearDamping, angularDamping and gravityScale are not in the JSON, and the loaded body has their defaults, 0 and 1.
# A vehicle that coasts to rest coasts for ever after loading. No message says so. Restitution and fixedRotation are kept.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" planck@1.5.0 > /dev/null
echo "planck 1.5.0"
cat > save.cjs <<'CODE'
const { World, Circle, Serializer } = require("planck");
const saved = new World({ x: 0, y: 0 });
const body = saved.createBody({ type: "dynamic", linearVelocity: { x: 3, y: 0 }, linearDamping: 1, angularDamping: 2,
                                gravityScale: 0.5, fixedRotation: true });
body.createFixture(new Circle(0.5), { density: 1, restitution: 0.25 });
const loaded = Serializer.fromJson(JSON.parse(JSON.stringify(Serializer.toJson(saved))));
const copy = loaded.getBodyList();
for (let step = 0; step < 600; step++) {
    saved.step(1 / 60);
    loaded.step(1 / 60);
}
for (const one of [body, copy])
    console.log(one.getPosition().x.toFixed(1), one.getLinearVelocity().length().toFixed(3), one.getLinearDamping(),
                one.getAngularDamping(), one.getGravityScale(), one.getFixtureList().getRestitution(), one.isFixedRotation());
CODE
{
    read -r way speed damping turning gravity bounce fixed
    read -r way2 speed2 damping2 turning2 gravity2 bounce2 fixed2
} < <(node save.cjs)
expect "way in 10 s from 3 m/s with a damping of 1, saved world" "$way" 3.0
expect "the same, loaded world" "$way2" 30.0
expect "speed after 10 s, saved and loaded world" "$speed $speed2" "0.000 3.000"
expect "linear damping, saved and loaded" "$damping $damping2" "1 0"
expect "angular damping, saved and loaded" "$turning $turning2" "2 0"
expect "scale of gravity, saved and loaded" "$gravity $gravity2" "0.5 1"
expect "restitution and fixed rotation, saved" "$bounce $fixed" "0.25 true"
expect "restitution and fixed rotation, loaded" "$bounce2 $fixed2" "0.25 true"
