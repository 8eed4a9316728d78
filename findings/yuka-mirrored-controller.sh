#!/bin/bash
# yuka: a mirrored fuzzy controller turns more to the right than to the left.
#
# Guess before the first run: symmetrical sets and rules give the middle of the output by the centroid.
# Seen: the middle gives the middle, but an error of 5 degrees turns by 7.63 to the right and one of -5 by 5.56 to the left. The
# module takes the centroid of ten points, with the upper end of the range and without the lower one, and has no setting for
# their number. With 1000 points both sides are nearly the same, with the mean of the maxima exactly.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" yuka@0.7.8 > /dev/null
echo "yuka 0.7.8"
cat > turn.mjs <<'CODE'
import { FuzzyModule, FuzzyRule, FuzzyVariable, LeftShoulderFuzzySet, RightShoulderFuzzySet, TriangularFuzzySet } from "yuka";
// turn ERROR METHOD: the output, from -30 to 30 degrees, for an error from -30 to 30. METHOD is the name of one, or the number of
// points of the centroid.
const [error, method] = process.argv.slice(2);
const module = new FuzzyModule();
const variable = (name) => {
    const made = new FuzzyVariable();
    made.add(new LeftShoulderFuzzySet(-30, -15, 0));
    made.add(new TriangularFuzzySet(-15, 0, 15));
    made.add(new RightShoulderFuzzySet(0, 15, 30));
    module.addFLV(name, made);
    return made;
};
const input = variable("error"), output = variable("turn");
for (let i = 0; i < 3; i++) module.addRule(new FuzzyRule(input.fuzzySets[i], output.fuzzySets[i]));
module.fuzzify("error", Number(error));
const turn = module.defuzzify("turn", FuzzyModule.DEFUZ_TYPE[method] ?? FuzzyModule.DEFUZ_TYPE.MAXAV);
console.log((Number(method) ? output.defuzzifyCentroid(Number(method)) : turn).toFixed(2));
CODE
expect "turn for an error of 0, centroid" "$(node turn.mjs 0 CENTROID)" 0.00
expect "turn for an error of 5" "$(node turn.mjs 5 CENTROID)" 7.63
expect "turn for an error of -5" "$(node turn.mjs -5 CENTROID)" -5.56
expect "turn for an error of 30" "$(node turn.mjs 30 CENTROID)" 20.00
expect "turn for an error of -30" "$(node turn.mjs -30 CENTROID)" -16.88
expect "turn for an error of 5, mean of the maxima" "$(node turn.mjs 5 MAXAV)" 7.50
expect "turn for an error of -5" "$(node turn.mjs -5 MAXAV)" -7.50
expect "turn for an error of 5, centroid of 1000 points" "$(node turn.mjs 5 1000)" 6.62
expect "turn for an error of -5" "$(node turn.mjs -5 1000)" -6.59
