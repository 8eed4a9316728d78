#!/bin/bash
# cannon-es: friction grows with the rate of the steps and with the number of contact points, but not with the load.
#
# Guess before the first run: a box with a friction of 0.3 that slides at 5 m/s comes to rest after v^2 / (2 mu g) = 4.17 m,
# and after a tenth of that where it is pressed down with nine times its weight. The time step changes a few percent.
# Seen: it comes to rest after 1 cm, and stays where it is on a slope of 80 degrees. The limit of the friction, a force, bounds
# an impulse of each step and of each contact point: at 60 steps per second a box with four points brakes as with 240 times its
# coefficient. 0.00125 gives the 4.17 m, at 120 steps per second half of that. The load changes nothing.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" cannon-es@0.20.0 > /dev/null
echo "cannon-es 0.20.0"
cat > slide.mjs <<'CODE'
import { Body, Box, Plane, Vec3, World } from "cannon-es";
// slide MU RATE PRESS SPEED SLOPE: the way in m, in 5 s, of a flat box of 1 kg on a plane. PRESS is a force in N into the plane.
const [mu, rate, press, speed, slope] = process.argv.slice(2).map(Number);
const angle = slope * Math.PI / 180;
const world = new World({ gravity: new Vec3(10 * Math.sin(angle), -10 * Math.cos(angle), 0) });
world.defaultContactMaterial.friction = mu;
const plane = new Body({ mass: 0, shape: new Plane() });
plane.quaternion.setFromEuler(-Math.PI / 2, 0, 0);
const box = new Body({ mass: 1, shape: new Box(new Vec3(1, 0.1, 1)), position: new Vec3(0, 0.1, 0),
                       velocity: new Vec3(speed, 0, 0), linearDamping: 0 });
world.addBody(plane);
world.addBody(box);
for (let step = 0; step < 5 * rate; step++) {
    box.applyForce(new Vec3(0, -press, 0));
    world.step(1 / rate);
}
console.log(box.position.x.toFixed(1));
CODE
expect "way in m with 0.3, 60 steps per second" "$(node slide.mjs 0.3 60 0 5 0)" 0.0
expect "the same, from rest on a slope of 80 degrees" "$(node slide.mjs 0.3 60 0 0 80)" 0.0
expect "way with 0.3 / (4 * 60), 60 steps per second" "$(node slide.mjs 0.00125 60 0 5 0)" 4.2
expect "the same, 120 steps per second" "$(node slide.mjs 0.00125 120 0 5 0)" 2.1
expect "the same, 60 steps per second, pressed with 90 N" "$(node slide.mjs 0.00125 60 90 5 0)" 4.2
