#!/bin/bash
# Enki: a robot's motor noise disappears when its program asks for more than the motors can do.
#
# Guess before the first run: the noise of a wheel is relative to its speed, so it is largest at full speed.
# Seen: noise is added to the command and the sum is then cut at the highest speed. A Thymio that is told 50 cm/s drives at
# exactly 16.6 cm/s and exactly straight; told 16.6 cm/s it is slower than that on average; told 10 cm/s it weaves.
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
cat > drive.cpp <<'CODE'
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <enki/PhysicalEngine.h>
#include <enki/robots/thymio2/Thymio2.h>
// drive SPEED: both wheels are told SPEED cm/s for 2 s. The mean speed of a wheel, and whether the robot stays on its line.
int main(int, char** argv) {
    Enki::World world(400, 400);
    world.setRandomSeed(1);
    Enki::Thymio2 robot;
    robot.pos = Enki::Point(200, 200);
    robot.leftSpeed = robot.rightSpeed = std::atof(argv[1]);
    world.addObject(&robot);
    for (int step = 0; step < 100; ++step) world.step(0.02);
    std::printf("%.2f cm/s, %s\n", robot.leftOdometry / 2, robot.pos.y == 200 ? "straight" : "not straight");
    world.removeObject(&robot);
}
CODE
g++ -w -Iroot/usr/include drive.cpp -Lroot/usr/lib -lenki -o drive
drive() { LD_LIBRARY_PATH=root/usr/lib ./drive "$@"; }
expect "told 10 cm/s" "$(drive 10)" "10.01 cm/s, not straight"
expect "told 16.6 cm/s" "$(drive 16.6)" "16.50 cm/s, not straight"
expect "told 50 cm/s" "$(drive 50)" "16.60 cm/s, straight"
