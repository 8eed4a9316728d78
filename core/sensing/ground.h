// The floor and the zones at a position: surface constants, forces, energy. In a torus a zone that reaches over an edge
// continues at the opposite one.
#pragma once

#include <cstdint>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab::sensing {

struct Ground {
    explicit Ground(const Scene&);

    // Constants of the last zone with a surface that covers the position, else of the arena.
    FloorConstants floor_at(maths::vec2 position) const;
    // Force (N) of all zones there on a vehicle of this mass (kg): wind, slope and pull.
    maths::vec2 push_at(maths::vec2 position, float mass) const;
    // Energy per second that all zones there give.
    float recharge_at(maths::vec2 position) const;

    // True when any zone has such an effect; when false, callers can skip the query.
    bool has_surfaces = false, pushes = false, recharges = false;
    FloorConstants plain;  // the arena's own

private:
    // A zone with all constants precomputed.
    struct Patch {
        maths::vec2 middle, ahead;
        float half_length = 0, half_width = 0;  // m, of a rectangle around the middle that contains the zone
        std::vector<maths::vec2> corners;       // of a polygon, else empty
        bool round = false, has_surface = false;
        FloorConstants floor{};
        float recharge = 0;
        maths::vec2 wind;
        float sine_of_slope = 0, pull = 0;
        bool covers(maths::vec2 position) const;
        maths::vec2 reach() const;  // m, half the size of its bounding box
    };
    static Patch patch_of(const Zone&, const Arena&);
    void sort_into_cells(const Arena&);
    int column(float x) const;
    int row(float y) const;

    // Calls visit(patch) for every zone that covers the position, in the order of Scene::zones.
    template <class Visit>
    void at(maths::vec2 position, Visit visit) const;

    // Zones sorted into square cells of the arena: the cost of a query does not grow with their number.
    std::vector<Patch> patches_;
    maths::vec2 origin_;
    float cell_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> first_, of_cell_;
};

}  // namespace braitenlab::sensing
