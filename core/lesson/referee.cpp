#include "core/lesson/referee.h"

#include <algorithm>
#include <cmath>

#include "core/io/json.h"
#include "core/match.h"

namespace braitenlab {

namespace {

// Equal but for the colours, which a run does not depend on.
bool same_but_for_colour(Start a, const Start& b) {
    a.colour = b.colour;
    return a == b;
}

bool same_but_for_colours(const std::vector<Start>& a, const std::vector<Start>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_but_for_colour);
}

// The members in the order of their numbers, without the values that vehicles in the world have of their own.
std::vector<Member> members_without_own_values(const Scene& scene) {
    std::vector<Member> members = scene.members;
    for (Member& member : members) member.brain.reset(), member.sensors.reset(), member.driver.reset();
    std::sort(members.begin(), members.end(),
              [](const Member& a, const Member& b) { return number_of(a) < number_of(b); });
    return members;
}

// Equal but for the brain, which a snapshot's scene does not keep up to date, and the colour.
bool same_but_for_brain(Kind a, const Kind& b) {
    a.brain = b.brain, a.colour = b.colour;
    return a == b;
}

bool same_but_for_submission(Kind a, const Kind& b) {
    a.colour = b.colour;
    return differ_in_submission_only(a, b);
}

// The kind whose brain or sensors a command changes, or −1.
int kind_of(const Snapshot& now, const Target& target) {
    if (target.vehicle == no_vehicle) return target.kind;
    const VehicleView* vehicle = find_vehicle(now, target.vehicle);
    return vehicle ? vehicle->kind : -1;
}

// True if the start with this index has no value of its exercise but the colour changed.
bool is_as_given(const Scene& given, const Snapshot& after, int start) {
    const auto index = static_cast<std::size_t>(start);
    return index < given.starts.size() && index < after.scene->starts.size() &&
           same_but_for_colour(after.scene->starts[index], given.starts[index]);
}

// True unless a command changes only what the student may change, or nothing that a run depends on.
bool is_help(const Scene& given, const Snapshot& after, const Command& command) {
    const int subject = subject_kind(given);
    const auto changes_other_kind = [&](int kind) { return subject >= 0 && kind != subject; };
    return std::visit(Match{[&](const TurnDial& c) { return changes_other_kind(kind_of(after, c.target)); },
                            [&](const SetBrain& c) { return changes_other_kind(kind_of(after, c.target)); },
                            [&](const SetSensors& c) { return changes_other_kind(kind_of(after, c.target)); },
                            [&](const EditKind& c) { return changes_other_kind(c.kind); },  // see is_as_given
                            [&](const EditStart& c) { return !is_as_given(given, after, c.start); },
                            [](const PlaceNodes&) { return false; }, [](const SetLook&) { return false; },
                            [](const Steer&) { return false; }, [](const Retitle&) { return false; },
                            [](const auto&) { return true; }},
                      command);
}

// True if the vehicle has the sensors that the exercise gives it.
bool has_given_sensors(const Scene& given, const Snapshot& now, const VehicleView& vehicle) {
    const auto start = static_cast<std::size_t>(vehicle.start);
    const bool is_given = vehicle.start >= 0 && start < given.starts.size() && given.starts[start].sensors;
    if (is_given) return kind_of(now, vehicle).sensors == *given.starts[start].sensors;
    return vehicle.design < 0 || std::any_of(given.members.begin(), given.members.end(), [&](const Member& member) {
               return member.sensors == kind_of(now, vehicle).sensors;
           });
}

// The brain and the driver of a vehicle at the start of a run: those of its start or member, else those of its kind.
struct GivenValues {
    const BrainGraph* brain = nullptr;
    Driver driver = Driver::brain;
};

// `own`: an entry of Scene::starts or Scene::members.
GivenValues with_own_values(GivenValues given, const auto& own) {
    if (own.brain) given.brain = &*own.brain;
    if (own.driver) given.driver = *own.driver;
    return given;
}

GivenValues given_values(const Scene& given, const Snapshot& now, const VehicleView& vehicle) {
    const Kind& kind = given.kinds[static_cast<std::size_t>(vehicle.kind)];
    const GivenValues kind_values{&kind.brain, kind.driver};
    if (vehicle.start >= 0) return with_own_values(kind_values, given.starts[static_cast<std::size_t>(vehicle.start)]);
    const int number = number_in_population(now, vehicle.id);
    for (const Member& member : given.members)
        if (number_of(member) == number) return with_own_values(kind_values, member);
    return kind_values;
}

// See Subjects.
std::size_t subject_count(const Exercise& exercise) { return std::max<std::size_t>(1, exercise.scene.starts.size()); }

// True if each vehicle has the driver that the exercise gives it, and a vehicle of another kind than the subject also
// the brain. Preconditions: tick 0, the scene is as given.
bool vehicles_are_as_given(const Scene& given, const Snapshot& now, int subject) {
    return std::all_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& vehicle) {
        if (static_cast<std::size_t>(vehicle.kind) >= given.kinds.size()) return true;
        const GivenValues values = given_values(given, now, vehicle);
        const bool is_other = subject >= 0 && vehicle.kind != subject;
        return vehicle.driver == values.driver && (!is_other || *brain_of(now, vehicle) == *values.brain);
    });
}

}  // namespace

bool is_as_given(const Exercise& exercise, const Scene& now) {
    const Scene& given = exercise.scene;
    if (now.kinds.size() != given.kinds.size()) return false;
    for (std::size_t k = 0; k < given.kinds.size(); ++k) {
        const bool is_subject = static_cast<int>(k) == subject_kind(given);
        if (!(is_subject ? same_but_for_submission : same_but_for_brain)(now.kinds[k], given.kinds[k])) return false;
    }
    return now.sources == given.sources && now.arena == given.arena && now.ecology == given.ecology &&
           same_but_for_colours(now.starts, given.starts) &&
           members_without_own_values(now) == members_without_own_values(given) && now.obstacles == given.obstacles &&
           now.zones == given.zones;
}

namespace {

// The places of nodes on the canvas do not count.
bool is_given_brain(const BrainGraph& brain, const BrainGraph& given) {
    return brain == given || same_wiring(brain, given);
}

// True if the vehicle has the brain and the sensors of its kind or, edited since, equal ones.
bool has_given_parts(const Snapshot& now, const VehicleView& vehicle, const Kind& given) {
    const auto row = static_cast<std::size_t>(vehicle.brain), kind = static_cast<std::size_t>(vehicle.kind);
    const bool is_of_kind = row >= now.brains.size() || now.brains[row] == now.kind_brains[kind];
    return (is_of_kind || is_given_brain(*now.brains[row], given.brain)) &&
           (vehicle.design < 0 || kind_of(now, vehicle).sensors == given.sensors);
}

}  // namespace

Referee::Comparison::Comparison(const Exercise& exercise, const Snapshot& now)
    : scene(now.scene), brains(now.kind_brains) {
    const Scene& given = exercise.scene;
    subject = subject_kind(given);
    is_given = is_as_given(exercise, *scene);
    has_every_part = brains.size() >= given.kinds.size() && scene->kinds.size() >= given.kinds.size();
    for (std::size_t k = 0; k < std::min(given.kinds.size(), brains.size()); ++k) {
        const bool has_brain = is_given_brain(*brains[k], given.kinds[k].brain);
        if (static_cast<int>(k) != subject) is_given = is_given && has_brain;
        has_every_part = has_every_part && has_brain && scene->kinds[k].body == given.kinds[k].body &&
                         scene->kinds[k].sensors == given.kinds[k].sensors;
    }
}

Referee::Referee(const Exercise& exercise) : exercise_(std::make_shared<const Exercise>(exercise)) {
    for (const Step& step : exercise.steps) state_.steps.push_back({initial_state(step.check)});
}

void Referee::begin(const Snapshot& now) {
    const std::vector<Start>& starts = exercise_->scene.starts;
    state_ = {};
    state_.begun = true;
    for (const Step& step : exercise_->steps) state_.steps.push_back({initial_state(step.check)});
    state_.subjects.assign(subject_count(*exercise_), no_vehicle);
    for (const VehicleView& vehicle : now.vehicles)
        if (vehicle.start >= 0 && static_cast<std::size_t>(vehicle.start) < starts.size())
            state_.subjects[static_cast<std::size_t>(vehicle.start)] = vehicle.id;
    if (starts.empty() && !now.vehicles.empty()) state_.subjects.front() = now.vehicles.front().id;
}

void Referee::watch(const Snapshot& now) {
    const bool is_new_run = !state_.begun || now.tick == 0 || now.tick < state_.tick;
    if (!is_new_run && now.tick == state_.tick) return;
    const bool missed_start = !state_.begun && now.tick > 0;
    if (is_new_run) begin(now);
    if (missed_start) state_.disturbed = true;
    state_.tick = now.tick;
    note_changes(now);
    state_.was_changed = now.tick > 0 && state_.changed;
    const Subjects subjects{exercise_->scene.starts, state_.subjects};
    const bool is_given = is_undisturbed(now);
    if (now.tick > 0 && (!is_given || state_.by_hand)) state_.disturbed = true;  // before, it can be put right
    state_.by_hand = state_.disturbed || !is_given;
    if (state_.by_hand) return;
    done_.resize(state_.steps.size());
    for (std::size_t i = 0; i < done_.size(); ++i) done_[i] = state_.steps[i].done;
    const CheckedTick tick{now, subjects, reference_at(now), done_};
    const bool is_over = now.seconds > static_cast<double>(exercise_->seconds);
    for (std::size_t i = 0; i < state_.steps.size(); ++i) {
        RefereeState::Judged& step = state_.steps[i];
        if (!step.done && !(is_over && step.check.lost))
            step.done = update(exercise_->steps[i].check, step.check, tick);
    }
}

// Null unless a step needs the reference.
const ReferencePath* Referee::reference_at(const Snapshot& now) {
    const auto needs = [](const Step& step) { return needs_reference(step.check); };
    if (std::none_of(exercise_->steps.begin(), exercise_->steps.end(), needs)) return nullptr;
    if (!reference_ || reference_->seed() != now.seed) reference_ = std::make_shared<Reference>(*exercise_, now.seed);
    return &reference_->until(now.tick);
}

void Referee::watch(const Snapshot& after, const Command& command) {
    if (after.tick > 0 && is_help(exercise_->scene, after, command)) state_.disturbed = state_.by_hand = true;
    watch(after);
    note_changes(after);
}

const Referee::Comparison& Referee::compared(const Snapshot& now) {
    if (comparison_.scene != now.scene || comparison_.brains != now.kind_brains) comparison_ = {*exercise_, now};
    return comparison_;
}

void Referee::note_changes(const Snapshot& now) {
    if (state_.was_changed) return;
    const std::vector<Kind>& given = exercise_->scene.kinds;
    const auto has_given_values = [&](const VehicleView& vehicle) {
        const auto kind = static_cast<std::size_t>(vehicle.kind);
        return kind >= given.size() || has_given_parts(now, vehicle, given[kind]);
    };
    state_.changed =
        !compared(now).has_every_part || !std::all_of(now.vehicles.begin(), now.vehicles.end(), has_given_values);
}

// The scene, the brains and sensors of other kinds, and who drives. After the first tick, commands for single vehicles
// are detected by is_help().
bool Referee::is_undisturbed(const Snapshot& now) {
    const Scene& given = exercise_->scene;
    const Comparison& comparison = compared(now);
    if (!comparison.is_given) return false;
    for (const VehicleView& vehicle : now.vehicles)
        if (comparison.subject >= 0 && vehicle.kind != comparison.subject && !has_given_sensors(given, now, vehicle))
            return false;
    for (std::size_t i = 0; i < std::min(given.starts.size(), state_.subjects.size()); ++i) {
        const VehicleView* vehicle = find_vehicle(now, state_.subjects[i]);
        if (!vehicle || static_cast<std::size_t>(vehicle->kind) >= given.kinds.size()) continue;
        const Driver of_kind = given.kinds[static_cast<std::size_t>(vehicle->kind)].driver;
        if (vehicle->driver != given.starts[i].driver.value_or(of_kind)) return false;
    }
    return now.tick > 0 || (now.generation == 1 && vehicles_are_as_given(given, now, comparison.subject));
}

std::vector<Verdict> Referee::verdicts() const {
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < state_.steps.size(); ++i)
        verdicts.push_back({state_.steps[i].done, measures(exercise_->steps[i].check, state_.steps[i].check),
                            !state_.steps[i].done && state_.steps[i].check.lost});
    return verdicts;
}

bool Referee::passed() const {
    return std::all_of(state_.steps.begin(), state_.steps.end(), [](const auto& step) { return step.done; });
}

bool Referee::lost() const {
    return std::any_of(state_.steps.begin(), state_.steps.end(),
                       [](const auto& step) { return !step.done && step.check.lost; });
}

namespace {

Json state_json(const CheckState& state) {
    Json json{{"met_since", state.met_since}, {"held", state.held}, {"lost", state.lost}};
    if (std::isfinite(state.value)) json["value"] = state.value;
    std::visit(
        [&]<class Own>(const Own& own) {
            Json& goal = json["goal"] = Json::object();
            if constexpr (requires { own.checks; }) {
                goal = Json::array();
                for (const CheckState& each : own.checks) goal.push_back(state_json(each));
            } else {
                visit_values(io::JsonWriter{goal}, own, Of<Own>{});
            }
        },
        state.goal);
    return json;
}

// `state` has the shape of its check. Throws Json::exception when the JSON has not.
void read_state(const Json& json, CheckState& state) {
    json.at("met_since").get_to(state.met_since);
    json.at("held").get_to(state.held);
    state.lost = json.value("lost", false);
    if (json.contains("value")) json.at("value").get_to(state.value);
    const Json& goal = json.at("goal");
    std::visit(
        [&]<class Own>(Own& own) {
            if constexpr (requires { own.checks; }) {
                for (std::size_t i = 0; i < own.checks.size(); ++i) read_state(goal.at(i), own.checks[i]);
            } else {
                visit_values(io::JsonReader{goal}, own, Of<Own>{});
            }
        },
        state.goal);
}

void visit_run_values(auto members, auto& state) {
    members.value("tick", state.tick), members.value("begun", state.begun);
    members.value("disturbed", state.disturbed), members.value("by_hand", state.by_hand);
    members.value("changed", state.changed), members.value("was_changed", state.was_changed);
    members.value("subjects", state.subjects);
}

}  // namespace

std::string write_referee_state(const RefereeState& state) {
    Json json{{"steps", Json::array()}};
    visit_run_values(io::JsonWriter{json}, state);
    for (const RefereeState::Judged& step : state.steps) {
        Json& judged = json["steps"].emplace_back(state_json(step.check));
        judged["done"] = step.done;
    }
    return io::json_text(json);
}

std::optional<RefereeState> read_referee_state(std::string_view text, const Exercise& exercise) {
    RefereeState state = Referee(exercise).state();
    try {
        const Json json = Json::parse(text);
        visit_run_values(io::JsonReader{json}, state);
        if (state.begun && state.subjects.size() != subject_count(exercise)) return std::nullopt;
        const Json& steps = json.at("steps");
        if (steps.size() != state.steps.size()) return std::nullopt;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            read_state(steps[i], state.steps[i].check);
            steps[i].at("done").get_to(state.steps[i].done);
        }
    } catch (const Json::exception&) {
        return std::nullopt;
    }
    return state;
}

}  // namespace braitenlab
