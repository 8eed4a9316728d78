#include "render/view/trails.h"

namespace braitenlab {

namespace {

constexpr std::uint64_t ticks_between = 6;   // a tenth of a second
constexpr float still = 0.04f, jump = 2.5f;  // m between two places

void extend(Trail& trail, maths::vec2 place) {
    if (trail.count > 0) {
        const float moved = maths::distance(trail.at(0), place);
        if (moved < still) return;
        if (moved > jump) trail.count = 0;
    }
    trail.newest = (trail.newest + 1) % Trail::capacity;
    trail.places[trail.newest] = place;
    if (trail.count < Trail::capacity) ++trail.count;
}

}  // namespace

void Trails::record(const Snapshot& now) {
    if (now.tick < tick_ || now.seed != seed_ || now.generation != generation_ || now.scene.get() != scene_)
        trails_.clear();
    tick_ = now.tick, seed_ = now.seed, generation_ = now.generation, scene_ = now.scene.get();
    for (const VehicleView& vehicle : now.vehicles) {
        const auto [found, is_new] = trails_.try_emplace(vehicle.id);
        Trail& trail = found->second;
        if (!is_new && now.tick < trail.seen + ticks_between) continue;
        trail.seen = now.tick;
        extend(trail, {vehicle.x, vehicle.y});
    }
    if (trails_.size() > now.vehicles.size())
        std::erase_if(trails_, [&](const auto& entry) { return !find_vehicle(now, entry.first); });
}

const Trail* Trails::of(VehicleId id) const {
    const auto found = trails_.find(id);
    return found == trails_.end() ? nullptr : &found->second;
}

}  // namespace braitenlab
