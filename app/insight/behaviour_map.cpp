#include "app/insight/behaviour_map.h"

#include <algorithm>
#include <utility>

#include "app/lab.h"
#include "app/lab_selection.h"

namespace braitenlab {

namespace {

using insight::MapAxis;
using insight::MapBase;
using insight::MapCell;
using insight::MapPlace;

constexpr std::size_t cells_per_job = 128;
constexpr std::size_t ticks_per_step = 300;  // about half a millisecond with one vehicle

// The cell of a map as a part of a job.
class CellPiece {
public:
    CellPiece(std::shared_ptr<const MapBase> base, MapPlace place) : base_(std::move(base)), place_(place) {}
    std::optional<MapCell> operator()() {
        if (!run_) run_.emplace(base_, place_, static_cast<int>(runs_.size()));
        if (!run_->advance(ticks_per_step)) return std::nullopt;
        runs_.push_back(run_->outcome());
        run_.reset();
        if (static_cast<int>(runs_.size()) < base_->question().seeds) return std::nullopt;
        return insight::cell_of(runs_);
    }

private:
    std::shared_ptr<const MapBase> base_;
    MapPlace place_;
    std::vector<insight::Outcome> runs_;
    std::optional<insight::MapRun> run_;
};

class PathOfCell {
public:
    PathOfCell(const std::shared_ptr<const MapBase>& base, MapPlace place) : run_(base, place, 0) {}
    std::optional<insight::Path> operator()() {
        if (!run_.advance(ticks_per_step)) return std::nullopt;
        return run_.path();
    }

private:
    insight::MapRun run_;
};

void forget_map(BehaviourMap& map) {
    map.subject.reset();
    map.base.reset();
    map.jobs.clear(), map.path_job.reset();
    map.path_of.reset();
    map.cells = insight::MapCells();
    map.order.clear();
    map.begun = map.known = 0;
    map.edits = -1;
}

// Sets the dials of the axes to 0 wherever the target's brain is.
void clear_axes(MapSubject& subject, const Snapshot& now, const VehicleView& vehicle) {
    const auto clear = [&](BrainGraph& brain) {
        for (const MapAxis* axis : {&subject.x, &subject.y})
            for (const Dial dial : axis->dials) turn(brain, dial, 0, subject.pair);
    };
    const std::string& kind = now.scene->kinds[static_cast<std::size_t>(vehicle.kind)].name;
    if (subject.target.vehicle == no_vehicle) clear(subject.scene.kinds[static_cast<std::size_t>(vehicle.kind)].brain);
    for (std::size_t i = 0; i < subject.scene.starts.size(); ++i) {
        Start& start = subject.scene.starts[i];
        const bool is_meant =
            subject.target.vehicle == no_vehicle ? start.kind == kind : static_cast<int>(i) == vehicle.start;
        if (is_meant && start.brain) clear(*start.brain);
    }
    for (Member& member : subject.scene.members) {
        const bool is_meant = subject.target.vehicle == no_vehicle ||
                              (vehicle.start < 0 && number_of(member) == number_in_population(now, vehicle.id));
        if (is_meant && member.brain) clear(*member.brain);
    }
}

MapSubject map_subject(const Lab& lab, const LabView& view, const VehicleView& vehicle, const Scene& scene) {
    const BehaviourMap& map = lab.map;
    const Snapshot& now = lab.document.session.snapshot();
    MapSubject subject{.scene = scene,
                       .seed = lab.document.session.seed(),
                       .run = lab.document.run_id,
                       .target = target_of(view, vehicle),
                       .pair = shown_pair(view, vehicle),
                       .x = *insight::axis_of(map.x),
                       .y = *insight::axis_of(map.y),
                       .seeds = map.seeds};
    subject.vehicle = id_at_start(scene, subject.seed, now, vehicle);
    if (subject.target.vehicle != no_vehicle) subject.target.vehicle = subject.vehicle;
    clear_axes(subject, now, vehicle);
    return subject;
}

void begin_map(BehaviourMap& map, MapSubject subject, const Scene& scene) {
    forget_map(map);
    auto base = MapBase::create({.scene = scene,
                                 .seed = subject.seed,
                                 .seeds = subject.seeds,
                                 .vehicle = subject.vehicle,
                                 .target = subject.target,
                                 .pair = subject.pair,
                                 .x = subject.x,
                                 .y = subject.y});
    map.subject = std::move(subject);
    if (!base) return;
    map.base = *base;
    map.cells = insight::MapCells(map.base->question().size);
    for (const auto& level : insight::map_levels(map.cells.size))
        map.order.insert(map.order.end(), level.begin(), level.end());
}

// Compares the scene only after an edit or another choice.
void follow_subject(Lab& lab, const LabView& view, const VehicleView& vehicle) {
    BehaviourMap& map = lab.map;
    const std::string choice = map.x + " " + map.y + " " + std::to_string(map.seeds) + " " +
                               std::to_string(view.settings.selection.whole_kind) + view.settings.selection.pair;
    if (map.subject && map.edits == lab.document.edits && map.compared_run == lab.document.run_id &&
        map.compared_vehicle == vehicle.id && map.compared_choice == choice &&
        map.subject->seed == lab.document.session.seed())
        return;
    const Scene scene = lab.document.session.edited_scene();
    MapSubject now = map_subject(lab, view, vehicle, scene);
    if (!map.subject || *map.subject != now) begin_map(map, std::move(now), scene);
    map.edits = lab.document.edits, map.compared_run = lab.document.run_id;
    map.compared_vehicle = vehicle.id, map.compared_choice = choice;
}

void take_cells(BehaviourMap& map) {
    while (!map.jobs.empty()) {
        const auto done = map.jobs.front().take();
        if (!done) return;
        map.jobs.pop_front();
        if (!*done) return forget_map(map);
        for (const MapCell& cell : **done) map.cells.at(map.order[map.known++]) = cell;
    }
}

// The first job is the coarse map alone.
void submit_cells(BehaviourMap& map, Jobs& jobs) {
    if (map.jobs.size() > 1 || !map.base || map.begun == map.order.size()) return;
    const std::size_t coarse = insight::map_levels(map.cells.size).front().size();
    const std::size_t count = std::min(map.begun == 0 ? coarse : cells_per_job, map.order.size() - map.begun);
    const auto first = map.order.begin() + static_cast<std::ptrdiff_t>(map.begun);
    const std::vector<MapPlace> places(first, first + static_cast<std::ptrdiff_t>(count));
    map.jobs.push_back(
        jobs.submit(count, [base = map.base, places](std::size_t part) { return CellPiece(base, places[part]); }));
    map.begun += count;
}

void follow_path(BehaviourMap& map, Jobs& jobs) {
    if (map.path_job)
        if (auto done = map.path_job->take()) {
            map.path_job.reset();
            if (*done) map.path = std::move(**done);
        }
    if (map.path_of == map.hovered) return;
    map.path_job.reset();
    map.path.clear();
    map.path_of = map.hovered;
    if (map.hovered && map.base)
        map.path_job = jobs.submit(
            1, [base = map.base, place = *map.hovered](std::size_t) { return PathOfCell(base, place); },
            [](std::vector<insight::Path> paths) { return std::move(paths.front()); });
}

}  // namespace

void update_map(Lab& lab, Jobs& jobs) {
    BehaviourMap& map = lab.map;
    const VehicleView* vehicle = selected_vehicle(lab);
    const LabView view = view_of(lab);
    if (!lab.view.map || !vehicle || lab.together || !can_show_map(view, *vehicle)) return forget_map(map);
    follow_subject(lab, view, *vehicle);
    take_cells(map);
    submit_cells(map, jobs);
    follow_path(map, jobs);
}

void choose_map(BehaviourMap& map, const MapRequest& wanted) {
    if (wanted.measure) map.measure = *wanted.measure;
    if (wanted.seeds) map.seeds = std::clamp(*wanted.seeds, 1, insight::limits::map_seeds);
    const auto exchange = [](std::string& axis, std::string& other, const std::string& path) {
        const auto now = insight::axis_of(path);
        if (!now) return;
        const std::string before = std::exchange(axis, path);
        if (!insight::have_common_value(*now, *insight::axis_of(other))) return;
        const auto is_free = [&](const std::string& each) {
            return !insight::have_common_value(*now, *insight::axis_of(each));
        };
        other = before;
        for (const char* each : insight::brain_axes)
            if (!is_free(other)) other = each;
    };
    if (wanted.x) exchange(map.x, map.y, *wanted.x);
    if (wanted.y) exchange(map.y, map.x, *wanted.y);
}

bool is_computing(const BehaviourMap& map) { return !map.jobs.empty() || map.path_job; }

std::optional<MapView> map_of(const Lab& lab, const LabView& view) {
    const BehaviourMap& map = lab.map;
    const VehicleView* vehicle = selected_vehicle(lab);
    if (!lab.view.map || !map.base || !vehicle || lab.together || !can_show_map(view, *vehicle)) return std::nullopt;
    MapView shown{.cells = &map.cells,
                  .x = map.subject->x,
                  .y = map.subject->y,
                  .measure = map.measure,
                  .seeds = map.seeds,
                  .progress = static_cast<float>(map.known) / static_cast<float>(map.order.size()),
                  .hovered = map.path_of};
    if (map.path_of && !map.path.empty()) shown.path = &map.path;
    return shown;
}

}  // namespace braitenlab
