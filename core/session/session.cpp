#include "core/session/session.h"

#include <algorithm>

#include "core/messages.h"
#include "core/scene/subject.h"
#include "core/session/own_values.h"
#include "core/world/cosmetic_edits.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_edits = 500;  // maximum number of undo steps

using Steps = std::vector<SharedStep>;

// The earlier command of a drag that `later` supersedes, or null. Several objects may be dragged together. Edits in
// place can be exchanged; a command that adds or removes changes indices.
Command* superseded_by(const Command& later, std::vector<Command>& commands) {
    for (auto earlier = commands.rbegin(); earlier != commands.rend(); ++earlier) {
        if (supersedes(later, *earlier)) return &*earlier;
        if (!supersedes(*earlier, *earlier)) return nullptr;
    }
    return nullptr;
}

// True when `back` are the commands that undo all of these, in reverse order: the values are those before the step.
// Ends at the first difference, because a drag of many objects asks after each of its commands.
bool has_no_effect(const UndoStep& step, const Snapshot& now) {
    auto expected = step.back.begin();
    for (auto command = step.again.rbegin(); command != step.again.rend(); ++command)
        for (const Command& one : undoing(now, *command))
            if (expected == step.back.end() || *expected++ != one) return false;
    return expected == step.back.end();
}

void push(Steps& steps, UndoStep step) { steps.push_back(std::make_shared<const UndoStep>(std::move(step))); }

}  // namespace

Session::Session(Scene opened, World at_keyframe, RunObserver observer)
    : opened_(std::move(opened)),
      world_(std::move(at_keyframe)),
      observer_(std::move(observer)),
      recording_(world_.checkpoint()) {
    world_.capture(snapshot_);
    observer_.watch(snapshot_);
    recording_ = Recording(world_.checkpoint(), observer_);
}

Result<Session> Session::open(const Scene& scene, std::uint64_t seed, RunObserver observer) {
    auto world = World::create(scene, seed);
    if (!world) return world.error();
    return Session(scene, std::move(*world), std::move(observer));
}

Session Session::resume(SavedRun run, RunObserver at_keyframe, Edits edits) {
    const Checkpoint& to = run.checkpoint;
    World world = World::restore({to.keyframe, to.keyframe_tick, {}, to.keyframe_tick});
    Session session(std::move(run.opened), std::move(world), std::move(at_keyframe));
    session.recording_ = Recording(to, session.observer_);
    session.restore(to.tick);
    session.edits_ = std::move(edits);
    session.remember_edits();
    return session;
}

std::optional<Error> Session::execute(const Command& command) {
    if (auto error = world_.apply(command)) return error;
    if (!world::is_cosmetic(command)) {
        if (recording_.latest() > world_.tick())
            forgotten_ = Forgotten{world_.tick(), edits_.done.size(), recording_, edits_since_};
        recording_.forget_after(world_.tick());
    }
    world_.capture(snapshot_);
    if (!world::is_cosmetic(command)) observer_.watch(snapshot_, command);
    recording_.add_command(world_, command, observer_);
    return std::nullopt;
}

// Call after each change of edits_, so that seek() can restore undo and redo of each tick.
void Session::remember_edits() {
    const std::uint64_t now = world_.tick();
    std::erase_if(edits_since_, [&](const auto& known) { return known.first == now || known.first > latest(); });
    const auto later =
        std::find_if(edits_since_.begin(), edits_since_.end(), [now](const auto& known) { return known.first > now; });
    edits_since_.emplace(later, now, edits_);
    const auto second = edits_since_.begin() + 1;  // the last entry not after the earliest tick is the first in use
    while (second < edits_since_.end() && second->first <= earliest()) edits_since_.erase(edits_since_.begin());
}

// Removes or adds an undo step at all later ticks, after a cosmetic edit, which keeps the later recorded ticks.
void Session::change_later(const SharedStep& lost, const SharedStep& gained) {
    for (auto& [tick, edits] : edits_since_) {
        if (tick <= world_.tick()) continue;
        std::erase(edits.done, lost);
        if (!gained) continue;
        edits.done.push_back(gained);
        edits.undone.clear();
    }
}

void Session::take_edits_of(std::uint64_t tick) {
    const auto later = std::find_if(edits_since_.begin(), edits_since_.end(),
                                    [tick](const auto& known) { return known.first > tick; });
    edits_ = later == edits_since_.begin() ? Edits{} : (later - 1)->second;
}

std::optional<Error> Session::apply(const Command& command, std::uint64_t gesture) {
    std::vector<Command> back = undoing(snapshot_, command);
    if (auto error = execute(command)) return error;
    if (back.empty()) return std::nullopt;

    const Command again = repeating(snapshot_, command);
    if (const auto* added = std::get_if<AddVehicle>(&again)) back = {RemoveVehicle{added->id}};
    edits_.undone.clear();
    const bool same_gesture = gesture != 0 && !edits_.done.empty() && edits_.done.back()->gesture == gesture;
    const SharedStep begun = same_gesture ? edits_.done.back() : nullptr;
    UndoStep step = begun ? *begun : UndoStep{{}, {}, gesture};
    if (same_gesture) edits_.done.pop_back();
    if (Command* superseded = same_gesture ? superseded_by(again, step.again) : nullptr) {
        *superseded = again;  // `back` stays that of the first command, completed by what only later ones change
        for (Command& further : beyond(step.back, back)) step.back.push_back(std::move(further));
    } else {
        step.again.push_back(again);
        step.back.insert(step.back.begin(), back.begin(), back.end());  // undone in reverse order
    }
    step.tick = snapshot_.tick, step.generation = snapshot_.generation;
    const bool is_back_where_it_began = same_gesture && has_no_effect(step, snapshot_);
    if (!is_back_where_it_began) push(edits_.done, std::move(step));
    change_later(begun, is_back_where_it_began ? nullptr : edits_.done.back());
    if (edits_.done.size() > most_edits) {
        edits_.done.erase(edits_.done.begin());
        if (forgotten_) --forgotten_->edits;
    }
    remember_edits();
    return std::nullopt;
}

bool Session::undo_brings_time_back() const {
    return forgotten_ && forgotten_->tick == world_.tick() && recording_.latest() == world_.tick() &&
           edits_.done.size() == forgotten_->edits + 1;
}

// Restores the world before the edit and the recorded ticks that the edit removed.
void Session::bring_time_back() {
    recording_ = std::move(forgotten_->recording);
    edits_since_ = std::move(forgotten_->edits_since);
    forgotten_.reset();
    restore(world_.tick());
}

namespace {

// Where another vehicle or an obstacle is now at the pose of a vehicle to restore: the nearest free pose.
void put_to_free_poses(const World& world, const Snapshot& now, Command& command) {
    const auto put = [&](AddVehicle& restored) {
        if (restored.at) restored.at = world.nearest_free_pose(restored.kind, *restored.at);
    };
    if (auto* vehicle = std::get_if<AddVehicle>(&command)) put(*vehicle);
    if (auto* population = std::get_if<SetPopulation>(&command))
        for (AddVehicle& vehicle : population->vehicles)
            if (!find_vehicle(now, vehicle.id)) put(vehicle);
}

// The vehicle that a command changes or removes, or no_vehicle.
VehicleId changed_vehicle(const Command& command) {
    return std::visit(
        []<class Of>([[maybe_unused]] const Of& c) {
            if constexpr (requires { c.target.vehicle; }) return c.target.vehicle;
            if constexpr (requires { c.vehicle; }) return c.vehicle;
            return no_vehicle;
        },
        command);
}

}  // namespace

// Executes a command of an undo step, for the vehicles that live.
void Session::execute_part(Command command, UndoResult& result) {
    const VehicleId vehicle = changed_vehicle(command);
    if (vehicle != no_vehicle && !find_vehicle(snapshot_, vehicle)) return;
    if (auto* moves = std::get_if<MoveObjects>(&command))
        std::erase_if(moves->of_vehicles, [&](const MoveVehicle& m) { return !find_vehicle(snapshot_, m.vehicle); });
    auto error = execute(command);
    if (error && !result.error) result.error = std::move(error);
}

UndoResult Session::undo() {
    if (edits_.done.empty()) return {};
    const SharedStep undone = edits_.done.back();
    UndoStep step = *undone;
    for (Command& command : step.again) command = repeating(snapshot_, command);
    const bool brings_time_back = undo_brings_time_back();
    edits_.done.pop_back();
    UndoResult result{true};
    if (brings_time_back) {
        push(edits_.undone, std::move(step));
        bring_time_back();
        return result;
    }
    const bool is_at_the_edit = step.tick == snapshot_.tick && step.generation == snapshot_.generation;
    for (Command command : step.back) {
        if (!is_at_the_edit) put_to_free_poses(world_, snapshot_, command);
        execute_part(command, result);
    }
    push(edits_.undone, std::move(step));
    change_later(undone, nullptr);
    if (forgotten_ && edits_.done.size() <= forgotten_->edits)
        forgotten_.reset();  // the removed ticks do not follow from this state
    remember_edits();
    return result;
}

UndoResult Session::redo() {
    if (edits_.undone.empty()) return {};
    UndoResult result{true};
    UndoStep step = *edits_.undone.back();
    step.gesture = 0;  // a drag that continues is a new step
    edits_.undone.pop_back();
    for (const Command& command : step.again) execute_part(command, result);
    push(edits_.done, std::move(step));
    change_later(nullptr, edits_.done.back());
    remember_edits();
    return result;
}

namespace {

void visit_tick(const World& world, Snapshot& snapshot, const RunVisitor& visitor) {
    if (!visitor.tick) return;
    world.capture(snapshot);
    visitor.tick(snapshot);
}

// Executes the commands recorded since the last keyframe at the world's tick.
void repeat_commands(World& world, const Recording& recording, Snapshot& snapshot, const RunVisitor& visitor) {
    for (const Command& command : recording.commands_at(world.tick())) {
        (void)world.apply(command);
        if (!visitor.command) continue;
        world.capture(snapshot);
        visitor.command(snapshot, command);
    }
}

// Visits the recorded tick of the world and executes its commands.
void repeat_tick(World& world, const Recording& recording, Snapshot& snapshot, const RunVisitor& visitor) {
    visit_tick(world, snapshot, visitor);
    if (const auto made = recording.keyframe_made_by_commands(world.tick())) world = World::restore(*made);
    repeat_commands(world, recording, snapshot, visitor);
}

}  // namespace

// Passes recorded ticks to the observer. At a keyframe it takes the stored one, which has also seen the commands that
// created the keyframe; these are not repeated. Valid while the session is not moved; empty without an observer.
RunVisitor Session::observing() {
    if (!observer_) return {};
    return {[this](const Snapshot& now) {
                if (recording_.keyframe_before(now.tick) == now.tick)
                    observer_ = recording_.observer_at(now.tick);
                else
                    observer_.watch(now);
            },
            [this](const Snapshot& after, const Command& command) {
                if (!world::is_cosmetic(command)) observer_.watch(after, command);
            }};
}

// Repeats recorded ticks.
void Session::repeat_until(std::uint64_t tick) {
    const RunVisitor observer = observing();
    while (world_.tick() < tick) {
        world_.step();
        repeat_tick(world_, recording_, snapshot_, observer);
    }
}

// Goes to a recorded tick from the last keyframe at or before it.
void Session::restore(std::uint64_t tick) {
    world_ = World::restore(recording_.keyframe_at(tick));
    observer_ = recording_.observer_at(tick);
    repeat_commands(world_, recording_, snapshot_, observing());
    repeat_until(tick);
    world_.capture(snapshot_);
}

void Session::replay(std::uint64_t from, const RunVisitor& visitor) const {
    from = std::clamp(from, earliest(), world_.tick());
    World past = World::restore(recording_.keyframe_at(from));
    Snapshot snapshot;
    const RunVisitor none;
    const auto due = [&]() -> const RunVisitor& { return past.tick() >= from ? visitor : none; };
    visit_tick(past, snapshot, due());
    repeat_commands(past, recording_, snapshot, due());
    while (past.tick() < world_.tick()) {
        past.step();
        repeat_tick(past, recording_, snapshot, due());
    }
}

void Session::step() {
    if (world_.tick() < latest()) return seek(world_.tick() + 1);
    world_.step();
    world_.capture(snapshot_);
    observer_.watch(snapshot_);
    forgotten_.reset();
    recording_.add_step(world_, observer_);
}

void Session::seek(std::uint64_t tick) {
    tick = std::clamp(tick, earliest(), latest());
    if (tick < world_.tick() || recording_.keyframe_before(tick) > world_.tick())
        restore(recording_.keyframe_before(tick));
    repeat_until(tick);
    take_edits_of(tick);
    world_.capture(snapshot_);
}

void Session::seek_roughly(std::uint64_t tick) {
    seek(recording_.keyframe_before(std::clamp(tick, earliest(), latest())));
}

void Session::go_to(const Bookmark& bookmark) {
    const std::uint64_t tick = bookmark.tick();
    if (tick >= earliest() && tick <= latest()) {  // a recorded tick: keep the ticks after it
        const Checkpoint recorded = recording_.at(tick);
        const auto same = [](const LoggedCommand& a, const LoggedCommand& b) {
            return a.tick == b.tick && a.command == b.command;
        };
        if (recorded.keyframe == bookmark.checkpoint.keyframe &&
            std::equal(recorded.commands.begin(), recorded.commands.end(), bookmark.checkpoint.commands.begin(),
                       bookmark.checkpoint.commands.end(), same))
            return seek(tick);
    }
    recording_ = Recording(bookmark.checkpoint, bookmark.observer);
    restore(tick);
    forgotten_.reset();
    edits_ = bookmark.edits;
    edits_since_.clear();
    edits_since_.emplace_back(earliest(), edits_);
}

void Session::return_to(const Timeline& run) {
    recording_ = run.recording;
    restore(run.tick);
    forgotten_.reset();
    edits_ = run.edits;
    edits_since_ = run.edits_since;
}

Scene Session::edited_scene() const {
    Scene scene = *snapshot_.scene;
    for (std::size_t k = 0; k < scene.kinds.size(); ++k) scene.kinds[k].brain = *snapshot_.kind_brains[k];
    add_own_values(scene, snapshot_);
    return scene;
}

namespace {

// True if the command edits only what Keep::submission keeps. `now`: before the reset.
bool is_about_submission(const Scene& opened, const Snapshot& now, const Command& command) {
    const int subject = subject_kind(opened);
    if (is_about_brains(command)) return true;
    if (const auto* sensors = std::get_if<SetSensors>(&command)) {
        const VehicleView* vehicle = find_vehicle(now, sensors->target.vehicle);
        return subject >= 0 && (vehicle ? vehicle->kind : sensors->target.kind) == subject;
    }
    const auto* kind = std::get_if<EditKind>(&command);
    return kind && subject >= 0 && kind->kind == subject &&
           differ_in_submission_only(kind->to, opened.kinds[static_cast<std::size_t>(subject)]);
}

}  // namespace

// A new run assigns new vehicle ids: first to vehicles with a start, then to the population. Renumbers undo and redo so
// that they refer to the same vehicles.
std::map<VehicleId, VehicleId> Session::renumber_after_reset(const Snapshot& before, Keep keep) {
    std::map<VehicleId, VehicleId> numbers;
    const auto starts = static_cast<VehicleId>(snapshot_.scene->starts.size());
    auto next = starts;
    const bool as_edited = keep == Keep::edits && !last_reset_error_;
    const std::vector<int> of_population = as_edited ? numbers_in_population(before) : std::vector<int>();
    auto number_of_next = of_population.begin();
    for (const VehicleView& v : before.vehicles) {
        const bool has_start = v.start >= 0 && v.start < starts;
        numbers[v.id] = has_start ? v.start : as_edited ? starts + *number_of_next++ : next;
        next += !has_start;
    }
    const auto number = [&](VehicleId id) {
        const auto [known, is_new] = numbers.try_emplace(id, next);  // a removed vehicle can be added again
        if (is_new) ++next;
        return known->second;
    };
    for (const VehicleView& v : before.vehicles) {
        const BrainGraph& brain = *brain_of(before, v);
        const VehicleId id = number(v.id);
        const VehicleView* now = find_vehicle(snapshot_, id);
        if (!now || now->kind != v.kind) continue;
        const std::vector<Sensor>& sensors = kind_of(before, v).sensors;
        if (v.kind == subject_kind(opened_) && sensors != kind_of(snapshot_, *now).sensors)
            (void)execute(SetSensors{{.vehicle = id}, sensors});
        if (brain != *brain_of(snapshot_, *find_vehicle(snapshot_, id)))
            (void)execute(SetBrain{{.vehicle = id}, brain});
    }
    const auto is_kept = [&](const Command& c) { return is_about_submission(opened_, before, c); };
    const auto renumber = [&](Steps& steps) {
        Steps kept;
        for (const auto& old : steps) {
            UndoStep step{{}, {}, 0};
            for (const Command& c : old->back) step.back.push_back(renumbered(c, number));
            for (const Command& c : old->again) step.again.push_back(renumbered(c, number));
            const bool still_applies =
                keep == Keep::edits || (std::all_of(old->again.begin(), old->again.end(), is_kept) &&
                                        std::all_of(old->back.begin(), old->back.end(), is_kept));
            if (still_applies) push(kept, std::move(step));
        }
        steps = std::move(kept);
    };
    renumber(edits_.done);
    renumber(edits_.undone);
    edits_since_.clear();
    remember_edits();
    return numbers;
}

namespace {

// The kind among `now` that the kind k of `opened` has become; null if there is none.
const Kind* counterpart(const std::vector<Kind>& now, const std::vector<Kind>& opened, std::size_t k) {
    if (now.size() == opened.size()) return &now[k];
    const auto found = std::find_if(now.begin(), now.end(), [&](const Kind& c) { return c.name == opened[k].name; });
    return found == now.end() ? nullptr : &*found;
}

// The opened scene with the submission and the other kinds' brains of the edited one. Kinds may have been added,
// removed or renamed.
Scene with_kept_edits(Scene opened, const Scene& edited) {
    const int subject = subject_kind(opened);
    for (std::size_t k = 0; k < opened.kinds.size(); ++k) {
        const Kind* kind = counterpart(edited.kinds, opened.kinds, k);
        if (!kind) continue;
        opened.kinds[k].brain = kind->brain;
        if (static_cast<int>(k) == subject)
            opened.kinds[k] = with_submission(std::move(opened.kinds[k]), submission_of(*kind));
    }
    return opened;
}

}  // namespace

void Session::reset(Keep keep) { restart(seed(), keep); }

std::map<VehicleId, VehicleId> Session::restart(std::uint64_t seed, Keep keep) {
    Scene scene = edited_scene();
    if (keep == Keep::submission) scene = with_kept_edits(opened_, scene);
    auto world = World::create(scene, seed);
    last_reset_error_.reset();
    if (!world) {  // such as a large brain that was made for fewer vehicles than the opened scene has
        last_reset_error_ = error_of(message_of("reset_as_opened") + message_of(world.error()));
        world = World::create(opened_, seed);
    }
    const Snapshot before = std::move(snapshot_);
    world_ = std::move(*world);
    forgotten_.reset();
    snapshot_ = {};
    world_.capture(snapshot_);
    observer_.watch(snapshot_);
    recording_ = Recording(world_.checkpoint(), observer_);
    return renumber_after_reset(before, keep);
}

}  // namespace braitenlab
