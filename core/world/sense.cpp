// Sensors: each reads its channel; noise and delay of a real sensor are added.
#include <algorithm>

#include "core/maths/random.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

using sensing::CompiledSensor;
using sensing::SensorPose;

namespace {

sensing::Outline chassis_outline(const WorldData& s, std::size_t row) {
    const Body& body = s.scene->kinds[s.kind(row)].body;
    const float l = body.length / 2, w = body.width / 2;
    return sensing::outline_of({{-l, -w}, {l, -w}, {l, w}, {-l, w}}, s.vehicles.motion[row]);
}

// 1 while a contact of the vehicle is in the bumper's field, else 0.
float read_bumper(const WorldData& s, SensingBuffers& buffers, const CompiledSensor& sensor, std::size_t row) {
    const VehicleId id = s.vehicles.id[row];
    const Body& body = s.scene->kinds[s.kind(row)].body;
    const mechanics::Motion& motion = s.vehicles.motion[row];
    const auto touched = std::equal_range(buffers.touched.begin(), buffers.touched.end(), Touch{id, no_vehicle},
                                          [](const Touch& a, const Touch& b) { return a.one < b.one; });
    for (auto touch = touched.first; touch != touched.second; ++touch) {
        if (touch->other == no_vehicle) {
            s.environment.outlines.find_near(motion.position, body.length + body.width, buffers.touched_outlines);
            for (const sensing::Outline& outline : buffers.touched_outlines)
                if (sensing::touches_field(sensor, body, motion, outline)) return 1;
        } else if (const auto other = s.row_of(touch->other)) {
            if (sensing::touches_field(sensor, body, motion, chassis_outline(s, *other))) return 1;
        }
    }
    return 0;
}

// `chance`: of the vehicle in this tick; see CompiledKind::has_noise.
float read_sensor(const WorldData& s, SensingBuffers& buffers, const CompiledSensor& sensor, std::size_t row,
                  maths::Random& chance) {
    const mechanics::Motion& m = s.vehicles.motion[row];
    const SensorPose pose = sensing::sensor_pose(sensor, m.position, m.ahead);
    switch (sensor.channel) {
        case Channel::memory:
            return read_memory(s, sensor, pose, row);
        case Channel::touch:
            return read_bumper(s, buffers, sensor, row);
        case Channel::energy:
            return sensing::response_to_amount(sensor, static_cast<float>(s.vehicles.energy[row]));
        case Channel::random:
            return sensing::response_to_amount(sensor, chance.uniform(0, 1));
        default:
            return sensing::read_environment(s.environment, buffers.grids, sensor, pose,
                                             static_cast<std::int32_t>(row));
    }
}

// All touches in both directions, so that the vehicle on either side finds them.
void list_touches(const std::vector<Touch>& touching, std::vector<Touch>& out) {
    out = touching;
    for (const Touch& touch : touching)
        if (touch.other != no_vehicle) out.push_back({touch.other, touch.one});
    std::sort(out.begin(), out.end());
}

void fill(SensingBuffers& buffers, const WorldData& s) {
    buffers.point_sources.clear();
    for (const Source& source : s.scene->sources)
        buffers.point_sources.push_back(
            {source.channel, {source.x, source.y}, strength_at(source, seconds_at(s.tick)), source.candela});
    buffers.roles.clear();
    const auto is_sensed = [&](Channel channel) { return s.sensed_channel[static_cast<std::size_t>(channel)]; };
    if (is_sensed(Channel::predator) || is_sensed(Channel::prey))
        for (std::size_t row = 0; row < s.vehicles.size(); ++row) buffers.roles.push_back(s.role(row));
    const sensing::Emitters emitters{buffers.point_sources, s.scene->kinds, s.vehicles.motion, s.vehicles.kind,
                                     buffers.roles};
    for (int c = 0; c < channel_count; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!is_sensed(channel) || !sensing::has_stimuli(channel)) continue;
        sensing::gather_stimuli(emitters, s.environment.seam, channel, buffers.stimuli);
        buffers.grids[static_cast<std::size_t>(c)].fill(buffers.stimuli);
    }
    if (is_sensed(Channel::touch)) list_touches(s.touching, buffers.touched);
}

// Random numbers for one vehicle's sensors in one tick; a repeated reading has the same noise.
maths::Random noise_for(const WorldData& s, std::size_t row) {
    const auto id = static_cast<std::uint32_t>(s.vehicles.id[row]);
    const std::uint64_t beyond_stream = (s.tick >> 31U) * 0x9e3779b97f4a7c15ULL;  // a stream has 63 bits
    return {s.seed ^ 0x6e6f697365ULL ^ beyond_stream, (s.tick << 32U) | id};
}

// Random numbers for the gains of one vehicle's sensors: the same at every tick and for every spread.
maths::Random gains_for(const WorldData& s, std::size_t row) {
    return {s.parts_seed ^ 0x6761696eULL, static_cast<std::uint32_t>(s.vehicles.id[row])};
}

// The sample that a sensor with an interval holds is in the slot before its ring.
float held_sample(const WorldData& s, const CompiledSensor& sensor, float value, std::size_t slot,
                  std::vector<float>* keep) {
    if (!sensing::is_sampled(sensor.interval, s.tick)) return s.vehicles.delayed[slot];
    if (keep) (*keep)[slot] = value;
    return value;
}

// Reads all sensors into `sensed`. A sensor with latency returns its reading of `delay` ticks ago from its ring buffer;
// the new reading replaces it in `keep_delayed` unless that is null.
void read_sensors(const WorldData& s, SensingBuffers& buffers, std::vector<float>& sensed,
                  std::vector<float>* keep_delayed) {
    fill(buffers, s);
    const Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const CompiledKind& kind = s.compiled(row);
        float* reading = sensed.data() + v.first_sensed[row];
        std::size_t ring = v.first_delayed[row];
        maths::Random chance;
        if (kind.has_noise) chance = noise_for(s, row);
        maths::Random gains;
        if (kind.has_gain_spread) gains = gains_for(s, row);
        for (const CompiledSensor& sensor : kind.sensors) {
            float value = read_sensor(s, buffers, sensor, row, chance);
            if (kind.has_gain_spread) value *= 1 + sensor.gain_spread * gains.uniform(-1, 1);
            if (sensor.noise > 0) value += sensor.noise * chance.normal();
            value = std::clamp(value, 0.0f, 1.0f);  // signals add up and saturate
            if (sensor.steps > 0) value = sensing::converted(value, sensor.steps);
            if (sensor.interval > 0) value = held_sample(s, sensor, value, ring++, keep_delayed);
            if (sensor.delay > 0) {
                const std::size_t slot = ring + s.tick % sensor.delay;
                const float delayed = v.delayed[slot];
                if (keep_delayed) (*keep_delayed)[slot] = value;
                value = delayed;
                ring += sensor.delay;
            }
            *reading++ = value;
        }
    }
}

}  // namespace

void sense(WorldData& s) {
    read_sensors(s, s.sensing_buffers, s.vehicles.sensed, &s.vehicles.delayed);
    s.readings_are_stale = false;
}

std::vector<float> sense_preview(const WorldData& s) {
    SensingBuffers buffers;
    buffers.grids = s.sensing_buffers.grids;  // for their layout
    std::vector<float> sensed(s.vehicles.sensed.size());
    read_sensors(s, buffers, sensed, nullptr);
    return sensed;
}

}  // namespace braitenlab::world
