#!/bin/bash
# synaptic: a network that is exported as a function has no memory.
#
# Guess before the first run: Network.standalone() returns a function that gives the outputs of the network, step by step, also
# where a neuron reads what another one had in the step before; a self-connection has the weight that project() is given.
# Seen: the function sets all of its variables, also the activations that wires back read, to their values at the time of the
# export in each call. A network with such a wire agrees with it in the first step only, and no message says so; one without
# agrees always. The same network as JSON agrees always. A self-connection has weight 1, whatever project() is given.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

npm install --silent --no-audit --no-fund --prefix "$dir" synaptic@1.1.4 > /dev/null
echo "synaptic 1.1.4"
cat > export.cjs <<'CODE'
const { Neuron, Layer, Network } = require("synaptic");
// One input, two hidden neurons, one output; all weights 1, no squashing. `wire` adds a wire between the hidden ones.
function network(wire) {
    const input = new Layer(1), hidden = new Layer(2), output = new Layer(1);
    input.project(hidden, Layer.connectionType.ALL_TO_ALL, 1);
    wire(hidden.list);
    hidden.project(output, Layer.connectionType.ALL_TO_ALL, 1);
    const made = new Network({ input, hidden: [hidden], output });
    for (const { neuron } of made.neurons()) neuron.bias = 0, neuron.squash = Neuron.squash.IDENTITY;
    return made;
}
const wires = { forward: ([first, second]) => first.project(second, 0.5), back: ([first, second]) => second.project(first, 0.5),
                self: ([first]) => first.project(first, 0.25) };
for (const [name, wire] of Object.entries(wires)) {
    const one = network(wire), exported = one.standalone(), copy = Network.fromJSON(JSON.parse(JSON.stringify(one.toJSON())));
    const steps = [1, 0, 0];
    const outputs = (run) => steps.map((x) => run([x])[0]).join(",");
    console.log(name, outputs((x) => one.activate(x)), outputs((x) => copy.activate(x)), outputs(exported));
}
CODE
while read -r wire network json exported; do
    case $wire in
    forward) wanted=2.5,0,0 wanted_of_export=2.5,0,0 ;;
    back) wanted=2,0.5,0 wanted_of_export=2,0,0 ;;
    self) wanted=2,1,1 wanted_of_export=2,0,0 ;;
    esac
    expect "outputs for 1, 0, 0 with a wire $wire, network" "$network" "$wanted"
    expect "the same, network from JSON" "$json" "$wanted"
    expect "the same, exported function" "$exported" "$wanted_of_export"
done < <(node export.cjs)
