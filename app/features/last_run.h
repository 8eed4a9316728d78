// The run before the last reset: its paths are shown beside the new run, and its timeline can be returned to.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "app/document.h"
#include "core/lesson/goal.h"
#include "core/world/snapshot.h"

namespace braitenlab {

struct Workspace;
struct GhostView;

// One pose per tick from tick 0 on, by vehicle.
struct RunPaths {
    std::uint64_t run = 0;  // Document::run_id
    std::map<VehicleId, ReferencePath> paths{};
};

// What starting an exercise over forgets: what the runs have shown, the grade, and the generations of a selection.
struct LessonBefore {
    Attempt::Work work;
    Standing standing;
    std::optional<GradedSubmission> graded{};
    std::vector<Parent> parents{};  // empty: no selection has begun
};

// A run that a reset or a return has left, with what an exercise knows about it.
struct LeftRun {
    std::uint64_t run = 0;  // Document::run_id
    Timeline timeline;
    RunPaths paths;
    std::map<VehicleId, VehicleId> new_ids{};  // of its vehicles in the run after it
    std::vector<RunPlace> path{};
    std::optional<LessonBefore> lesson{};  // of a run that was left by starting over
};

// A return can be undone until an edit or a new tick. `state` also tells that an undo took it back: redo repeats it.
struct UndoOfReturn {
    enum class State { none, returned, undone } state = State::none;
    std::int64_t edits = 0;    // Document::edits then
    std::uint64_t latest = 0;  // Session::latest() then
};

struct LastRun {
    RunPaths present, last;
    std::optional<LeftRun> left{};
    UndoOfReturn undo{};
};

// Call before each tick. Records the first 16 vehicles for at most ten minutes, if the run is known from its start on.
void record_paths(LastRun&, const Workspace&);

// The poses of the selected vehicle in the present run, by tick; null if they are not known from its start on.
const ReferencePath* path_of_selected(const LastRun&, const Workspace&);

// The present run. Call before a reset, after record_paths().
LeftRun present_run(const LastRun&, const Workspace&);

// Call after the reset: the run becomes the last one unless it is shorter than half a second. new_ids: of its vehicles
// in the new run.
void keep_run(LastRun&, const Workspace&, LeftRun ended, const std::map<VehicleId, VehicleId>& new_ids);

// The present run with all that starting the exercise over takes away. Precondition: an exercise is open.
LeftRun run_before_start_over(LastRun&, const Workspace&);
// Call after starting over: the next undo returns to this run, whatever its length, with its scene and generations.
void keep_for_undo(LastRun&, const Workspace&, LeftRun);

// Exchanges the present run and the last one: tick, timeline, scene, brains and undo history are those of the last run,
// paused. Once more returns to the newer run.
void return_to_last_run(LastRun&, Workspace&);
bool has_left_run(const LastRun&, const Workspace&);

// True if the next undo or redo takes the return back or repeats it.
bool can_undo_return(const LastRun&, const Workspace&);
bool can_redo_return(const LastRun&, const Workspace&);
void undo_return(LastRun&, Workspace&);
void redo_return(LastRun&, Workspace&);

// The selected vehicle in the last run, at the displayed time. nullopt: not known, or it is not to be shown.
std::optional<GhostView> last_run_of(const LastRun&, const Workspace&);

}  // namespace braitenlab
