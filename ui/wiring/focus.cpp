#include "ui/wiring/focus.h"

#include <cmath>

namespace braitenlab {

using maths::vec2;

namespace {

template <class Visitor>
void each_stop(const Layout& layout, bool nodes_only, Visitor visit) {
    for (const NodeShape& node : layout.nodes) visit(Hit{Part::node, node.id, {}}, node.centre);
    if (nodes_only) return;
    for (const WireShape& wire : layout.wires) visit(Hit{Part::label, 0, wire.ends}, wire.label);
}

vec2 direction(Towards towards) {
    switch (towards) {
        case Towards::left:
            return {-1, 0};
        case Towards::right:
            return {1, 0};
        case Towards::up:
            return {0, -1};
        default:
            return {0, 1};
    }
}

}  // namespace

std::optional<vec2> middle_of(const Layout& layout, const Hit& thing) {
    if (thing.part == Part::label || thing.part == Part::wire) {
        const WireShape* wire = find_shape(layout, thing.wire);
        return wire == nullptr ? std::nullopt : std::optional(wire->label);
    }
    const NodeShape* node = thing.part == Part::nothing ? nullptr : find_shape(layout, thing.node);
    return node == nullptr ? std::nullopt : std::optional(node->centre);
}

Hit next_towards(const Layout& layout, const Hit& from, Towards towards, bool nodes_only) {
    const auto start = middle_of(layout, from);
    Hit best = start ? from : Hit{};
    float least = 1e30f;
    const vec2 ahead = direction(towards);
    each_stop(layout, nodes_only || !start, [&](const Hit& stop, vec2 at) {
        float cost = at.x + at.y;
        if (start) {
            const float along = maths::dot(at - *start, ahead), aside = std::abs(at.x - start->x) * std::abs(ahead.y) +
                                                                        std::abs(at.y - start->y) * std::abs(ahead.x);
            if (along < 4) return;
            cost = along + 2.2f * aside;
        }
        if (cost >= least) return;
        least = cost;
        best = stop;
    });
    return best;
}

}  // namespace braitenlab
