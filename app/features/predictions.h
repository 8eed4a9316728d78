// The coming seconds of the selected vehicle, computed in the background: while something is dragged or set by keys,
// beside the path before that; and while the pointer is over a preset or a wire, what that one would change.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/jobs/asked.h"
#include "core/insight/predict.h"

namespace braitenlab {

struct Workspace;
struct PredictionView;

// What a path depends on. A path of an equal subject need not be computed again.
struct PredictionSubject {
    std::uint64_t run = 0;   // Document::run_id
    std::int64_t edits = 0;  // Document::edits
    std::uint64_t tick = 0;  // the first of the path
    VehicleId vehicle = no_vehicle;
    std::vector<Command> changes{};
    friend bool operator==(const PredictionSubject&, const PredictionSubject&) = default;
};

struct Predictions {
    std::vector<Command> what_if{};  // of the preset or wire under the pointer; set once per frame. Empty: none

    bool pressed = false;                         // something is dragged or set by keys; set by note_press()
    bool button = false;                          // the left button is down
    std::uint64_t keys = 0;                       // gesture number of an edit by keys; 0: none
    std::optional<insight::Question> at_press{};  // the run before the first edit of the drag or of the keys
    PredictionSubject subject_at_press{};

    Asked<PredictionSubject, insight::Path> path{}, before{};  // `before`: without the edits or without `what_if`
    // With other random numbers; where the run depends on them. Of the subject of `path`, or for a moment of the edit
    // before.
    Asked<PredictionSubject, std::vector<insight::Path>> fan{};
    double asked_at = 0;      // wall seconds, of `path`
    bool is_what_if = false;  // `path` is about `what_if`
};

// Call once per frame, before the requests of the frame are executed. `down`: the left mouse button. `keys`: gesture
// number of an edit by keys in this frame or a moment ago, which counts as a drag; 0: none.
void note_press(Predictions&, const Workspace&, bool down, std::uint64_t keys = 0);

// True while a path is computed.
bool is_computing(const Predictions&);

// Call once per turn, after Jobs::deliver. Asks for the paths that are needed and takes finished ones. While a path of
// a drag is computed, only the newest edit waits, and for the fan of a path it waits a moment; another drag, preset or
// wire cancels what is computed.
void update_predictions(Predictions&, const Workspace&, Jobs&);

// The paths to draw; nullopt: none. They point into the predictions.
std::optional<PredictionView> prediction_of(const Predictions&, const Workspace&);

}  // namespace braitenlab
