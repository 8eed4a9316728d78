#include "core/insight/compare.h"

#include <algorithm>
#include <cmath>

#include "core/sensing/compiled_sensor.h"
#include "core/sensing/intensity.h"
#include "core/sensing/stimulus_grid.h"

namespace braitenlab::insight {

bool is_same(const Design& a, const Design& b) { return a.sensors == b.sensors && same_wiring(a.brain, b.brain); }

Design design_of(const Snapshot& now, const VehicleView& vehicle) {
    return {*brain_of(now, vehicle), kind_of(now, vehicle).sensors};
}

std::vector<Command> commands_for(const Design& design, const Snapshot& now, const VehicleView& vehicle,
                                  Target target) {
    std::vector<Command> commands;
    const Design present = design_of(now, vehicle);
    if (present.sensors != design.sensors) commands.emplace_back(SetSensors{target, design.sensors});
    if (!same_wiring(present.brain, design.brain)) commands.emplace_back(SetBrain{target, design.brain});
    return commands;
}

float light_at(const Snapshot& now, const VehicleView& vehicle) {
    const sensing::IntensityInput input = intensity_input(now, Channel::light, vehicle.id);
    if (input.stimuli.empty()) return NAN;
    sensing::StimulusGrid stimuli;
    const sensing::CompiledSensor sensor(input.sensor);
    stimuli.lay_out(now.scene->arena, sensor.range);
    stimuli.fill(input.stimuli);
    constexpr std::int32_t no_row = -2;
    return std::min(1.0f, stimuli.total(sensor, sensing::sensor_pose(sensor, {vehicle.x, vehicle.y}, {1, 0}), no_row));
}

DesignRun::DesignRun(const CompareQuestion& question, const Design& design)
    : vehicle_(question.vehicle), ticks_(question.ticks) {
    World world = World::restore(question.start);
    world.capture(now_);
    const VehicleView* vehicle = find_vehicle(now_, vehicle_);
    if (!vehicle) return;
    for (const Command& command : commands_for(design, now_, *vehicle, question.target)) (void)world.apply(command);
    world_.emplace(std::move(world));
    judge_.emplace(*world_, vehicle_);
    run_.path.reserve(ticks_ + 1);
    add_tick();
}

bool DesignRun::advance(std::size_t ticks) {
    for (; world_ && ticks > 0; --ticks) {
        world_->step();
        add_tick();
    }
    return !world_;
}

void DesignRun::add_tick() {
    const bool goes_on = judge_->add(*world_);
    if (goes_on) {
        run_.path.push_back(judge_->pose());
        world_->capture(now_);
        const float light = light_at(now_, *find_vehicle(now_, vehicle_));
        has_light_ |= !std::isnan(light);
        if (run_.path.size() > 1 && light >= in_light_from) ++lit_ticks_;
    }
    if (goes_on && run_.path.size() <= ticks_) return;
    const Outcome outcome = judge_->outcome(*world_);
    constexpr float seam_jump = 1;  // m; across the seam of a torus
    double driven = 0;
    for (std::size_t i = 1; i < run_.path.size(); ++i) {
        const Pose &from = run_.path[i - 1], &to = run_.path[i];
        const float step = std::hypot(to.x - from.x, to.y - from.y);
        if (step < seam_jump) driven += static_cast<double>(step);
    }
    constexpr float tick = 1.0f / 60;  // s
    run_.numbers = {outcome.closest, outcome.time_to_touch, outcome.final_distance, static_cast<float>(driven),
                    has_light_ ? static_cast<float>(lit_ticks_) * tick : NAN};
    world_.reset();
}

float DesignRun::progress() const {
    if (!world_) return 1;
    return static_cast<float>(run_.path.size()) / static_cast<float>(ticks_ + 1);
}

ComparedRun run_design(const CompareQuestion& question, const Design& design) {
    DesignRun run(question, design);
    constexpr std::size_t piece = 1024;
    while (!run.advance(piece)) {
    }
    return run.run();
}

std::optional<float> difference(const CompareNumbers& a, const CompareNumbers& b, CompareMeasure measure) {
    const float one = a[static_cast<std::size_t>(measure)], other = b[static_cast<std::size_t>(measure)];
    if (!std::isfinite(one) || !std::isfinite(other)) return std::nullopt;
    return other - one;
}

}  // namespace braitenlab::insight
