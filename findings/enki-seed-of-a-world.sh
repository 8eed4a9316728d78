#!/bin/bash
# Enki: the seed of a world is the seed of all worlds.
#
# Guess before the first run: World::setRandomSeed seeds the world it is called on, so that each of several worlds in a
# program can be repeated, in any order and side by side.
# Seen: all worlds share one generator. A world that is seeded with 1 takes another path when a second world steps between
# its steps, and the same path again when the second world is seeded with 1.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

apt-get download -qq libenki-dev=1:1.6.99-2+b6 libenki2=1:1.6.99-2+b6 2>/dev/null
for package in *.deb; do dpkg -x "$package" root; done
echo "Enki 1.6.99-2+b6"
cat > worlds.cpp <<'CODE'
#include <cstdio>
#include <enki/PhysicalEngine.h>
#include <enki/robots/thymio2/Thymio2.h>
struct Drive {
    Enki::World world{400, 400};
    Enki::Thymio2 robot;
    Drive() {
        robot.pos = Enki::Point(200, 200);
        robot.leftSpeed = robot.rightSpeed = 5;
        world.addObject(&robot);
    }
    ~Drive() { world.removeObject(&robot); }
    double turn(int steps) {
        for (int step = 0; step < steps; ++step) world.step(0.02);
        return robot.angle;
    }
};
int main() {
    Drive alone, beside, other, after;
    alone.world.setRandomSeed(1);
    const double expected = alone.turn(100);
    beside.world.setRandomSeed(1);
    for (int step = 0; step < 100; ++step) { beside.turn(1); other.turn(1); }
    other.world.setRandomSeed(1);  // the seed of `other`, the steps of `after`
    const double of_other = after.turn(100);
    std::printf("%s %s\n", beside.robot.angle == expected ? "same" : "another", of_other == expected ? "same" : "another");
}
CODE
g++ -w -Iroot/usr/include worlds.cpp -Lroot/usr/lib -lenki -o worlds
read -r beside after < <(LD_LIBRARY_PATH=root/usr/lib ./worlds)
expect "path of a seeded world beside another one" "$beside" another
expect "path of a world after another world was seeded" "$after" same
