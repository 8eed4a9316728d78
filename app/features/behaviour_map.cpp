#include "app/features/behaviour_map.h"

#include <algorithm>
#include <cmath>

#include "app/course/lesson_view.h"
#include "app/jobs/in_pieces.h"
#include "app/lab_selection.h"
#include "app/workspace.h"
#include "core/scene/scene_number.h"

namespace braitenlab {

namespace {

using insight::AxisValue;
using insight::MapAxis;
using insight::MapBase;
using insight::MapCell;
using insight::MapPlace;

constexpr std::size_t cells_per_job = 128;
constexpr std::size_t ticks_per_step = 300;  // about half a millisecond with one vehicle

// The cell of a map as a part of a job: it is shown before the other parts are complete.
class CellPiece {
public:
    CellPiece(std::shared_ptr<const MapBase> base, std::shared_ptr<NewCells> cells, MapPlace place)
        : base_(std::move(base)), cells_(std::move(cells)), place_(place) {}
    std::optional<bool> operator()() {
        if (!run_) run_.emplace(base_, place_, static_cast<int>(runs_.size()));
        if (!run_->advance(ticks_per_step)) return std::nullopt;
        runs_.push_back(run_->outcome());
        run_.reset();
        if (static_cast<int>(runs_.size()) < base_->question().seeds) return std::nullopt;
        cells_->add(place_, insight::cell_of(runs_));
        return true;
    }
    float progress() const {
        return (static_cast<float>(runs_.size()) + (run_ ? run_->progress() : 0)) /
               static_cast<float>(base_->question().seeds);
    }

private:
    std::shared_ptr<const MapBase> base_;
    std::shared_ptr<NewCells> cells_;
    MapPlace place_;
    std::vector<insight::Outcome> runs_;
    std::optional<insight::MapRun> run_;
};

void forget_map(BehaviourMap& map) {
    map.subject.reset();
    map.base.reset(), map.new_cells.reset();
    map.jobs.clear(), map.path.forget();
    map.cells = insight::MapCells();
    map.order.clear();
    map.begun = map.known = 0;
    map.compared.reset();
}

// Sets the values of the axes to 0, dials wherever the target's brain is.
void clear_axes(MapSubject& subject, const Snapshot& now, const VehicleView& vehicle) {
    const auto clear = [&](BrainGraph& brain) {
        for (const MapAxis* axis : {&subject.x, &subject.y})
            for (const Dial dial : axis->dials) turn(brain, dial, 0, subject.pair);
    };
    for (const MapAxis* axis : {&subject.x, &subject.y})
        for (const std::string& path : axis->values)
            set_number_at(subject.scene, std::string_view(path).substr(path.front() == '-' ? 1 : 0), 0);
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

insight::ValueSubject subject_of(const Workspace& space, const VehicleView& vehicle) {
    const Snapshot& now = space.document.session.snapshot();
    const Selection& selection = space.view.selection;
    return {now, vehicle, target_of(selection, vehicle), chosen_pair(kind_of(now, vehicle), selection.pair)};
}

MapChoice usual(const AxisValue& value) { return {value.id, value.from, value.to}; }

// Axes whose values this vehicle or this scene does not have are those of a new lab. Another document has its own
// ranges.
void keep_axes(BehaviourMap& map, const std::vector<AxisValue>& values, bool is_new_document) {
    const AxisValue *x = find_value(values, map.x.id), *y = find_value(values, map.y.id);
    if (!x || !y)
        map.x = BehaviourMap().x, map.y = BehaviourMap().y;
    else if (is_new_document)
        map.x = usual(*x), map.y = usual(*y);
}

MapSubject map_subject(const BehaviourMap& map, const Workspace& space, const insight::ValueSubject& values,
                       const std::vector<AxisValue>& offered, Scene& scene) {
    const auto axis = [&](const MapChoice& choice) {
        return insight::axis_of(*find_value(offered, choice.id), choice.from, choice.to);
    };
    const bool has_sensors = find_value(offered, map.x.id)->owner == insight::ValueOwner::sensors ||
                             find_value(offered, map.y.id)->owner == insight::ValueOwner::sensors;
    if (has_sensors) place_sensors(scene, values);
    MapSubject subject{.scene = scene,
                       .seed = space.document.session.seed(),
                       .run = space.document.run_id,
                       .target = values.target,
                       .pair = values.pair,
                       .x = axis(map.x),
                       .y = axis(map.y),
                       .seeds = map.seeds};
    subject.vehicle = id_at_start(scene, subject.seed, values.now, values.vehicle);
    if (subject.target.vehicle != no_vehicle) subject.target.vehicle = subject.vehicle;
    clear_axes(subject, values.now, values.vehicle);
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
    map.new_cells = std::make_shared<NewCells>();
    map.cells = insight::MapCells(map.base->question().size);
    for (const auto& level : insight::map_levels(map.cells.size))
        map.order.insert(map.order.end(), level.begin(), level.end());
}

MapKey key_of(const BehaviourMap& map, const Workspace& space, const VehicleView& vehicle) {
    const Selection& selection = space.view.selection;
    return {space.document.edits,
            space.document.run_id,
            space.document.session.seed(),
            vehicle.id,
            selection.whole_kind,
            selection.pair,
            map.x,
            map.y,
            map.seeds};
}

// Compares the scene only after an edit or another choice.
void follow_subject(BehaviourMap& map, const Workspace& space, const VehicleView& vehicle) {
    if (map.subject && map.compared == key_of(map, space, vehicle)) return;
    const insight::ValueSubject values = subject_of(space, vehicle);
    const std::vector<AxisValue> offered = axis_values(values);
    keep_axes(map, offered, std::exchange(map.run, space.document.run_id) != space.document.run_id);
    Scene scene = space.document.session.edited_scene();
    MapSubject now = map_subject(map, space, values, offered, scene);
    if (!map.subject || *map.subject != now) begin_map(map, std::move(now), scene);
    map.compared = key_of(map, space, vehicle);
}

void take_cells(BehaviourMap& map) {
    if (!map.new_cells) return;
    for (const auto& [place, cell] : map.new_cells->take()) map.cells.at(place) = cell, ++map.known;
    while (!map.jobs.empty()) {
        const auto done = map.jobs.front().take();
        if (!done) return;
        map.jobs.pop_front();
        if (!*done) return forget_map(map);
    }
}

// The first job is the coarse map alone, before all others.
void submit_cells(BehaviourMap& map, Jobs& jobs) {
    while (map.base && map.jobs.size() < jobs_at_once && map.begun < map.order.size()) {
        const std::size_t coarse = insight::map_levels(map.cells.size).front().size();
        const std::size_t wanted = map.begun == 0 ? coarse : parts_of_next_job(map.jobs.size(), cells_per_job);
        const std::size_t count = std::min(wanted, map.order.size() - map.begun);
        const auto first = map.order.begin() + static_cast<std::ptrdiff_t>(map.begun);
        const std::vector<MapPlace> places(first, first + static_cast<std::ptrdiff_t>(count));
        const auto begin = [base = map.base, cells = map.new_cells, places](std::size_t part) {
            return CellPiece(base, cells, places[part]);
        };
        const auto all = [](const std::vector<bool>&) { return true; };
        map.jobs.push_back(map.begun == 0 ? jobs.submit_first(count, begin, all) : jobs.submit(count, begin, all));
        map.begun += count;
    }
}

void follow_path(BehaviourMap& map, Jobs& jobs) {
    if (!map.hovered || !map.base) return map.path.forget();
    if (!map.path.is_about(*map.hovered)) map.path.forget(), map.path.ask(*map.hovered);
    map.path.follow([&](MapPlace place) {
        return jobs.submit(InPieces(insight::MapRun(map.base, place, 0), ticks_per_step, &insight::MapRun::path));
    });
}

bool have_common_value(const AxisValue& a, const AxisValue& b) {
    return insight::have_common_value(axis_of(a, 0, 1), axis_of(b, 0, 1));
}

// The axis shows the value of this id, and the other one that of the axis if it has a part of it.
void exchange_axes(MapChoice& axis, MapChoice& other, const std::string& id, const std::vector<AxisValue>& values) {
    const AxisValue* chosen = find_value(values, id);
    const AxisValue* theirs = find_value(values, other.id);
    if (!chosen || !theirs) return;
    const MapChoice before = std::exchange(axis, usual(*chosen));
    if (!have_common_value(*chosen, *theirs)) return;
    other = before;
    for (const AxisValue& each : values)
        if (const AxisValue* now = find_value(values, other.id); !now || have_common_value(*chosen, *now))
            other = usual(each);
}

// Two different ends within the range of the value.
void set_range(MapChoice& axis, const MapRange& range, const std::vector<AxisValue>& values) {
    const AxisValue* value = find_value(values, axis.id);
    if (!value) return;
    const auto low = static_cast<float>(value->allowed.low), high = static_cast<float>(value->allowed.high);
    const float from = std::clamp(range.from, low, high), to = std::clamp(range.to, low, high);
    if (std::isfinite(from) && std::isfinite(to) && from != to) axis.from = from, axis.to = to;
}

// With the runs that are not complete; 1 only once every cell is known.
float progress_of(const BehaviourMap& map) {
    if (map.known == map.order.size()) return 1;
    auto cells = static_cast<float>(map.known);
    for (const auto& job : map.jobs) {
        const JobProgress of = job.progress();
        cells += std::max(0.0f, of.fraction * static_cast<float>(of.parts) - static_cast<float>(of.done));
    }
    return std::min(cells / static_cast<float>(map.order.size()), 0.999f);
}

}  // namespace

void NewCells::add(insight::MapPlace place, insight::MapCell cell) {
    const std::scoped_lock lock(mutex_);
    cells_.emplace_back(place, cell);
}

std::vector<std::pair<insight::MapPlace, insight::MapCell>> NewCells::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(cells_, {});
}

std::string_view why_no_map(const Workspace& space) {
    const VehicleView* vehicle = selected_vehicle(space);
    return why_no_map(vehicle, disclosure_of(space), vehicle && is_secret(space, vehicle->kind), space.view.revealed,
                      space.pages ? &*space.pages : nullptr);
}

void update_map(BehaviourMap& map, const Workspace& space, Jobs& jobs) {
    if (!space.view.map || space.together || !why_no_map(space).empty()) return forget_map(map);
    follow_subject(map, space, *selected_vehicle(space));
    take_cells(map);
    submit_cells(map, jobs);
    follow_path(map, jobs);
}

void choose_map(BehaviourMap& map, const Workspace& space, const MapRequest& wanted) {
    if (wanted.measure) map.measure = *wanted.measure;
    if (wanted.seeds) map.seeds = std::clamp(*wanted.seeds, 1, insight::limits::map_seeds);
    const VehicleView* vehicle = selected_vehicle(space);
    if (!vehicle) return;
    const std::vector<AxisValue> values = axis_values(subject_of(space, *vehicle));
    if (wanted.x) exchange_axes(map.x, map.y, *wanted.x, values);
    if (wanted.y) exchange_axes(map.y, map.x, *wanted.y, values);
    if (wanted.x_range) set_range(map.x, *wanted.x_range, values);
    if (wanted.y_range) set_range(map.y, *wanted.y_range, values);
}

bool is_computing(const BehaviourMap& map) { return !map.jobs.empty() || map.path.is_computing(); }

std::optional<MapView> map_of(const BehaviourMap& map, const Workspace& space) {
    if (!space.view.map || !map.base || space.together || !why_no_map(space).empty()) return std::nullopt;
    MapView shown{.cells = &map.cells,
                  .x = map.subject->x,
                  .y = map.subject->y,
                  .measure = map.measure,
                  .seeds = map.seeds,
                  .progress = progress_of(map),
                  .path = map.path.answer()};
    if (map.path.question()) shown.hovered = *map.path.question();
    return shown;
}

}  // namespace braitenlab
