// Parts that all handles in the scene share. Without Dear ImGui; they are drawn by draw_handle() in draw.h.
#pragma once

#include <optional>

#include "ui/scene_input/under_pointer.h"

namespace braitenlab::ui {

inline constexpr float handle_grip = 12;  // layout pixels around a handle within which a mouse takes it

// True if handles can be shown: over the scene, for the hand, and not while the camera rides with a vehicle.
inline bool shows_handles(const SceneInputState& state, const LabView& view) {
    return view.mode != Mode::wiring && state.tool == SceneInputTool::hand && !rides(view.settings.camera.mode) &&
           view.now->scene && !view.lecture;
}

// Finds the handle nearest to the pointer.
template <class Id>
struct NearestHandle {
    const SceneInputFrame& frame;
    Id found{};  // its initial value: none is within reach
    float nearest = 1e9f;

    void offer(Id id, const std::optional<maths::vec2>& place) {
        const float distance = place ? pixels_from(frame, *place) : 1e9f;
        if (distance <= handle_grip * frame.scale * finger_reach(frame.view) && distance < nearest)
            nearest = distance, found = id;
    }
};

}  // namespace braitenlab::ui
