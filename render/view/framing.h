// The part of the floor that the camera frames by default: the action of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "render/view/camera.h"

namespace braitenlab {

// The smallest box around all vehicles, sources, lines of tape and the obstacles near them, inside the arena with its
// walls; the whole arena without sources and tape. m.
FloorBox action_of(const Snapshot&);

// What the framed box depends on besides the snapshot.
struct FramingInput {
    Camera camera;
    VehicleId selected = no_vehicle;
    Rect window, free_area;
    float least_share = 0.05f;  // of the free area's width: least length of the selected vehicle, with few vehicles
    std::optional<FloorBox> other_run{};  // where a run is that is drawn beside this one
    float seconds = 0;                    // since the last frame; 0: no glide, the box changes at once
    bool held = false;                    // the user holds something: the box stays
    std::optional<FloorBox> close_up{};   // framed in place of the action
};

// Follows the action of a run: the box grows with it and does not shrink. While the user has zoomed or moved the
// camera, the box stays.
class Framing {
public:
    // The box of this frame.
    FloorBox follow(const Snapshot&, const FramingInput&);

    // Fits the box to the present action at the next call.
    void start_over() { shown_.reset(), grown_.reset(); }

private:
    std::optional<FloorBox> shown_, grown_;  // displayed box; box around the action since the start
    std::uint64_t seed_ = 0;
    int generation_ = 0;
    std::string scene_;
};

inline constexpr std::size_t few_vehicles = 5;  // up to this number the selected one has a least size

}  // namespace braitenlab
