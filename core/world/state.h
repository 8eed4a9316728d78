// A running world: the moment, and everything that is worked out from it. Inside core/world only.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/world/field.h"
#include "core/world/ground.h"
#include "core/world/moment.h"
#include "core/world/outline.h"
#include "core/world/physics.h"
#include "core/world/places.h"
#include "core/world/world.h"

namespace braitenlab {

struct WorldState : Moment {
    // Takes the moment as it is; kinds, outlines, fields and bodies follow from it alone. After an edit of the scene's
    // designs, and at every keyframe, a world is made again from its own moment:  s = WorldState(Moment(s)).
    explicit WorldState(Moment);

    std::vector<CompiledKind> kinds;
    Ground ground;
    Outlines outlines;  // walls, obstacles and posts, for eyes
    Seam seam;
    std::array<bool, channel_count> sensed_channel{};
    std::array<Field, channel_count> fields;
    bool anyone_remembers = false;          // any kind has a place memory
    std::vector<Bump> bumps;                // of this tick, where anyone remembers
    std::vector<Touch> begun;               // what began to touch in the last step, sorted
    std::vector<Touch> touched;             // all touches, both ways round, sorted; kept where there are bumpers
    std::vector<Stimulus> stimuli;          // scratch
    std::vector<Outline> touched_outlines;  // scratch
    bool eyes_are_stale = true;             // something moved since they looked
    std::vector<float> foreseen_neurons;    // what the next tick would make of them; empty: as they are
    Physics physics;

    Role role(std::size_t row) const { return vehicles.design[row]->role; }
    std::size_t kind(std::size_t row) const { return static_cast<std::size_t>(vehicles.kind[row]); }
    std::optional<std::size_t> row_of(VehicleId) const;
};

// ── The tick, in order ──────────────────────────────────────────────────────────────────────────────────────────────
void sense(WorldState&);           // sense.cpp   sensors read their channels
void glance(WorldState&);          //             the same, but slow sensors keep nothing of it
void think(WorldState&);           // think.cpp   brains and other drivers turn readings into wheel commands
void drive(WorldState&);           // drive.cpp   wheels push bodies
void keep_inside(WorldState&);     // edge.cpp    a torus closes, walls hold
void remember(WorldState&);        // memory.cpp  where they met obstacles
void touch_and_live(WorldState&);  // live.cpp    bites, energy, deaths and births, the inactivity timer

// After a command and before the next tick, a picture shows what the eyes see now and what the drivers make of it; the
// brains' own state waits for the tick.
void foresee(WorldState&);

// ── Who is in the world ─────────────────────────────────────────────────────────────────────────────────────────────
void populate(WorldState&);    // populate.cpp  the first generation
void repopulate(WorldState&);  // the next one: as many again, elsewhere
void add_vehicle(WorldState&, int kind, int start, VehicleId, SharedDesign, const Pose&);
void remove_vehicles(WorldState&, const std::vector<std::size_t>& rows);  // which ascend
void enter_again(WorldState&, std::size_t row);                           // at its start or elsewhere, as good as new
// At random, clear of others where there is room; the place is taken from then on.
Pose free_place(const WorldState&, Places&, int kind, VehicleId);
int kind_due(const WorldState&);                 // the kind that the shares ask for next
bool is_outside(const Arena&, maths::vec2);      // edge.cpp
void read_motion(WorldState&, std::size_t row);  // takes over where the body is now

// ── From outside and to the outside ────────────────────────────────────────────────────────────────────────────────
std::optional<Error> carry_out(WorldState&, const Command&);                     // commands.cpp, edits.cpp
float strength(const Moment&, const Mark&);                                      // memory.cpp: what is left of it, 0..1
float read_memory(const WorldState&, const Eye&, const Gaze&, std::size_t row);  // its own marks, added up
void capture(const WorldState&, Snapshot&);                                      // capture.cpp
std::uint64_t hash(const Moment&);                                               // hash.cpp

}  // namespace braitenlab
