// What lies under a place: the floor there, and what the zones do to whoever stands on it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"

namespace braitenlab {

struct Ground {
    explicit Ground(const Scene&);

    // Of the last zone with a surface that covers the place, else of the arena.
    FloorConstants floor_at(maths::vec2 place) const;
    // N, from wind, slopes and pulls: what all zones there do to a vehicle of this mass (kg).
    maths::vec2 push_at(maths::vec2 place, float mass) const;
    // Energy a second that all zones there give.
    float recharge_at(maths::vec2 place) const;

    // Whether there is any zone that does such a thing; where not, nobody need ask.
    bool has_surfaces = false, pushes = false, recharges = false;
    FloorConstants plain;  // the arena's own

private:
    // A zone with everything worked out that no tick changes.
    struct Patch {
        maths::vec2 middle, ahead;
        float half_length = 0, half_width = 0;
        bool round = false, has_surface = false;
        FloorConstants floor{};
        float recharge = 0;
        maths::vec2 wind;
        float sine_of_slope = 0, pull = 0;
        bool covers(maths::vec2 place) const;
    };
    static Patch patch_of(const Zone&, const Arena&);
    void sort_into_cells(const Arena&);
    int column(float x) const;
    int row(float y) const;

    // Calls visit(patch) for every zone that covers the place, in the scene's order.
    template <class Visit>
    void at(maths::vec2 place, Visit visit) const;

    // Zones by square cells of the arena, so that a thousand of them cost no more than a few.
    std::vector<Patch> patches_;
    maths::vec2 origin_;
    float cell_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> first_, of_cell_;
};

}  // namespace braitenlab
