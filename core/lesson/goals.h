// The table of goals, their combinations, and checks: a goal with its vehicle and its conditions on time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/lesson/goal.h"
#include "core/lesson/goals/direction.h"
#include "core/lesson/goals/motion.h"
#include "core/lesson/goals/others.h"
#include "core/lesson/goals/place.h"

namespace braitenlab {

namespace limits {
inline constexpr std::size_t checks = 8;  // of one combination
inline constexpr std::size_t steps = 32;  // of an exercise
}  // namespace limits

struct Check;
struct CheckState;

namespace goals {

enum class Combines { all, any, none };

// Met by its checks together. One of Combines::none judges checks about vehicles that are in the scene; use it beside
// `runs`.
template <Combines how>
struct Combination {
    static constexpr Traits traits =
        how == Combines::all   ? Traits{"all_of", "", false, 0, "every one of its checks is met at the same time"}
        : how == Combines::any ? Traits{"any_of", "", false, 0, "at least one of its checks is met"}
                               : Traits{"none_of", "", false, 0,
                                        "none of its checks has been met in the run so far, "
                                        "with their vehicles still in the scene"};
    struct State {
        std::vector<CheckState> checks;
    };
    std::vector<Check> checks;
};
using AllOf = Combination<Combines::all>;
using AnyOf = Combination<Combines::any>;
using NoneOf = Combination<Combines::none>;

template <Combines how>
void describe(auto& v, Of<Combination<how>>) {
    v.list("check", &Combination<how>::checks, limits::checks, "a check with its own goal; at least one");
}

}  // namespace goals

// The table of goals: every goal that a file can name.
using Goal = std::variant<goals::Runs, goals::Survives, goals::TurnsTo, goals::TurnsAway, goals::Faces, goals::Touches,
                          goals::Avoids, goals::KeepsDistance, goals::SteadyDistance, goals::Circles, goals::Visits,
                          goals::Enters, goals::DrivesThrough, goals::FollowsLine, goals::SpeedsUp, goals::Rests,
                          goals::Drives, goals::KeepsSpeed, goals::KeepsMoving, goals::SpeedFollows, goals::Follows,
                          goals::Collides, goals::Captures, goals::Population, goals::Recharges, goals::Matches,
                          goals::AllOf, goals::AnyOf, goals::NoneOf>;

template <class Variant>
struct StatesOf;
template <class... Goals>
struct StatesOf<std::variant<Goals...>> {
    using type = std::variant<typename Goals::State...>;
};
using GoalState = StatesOf<Goal>::type;  // the alternative has the same index as the goal's

// A goal, the vehicle it is about and its conditions on time.
struct Check {
    Goal goal;
    std::string vehicle{};  // name of one of the scene's starts; empty: that of the check around it, else the first
    float hold = 0;         // s, 0..600; the goal must stay met for so long without a break
    float earliest = 0;     // s; ticks before are not judged
    float latest = 0;       // s; ticks after are not judged; 0: no limit
    int after = 0;          // number, from 1, of a step; ticks before that step is done are not judged. 0: none
};

struct CheckState {
    GoalState goal;
    float value = 0;              // measured last, or the best so far (see Measure::best)
    std::int64_t met_since = -1;  // tick since which the goal has been met without a break; −1: not met
    std::int64_t held = 0;        // ticks that it has been met since then
    bool lost = false;            // the check cannot be met any more in this run
};

// A value beside the one it needs.
struct Measure {
    float value = 0, needed = 0;
    std::string_view unit;               // "s", "m", "°", "×"
    bool at_most = false;                // needs value <= needed; otherwise value >= needed
    bool best = false;                   // the value is the best so far; otherwise the present one
    std::optional<float> needed_most{};  // needs also value <= this
    // What is measured, where the unit alone does not say it: "rest", "hold", "path", "nearest", "steady".
    std::string_view quantity{};
    std::string source{};  // name of what the value is about: a source, or two vehicles as "one → two"; empty: none
    bool met = false;      // its goal is met at present, or the hold time has passed
    friend bool operator==(const Measure&, const Measure&) = default;
};

CheckState initial_state(const Check&);

// One tick of a run as checks see it.
struct CheckedTick {
    const Snapshot& now;
    const Subjects& subjects;
    const ReferencePath* reference = nullptr;  // see goals::Observation
    const std::vector<bool>& done;             // the steps that are done
};

// Judges one tick. True when the goal is met and has been met for the hold time. Call for ascending ticks.
bool update(const Check&, CheckState&, const CheckedTick&);

// What to show of a check: the values of its goals, and with a hold time for how many seconds they have been met. Those
// inside none_of show the opposite of what their checks need, and of a range its nearer limit.
std::vector<Measure> measures(const Check&, const CheckState&);

// True if a goal of the check needs the reference path.
bool needs_reference(const Check&);

}  // namespace braitenlab
