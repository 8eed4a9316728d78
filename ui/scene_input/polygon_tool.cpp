#include "ui/scene_input/polygon_tool.h"

#include "ui/scene_input/under_pointer.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float corner_grip = 11;  // layout pixels round the first corner, which closes
constexpr double refusal_seconds = 3;

void refuse(SceneInputState& state, double wall_seconds, std::string_view key) {
    state.refusal = {std::string(key), wall_seconds + refusal_seconds};
}

}  // namespace

std::string_view reason(OutlineFault fault) {
    switch (fault) {
        case OutlineFault::none:
            break;
        case OutlineFault::too_near:
            return "scene_input.refused.too_near";
        case OutlineFault::crosses:
            return "scene_input.refused.crosses";
        case OutlineFault::dents:
            return "scene_input.refused.dents";
        case OutlineFault::too_many:
            return "scene_input.refused.too_many";
        case OutlineFault::too_few:
            return "scene_input.refused.too_few";
        case OutlineFault::too_narrow:
            return "scene_input.refused.too_narrow";
    }
    return {};
}

void click_corner(SceneInputState& state, const SceneInputFrame& frame, vec2 at, Outbox& outbox) {
    const SceneInputPointer& pointer = frame.pointer;
    const bool on_first =
        state.corners.size() >= 3 && pixels_from(frame, state.corners[0]) <= corner_grip * frame.scale;
    if (on_first || (pointer.left_double && state.corners.size() >= 3))
        return close_outline(state, frame.view.wall_seconds, pointer.shift, outbox);
    if (pointer.left_double) return;  // the first of the two clicks has set the corner
    if (const OutlineFault fault = fault_of_next(state.corners, at); fault != OutlineFault::none)
        return refuse(state, frame.view.wall_seconds, reason(fault));
    state.corners.push_back(at);
}

void take_back_corner(SceneInputState& state) {
    state.refusal = {};
    if (state.corners.empty())
        state.tool = SceneInputTool::hand;
    else
        state.corners.pop_back();
}

void close_outline(SceneInputState& state, double wall_seconds, bool keep_tool, Outbox& outbox) {
    if (const OutlineFault fault = fault_of(state.corners); fault != OutlineFault::none)
        return refuse(state, wall_seconds, reason(fault));
    outbox.push_back(EditRequest{AddObstacle{obstacle_from(state.corners)}});
    state.corners.clear();
    state.refusal = {};
    if (!keep_tool) state.tool = SceneInputTool::hand;
}

}  // namespace braitenlab
