// What panels, shortcuts and the mouse ask of the lab. The app carries requests out in order, once a frame.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "core/world/command.h"

namespace braitenlab {

// Requests without a value: what buttons and shortcuts do.
enum class Action {
    play_pause, step, reset, add, remove, follow, new_population, exit, sensors, outlines, wiring,
    undo, redo, slower, faster, next_vehicle, previous_vehicle, home, cancel, screenshot, full_screen, theme,
    hint, exercise_reset,
};

struct EditRequest {
    Command command;
    std::uint64_t gesture = 0;  // the same for all edits of one drag: one step of undo
};
struct SelectRequest {
    VehicleId vehicle = no_vehicle;
};
struct ScopeRequest {
    bool whole_kind = true;
};
struct PredictRequest {
    int option = 0;  // 0-based
};
struct SpeedRequest {
    float time_scale = 1;
};

using Request = std::variant<Action, EditRequest, SelectRequest, ScopeRequest, PredictRequest, SpeedRequest>;
using Outbox = std::vector<Request>;

}  // namespace braitenlab
