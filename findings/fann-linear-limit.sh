#!/bin/bash
# FANN: a neuron with a linear curve is limited, the more the steeper its curve is.
#
# Guess before the first run: the output of FANN_LINEAR is steepness times the weighted sum, for every sum.
# Seen: it ends at 150 / steepness. With a weight of 1 the readings 200 and 1023 of a 10-bit converter give the same output,
# 150; with a steepness of 2 the output ends at 75. fann_run returns no error.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

apt-get download -qq libfann-dev=2.2.0+ds-8 libfann2=2.2.0+ds-8 2>/dev/null
for package in *.deb; do dpkg -x "$package" root; done
echo "FANN 2.2.0+ds-8"
cat > neuron.c <<'CODE'
#include <stdio.h>
#include <stdlib.h>
#include <fann.h>
// neuron STEEPNESS INPUT: the output of one linear neuron with a weight of 1 and no bias.
int main(int argc, char** argv) {
    struct fann* net = fann_create_standard(2, 1, 1);
    fann_type input = atof(argv[2]);
    fann_set_weight_array(net, (struct fann_connection[]){{0, 2, 1}, {1, 2, 0}}, 2);
    fann_set_activation_function_output(net, FANN_LINEAR);
    fann_set_activation_steepness_output(net, atof(argv[1]));
    printf("%g\n", fann_run(net, &input)[0]);
    fann_destroy(net);
}
CODE
lib=root/usr/lib/x86_64-linux-gnu
gcc -Iroot/usr/include neuron.c -L"$lib" -lfann -lm -o neuron
neuron() { LD_LIBRARY_PATH=$lib ./neuron "$@"; }
expect "steepness 1, input 100" "$(neuron 1 100)" 100
expect "steepness 1, input 200" "$(neuron 1 200)" 150
expect "steepness 1, input 1023" "$(neuron 1 1023)" 150
expect "steepness 0.5, input 1023" "$(neuron 0.5 1023)" 300
expect "steepness 2, input 1023" "$(neuron 2 1023)" 75
