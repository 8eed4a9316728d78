#include "app/features/last_run.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/lab_selection.h"
#include "app/workspace.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_vehicles = 16, most_poses = 36000;  // 7 MB
constexpr std::size_t least_poses = 30;

// Paths long enough to be shown, by the ids in another run.
RunPaths renumbered(RunPaths paths, const std::map<VehicleId, VehicleId>& ids) {
    RunPaths shown{paths.run, {}};
    for (auto& [id, path] : paths.paths)
        if (const auto found = ids.find(id); found != ids.end() && path.size() >= least_poses)
            shown.paths[found->second] = std::move(path);
    return shown;
}

UndoOfReturn undo_of(const Workspace& space, UndoOfReturn::State state) {
    return {state, space.document.edits, space.document.session.latest()};
}

bool is(const LastRun& runs, const Workspace& space, UndoOfReturn::State state) {
    const UndoOfReturn now = undo_of(space, state), &then = runs.undo;
    return has_left_run(runs, space) && then.state == state && then.edits == now.edits && then.latest == now.latest;
}

LessonBefore lesson_before(const Lesson& lesson) {
    return {lesson.attempt.work, lesson.standing, lesson.graded,
            lesson.selecting ? lesson.selecting->parents : std::vector<Parent>{}};
}

void give_back(Lesson& lesson, LessonBefore before, std::uint64_t seed) {
    lesson.attempt.work = std::move(before.work);
    lesson.standing = before.standing;
    lesson.standing.starts_tested.reset();
    lesson.graded = std::move(before.graded);
    lesson.grading.reset();
    lesson.selecting.reset();
    if (!before.parents.empty()) lesson.selecting = Selecting{.parents = std::move(before.parents), .start = seed};
}

}  // namespace

void record_paths(LastRun& runs, const Workspace& space) {
    const Session& session = space.document.session;
    const Snapshot& now = session.snapshot();
    RunPaths& present = runs.present;
    const bool is_new = session.latest() == now.tick;  // else a recorded tick is repeated
    if (is_new && (present.run != space.document.run_id || now.tick == 0)) present = {space.document.run_id, {}};
    if (now.tick >= most_poses) return;
    for (std::size_t i = 0; i < std::min(most_vehicles, now.vehicles.size()); ++i) {
        const VehicleView& vehicle = now.vehicles[i];
        if (now.tick == 0) present.paths.try_emplace(vehicle.id);
        const auto found = present.paths.find(vehicle.id);
        if (found == present.paths.end()) continue;  // born later
        ReferencePath& path = found->second;
        if (is_new && path.size() > now.tick) path.resize(static_cast<std::size_t>(now.tick));
        if (path.size() == now.tick) path.push_back({vehicle.x, vehicle.y, vehicle.heading});
    }
}

const ReferencePath* path_of_selected(const LastRun& runs, const Workspace& space) {
    const RunPaths& present = runs.present;
    const auto found = present.paths.find(space.view.selection.vehicle);
    return present.run == space.document.run_id && !space.together && found != present.paths.end() ? &found->second
                                                                                                   : nullptr;
}

LeftRun present_run(const LastRun& runs, const Workspace& space) {
    LeftRun run{.run = space.document.run_id, .timeline = space.document.session.timeline(), .paths = runs.present};
    if (run.paths.run != run.run) run.paths = {run.run, {}};
    if (const auto& lesson = space.document.lesson) run.path = lesson->path;
    return run;
}

void keep_run(LastRun& runs, const Workspace& space, LeftRun ended, const std::map<VehicleId, VehicleId>& new_ids) {
    runs.present = {space.document.run_id, {}};
    runs.undo = {};
    if (RunPaths paths = renumbered(ended.paths, new_ids); !paths.paths.empty()) runs.last = std::move(paths);
    if (ended.timeline.recording.latest() + 1 < least_poses) return;
    ended.new_ids = new_ids;
    runs.left = std::move(ended);
}

LeftRun run_before_start_over(LastRun& runs, const Workspace& space) {
    record_paths(runs, space);
    LeftRun run = present_run(runs, space);
    run.lesson = lesson_before(*space.document.lesson);
    return run;
}

void keep_for_undo(LastRun& runs, const Workspace& space, LeftRun run) {
    for (const VehicleView& vehicle : space.document.session.snapshot().vehicles) run.new_ids[vehicle.id] = vehicle.id;
    runs.left = std::move(run);
    runs.undo = undo_of(space, UndoOfReturn::State::returned);
}

bool has_left_run(const LastRun& runs, const Workspace& space) {
    return runs.left && runs.left->run == space.document.run_id;
}

void return_to_last_run(LastRun& runs, Workspace& space) {
    if (!has_left_run(runs, space)) return say(space, {NoticeKind::failure, "unavailable.no_last_run"});
    set_mode(space, Mode::paused);
    record_paths(runs, space);
    LeftRun now = present_run(runs, space), then = std::move(*runs.left);
    std::map<VehicleId, VehicleId> old_ids;
    for (const auto& [old_id, new_id] : then.new_ids) old_ids[new_id] = old_id;
    space.document.session.return_to(then.timeline);
    if (auto& lesson = space.document.lesson) {
        lesson->path = std::move(then.path);
        if (then.lesson) {
            now.lesson = lesson_before(*lesson);
            give_back(*lesson, std::move(*then.lesson), space.document.session.seed());
        }
    }
    runs.present = std::move(then.paths);
    if (RunPaths paths = renumbered(now.paths, old_ids); !paths.paths.empty()) runs.last = std::move(paths);
    renumber_selection(space.view.selection, old_ids);
    now.new_ids = std::move(old_ids);
    runs.left = std::move(now);
    ++space.document.edits;
    runs.undo = undo_of(space, UndoOfReturn::State::returned);
    space.steered = {};
    forget_motion(space);
    keep_selection(space);
    watch(space);
    say(space, {NoticeKind::done, "notice.returned"});
}

bool can_undo_return(const LastRun& runs, const Workspace& space) {
    return is(runs, space, UndoOfReturn::State::returned);
}
bool can_redo_return(const LastRun& runs, const Workspace& space) {
    return is(runs, space, UndoOfReturn::State::undone);
}

void undo_return(LastRun& runs, Workspace& space) {
    return_to_last_run(runs, space);
    runs.undo.state = UndoOfReturn::State::undone;
}

void redo_return(LastRun& runs, Workspace& space) { return_to_last_run(runs, space); }

std::optional<GhostView> last_run_of(const LastRun& runs, const Workspace& space) {
    const RunPaths& last = runs.last;
    if (!space.view.overlays.last_run || space.together || last.run != space.document.run_id) return std::nullopt;
    const Snapshot& now = space.document.session.snapshot();
    const VehicleView* vehicle = find_vehicle(now, space.view.selection.vehicle);
    const auto found = last.paths.find(space.view.selection.vehicle);
    if (!vehicle || found == last.paths.end()) return std::nullopt;
    return ghost_at(space, found->second, kind_of(now, *vehicle).body);
}

}  // namespace braitenlab
