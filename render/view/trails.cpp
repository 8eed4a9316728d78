#include "render/view/trails.h"

#include <algorithm>
#include <cmath>

namespace braitenlab {

namespace {

constexpr std::uint64_t ticks_between = 6;  // a tenth of a second
constexpr float still = 0.04f;              // m between two places

// Whether a vehicle that jumped from one place to the other went over the edge of a torus.
bool went_round(const Arena& arena, maths::vec2 from, maths::vec2 to) {
    const auto around = [](float way, float side) { return std::min(std::fabs(way), side - std::fabs(way)); };
    return arena.edge == Edge::torus &&
           std::hypot(around(to.x - from.x, arena.width), around(to.y - from.y, arena.height)) <= Trail::jump;
}

void extend(Trail& trail, maths::vec2 place, const Arena& arena) {
    if (trail.count > 0) {
        const float moved = maths::distance(trail.at(0), place);
        if (moved < still) return;
        if (moved > Trail::jump && !went_round(arena, trail.at(0), place)) trail.count = 0;
    }
    trail.newest = (trail.newest + 1) % Trail::capacity;
    trail.places[trail.newest] = place;
    if (trail.count < Trail::capacity) ++trail.count;
}

}  // namespace

void Trails::record(const Snapshot& now) {
    // Edits make a new scene of the same name: the run goes on.
    const std::string name = now.scene ? now.scene->name : std::string{};
    const Arena arena = now.scene ? now.scene->arena : Arena{};
    if (now.tick < tick_ || now.seed != seed_ || now.generation != generation_ || name != scene_) trails_.clear();
    tick_ = now.tick, seed_ = now.seed, generation_ = now.generation, scene_ = name;
    for (const VehicleView& vehicle : now.vehicles) {
        const auto [found, is_new] = trails_.try_emplace(vehicle.id);
        Trail& trail = found->second;
        if (!is_new && now.tick < trail.seen + ticks_between) continue;
        trail.seen = now.tick;
        extend(trail, {vehicle.x, vehicle.y}, arena);
    }
    if (trails_.size() > now.vehicles.size())
        std::erase_if(trails_, [&](const auto& entry) { return !find_vehicle(now, entry.first); });
}

const Trail* Trails::of(VehicleId id) const {
    const auto found = trails_.find(id);
    return found == trails_.end() ? nullptr : &found->second;
}

}  // namespace braitenlab
