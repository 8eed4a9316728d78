// Goals about other vehicles, energy, and a vehicle with another brain.
#pragma once

#include "core/lesson/goal.h"

namespace braitenlab::goals {

// In a torus, across the seam if that is shorter.
struct Follows {
    static constexpr Traits traits{"follows", "m", true, INFINITY,
                                   "the other vehicle is within `metres` and within `degrees` of straight ahead"};
    struct State {
        float degrees = 180;  // off straight ahead, measured last
    };
    std::string other;
    float metres = 0, degrees = 0;
    float needed() const { return metres; }
    SecondValue second(const State& state) const { return {state.degrees, degrees, "°"}; }
};

// Combine it with `runs`.
struct Collides {
    static constexpr Traits traits{
        "collides", "contacts", true, 0, "vehicles have touched one another, obstacles or walls at most `count` times",
        true,       true};
    struct State {};
    int count = 0;
    float needed() const { return static_cast<float>(count); }
};

struct Captures {
    static constexpr Traits traits{"captures", "captures", false, 0, "predators have caught `count` prey", false, true};
    struct State {};
    int count = 0;
    float needed() const { return static_cast<float>(count); }
};

struct Population {
    static constexpr Traits traits{
        "population", "vehicles", false, 0, "at least `count` vehicles of the kind are in the scene", false, true};
    struct State {};
    std::string kind;
    int count = 0;
    float needed() const { return static_cast<float>(count); }
};

struct Recharges {
    static constexpr Traits traits{"recharges", "times", false, 0,
                                   "the vehicle's energy has risen from below `low` to above `high`, `count` times"};
    struct State {
        bool is_low = false;
        std::uint64_t times = 0;
    };
    float low = 0, high = 0;
    int count = 0;
    float needed() const { return static_cast<float>(count); }
};

// The reference is a run with the exercise's solution from the same seed. Only of the first vehicle. In a torus, the
// distance is across the seam if that is shorter.
struct Matches {
    static constexpr Traits traits{"matches",
                                   "m",
                                   true,
                                   INFINITY,
                                   "after `seconds`, the mean distance between the first vehicle and one with the "
                                   "solution's brain that started alike is at most `metres`",
                                   true,
                                   false,
                                   "path"};
    struct State {
        double count = 0, mean = 0;  // ticks, m
    };
    float metres = 0, seconds = 0;
    float needed() const { return metres; }
};

std::optional<Reading> measure(const Follows&, Follows::State&, const Observation&);
std::optional<Reading> measure(const Collides&, Collides::State&, const Observation&);
std::optional<Reading> measure(const Captures&, Captures::State&, const Observation&);
std::optional<Reading> measure(const Population&, Population::State&, const Observation&);
std::optional<Reading> measure(const Recharges&, Recharges::State&, const Observation&);
std::optional<Reading> measure(const Matches&, Matches::State&, const Observation&);

// ── Keys in files, each of which must be given ──
void describe(auto& v, Of<Follows>) {
    v.text("other", &Follows::other, limits::name_length, "NAME of the [vehicle.NAME] that is followed");
    v.number("metres", &Follows::metres, "m", {0.01, 100}, "largest distance");
    v.number("degrees", &Follows::degrees, "°", {0.5, 180}, "largest angle between the heading and the other vehicle");
}
void describe(auto& v, Of<Collides>) {
    v.number("count", &Collides::count, "", {0, 1e6}, "largest number of contacts");
}
void describe(auto& v, Of<Captures>) {
    v.number("count", &Captures::count, "", {1, 1e6}, "smallest number of captures");
}
void describe(auto& v, Of<Population>) {
    v.text("kind", &Population::kind, limits::name_length, "name of a kind of the scene");
    v.number("count", &Population::count, "", {1, limits::vehicles}, "smallest number of vehicles");
}
void describe(auto& v, Of<Recharges>) {
    v.number("low", &Recharges::low, "", {0, 1}, "energy below which it needs energy");
    v.number("high", &Recharges::high, "", {0, 1}, "energy above which it is recharged");
    v.number("count", &Recharges::count, "", {1, 1000}, "smallest number of times");
}
void describe(auto& v, Of<Matches>) {
    v.number("metres", &Matches::metres, "m", {0.001, 100}, "largest mean distance");
    v.number("seconds", &Matches::seconds, "s", {0.1, 600}, "duration of the run before it can be met");
}

// ── States, for saved work ──
void visit_values(auto values, auto& s, Of<Follows::State>) { values.value("degrees", s.degrees); }
void visit_values(auto values, auto& s, Of<Recharges::State>) {
    values.value("is_low", s.is_low), values.value("times", s.times);
}
void visit_values(auto values, auto& s, Of<Matches::State>) {
    values.value("count", s.count), values.value("mean", s.mean);
}

}  // namespace braitenlab::goals
