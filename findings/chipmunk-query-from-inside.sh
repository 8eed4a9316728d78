#!/bin/bash
# Chipmunk: a segment query that begins inside a shape reports its own end as the point of the hit.
#
# Guess before the first run: a segment that begins inside a circle or a box meets no surface from outside, so there is no hit.
# Seen: there is a hit, and its two results contradict each other: alpha is 0 (at the beginning), the point is the end of the
# segment. A sensor of range 5 whose beam begins inside a wall sees it 0 away by alpha and 5 away by the point. From outside,
# both name the same place.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

apt-get download -qq libchipmunk-dev=7.0.3-5 libchipmunk7=7.0.3-5 2>/dev/null
for package in *.deb; do dpkg -x "$package" root; done
echo "Chipmunk 7.0.3-5"
cat > query.c <<'CODE'
#include <stdio.h>
#include <stdlib.h>
#include <chipmunk/chipmunk.h>
// query SHAPE FROM: a segment of length 5 from (FROM, 0) along x; the shape spans -1 to 1.
// Prints hit, distance by alpha, distance by point.
int main(int argc, char** argv) {
    cpSpace* space = cpSpaceNew();
    cpBody* wall = cpSpaceGetStaticBody(space);
    const double from = atof(argv[2]);
    cpSpaceAddShape(space, argv[1][0] == 'c' ? cpCircleShapeNew(wall, 1, cpvzero)
                                            : cpBoxShapeNew2(wall, cpBBNew(-1, -1, 1, 1), 0));
    cpSegmentQueryInfo seen;
    const cpShape* hit = cpSpaceSegmentQueryFirst(space, cpv(from, 0), cpv(from + 5, 0), 0, CP_SHAPE_FILTER_ALL, &seen);
    printf("%d %g %g\n", hit != NULL, 5 * seen.alpha, seen.point.x - from);
    return 0;
}
CODE
lib=root/usr/lib/x86_64-linux-gnu
gcc -Iroot/usr/include query.c -L"$lib" -l:libchipmunk.so.7 -lm -o query
query() { LD_LIBRARY_PATH=$lib ./query "$@" 2>/dev/null | tail -1; }  # without its greeting
echo "hit, distance by alpha, distance by point:"
expect "circle, from outside" "$(query circle -4)" "1 3 3"
expect "circle, from inside" "$(query circle 0.25)" "1 0 5"
expect "box, from outside" "$(query box -4)" "1 3 3"
expect "box, from inside" "$(query box 0.25)" "1 0 5"
