// A scene whose only vehicle has a brain of any size, as the text of its file.

// `nodes` includes the two eyes and two motors. The wires are the same ones in each run.
export function largeScene(nodes, wires) {
    let seed = 7;
    const chance = (below) => (seed = (seed * 1103515245 + 12345) % 2147483648) % 65536 % below;
    const neurons = Array.from({ length: nodes - 4 }, (_, i) => `N${i + 1}`);
    const targets = [...neurons, "ML", "MR"], sources = [...neurons, "SL", "SR"];
    const drawn = new Set();
    while (drawn.size < wires) drawn.add(`${sources[chance(sources.length)]} ${targets[chance(targets.length)]}`);
    const parts = [
        'format = 1\ntitle = "Large"\n[arena]\nwidth = 12\nheight = 9\n',
        '[vehicle.one]\nkind = "large"\nx = -3\ny = 0\n[source.lamp]\nx = 3\ny = 1\n',
        "[kind.large.brain]\nLM = 0.1\nRM = 0.1\n",
        ...neurons.map((name) => `[[kind.large.brain.node]]\nname = "${name}"\n`),
        ...[...drawn].map((ends, i) => {
            const [from, to] = ends.split(" ");
            return `[[kind.large.brain.wire]]\nfrom = "${from}"\nto = "${to}"\nweight = ${(i % 9) / 4 - 1}\n`;
        }),
    ];
    return parts.join("\n");
}
