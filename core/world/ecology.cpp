// Ecology: bites, energy, falls, deaths, births and the inactivity timer.
#include <algorithm>

#include "core/brain/brain.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

namespace {

constexpr std::uint64_t bite_ticks = 60;    // between two bites of one pair: 1 s
constexpr std::uint64_t strike_ticks = 60;  // between two strikes of one pair: 1 s
constexpr float moving_speed = 0.05f;       // m/s; a slower vehicle counts as still

void bite(WorldData& s, std::size_t predator, std::size_t prey) {
    const double taken = std::min(static_cast<double>(s.scene->ecology.bite), s.vehicles.energy[prey]);
    s.vehicles.energy[prey] -= taken;
    s.vehicles.energy[predator] = std::min(1.0, s.vehicles.energy[predator] + taken);
    ++s.events.captures;
}

void bite_prey(WorldData& s) {
    std::erase_if(s.bites, [&](const Bite& b) { return s.tick - b.tick >= bite_ticks; });
    const auto before = static_cast<std::ptrdiff_t>(s.bites.size());
    const auto by_pair = [](const Bite& a, const Bite& b) { return a.pair < b.pair; };
    for (const Touch& pair : s.touching) {
        if (pair.other == no_vehicle) continue;
        const auto one = s.row_of(pair.one), other = s.row_of(pair.other);
        if (!one || !other) continue;
        const bool first_hunts = s.role(*one) == Role::predator && s.role(*other) == Role::prey;
        const bool second_hunts = s.role(*other) == Role::predator && s.role(*one) == Role::prey;
        if (!first_hunts && !second_hunts) continue;
        if (std::binary_search(s.bites.begin(), s.bites.begin() + before, Bite{pair}, by_pair)) continue;
        s.bites.push_back({pair, s.tick});
        first_hunts ? bite(s, *one, *other) : bite(s, *other, *one);
    }
    std::inplace_merge(s.bites.begin(), s.bites.begin() + before, s.bites.end(), by_pair);
}

void record_strikes(WorldData& s) {
    std::erase_if(s.strikes, [&](const Strike& strike) { return s.tick - strike.tick >= strike_ticks; });
    s.physics.find_strikes(s.begun, s.struck);
    const auto before = static_cast<std::ptrdiff_t>(s.strikes.size());
    const auto by_pair = [](const Strike& a, const Strike& b) { return a.pair() < b.pair(); };
    for (const Bump& bump : s.struck) {
        const Strike strike{bump.vehicle, bump.at, s.tick, bump.other};
        if (!std::binary_search(s.strikes.begin(), s.strikes.begin() + before, strike, by_pair))
            s.strikes.push_back(strike);
    }
    std::inplace_merge(s.strikes.begin(), s.strikes.begin() + before, s.strikes.end(), by_pair);
}

// The first kind of the opposite role, or the vehicle's kind if there is none. Roles that follow from the wiring count
// like roles set in the scene.
int successor_kind(const WorldData& s, std::size_t row) {
    const Role role = s.role(row);
    const Role opposite = role == Role::predator ? Role::prey : role == Role::prey ? Role::predator : Role::none;
    if (opposite == Role::none) return s.vehicles.kind[row];
    for (std::size_t k = 0; k < s.kind_brains.size(); ++k)
        if (s.kind_brains[k]->role == opposite) return static_cast<int>(k);
    return s.vehicles.kind[row];
}

void spend_energy(WorldData& s) {
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        double& energy = s.vehicles.energy[row];
        float rate = -s.scene->ecology.drain;
        if (s.environment.ground.recharges) rate += s.environment.ground.recharge_at(s.vehicles.motion[row].position);
        energy = std::clamp(energy + static_cast<double>(rate * tick_seconds), 0.0, 1.0);
    }
}

// Respawns each vehicle that is beyond an open edge. It keeps its id, so that a selection in the window stays valid.
void fall(WorldData& s) {
    s.fallen.clear();
    if (s.scene->arena.edge != Boundary::open) return;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        if (!is_outside(s.scene->arena, s.vehicles.motion[row].position)) continue;
        ++s.events.falls, ++s.events.deaths, ++s.events.births;
        s.fallen.push_back(s.vehicles.id[row]);
        respawn(s, row);
    }
}

// Replaces each vehicle without energy by a new one of the opposite role at a random pose.
void replace_starved(WorldData& s) {
    std::vector<std::size_t> starved;
    std::vector<int> successors;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        if (s.vehicles.energy[row] > 0) continue;
        starved.push_back(row);
        successors.push_back(successor_kind(s, row));
    }
    if (starved.empty()) return;
    remove_vehicles(s, starved);
    FreeSpace free_space(s);
    for (const int kind : successors) {
        const VehicleId id = s.next_id++;
        add_vehicle(s, kind, -1, id, s.kind_brains[static_cast<std::size_t>(kind)], free_pose(s, free_space, kind, id));
        ++s.events.deaths, ++s.events.births;
    }
    // Many bodies added at random positions make Box2D's tree slow; a rebuilt world adds all bodies in order of
    // position.
    constexpr std::size_t many = 256;
    if (starved.size() > many) s.rebuild();
}

void watch_inactivity(WorldData& s) {
    const bool anyone_moves =
        std::any_of(s.vehicles.motion.begin(), s.vehicles.motion.end(),
                    [](const mechanics::Motion& m) { return maths::length(m.velocity) > moving_speed; });
    s.still_ticks = anyone_moves ? 0 : s.still_ticks + 1;
    const float limit = s.scene->ecology.inactivity;
    if (limit > 0 && s.vehicles.size() > 0 && static_cast<float>(s.still_ticks) * tick_seconds >= limit)
        new_generation(s);
}

}  // namespace

void touch_and_live(WorldData& s) {
    s.events.contacts += static_cast<std::int64_t>(s.begun.size());
    bite_prey(s);
    record_strikes(s);
    spend_energy(s);
    fall(s);
    replace_starved(s);
    watch_inactivity(s);
}

}  // namespace braitenlab::world
