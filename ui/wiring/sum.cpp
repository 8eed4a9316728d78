#include "ui/wiring/sum.h"

#include <algorithm>
#include <vector>

#include "ui/widgets/number.h"

namespace braitenlab {
namespace {

struct Term {
    std::string size;  // without the sign that joins it to the others
    bool negative = false;
};

std::vector<Term> terms_of(const BrainGraph& graph, const Node& node, const std::function<float(NodeId)>& value) {
    std::vector<const Wire*> arriving;
    for (const Wire& wire : graph.wires)
        if (wire.to == node.id && wire.weight != 0) arriving.push_back(&wire);
    std::sort(arriving.begin(), arriving.end(), [](const Wire* a, const Wire* b) { return a->from < b->from; });
    std::vector<Term> terms;
    for (const Wire* wire : arriving) {
        const float input = signal(*wire, value(wire->from)) / wire->weight;  // behind threshold and curve
        const std::string factor = input < 0 ? "(" + fixed(input, 2) + ")" : fixed(input, 2);
        const float size = wire->weight < 0 ? -wire->weight : wire->weight;
        terms.push_back({factor + "·" + fixed(size, 2), wire->weight < 0});
    }
    if (node.bias != 0 || terms.empty())
        terms.push_back({fixed(node.bias < 0 ? -node.bias : node.bias, 2), node.bias < 0});
    return terms;
}

}  // namespace

std::string sum_text(const BrainGraph& graph, NodeId id, const std::function<float(NodeId)>& value) {
    constexpr std::size_t terms_a_line = 3;
    const Node* node = find_node(graph, id);
    if (node == nullptr || node->kind == NodeKind::sensor) return {};
    std::string text;
    std::size_t count = 0;
    for (const Term& term : terms_of(graph, *node, value)) {
        if (count > 0) text += count % terms_a_line == 0 ? "\n" : " ";
        if (term.negative)
            text += count > 0 ? "− " : "−";
        else if (count > 0)
            text += "+ ";
        text += term.size;
        ++count;
    }
    return text + " → " + fixed(value(id), 2);
}

}  // namespace braitenlab
