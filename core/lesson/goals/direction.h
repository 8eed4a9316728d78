// Goals about where a vehicle heads.
#pragma once

#include "core/lesson/goal.h"

namespace braitenlab::goals {

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

// A source that lies outside `degrees` from the start on does not count: the vehicle has not turned away.
struct TurnsAway {
    static constexpr Traits traits{"turns_away", "°", false, 0,
                                   "the source lies at least `degrees` off straight ahead, having been nearer to it "
                                   "before; no start may begin outside"};
    struct State {
        bool was_inside = false;
    };
    std::string source;
    float degrees = 0;
    float needed() const { return degrees; }
};

struct Faces {
    static constexpr Traits traits{"faces", "°", true, 180, "the source lies within `degrees` of straight ahead"};
    struct State {};
    std::string source;
    float degrees = 0;
    float needed() const { return degrees; }
};

std::optional<Reading> measure(const TurnsTo&, TurnsTo::State&, const Observation&);
std::optional<Reading> measure(const TurnsAway&, TurnsAway::State&, const Observation&);
std::optional<Reading> measure(const Faces&, Faces::State&, const Observation&);

// ── Keys in files, each of which must be given; an empty source is the nearest one ──
void describe(auto& v, Of<TurnsTo>) {
    v.text("source", &TurnsTo::source, limits::name_length, "name of a source of the scene");
    v.number("degrees", &TurnsTo::degrees, "°", {0.5, 180}, "largest angle between the heading and the source");
}
void describe(auto& v, Of<TurnsAway>) {
    v.text("source", &TurnsAway::source, limits::name_length, "name of a source of the scene");
    v.number("degrees", &TurnsAway::degrees, "°", {0.5, 180}, "smallest angle between the heading and the source");
}
void describe(auto& v, Of<Faces>) {
    v.text("source", &Faces::source, limits::name_length, "name of a source of the scene; empty: the nearest one");
    v.number("degrees", &Faces::degrees, "°", {0.5, 180}, "largest angle between the heading and the source");
}

// ── States, for saved work ──
void visit_values(auto values, auto& s, Of<TurnsTo::State>) { values.value("was_outside", s.was_outside); }
void visit_values(auto values, auto& s, Of<TurnsAway::State>) { values.value("was_inside", s.was_inside); }

}  // namespace braitenlab::goals
