// What happens between bodies and over time: bites, energy, deaths and births, and the timer of an idle world.
#include <algorithm>
#include <cmath>

#include "core/brain/brain.h"
#include "core/world/state.h"

namespace braitenlab {

namespace {

constexpr std::uint64_t bite_ticks = 60;  // one bite a second and pair
constexpr float moving_speed = 0.05f;     // m/s; slower counts as standing still

void bite(WorldState& s, std::size_t predator, std::size_t prey) {
    const float taken = std::min(s.scene->ecology.bite, s.vehicles.energy[prey]);
    s.vehicles.energy[prey] -= taken;
    s.vehicles.energy[predator] = std::min(1.0f, s.vehicles.energy[predator] + taken);
    ++s.events.captures;
}

void bite_prey(WorldState& s) {
    std::erase_if(s.bites, [&](const Bite& b) { return s.tick - b.tick >= bite_ticks; });
    for (const Touch& pair : s.touching) {
        if (pair.other == no_vehicle) continue;
        const auto one = s.row_of(pair.one), other = s.row_of(pair.other);
        if (!one || !other) continue;
        const bool first_hunts = s.role(*one) == Role::predator && s.role(*other) == Role::prey;
        const bool second_hunts = s.role(*other) == Role::predator && s.role(*one) == Role::prey;
        if (!first_hunts && !second_hunts) continue;
        const bool bitten_lately =
            std::any_of(s.bites.begin(), s.bites.end(), [&](const Bite& b) { return b.pair == pair; });
        if (bitten_lately) continue;
        s.bites.push_back({pair, s.tick});
        first_hunts ? bite(s, *one, *other) : bite(s, *other, *one);
    }
}

// The first kind of the opposite role, else the kind itself.
int successor_kind(const Scene& scene, int kind) {
    const Role role = scene.kinds[static_cast<std::size_t>(kind)].role;
    const Role opposite = role == Role::predator ? Role::prey : role == Role::prey ? Role::predator : Role::none;
    if (opposite == Role::none) return kind;
    for (std::size_t k = 0; k < scene.kinds.size(); ++k)
        if (scene.kinds[k].role == opposite) return static_cast<int>(k);
    return kind;
}

void spend_energy(WorldState& s) {
    const float spent = s.scene->ecology.drain * tick_seconds;
    for (float& energy : s.vehicles.energy) energy = std::max(0.0f, energy - spent);
}

// Whoever has no energy left leaves, and one of the opposite role enters elsewhere.
void bury_and_bear(WorldState& s) {
    for (std::size_t row = 0; row < s.vehicles.size();) {
        if (s.vehicles.energy[row] > 0) {
            ++row;
            continue;
        }
        const int kind = successor_kind(*s.scene, s.vehicles.kind[row]);
        remove_vehicle(s, row);
        ++s.events.deaths;
        const VehicleId id = s.next_id++;
        add_vehicle(s, kind, -1, id, s.newcomers[static_cast<std::size_t>(kind)], free_place(s, id));
        ++s.events.births;
    }
}

void watch_inactivity(WorldState& s) {
    const bool anyone_moves = std::any_of(s.vehicles.motion.begin(), s.vehicles.motion.end(),
                                          [](const Motion& m) { return maths::length(m.velocity) > moving_speed; });
    s.still_ticks = anyone_moves ? 0 : s.still_ticks + 1;
    const float limit = s.scene->ecology.inactivity;
    if (limit > 0 && s.vehicles.size() > 0 && static_cast<float>(s.still_ticks) * tick_seconds >= limit) repopulate(s);
}

}  // namespace

void touch_and_live(WorldState& s) {
    s.events.contacts += static_cast<std::int64_t>(s.begun.size());
    bite_prey(s);
    spend_energy(s);
    bury_and_bear(s);
    watch_inactivity(s);
}

}  // namespace braitenlab
