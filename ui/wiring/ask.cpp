#include "ui/wiring/ask.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr double wiring_refusal_seconds = 2.5;

}  // namespace

void refuse(CanvasState& state, const CanvasFrame& frame, std::string_view key) {
    const Rect& area = frame.area;
    const bool inside = frame.pointer.valid && area.contains(frame.pointer.at.x, frame.pointer.at.y);
    const vec2 at = inside ? frame.pointer.at : vec2{area.x + area.w / 3, area.y + area.h / 2};
    state.refusal = {std::string(key), at, frame.wall_seconds + wiring_refusal_seconds};
}

void refuse(CanvasState& state, const CanvasFrame& frame, Refusal refusal) {
    refuse(state, frame, refusal_key(refusal));
}

bool ask(CanvasState& state, const CanvasFrame& frame, const Edit& edit, std::uint64_t gesture, Outbox& outbox) {
    if (edit)
        outbox.push_back(EditRequest{SetBrain{frame.target, in_place(*edit.graph, frame.layout)}, gesture});
    else
        refuse(state, frame, edit.refusal);
    return static_cast<bool>(edit);
}

void ask_weight(const CanvasFrame& frame, const BrainGraph& graph, WireEnds ends, float weight, std::uint64_t gesture,
                Outbox& outbox) {
    if (const auto dial = direct_dial(graph, ends))
        outbox.push_back(EditRequest{TurnDial{frame.target, *dial, weight}, gesture});
    else if (const Edit edit = set_weight(graph, ends, weight))
        outbox.push_back(EditRequest{SetBrain{frame.target, in_place(*edit.graph, frame.layout)}, gesture});
}

void ask_places(const CanvasFrame& frame, const Places& moved, std::uint64_t gesture, Outbox& outbox) {
    if (moved.empty()) return;
    PlaceNodes all{frame.target, {}};
    for (const NodeShape& shape : frame.layout.nodes) {
        const auto to = moved.find(shape.id);
        all.places.push_back({shape.id, to == moved.end() ? shape.centre : to->second});
    }
    outbox.push_back(EditRequest{std::move(all), gesture});
}

void select(CanvasState& state, const Hit& hit, bool add) {
    if (!add) state.selection = {};
    const auto toggle = [add](auto& set, const auto& item) {
        if (!set.insert(item).second && add) set.erase(item);
    };
    const bool wire = hit.part == Part::label || hit.part == Part::wire;
    if (wire)
        toggle(state.selection.wires, hit.wire);
    else if (hit.part != Part::nothing)
        toggle(state.selection.nodes, hit.node);
    state.focus = hit.part == Part::nothing ? Hit{}
                  : wire                    ? Hit{Part::label, 0, hit.wire}
                                            : Hit{Part::node, hit.node, {}};
}

}  // namespace braitenlab
