#include "core/lesson/goals.h"

#include <algorithm>
#include <cmath>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/maths/vec.h"
#include "core/sensing/seam.h"

namespace braitenlab {

namespace goals {

std::optional<maths::vec2> offset_to_source(const std::string& source, const Observation& at) {
    const sensing::Seam seam(at.now.scene->arena);
    std::optional<maths::vec2> nearest;
    for (const SourceView& view : at.now.sources) {
        if (!source.empty() && at.now.scene->sources[static_cast<std::size_t>(view.source)].name != source) continue;
        const maths::vec2 offset = seam.shortest({view.x - at.vehicle.x, view.y - at.vehicle.y});
        if (!nearest || maths::length(offset) < maths::length(*nearest)) nearest = offset;
    }
    return nearest;
}

float degrees_off(const VehicleView& vehicle, maths::vec2 offset) {
    const float bearing = maths::arctangent2(offset.y, offset.x) - vehicle.heading;
    return std::fabs(maths::degrees(maths::wrap_angle(bearing)));
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
    const CheckedTick& tick;
    std::string_view vehicle;  // of the check around this one
    bool together = false;     // see is_together()
};

bool judge(const Check&, CheckState&, CheckContext);

// True if the check, or those inside it, must be met while others are, or for a time.
bool is_together(const Check& check) {
    return check.hold > 0 || std::holds_alternative<goals::AllOf>(check.goal) ||
           std::holds_alternative<goals::NoneOf>(check.goal);
}

// A value that must fall shows its smallest so far, unless its check is one of is_together().
template <class G>
bool shows_best(bool together) {
    return G::traits.at_most && !G::traits.is_total && !together;
}

// True if the vehicles that the check is about are in the scene.
bool has_vehicles(const Check& check, CheckContext context) {
    if (!check.vehicle.empty()) context.vehicle = check.vehicle;
    return std::visit(
        [&]<class G>(const G& goal) {
            if constexpr (Combined<G>)
                return std::all_of(goal.checks.begin(), goal.checks.end(),
                                   [&](const Check& each) { return has_vehicles(each, context); });
            else
                return G::traits.is_of_scene ||
                       find_vehicle(context.tick.now, context.tick.subjects.id(context.vehicle)) != nullptr;
        },
        check.goal);
}

template <Combined G>
bool is_met(const G& goal, typename G::State& state, CheckState& own, const CheckContext& context) {
    std::ptrdiff_t met = 0, lost = 0;
    for (std::size_t i = 0; i < goal.checks.size(); ++i) {
        met += judge(goal.checks[i], state.checks[i], context);
        lost += state.checks[i].lost;
    }
    const std::ptrdiff_t all = std::ssize(goal.checks);
    if constexpr (std::is_same_v<G, goals::NoneOf>) {
        own.lost |= met > 0;
        return !own.lost && std::all_of(goal.checks.begin(), goal.checks.end(),
                                        [&](const Check& each) { return has_vehicles(each, context); });
    }
    own.lost |= std::is_same_v<G, goals::AllOf> ? lost > 0 : lost == all;
    return std::is_same_v<G, goals::AllOf> ? met == all : met > 0;
}

template <class G>
bool is_met(const G& goal, typename G::State& own, CheckState& state, const CheckContext& context) {
    static const VehicleView absent;
    const auto& [now, subjects, reference, done] = context.tick;
    const VehicleView* vehicle = find_vehicle(now, subjects.id(context.vehicle));
    if (!vehicle && !G::traits.is_of_scene) return false;
    const auto reading = measure(goal, own, {now, vehicle ? *vehicle : absent, subjects, reference});
    if (!reading) return false;
    const bool keeps_best = shows_best<G>(context.together);
    state.value = keeps_best ? std::min(state.value, reading->value) : reading->value;
    state.lost |= reading->lost;
    return reading->met;
}

bool is_step_done(const std::vector<bool>& done, int number) {
    return number == 0 ||
           (static_cast<std::size_t>(number) <= done.size() && done[static_cast<std::size_t>(number) - 1]);
}

std::int64_t ticks_of_hold(const Check& check) { return std::lround(check.hold / tick_seconds); }

bool judge(const Check& check, CheckState& state, CheckContext context) {
    const double seconds = context.tick.now.seconds;
    const bool is_over = check.latest > 0 && seconds > static_cast<double>(check.latest);
    state.lost |= is_over;
    if (is_over || seconds < static_cast<double>(check.earliest) || !is_step_done(context.tick.done, check.after))
        return state.met_since = -1, state.held = 0, false;
    if (!check.vehicle.empty()) context.vehicle = check.vehicle;
    context.together |= is_together(check);
    const bool met =
        visit_goal(check, state, [&](const auto& goal, auto& own) { return is_met(goal, own, state, context); });
    const auto tick = static_cast<std::int64_t>(context.tick.now.tick);
    if (!met) state.met_since = -1;
    if (met && state.met_since < 0) state.met_since = tick;
    state.held = met ? tick - state.met_since : 0;
    return met && state.held >= ticks_of_hold(check);
}

template <class G>
std::optional<float> needed_most(const G& goal) {
    if constexpr (requires { goal.needed_most(); }) return goal.needed_most();
    return std::nullopt;
}

template <class G>
std::string source_of(const G& goal, [[maybe_unused]] const Check& check) {
    if constexpr (requires { goal.source; }) return goal.source;
    if constexpr (std::is_same_v<G, goals::Follows>)
        return check.vehicle.empty() ? goal.other : check.vehicle + " → " + goal.other;
    return {};
}

// What a value must be so that the measure is not met: outside a range, the nearer of both sides.
Measure opposite(Measure measure) {
    measure.best = false;
    measure.met = !measure.met;
    measure.at_most = !measure.at_most;
    const bool is_count = measure.unit == "captures" || measure.unit == "vehicles" || measure.unit == "times";
    if (measure.at_most && is_count) measure.needed -= 1;  // fewer than these
    if (!measure.needed_most) return measure;
    measure.at_most = measure.value < (measure.needed + *measure.needed_most) / 2;
    if (!measure.at_most) measure.needed = *measure.needed_most;
    measure.needed_most.reset();
    return measure;
}

// The values of a goal that is no combination.
template <class G>
std::vector<Measure> values_of(const G& goal, const Check& check, const CheckState& state, bool together) {
    const Measure first{state.value,        goal.needed(),           G::traits.unit,
                        G::traits.at_most,  shows_best<G>(together), needed_most(goal),
                        G::traits.quantity, source_of(goal, check),  state.met_since >= 0};
    if constexpr (requires { goal.second(std::get<typename G::State>(state.goal)); }) {
        const goals::SecondValue second = goal.second(std::get<typename G::State>(state.goal));
        Measure distance = first;
        distance.met = first.value <= first.needed;
        if (!std::isfinite(first.value)) return {distance};  // both are unknown
        return {distance,
                {second.value,
                 second.needed,
                 second.unit,
                 true,
                 false,
                 {},
                 {},
                 first.source,
                 second.value <= second.needed}};
    }
    return {first};
}

// `negated`: the check must not be met.
void add_measures(const Check& check, const CheckState& state, bool together, bool negated, std::vector<Measure>& all) {
    const auto add = [&](const Measure& measure) { all.push_back(negated ? opposite(measure) : measure); };
    together |= is_together(check);
    std::visit(
        [&]<class G>(const G& goal) {
            if constexpr (Combined<G>) {
                const auto& states = std::get<typename G::State>(state.goal).checks;
                for (std::size_t i = 0; i < goal.checks.size(); ++i)
                    add_measures(goal.checks[i], states[i], together, negated != std::is_same_v<G, goals::NoneOf>, all);
            } else {
                for (const Measure& measure : values_of(goal, check, state, together)) add(measure);
            }
        },
        check.goal);
    if (check.hold <= 0) return;
    const float held = static_cast<float>(state.held) * tick_seconds;
    const bool is_held = state.met_since >= 0 && state.held >= ticks_of_hold(check);
    add({held, check.hold, "s", false, false, {}, "hold", {}, is_held});
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

bool update(const Check& check, CheckState& state, const CheckedTick& tick) { return judge(check, state, {tick, {}}); }

std::vector<Measure> measures(const Check& check, const CheckState& state) {
    std::vector<Measure> all;
    add_measures(check, state, false, false, all);
    return all;
}

bool needs_reference(const Check& check) {
    return std::visit(
        []<class G>(const G& goal) {
            if constexpr (Combined<G>) return std::any_of(goal.checks.begin(), goal.checks.end(), needs_reference);
            return std::is_same_v<G, goals::Matches>;
        },
        check.goal);
}

}  // namespace braitenlab
