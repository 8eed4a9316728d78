// Goals about where a vehicle is: distances to sources, zones and gates, and ways round a source. In a torus, distances
// are across the seam if that is shorter.
#pragma once

#include "core/lesson/goal.h"

namespace braitenlab::goals {

struct Touches {
    static constexpr Traits traits{"touches", "m", true, INFINITY,
                                   "the vehicle's origin is within `metres` of the source"};
    struct State {};
    std::string source;
    float metres = 0;
    float needed() const { return metres; }
};

// Combine it with `runs`: it is met as long as the vehicle has not come too near.
struct Avoids {
    static constexpr Traits traits{.word = "avoids",
                                   .unit = "m",
                                   .unmeasured = INFINITY,
                                   .meaning = "the vehicle's origin has never been nearer to the source than `metres`",
                                   .quantity = "nearest"};
    struct State {
        float nearest = -1;  // m; −1: not measured yet
    };
    std::string source;
    float metres = 0;
    float needed() const { return metres; }
};

struct KeepsDistance {
    static constexpr Traits traits{"keeps_distance", "m", false, INFINITY,
                                   "the vehicle's origin is between `from` and `to` metres away from the source"};
    struct State {};
    std::string source;
    float from = 0, to = 0;
    float needed() const { return from; }
    float needed_most() const { return to; }
};

// Rounds in either direction. A distance outside the ring sets the count back to 0.
struct Circles {
    static constexpr Traits traits{"circles", "rounds", false, 0,
                                   "the vehicle has gone round the source `rounds` times without leaving the ring "
                                   "between the distances `from` and `to`"};
    struct State {
        bool inside = false;
        float bearing = 0;  // rad: direction of the vehicle as seen from the source
        double turned = 0;  // rad: sum of its changes
    };
    std::string source;
    float from = 0, to = 0, rounds = 0;
    float needed() const { return rounds; }
};

// The variation is (largest − smallest) / largest distance since it was last larger than `percent`.
struct SteadyDistance {
    static constexpr Traits traits{
        .word = "steady_distance",
        .unit = "s",
        .meaning = "the distance to the source has varied by at most `percent` for `seconds`",
        .quantity = "steady"};
    struct State {
        std::int64_t since = -1;  // tick; −1: not begun
        float nearest = 0, furthest = 0;
    };
    std::string source;
    float percent = 0, seconds = 0;
    float needed() const { return seconds; }
};

struct Visits {
    static constexpr Traits traits{"visits", "", false, 0,
                                   "the vehicle's origin has been within `metres` of `count` different sources"};
    struct State {
        std::uint64_t visited = 0;  // bit i: source i; further sources do not count
    };
    float metres = 0;
    int count = 0;
    float needed() const { return static_cast<float>(count); }
};

struct Enters {
    static constexpr Traits traits{"enters", "m", true, INFINITY, "the vehicle's origin is in the zone"};
    struct State {};
    std::string zone;
    float needed() const { return 0; }
};

// In a torus, the line and the way are across the seam if that is shorter. The move to the start in a new generation
// or after a fall over an open edge does not count.
struct DrivesThrough {
    static constexpr Traits traits{"drives_through", "m", true, INFINITY,
                                   "the vehicle's origin has crossed the straight line between the two obstacles"};
    struct State {
        bool begun = false, crossed = false;
        float x = 0, y = 0;      // m, at the tick before
        std::int64_t moves = 0;  // generations and falls of vehicles at the tick before
    };
    std::string left, right;
    float needed() const { return 0; }
};

// Progress counts only while the vehicle is on the line.
struct FollowsLine {
    static constexpr Traits traits{"follows_line", "laps", false, 0,
                                   "the vehicle has gone `laps` times round the middle of the tape with its origin "
                                   "within `metres` of the tape; a part further away does not count"};
    struct State {
        bool begun = false;
        float bearing = 0;  // rad
        double turned = 0;
    };
    float metres = 0, laps = 0;
    float needed() const { return laps; }
};

std::optional<Reading> measure(const Touches&, Touches::State&, const Observation&);
std::optional<Reading> measure(const Avoids&, Avoids::State&, const Observation&);
std::optional<Reading> measure(const KeepsDistance&, KeepsDistance::State&, const Observation&);
std::optional<Reading> measure(const Circles&, Circles::State&, const Observation&);
std::optional<Reading> measure(const SteadyDistance&, SteadyDistance::State&, const Observation&);
std::optional<Reading> measure(const Visits&, Visits::State&, const Observation&);
std::optional<Reading> measure(const Enters&, Enters::State&, const Observation&);
std::optional<Reading> measure(const DrivesThrough&, DrivesThrough::State&, const Observation&);
std::optional<Reading> measure(const FollowsLine&, FollowsLine::State&, const Observation&);

// ── Keys in files, each of which must be given ──
inline constexpr const char* source_meaning = "name of a source of the scene; empty: the nearest one";

void describe(auto& v, Of<Touches>) {
    v.text("source", &Touches::source, limits::name_length, source_meaning);
    v.number("metres", &Touches::metres, "m", {0.01, 100},
             "largest distance between the vehicle's origin and the source");
}
void describe(auto& v, Of<Avoids>) {
    v.text("source", &Avoids::source, limits::name_length, source_meaning);
    v.number("metres", &Avoids::metres, "m", {0.01, 100},
             "smallest distance between the vehicle's origin and the source");
}
void describe(auto& v, Of<KeepsDistance>) {
    v.text("source", &KeepsDistance::source, limits::name_length, source_meaning);
    v.number("from", &KeepsDistance::from, "m", {0, 100}, "smallest distance");
    v.number("to", &KeepsDistance::to, "m", {0, 100}, "largest distance");
}
void describe(auto& v, Of<Circles>) {
    v.text("source", &Circles::source, limits::name_length, "name of a source of the scene");
    v.number("from", &Circles::from, "m", {0, 100}, "smallest distance");
    v.number("to", &Circles::to, "m", {0, 100}, "largest distance");
    v.number("rounds", &Circles::rounds, "", {0.01, 1000}, "number of rounds");
}
void describe(auto& v, Of<SteadyDistance>) {
    v.text("source", &SteadyDistance::source, limits::name_length, "name of a source of the scene");
    v.number("percent", &SteadyDistance::percent, "%", {0.1, 100}, "largest variation");
    v.number("seconds", &SteadyDistance::seconds, "s", {0.1, 600}, "duration");
}
void describe(auto& v, Of<Visits>) {
    v.number("metres", &Visits::metres, "m", {0.01, 100}, "largest distance to a visited source");
    v.number("count", &Visits::count, "", {1, 64}, "number of different sources");
}
void describe(auto& v, Of<Enters>) {
    v.text("zone", &Enters::zone, limits::name_length, "name of a zone of the scene");
}
void describe(auto& v, Of<DrivesThrough>) {
    v.text("left", &DrivesThrough::left, limits::name_length, "name of an obstacle: one post of the gate");
    v.text("right", &DrivesThrough::right, limits::name_length, "name of an obstacle: the other post");
}
void describe(auto& v, Of<FollowsLine>) {
    v.number("metres", &FollowsLine::metres, "m", {0.01, 10}, "largest distance to the tape");
    v.number("laps", &FollowsLine::laps, "", {0.01, 100}, "number of laps");
}

// ── States, for saved work ──
void visit_values(auto values, auto& s, Of<Avoids::State>) { values.value("nearest", s.nearest); }
void visit_values(auto values, auto& s, Of<Circles::State>) {
    values.value("inside", s.inside), values.value("bearing", s.bearing), values.value("turned", s.turned);
}
void visit_values(auto values, auto& s, Of<SteadyDistance::State>) {
    values.value("since", s.since), values.value("nearest", s.nearest), values.value("furthest", s.furthest);
}
void visit_values(auto values, auto& s, Of<Visits::State>) { values.value("visited", s.visited); }
void visit_values(auto values, auto& s, Of<DrivesThrough::State>) {
    values.value("begun", s.begun), values.value("crossed", s.crossed);
    values.value("x", s.x), values.value("y", s.y), values.value("moves", s.moves);
}
void visit_values(auto values, auto& s, Of<FollowsLine::State>) {
    values.value("begun", s.begun), values.value("bearing", s.bearing), values.value("turned", s.turned);
}

}  // namespace braitenlab::goals
