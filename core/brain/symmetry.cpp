#include "core/brain/symmetry.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace braitenlab {

namespace {

struct Ends {
    NodeId left_eye, right_eye, left_motor, right_motor;
};

std::optional<Ends> ends(const BrainGraph& brain, const SensorPair& pair) {
    const auto id = [&](const std::string& name, NodeKind kind) {
        const Node* node = find_node(brain, name);
        return node && node->kind == kind ? node->id : NodeId{-1};
    };
    const Ends e{id(pair.left, NodeKind::sensor), id(pair.right, NodeKind::sensor), id("ML", NodeKind::motor),
                 id("MR", NodeKind::motor)};
    const bool whole = e.left_eye >= 0 && e.right_eye >= 0 && e.left_motor >= 0 && e.right_motor >= 0;
    return whole ? std::optional(e) : std::nullopt;
}

// Sets the wire from `from` to `to` to the model, or removes it when the model is null. Lesions stay.
void copy_wire(BrainGraph& brain, const Wire* model, NodeId from, NodeId to) {
    Wire* wire = find_wire(brain, from, to);
    if (!model) {
        std::erase_if(brain.wires, [&](const Wire& w) { return w.from == from && w.to == to; });
        return;
    }
    Wire made = *model;
    made.from = from, made.to = to;
    made.cut = wire && wire->cut;
    if (wire)
        *wire = made;
    else
        brain.wires.push_back(made);
}

// Swaps the parameters of two wires, except lesions.
void swap_wires(BrainGraph& brain, NodeId eye, NodeId one_motor, NodeId other_motor) {
    const Wire* one = find_wire(brain, eye, one_motor);
    const Wire* other = find_wire(brain, eye, other_motor);
    const std::optional<Wire> first = one ? std::optional(*one) : std::nullopt;
    const std::optional<Wire> second = other ? std::optional(*other) : std::nullopt;
    copy_wire(brain, second ? &*second : nullptr, eye, one_motor);
    copy_wire(brain, first ? &*first : nullptr, eye, other_motor);
}

}  // namespace

BrainGraph mirrored(BrainGraph brain, const SensorPair& pair) {
    const auto e = ends(brain, pair);
    if (!e) return brain;
    const auto wire = [&](NodeId from, NodeId to) {
        const Wire* found = find_wire(brain, from, to);
        return found ? std::optional(*found) : std::nullopt;
    };
    const auto straight = wire(e->left_eye, e->left_motor), across = wire(e->right_eye, e->left_motor);
    copy_wire(brain, straight ? &*straight : nullptr, e->right_eye, e->right_motor);
    copy_wire(brain, across ? &*across : nullptr, e->left_eye, e->right_motor);
    const Node left = *find_node(brain, std::string("ML"));
    Node& right = *find_node(brain, std::string("MR"));
    right.bias = left.bias;
    right.curve = left.curve;
    right.time_constant = left.time_constant;
    return brain;
}

BrainGraph crossed(BrainGraph brain, const SensorPair& pair) {
    const auto e = ends(brain, pair);
    if (!e) return brain;
    swap_wires(brain, e->left_eye, e->left_motor, e->right_motor);
    swap_wires(brain, e->right_eye, e->right_motor, e->left_motor);
    return brain;
}

}  // namespace braitenlab
