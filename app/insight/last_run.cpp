#include "app/insight/last_run.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "app/course/lab_lesson.h"
#include "app/course/reference_runs.h"
#include "app/lab.h"
#include "app/lab_selection.h"
#include "app/playback.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_vehicles = 16, most_poses = 36000;  // 7 MB
constexpr std::size_t least_poses = 30;

}  // namespace

void record_paths(Lab& lab) {
    const Session& session = lab.document.session;
    const Snapshot& now = session.snapshot();
    RunPaths& present = lab.last_run.present;
    const bool is_new = session.latest() == now.tick;  // else a recorded tick is repeated
    if (is_new && (present.run != lab.document.run_id || now.tick == 0)) present = {lab.document.run_id, {}};
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

namespace {

// Paths long enough to be shown, by the ids in another run.
RunPaths renumbered(RunPaths paths, const std::map<VehicleId, VehicleId>& ids) {
    RunPaths shown{paths.run, {}};
    for (auto& [id, path] : paths.paths)
        if (const auto found = ids.find(id); found != ids.end() && path.size() >= least_poses)
            shown.paths[found->second] = std::move(path);
    return shown;
}

UndoOfReturn undo_of(const Lab& lab, UndoOfReturn::State state) {
    return {state, lab.document.edits, lab.document.session.latest()};
}

bool is(const Lab& lab, UndoOfReturn::State state) {
    const UndoOfReturn now = undo_of(lab, state), &then = lab.last_run.undo;
    return has_left_run(lab) && then.state == state && then.edits == now.edits && then.latest == now.latest;
}

}  // namespace

const ReferencePath* path_of_selected(const Lab& lab) {
    const RunPaths& present = lab.last_run.present;
    const auto found = present.paths.find(lab.view.selection.vehicle);
    return present.run == lab.document.run_id && !lab.together && found != present.paths.end() ? &found->second
                                                                                               : nullptr;
}

LeftRun present_run(const Lab& lab) {
    LeftRun run{.run = lab.document.run_id, .timeline = lab.document.session.timeline(), .paths = lab.last_run.present};
    if (run.paths.run != run.run) run.paths = {run.run, {}};
    if (const auto& lesson = lab.document.lesson) run.path = lesson->path;
    return run;
}

void keep_run(Lab& lab, LeftRun ended, const std::map<VehicleId, VehicleId>& new_ids) {
    LastRun& runs = lab.last_run;
    runs.present = {lab.document.run_id, {}};
    runs.undo = {};
    if (RunPaths paths = renumbered(ended.paths, new_ids); !paths.paths.empty()) runs.last = std::move(paths);
    if (ended.timeline.recording.latest() + 1 < least_poses) return;
    ended.new_ids = new_ids;
    runs.left = std::move(ended);
}

namespace {

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

LeftRun run_before_start_over(Lab& lab) {
    record_paths(lab);
    LeftRun run = present_run(lab);
    run.lesson = lesson_before(*lab.document.lesson);
    return run;
}

void keep_for_undo(Lab& lab, LeftRun run) {
    for (const VehicleView& vehicle : lab.document.session.snapshot().vehicles) run.new_ids[vehicle.id] = vehicle.id;
    lab.last_run.left = std::move(run);
    lab.last_run.undo = undo_of(lab, UndoOfReturn::State::returned);
}

bool has_left_run(const Lab& lab) { return lab.last_run.left && lab.last_run.left->run == lab.document.run_id; }

void return_to_last_run(Lab& lab) {
    if (!has_left_run(lab)) return say(lab, {NoticeKind::failure, "unavailable.no_last_run"});
    LastRun& runs = lab.last_run;
    set_mode(lab, Mode::paused);
    record_paths(lab);
    LeftRun now = present_run(lab), then = std::move(*runs.left);
    std::map<VehicleId, VehicleId> old_ids;
    for (const auto& [old_id, new_id] : then.new_ids) old_ids[new_id] = old_id;
    lab.document.session.return_to(then.timeline);
    if (auto& lesson = lab.document.lesson) {
        lesson->path = std::move(then.path);
        if (then.lesson) {
            now.lesson = lesson_before(*lesson);
            give_back(*lesson, std::move(*then.lesson), lab.document.session.seed());
        }
    }
    runs.present = std::move(then.paths);
    if (RunPaths paths = renumbered(now.paths, old_ids); !paths.paths.empty()) runs.last = std::move(paths);
    renumber_selection(lab.view.selection, old_ids);
    now.new_ids = std::move(old_ids);
    runs.left = std::move(now);
    ++lab.document.edits;
    runs.undo = undo_of(lab, UndoOfReturn::State::returned);
    lab.steered = {};
    lab.playback.previous.clear();
    lab.playback.debt = 0;
    keep_selection(lab);
    watch(lab);
    say(lab, {NoticeKind::done, "notice.returned"});
}

bool can_undo_return(const Lab& lab) { return is(lab, UndoOfReturn::State::returned); }
bool can_redo_return(const Lab& lab) { return is(lab, UndoOfReturn::State::undone); }

void undo_return(Lab& lab) {
    return_to_last_run(lab);
    lab.last_run.undo.state = UndoOfReturn::State::undone;
}

void redo_return(Lab& lab) { return_to_last_run(lab); }

std::optional<GhostView> last_run_of(const Lab& lab) {
    const RunPaths& last = lab.last_run.last;
    if (!lab.view.overlays.last_run || lab.together || last.run != lab.document.run_id) return std::nullopt;
    const Snapshot& now = lab.document.session.snapshot();
    const VehicleView* vehicle = find_vehicle(now, lab.view.selection.vehicle);
    const auto found = last.paths.find(lab.view.selection.vehicle);
    if (!vehicle || found == last.paths.end()) return std::nullopt;
    return ghost_at(lab, found->second, kind_of(now, *vehicle).body);
}

}  // namespace braitenlab
