#!/bin/bash
# fuzzylite: what a format cannot say is left out of an exported controller, without a message.
#
# Guess before the first run: a controller that is exported as .fis (Matlab) or .fcl (IEC 61131-7) and read back gives the same
# outputs, or the export says what it cannot express.
# Seen: the order of priority of the rules, the number of points of the centroid and the switches of inputs and of blocks of
# rules are gone, so what was off is on. A robot that turned left before a wall turns right to the light. No message says so, and
# the exit status is 0. The format .fll keeps all of them.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

apt-get download -qq fuzzylite=6.0+dfsg-6 libfuzzylite6.0=6.0+dfsg-6 2>/dev/null
for package in *.deb; do dpkg -x "$package" root; done
echo "fuzzylite 6.0+dfsg-6"
fuzzylite() { LD_LIBRARY_PATH=root/usr/lib/x86_64-linux-gnu root/usr/bin/fuzzylite "$@"; }
# robot ACTIVATION POINTS LIGHT RULES: how a robot between a wall and a light turns, by its copies as .fll, .fis and .fcl; then
# the size of the messages. LIGHT and RULES: is the input of the light, is the block of the rules on?
robot() {
    cat > robot.fll <<FLL
Engine: robot
InputVariable: wall
  enabled: true
  range: 0 1
  lock-range: false
  term: near Ramp 0 1
InputVariable: light
  enabled: $3
  range: 0 1
  lock-range: false
  term: bright Ramp 0 1
OutputVariable: turn
  enabled: true
  range: -1 1
  lock-range: false
  aggregation: Maximum
  defuzzifier: Centroid $2
  default: 0
  lock-previous: false
  term: left Triangle -1 -0.5 0
  term: right Triangle 0 0.5 1
RuleBlock: rules
  enabled: $4
  conjunction: none
  disjunction: none
  implication: Minimum
  activation: $1
  rule: if wall is near then turn is left
  rule: if light is bright then turn is right
FLL
    echo "0.4 0.8" > readings
    for format in fll fis fcl; do
        fuzzylite -i robot.fll -if fll -o "copy.$format" -of $format >> messages 2>&1 || echo failed >> messages
        fuzzylite -i "copy.$format" -if $format -d readings -of fld -o turn -dheader false -dinputs false >> messages 2>&1
        printf '%s ' "$(tr -d ' ' < turn)"
    done
    tr -d '[:space:]' < messages | wc -c
}
expect "all rules, 100 points: turn as .fll .fis .fcl, messages" "$(robot General 100 true true)" "0.100 0.100 0.100 0"
expect "the first rule that fires: the same" "$(robot 'First 1 0' 100 true true)" "-0.500 0.100 0.100 0"
expect "the rule that fires most" "$(robot 'Highest 1' 100 true true)" "0.500 0.100 0.100 0"
expect "all rules, 5 points" "$(robot General 5 true true)" "0.080 0.100 0.100 0"
expect "the input of the light is off" "$(robot General 100 false true)" "-0.500 0.100 0.100 0"
expect "the rules are off" "$(robot General 100 true false)" "0.000 0.100 0.100 0"
