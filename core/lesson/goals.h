// Goals of an exercise: what a vehicle must do, and how far it is from having done it.
//
// A goal is one struct: its parameters, `traits`, `needed()`, its `State` (what it remembers from tick to tick), the
// description of its file keys and an overload of `measure`. To add a goal, write the struct here, list it in `Goal`
// and define its `measure` in goals.cpp. Reading, error messages, documentation and saved state derive from these.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scene/schema.h"
#include "core/world/snapshot.h"

namespace braitenlab {

namespace limits {
inline constexpr std::size_t checks = 8;  // of one all_of or any_of
}

struct Check;
struct CheckState;

namespace goals {

struct Traits {
    std::string_view word;     // in files
    std::string_view unit;     // of the measured and the needed value
    bool at_most = false;      // met when the measured value is at most the needed one; otherwise at least
    float unmeasured = 0;      // value shown before the first measurement
    std::string_view meaning;  // for the documentation: when the goal is met
};

// One tick of a run and the vehicle that the goal is about.
struct Observation {
    const Snapshot& now;
    const VehicleView& vehicle;
};

struct Reading {
    float value = 0;   // in the goal's unit
    bool met = false;  // true while the goal is met
};

struct Runs {
    static constexpr Traits traits{"runs", "s", false, 0, "the run has lasted `seconds`"};
    struct State {};
    float seconds = 0;
    float needed() const { return seconds; }
};

// A source that lies within `degrees` from the start on does not count: the vehicle has not turned to it.
struct TurnsTo {
    static constexpr Traits traits{
        "turns_to", "°", true, 180,
        "the source lies within `degrees` of straight ahead, having been further off before; "
        "no start may begin inside"};
    struct State {
        bool was_outside = false;
    };
    std::string source;
    float degrees = 0;
    float needed() const { return degrees; }
};

struct Touches {
    static constexpr Traits traits{"touches", "m", true, INFINITY,
                                   "the vehicle's origin is within `metres` of the source"};
    struct State {};
    std::string source;
    float metres = 0;
    float needed() const { return metres; }
};

// Decided by the speed at the first tick within `metres`; later ticks do not count.
struct SpeedsUp {
    static constexpr Traits traits{
        "speeds_up", "×", false, 0,
        "at its first tick within `metres` of the source, the vehicle moves at least `factor` "
        "times as fast as after its first second"};
    struct State {
        float first_speed = 0;  // m/s after the first second; 0: not known yet
        float ratio = 0;        // of the present speed to the first; that of the first arrival once it is decided
        bool decided = false;
    };
    std::string source;
    float metres = 0, factor = 0;
    float needed() const { return factor; }
};

// Met while all of its checks are met at the same time.
struct AllOf {
    static constexpr Traits traits{"all_of", "", false, 0, "every one of its checks is met at the same time"};
    struct State {
        std::vector<CheckState> checks;
    };
    std::vector<Check> checks;
};

// Met while at least one of its checks is met.
struct AnyOf {
    static constexpr Traits traits{"any_of", "", false, 0, "at least one of its checks is met"};
    struct State {
        std::vector<CheckState> checks;
    };
    std::vector<Check> checks;
};

// The value of this tick, or nullopt when it cannot be measured (the source is missing, the first second is not over).
std::optional<Reading> measure(const Runs&, Runs::State&, const Observation&);
std::optional<Reading> measure(const TurnsTo&, TurnsTo::State&, const Observation&);
std::optional<Reading> measure(const Touches&, Touches::State&, const Observation&);
std::optional<Reading> measure(const SpeedsUp&, SpeedsUp::State&, const Observation&);

// ── Keys in files, each of which must be given ──
template <class Visitor>
void describe(Visitor& v, Of<Runs>) {
    v.number("seconds", &Runs::seconds, "s", {0.1, 600}, "duration of the run");
}
template <class Visitor>
void describe(Visitor& v, Of<TurnsTo>) {
    v.text("source", &TurnsTo::source, limits::name_length, "name of a source of the scene");
    v.number("degrees", &TurnsTo::degrees, "°", {0.5, 180}, "largest angle between the heading and the source");
}
template <class Visitor>
void describe(Visitor& v, Of<Touches>) {
    v.text("source", &Touches::source, limits::name_length, "name of a source of the scene");
    v.number("metres", &Touches::metres, "m", {0.01, 100},
             "largest distance between the vehicle's origin and the source");
}
template <class Visitor>
void describe(Visitor& v, Of<SpeedsUp>) {
    v.text("source", &SpeedsUp::source, limits::name_length, "name of a source of the scene");
    v.number("metres", &SpeedsUp::metres, "m", {0.01, 100}, "distance at which the speed is compared");
    v.number("factor", &SpeedsUp::factor, "×", {0.01, 100}, "smallest ratio to the speed after the first second");
}
template <class Visitor>
void describe(Visitor& v, Of<AllOf>) {
    v.list("check", &AllOf::checks, limits::checks, "a check with its own goal; at least one");
}
template <class Visitor>
void describe(Visitor& v, Of<AnyOf>) {
    v.list("check", &AnyOf::checks, limits::checks, "a check with its own goal; at least one");
}

// ── States, for saved work ──
template <class Visitor>
void describe(Visitor&, Of<Runs::State>) {}
template <class Visitor>
void describe(Visitor&, Of<Touches::State>) {}
template <class Visitor>
void describe(Visitor& v, Of<TurnsTo::State>) {
    v.flag("was_outside", &TurnsTo::State::was_outside, "");
}
template <class Visitor>
void describe(Visitor& v, Of<SpeedsUp::State>) {
    v.number("first_speed", &SpeedsUp::State::first_speed, "m/s", {0, 1e6}, "");
    v.number("ratio", &SpeedsUp::State::ratio, "×", {0, 1e6}, "");
    v.flag("decided", &SpeedsUp::State::decided, "");
}

}  // namespace goals

// The table of goals: every goal that a file can name.
using Goal = std::variant<goals::Runs, goals::TurnsTo, goals::Touches, goals::SpeedsUp, goals::AllOf, goals::AnyOf>;

template <class Variant>
struct StatesOf;
template <class... Goals>
struct StatesOf<std::variant<Goals...>> {
    using type = std::variant<typename Goals::State...>;
};
using GoalState = StatesOf<Goal>::type;  // the alternative has the same index as the goal's

// A goal, the vehicle it is about and how long it must stay met.
struct Check {
    Goal goal;
    std::string vehicle{};  // name of one of the scene's starts; empty: that of the check around it, else the first
    float hold = 0;         // s, 0..600; the goal must stay met for so long without a break
};

struct CheckState {
    GoalState goal;
    float value = 0;              // measured last, or the best so far (see Measure::best)
    std::int64_t met_since = -1;  // tick since which the goal has been met without a break; −1: not met
    std::int64_t held = 0;        // ticks that it has been met since then
};

// A value beside the one it needs.
struct Measure {
    float value = 0, needed = 0;
    std::string_view unit;  // "s", "m", "°", "×"
    bool at_most = false;   // needs value <= needed; otherwise value >= needed
    bool best = false;      // the value is the best so far; otherwise the present one
    friend bool operator==(const Measure&, const Measure&) = default;
};

// The vehicles that checks are about: ids[i] is the vehicle of starts[i]. A scene without starts has one id, that of
// its first vehicle.
struct Subjects {
    std::span<const Start> starts;
    std::span<const VehicleId> ids;
    VehicleId id(std::string_view start_name) const;  // of the first vehicle when the name is empty; or no_vehicle
};

CheckState initial_state(const Check&);

// Judges one tick. True when the goal is met and has been met for the hold time. Call for ascending ticks.
bool update(const Check&, CheckState&, const Snapshot&, const Subjects&);

// What to show of a check: the values of its goals, and with a hold time for how many seconds they have been met.
std::vector<Measure> measures(const Check&, const CheckState&);

}  // namespace braitenlab
