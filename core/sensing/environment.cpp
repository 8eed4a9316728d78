#include "core/sensing/environment.h"

#include <algorithm>

namespace braitenlab::sensing {

using maths::vec2;

namespace {

void gather_lamps(const Emitters& e, const Seam& seam, Channel channel, std::vector<Stimulus>& out) {
    for (std::size_t row = 0; row < e.motion.size(); ++row)
        for (const CarriedLamp& lamp : e.kinds[static_cast<std::size_t>(e.kind[row])].lamps)
            if (is_seen_as(lamp.channel, channel))
                out.push_back({seam.inside(mechanics::to_world(e.motion[row], {lamp.x, lamp.y})), lamp.strength,
                               static_cast<std::int32_t>(row), lamp.candela});
}

float read_stimuli(const Environment& e, const StimulusGrid& grid, const CompiledSensor& sensor, const SensorPose& pose,
                   std::int32_t self) {
    if (!sensor.is_blocked || !e.outlines.any_obstacle_near(pose.position, sensor.range))
        return grid.total(sensor, pose, self);
    return grid.total_in_sight(sensor, pose, self, [&](vec2 from, vec2 to) { return e.outlines.block(from, to); });
}

}  // namespace

bool has_stimuli(Channel channel) { return row_of(channel).is_summed; }

void gather_stimuli(const Emitters& e, const Seam& seam, Channel channel, std::vector<Stimulus>& out) {
    out.clear();
    for (const PointSource& source : e.sources)
        if (is_seen_as(source.channel, channel))
            out.push_back({seam.inside(source.position), source.strength, -1, source.candela});
    if (channel == Channel::predator || channel == Channel::prey || channel == Channel::vehicle) {
        const Role wanted = channel == Channel::predator ? Role::predator : Role::prey;
        for (std::size_t row = 0; row < e.motion.size(); ++row)
            if (channel == Channel::vehicle || e.role[row] == wanted)
                out.push_back({seam.inside(e.motion[row].position), 1, static_cast<std::int32_t>(row)});
    }
    const bool is_carried = std::any_of(e.kinds.begin(), e.kinds.end(), [&](const Kind& kind) {
        return std::any_of(kind.lamps.begin(), kind.lamps.end(),
                           [&](const CarriedLamp& lamp) { return is_seen_as(lamp.channel, channel); });
    });
    if (is_carried) gather_lamps(e, seam, channel, out);
}

Environment::Environment(const Scene& scene, const std::vector<mechanics::Motion>& obstacles)
    : ground(scene),
      outlines(scene, obstacles),
      seam(scene.arena),
      ambient(scene.arena.ambient),
      lux(scene.arena.lux) {}

float read_environment(const Environment& e, const StimulusGrids& grids, const CompiledSensor& sensor, SensorPose pose,
                       std::int32_t self) {
    if (sensor.channel == Channel::obstacle) return total_reading(sensor, e.outlines.total(sensor, pose), 0);
    pose.position = e.seam.inside(pose.position);
    if (sensor.channel == Channel::floor)
        return response_to_amount(sensor, e.ground.floor_at(pose.position).reflectance);
    const StimulusGrid& grid = grids[static_cast<std::size_t>(sensor.channel)];
    const float light = read_stimuli(e, grid, sensor, pose, self);
    return sensor.sees_ambient_light ? total_reading(sensor, light, e.ambient, e.lux) : total_reading(sensor, light, 0);
}

}  // namespace braitenlab::sensing
