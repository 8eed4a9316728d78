// The runs of a breeding.
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/evolve/breeding.h"
#include "core/insight/run_judge.h"
#include "core/insight/study.h"

namespace braitenlab::evolve {

namespace {

float time_of_capture(World& world, std::uint64_t ticks, float seconds) {
    while (world.tick() < ticks && world.events().captures == 0) world.step();
    return world.events().captures == 0 ? seconds : static_cast<float>(world.tick()) / 60;
}

VehicleId prey_in(const World& start) {
    for (const VehicleView& vehicle : snapshot_of(start).vehicles)
        if (vehicle.role == Role::prey) return vehicle.id;
    return no_vehicle;
}

float measured(World& world, std::uint64_t ticks, insight::StudyMeasure measure) {
    std::optional<insight::RunJudge> judge;
    insight::Outcome outcome;
    if (row_of(measure).of_vehicle) judge.emplace(world, prey_in(world));
    for (;;) {
        if (judge && (!judge->add(world) || world.tick() >= ticks)) outcome = judge->outcome(world), judge.reset();
        if (world.tick() >= ticks) break;
        world.step();
    }
    return static_cast<float>(insight::number_of(measure, snapshot_of(world), outcome));
}

}  // namespace

Scene scene_of(const BreedingBase& base, const Trial& trial) {
    Scene scene = base.scene();
    for (const auto& kind : trial.kinds)
        *std::find_if(scene.kinds.begin(), scene.kinds.end(), [&](const Kind& k) { return k.name == kind->name; }) =
            *kind;
    return scene;
}

float run_of(const BreedingBase& base, const Trial& trial) {
    const Breeding& breeding = base.breeding();
    auto world = World::create(scene_of(base, trial), trial.seed);
    if (!world) return breeding.seconds;
    const auto ticks = static_cast<std::uint64_t>(std::lround(breeding.seconds * 60));
    return breeding.measure ? measured(*world, ticks, *breeding.measure)
                            : time_of_capture(*world, ticks, breeding.seconds);
}

float score_of(const Breeding& breeding, Side side, float number) {
    const bool is_time = !breeding.measure || row_of(*breeding.measure).unit == "s";
    float share = 0.5F;
    if (std::isinf(number))
        share = 1;
    else if (!std::isnan(number))
        share = is_time ? std::min(1.0F, number / breeding.seconds) : number / (1 + number);
    const bool has_share = (side == Side::predator) == (breeding.predator_better == Better::more);
    return has_share ? share : 1 - share;
}

}  // namespace braitenlab::evolve
