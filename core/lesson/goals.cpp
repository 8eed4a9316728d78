#include "core/lesson/goals.h"

#include <algorithm>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/maths/vec.h"

namespace braitenlab {

namespace goals {

namespace {

// The lowest first speed that a speed is compared with: any speed is a large multiple of that of a standing vehicle.
constexpr float least_first_speed = 0.05f;  // m/s

// From the vehicle to the source; sources may have been added or removed since the start.
std::optional<maths::vec2> offset_to(const std::string& source, const Observation& at) {
    const int index = find_source(*at.now.scene, source);
    if (index < 0) return std::nullopt;
    const SourceView& view = at.now.sources[static_cast<std::size_t>(index)];
    return maths::vec2{view.x - at.vehicle.x, view.y - at.vehicle.y};
}

}  // namespace

std::optional<Reading> measure(const Runs& goal, Runs::State&, const Observation& at) {
    const auto seconds = static_cast<float>(at.now.seconds);
    return Reading{seconds, seconds >= goal.seconds};
}

std::optional<Reading> measure(const TurnsTo& goal, TurnsTo::State& state, const Observation& at) {
    const auto offset = offset_to(goal.source, at);
    if (!offset) return std::nullopt;
    const float bearing = maths::arctangent2(offset->y, offset->x) - at.vehicle.heading;
    const float off = std::fabs(maths::degrees(maths::wrap_angle(bearing)));
    if (off > goal.degrees) state.was_outside = true;
    return Reading{off, state.was_outside && off <= goal.degrees};
}

std::optional<Reading> measure(const Touches& goal, Touches::State&, const Observation& at) {
    const auto offset = offset_to(goal.source, at);
    if (!offset) return std::nullopt;
    const float distance = maths::length(*offset);
    return Reading{distance, distance <= goal.metres};
}

std::optional<Reading> measure(const SpeedsUp& goal, SpeedsUp::State& state, const Observation& at) {
    if (state.first_speed == 0 && at.now.seconds >= 1)
        state.first_speed = std::max(std::fabs(at.vehicle.speed), least_first_speed);
    if (!state.decided) {
        const auto offset = offset_to(goal.source, at);
        if (!offset || state.first_speed == 0) return std::nullopt;
        state.ratio = std::fabs(at.vehicle.speed) / state.first_speed;
        state.decided = maths::length(*offset) <= goal.metres;
    }
    return Reading{state.ratio, state.decided && state.ratio >= goal.factor};
}

}  // namespace goals

namespace {

template <class T>
concept Combined = requires(const T& goal) {
    goal.checks;
};

// What of a check and its state belongs together: calls `with` with the goal and its own state.
template <class With>
auto visit_goal(const Check& check, CheckState& state, const With& with) {
    return std::visit([&]<class G>(const G& goal) { return with(goal, std::get<typename G::State>(state.goal)); },
                      check.goal);
}

struct CheckContext {
    const Snapshot& now;
    const Subjects& subjects;
    std::string_view vehicle;  // of the check around this one
    bool together = false;     // this check must be met while others are, or for a time: its best value says nothing
};

bool judge(const Check&, CheckState&, CheckContext);

template <Combined G>
bool is_met(const G& goal, typename G::State& state, CheckState&, const CheckContext& context) {
    std::ptrdiff_t met = 0;
    for (std::size_t i = 0; i < goal.checks.size(); ++i) met += judge(goal.checks[i], state.checks[i], context);
    return std::is_same_v<G, goals::AllOf> ? met == std::ssize(goal.checks) : met > 0;
}

template <class G>
bool is_met(const G& goal, typename G::State& own, CheckState& state, const CheckContext& context) {
    const VehicleView* vehicle = find_vehicle(context.now, context.subjects.id(context.vehicle));
    if (!vehicle) return false;
    const auto reading = measure(goal, own, {context.now, *vehicle});
    if (!reading) return false;
    const bool keeps_best = G::traits.at_most && !context.together;
    state.value = keeps_best ? std::min(state.value, reading->value) : reading->value;
    return reading->met;
}

bool judge(const Check& check, CheckState& state, CheckContext context) {
    if (!check.vehicle.empty()) context.vehicle = check.vehicle;
    context.together |= check.hold > 0 || std::holds_alternative<goals::AllOf>(check.goal);
    const bool met =
        visit_goal(check, state, [&](const auto& goal, auto& own) { return is_met(goal, own, state, context); });
    const auto tick = static_cast<std::int64_t>(context.now.tick);
    if (!met) state.met_since = -1;
    if (met && state.met_since < 0) state.met_since = tick;
    state.held = met ? tick - state.met_since : 0;
    return met && state.held >= std::lround(check.hold / tick_seconds);
}

void add_measures(const Check& check, const CheckState& state, bool together, std::vector<Measure>& all) {
    together |= check.hold > 0 || std::holds_alternative<goals::AllOf>(check.goal);
    std::visit(
        [&]<class G>(const G& goal) {
            if constexpr (Combined<G>) {
                const auto& states = std::get<typename G::State>(state.goal).checks;
                for (std::size_t i = 0; i < goal.checks.size(); ++i)
                    add_measures(goal.checks[i], states[i], together, all);
            } else {
                all.push_back(
                    {state.value, goal.needed(), G::traits.unit, G::traits.at_most, G::traits.at_most && !together});
            }
        },
        check.goal);
    if (check.hold > 0) all.push_back({static_cast<float>(state.held) * tick_seconds, check.hold, "s", false, false});
}

}  // namespace

VehicleId Subjects::id(std::string_view start_name) const {
    if (ids.empty()) return no_vehicle;
    if (start_name.empty()) return ids.front();
    const auto start =
        std::find_if(starts.begin(), starts.end(), [&](const Start& each) { return each.name == start_name; });
    return start == starts.end() ? no_vehicle : ids[static_cast<std::size_t>(start - starts.begin())];
}

CheckState initial_state(const Check& check) {
    return std::visit(
        []<class G>(const G& goal) {
            typename G::State own;
            if constexpr (Combined<G>)
                for (const Check& each : goal.checks) own.checks.push_back(initial_state(each));
            return CheckState{std::move(own), G::traits.unmeasured};
        },
        check.goal);
}

bool update(const Check& check, CheckState& state, const Snapshot& now, const Subjects& subjects) {
    return judge(check, state, {now, subjects, {}});
}

std::vector<Measure> measures(const Check& check, const CheckState& state) {
    std::vector<Measure> all;
    add_measures(check, state, false, all);
    return all;
}

}  // namespace braitenlab
