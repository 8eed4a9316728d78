#include "core/insight/origin.h"

#include <cstddef>

#include "core/maths/angle.h"
#include "core/sensing/compiled_sensor.h"
#include "core/sensing/environment.h"
#include "core/sensing/intensity.h"

namespace braitenlab::insight {

namespace {

// Of each stimulus of intensity_input(), in its order: the sources of the channel, then the others.
Origin origin_of(const Snapshot& now, const VehicleView& vehicle, Channel channel, std::size_t stimulus,
                 std::int32_t owner) {
    if (owner < 0) {
        for (const SourceView& source : now.sources)
            if (is_seen_as(source.channel, channel) && stimulus-- == 0) return {.source = source.source};
        return {};
    }
    for (const VehicleView& other : now.vehicles)  // the owner is a row without the vehicle that senses
        if (other.id != vehicle.id && owner-- == 0) return {.vehicle = other.id};
    return {};
}

}  // namespace

std::optional<Origin> main_origin(const Snapshot& now, const VehicleView& vehicle, const Sensor& given) {
    if (!now.scene || !sensing::has_stimuli(given.channel) || given.channel == Channel::memory) return std::nullopt;
    const sensing::IntensityInput input = intensity_input(now, given.channel, vehicle.id);
    const sensing::Environment around(*now.scene, input.obstacles);
    const sensing::CompiledSensor sensor(given);
    sensing::SensorPose pose = sensing::sensor_pose(sensor, {vehicle.x, vehicle.y}, maths::direction(vehicle.heading));
    pose.position = around.seam.inside(pose.position);
    float sum = 0, most = 0;
    std::size_t strongest = 0;
    for (std::size_t i = 0; i < input.stimuli.size(); ++i) {
        const sensing::Stimulus& stimulus = input.stimuli[i];
        const maths::vec2 at = pose.position + around.seam.shortest(stimulus.position - pose.position);
        const float strength = sensing::strength_for(sensor, stimulus.strength, stimulus.candela);
        const float response = sensing::response_to(sensor, pose, at, strength);
        if (response <= 0 || (sensor.is_blocked && around.outlines.block(pose.position, at))) continue;
        sum += response;
        if (response > most) most = response, strongest = i;
    }
    if (most <= 0.5f * sum) return std::nullopt;
    return origin_of(now, vehicle, given.channel, strongest, input.stimuli[strongest].owner);
}

}  // namespace braitenlab::insight
