// Goals about how a vehicle moves: time, speed, and speed as a function of what it senses.
#pragma once

#include "core/lesson/goal.h"

namespace braitenlab::goals {

struct Runs {
    static constexpr Traits traits{"runs", "s", false, 0,
                                   "the run has lasted `seconds` and the vehicle is still in the scene"};
    struct State {};
    float seconds = 0;
    float needed() const { return seconds; }
};

struct Survives {
    static constexpr Traits traits{"survives", "s", false, 0,
                                   "the run has lasted `seconds` and no vehicle has fallen over an open edge"};
    struct State {
        float fell_at = -1;  // s, of the first fall; −1: none fell
    };
    float seconds = 0;
    float needed() const { return seconds; }
};

// The speed is compared with that at the first judged tick at or after 1 s; see Check::earliest and Check::after.
// Decided by the speed at the first tick within `metres`; later ticks do not count.
struct SpeedsUp {
    static constexpr Traits traits{
        "speeds_up", "×", false, 0,
        "at its first tick within `metres` of the source, the vehicle moves at least `factor` "
        "times as fast as at 1 s, or at the first judged tick after that"};
    struct State {
        float first_speed = 0;  // m/s at the first judged tick from 1 s on; 0: not known yet
        float ratio = 0;        // of the present speed to the first; that of the first arrival once it is decided
        bool decided = false;
    };
    std::string source;
    float metres = 0, factor = 0;
    float needed() const { return factor; }
};

struct Rests {
    static constexpr Traits traits{"rests", "m/s", true, INFINITY, "the vehicle moves at most this `speed`"};
    struct State {};
    float speed = 0;
    float needed() const { return speed; }
};

struct Drives {
    static constexpr Traits traits{"drives", "m/s", false, 0,
                                   "the vehicle moves at least this `speed`, forwards or backwards"};
    struct State {};
    float speed = 0;
    float needed() const { return speed; }
};

struct KeepsSpeed {
    static constexpr Traits traits{"keeps_speed", "m/s", false, 0, "the speed is between `from` and `to`"};
    struct State {};
    float from = 0, to = 0;
    float needed() const { return from; }
    float needed_most() const { return to; }
};

// Combine it with `runs`: it is met as long as no rest was too long. The value is the longest rest so far.
struct KeepsMoving {
    static constexpr Traits traits{
        "keeps_moving", "s",   true,  0, "the vehicle has never moved slower than `speed` for longer than `seconds`",
        true,           false, "rest"};
    struct State {
        std::int64_t slow_since = -1;  // tick; −1: it moves
        std::int64_t longest = 0;      // ticks
    };
    float speed = 0, seconds = 0;
    float needed() const { return seconds; }
};

// Pearson's correlation, from the running means and moments of B. P. Welford, Technometrics 4 (1962).
struct SpeedFollows {
    static constexpr Traits traits{"speed_follows", "correlation", false, 0,
                                   "after `seconds`, the speed and the sensor's reading have at least this "
                                   "`correlation` over the run so far"};
    struct State {
        double count = 0, mean_speed = 0, mean_reading = 0;
        double speed_moment = 0, reading_moment = 0, product_moment = 0;  // sums of products of deviations
    };
    std::string sensor;
    float correlation = 0, seconds = 0;
    float needed() const { return correlation; }
};

std::optional<Reading> measure(const Runs&, Runs::State&, const Observation&);
std::optional<Reading> measure(const Survives&, Survives::State&, const Observation&);
std::optional<Reading> measure(const SpeedsUp&, SpeedsUp::State&, const Observation&);
std::optional<Reading> measure(const Rests&, Rests::State&, const Observation&);
std::optional<Reading> measure(const Drives&, Drives::State&, const Observation&);
std::optional<Reading> measure(const KeepsSpeed&, KeepsSpeed::State&, const Observation&);
std::optional<Reading> measure(const KeepsMoving&, KeepsMoving::State&, const Observation&);
std::optional<Reading> measure(const SpeedFollows&, SpeedFollows::State&, const Observation&);

// ── Keys in files, each of which must be given ──
void describe(auto& v, Of<Runs>) { v.number("seconds", &Runs::seconds, "s", {0.1, 600}, "duration of the run"); }
void describe(auto& v, Of<Survives>) {
    v.number("seconds", &Survives::seconds, "s", {0.1, 600}, "duration of the run");
}
void describe(auto& v, Of<SpeedsUp>) {
    v.text("source", &SpeedsUp::source, limits::name_length, "name of a source of the scene; empty: the nearest one");
    v.number("metres", &SpeedsUp::metres, "m", {0.01, 100}, "distance at which the speed is compared");
    v.number("factor", &SpeedsUp::factor, "×", {0.01, 100}, "smallest ratio to the speed after the first second");
}
void describe(auto& v, Of<Rests>) { v.number("speed", &Rests::speed, "m/s", {0.001, 10}, "largest speed"); }
void describe(auto& v, Of<Drives>) { v.number("speed", &Drives::speed, "m/s", {0.001, 10}, "smallest speed"); }
void describe(auto& v, Of<KeepsSpeed>) {
    v.number("from", &KeepsSpeed::from, "m/s", {-10, 10}, "smallest speed along the heading");
    v.number("to", &KeepsSpeed::to, "m/s", {-10, 10}, "largest speed along the heading");
}
void describe(auto& v, Of<KeepsMoving>) {
    v.number("speed", &KeepsMoving::speed, "m/s", {0.001, 10}, "a vehicle that moves slower rests");
    v.number("seconds", &KeepsMoving::seconds, "s", {0, 600}, "longest rest");
}
void describe(auto& v, Of<SpeedFollows>) {
    v.text("sensor", &SpeedFollows::sensor, limits::name_length, "name of a sensor of the vehicle");
    v.number("correlation", &SpeedFollows::correlation, "", {-1, 1}, "smallest correlation");
    v.number("seconds", &SpeedFollows::seconds, "s", {0.1, 600}, "duration of the run before it can be met");
}

// ── States, for saved work ──
void visit_values(auto values, auto& s, Of<Survives::State>) { values.value("fell_at", s.fell_at); }
void visit_values(auto values, auto& s, Of<SpeedsUp::State>) {
    values.value("first_speed", s.first_speed), values.value("ratio", s.ratio), values.value("decided", s.decided);
}
void visit_values(auto values, auto& s, Of<KeepsMoving::State>) {
    values.value("slow_since", s.slow_since), values.value("longest", s.longest);
}
void visit_values(auto values, auto& s, Of<SpeedFollows::State>) {
    values.value("count", s.count), values.value("mean_speed", s.mean_speed);
    values.value("mean_reading", s.mean_reading), values.value("speed_moment", s.speed_moment);
    values.value("reading_moment", s.reading_moment), values.value("product_moment", s.product_moment);
}

}  // namespace braitenlab::goals
