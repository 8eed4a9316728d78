// What the parts of the draw list share while one picture is made. Only draw_list.cpp and the other draw_….cpp need it.
#pragma once

#include "core/maths/angle.h"
#include "render/view/draw_list.h"
#include "render/view/palette.h"

namespace braitenlab::render {

// All that is asked for again and again while one picture is made.
struct Drawing {
    DrawList& list;
    const Snapshot& now;
    const Picture& picture;
    Palette colours;
    maths::mat4 to_clip;  // projection · view
    float crowd;          // 1 for a few vehicles, less the more there are
};

constexpr float wall_thickness = 0.22f, wall_height = 0.35f;  // m
constexpr float deck_height = 0.27f;                          // m, of the standard vehicle

// One vehicle with what it is made of.
struct Subject {
    const VehicleView& view;
    const Kind& kind;
    const BrainGraph* brain;
    maths::vec2 place, ahead;
    float height_scale;
    float pixels;  // its length on the screen, layout pixels
    float detail;  // 0 small on the screen .. 1 large enough for small parts
    bool selected, hovered, driven;
    const DeckPlan* plan = nullptr;  // of the brain that drives it; null when something else does

    maths::vec2 to_world(maths::vec2 own) const { return place + maths::rotate(own, ahead); }
};

inline maths::vec4 rgb_with(Colour c, float w) { return {c.r, c.g, c.b, w}; }

// Whether a lesion covers an eye of the vehicle.
bool is_covered(const Subject&, std::size_t sensor);

// What a sensor of the vehicle reads now, 0..1; a covered one nothing.
float sensed(const Drawing&, const Subject&, std::size_t sensor);

// 1 left, −1 right, 0 amid.
int side_of(const Sensor&);

// Whether anything within `radius` metres of a place may be in the picture; never wrong when it says no.
bool in_sight(const Drawing&, maths::vec2 place, float radius);

// Adds what stands and lies in the arena, and what vehicles remember of it.
void add_world(Drawing&);
// Adds a source's light and shape; `foot` is the height it stands at, m.
void add_source(Drawing&, Channel, maths::vec2 place, float foot, float strength, float size);

// Adds every vehicle with all its parts.
void add_vehicles(Drawing&, const Trails&);
void add_fields(Drawing&, const Subject&);
// The wires and neurons, and a cross over what a lesion has put out of work.
void add_wires(Drawing&, const Subject&);
void add_stopped_wheels(Drawing&, const Subject&);
const DeckPlan* plan_of(Drawing&, const Subject&);
void add_wheel_arrows(Drawing&, const Subject&);
void add_trail(Drawing&, const Subject&, const Trail&);

// Adds the words: sources, zones, vehicles and the metres along the arena's edge.
void add_labels(Drawing&);

}  // namespace braitenlab::render
