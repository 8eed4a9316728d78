#include "core/evolve/duel.h"

#include <cmath>

namespace braitenlab::evolve {

float number_of(const BreedingBase& base, const Trial& trial, const Duel& duel) {
    if (base.breeding().measure) return run_of(base, trial);
    return duel.is_eaten ? duel.seconds() : base.breeding().seconds;
}

DuelRun::DuelRun(const BreedingBase& base, const Trial& trial)
    : world_(std::move(*World::create(scene_of(base, trial), trial.seed))),
      most_(static_cast<std::size_t>(std::lround(base.breeding().seconds * 60))),
      ends_with_capture_(!base.breeding().measure) {
    record();
}

void DuelRun::record() {
    world_.capture(now_);
    for (const VehicleView& vehicle : now_.vehicles) {
        std::vector<Pose>& path = at(duel_.paths, vehicle.role == Role::predator ? Side::predator : Side::prey);
        if (vehicle.role != Role::none && path.size() == world_.tick())
            path.push_back({vehicle.x, vehicle.y, vehicle.heading});
    }
    // The prey that is eaten stays where it was, so that both paths have the same length.
    for (std::vector<Pose>& path : duel_.paths)
        if (path.size() == world_.tick() && !path.empty()) path.push_back(path.back());
    duel_.is_eaten = world_.events().captures > 0;
}

bool DuelRun::advance(std::size_t ticks) {
    const auto has_ended = [&] { return world_.tick() >= most_ || (ends_with_capture_ && duel_.is_eaten); };
    for (; ticks > 0 && !has_ended(); --ticks) world_.step(), record();
    return has_ended();
}

}  // namespace braitenlab::evolve
