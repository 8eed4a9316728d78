// Sensors read what there is on their channels: fields of what others give off, outlines of what stands in the way, and
// what concerns the vehicle itself. Then comes what real sensors add: noise, and time.
#include <algorithm>

#include "core/maths/random.h"
#include "core/world/bumper.h"
#include "core/world/state.h"

namespace braitenlab {

using maths::vec2;

namespace {

// Channels whose signals come from places, and add up.
bool is_field(Channel channel) { return channel < Channel::memory && channel != Channel::obstacle; }

void gather_lamps(const WorldState& s, Channel channel, std::vector<Stimulus>& out) {
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        const Motion& m = s.vehicles.motion[row];
        for (const CarriedLamp& lamp : s.scene->kinds[s.kind(row)].lamps)
            if (is_seen_as(lamp.channel, channel))
                out.push_back({s.seam.inside(m.place + maths::rotate({lamp.x, lamp.y}, m.ahead)), lamp.strength,
                               static_cast<std::int32_t>(row)});
    }
}

// Everything that can be sensed on a channel now, in a fixed order: sources, vehicles by row, the lamps they carry.
void gather(const WorldState& s, Channel channel, std::vector<Stimulus>& out) {
    out.clear();
    for (const Source& source : s.scene->sources)
        if (is_seen_as(source.channel, channel))
            out.push_back({s.seam.inside({source.x, source.y}), source.strength, -1});
    if (channel == Channel::predator || channel == Channel::prey || channel == Channel::vehicle) {
        const Role wanted = channel == Channel::predator ? Role::predator : Role::prey;
        for (std::size_t row = 0; row < s.vehicles.size(); ++row)
            if (channel == Channel::vehicle || s.role(row) == wanted)
                out.push_back({s.seam.inside(s.vehicles.motion[row].place), 1, static_cast<std::int32_t>(row)});
    }
    const bool anyone_carries = std::any_of(s.scene->kinds.begin(), s.scene->kinds.end(), [&](const Kind& kind) {
        return std::any_of(kind.lamps.begin(), kind.lamps.end(),
                           [&](const CarriedLamp& lamp) { return is_seen_as(lamp.channel, channel); });
    });
    if (anyone_carries) gather_lamps(s, channel, out);
}

float read_field(const WorldState& s, const Eye& eye, Gaze gaze, std::size_t row) {
    const Field& field = s.fields[static_cast<std::size_t>(eye.channel)];
    const auto self = static_cast<std::int32_t>(row);
    gaze.from = s.seam.inside(gaze.from);
    if (!eye.obstacles_may_hide || !s.outlines.any_obstacle_near(gaze.from, eye.range))
        return field.total(eye, gaze, self);
    return field.total_in_sight(eye, gaze, self, [&](vec2 from, vec2 to) { return s.outlines.hide(from, to); });
}

Outline chassis_outline(const WorldState& s, std::size_t row) {
    const Body& body = s.scene->kinds[s.kind(row)].body;
    const float l = body.length / 2, w = body.width / 2;
    return outline_of({{-l, -w}, {l, -w}, {l, w}, {-l, w}}, s.vehicles.motion[row]);
}

// 1 while the vehicle touches something in the bumper's field.
float read_bumper(WorldState& s, const Eye& eye, std::size_t row) {
    const VehicleId id = s.vehicles.id[row];
    const Body& body = s.scene->kinds[s.kind(row)].body;
    const Motion& motion = s.vehicles.motion[row];
    const auto touched = std::equal_range(s.touched.begin(), s.touched.end(), Touch{id, no_vehicle},
                                          [](const Touch& a, const Touch& b) { return a.one < b.one; });
    for (auto touch = touched.first; touch != touched.second; ++touch) {
        if (touch->other == no_vehicle) {
            s.outlines.near(motion.place, body.length + body.width, s.touched_outlines);
            for (const Outline& outline : s.touched_outlines)
                if (feels(eye, body, motion, outline)) return 1;
        } else if (const auto other = s.row_of(touch->other)) {
            if (feels(eye, body, motion, chassis_outline(s, *other))) return 1;
        }
    }
    return 0;
}

// A boolean sensor for something that is always there tells whether it is at least half.
float as_response(const Eye& eye, float amount) {
    return eye.response == SensorResponse::graded ? amount : amount >= 0.5f ? 1.0f : 0.0f;
}

float read(WorldState& s, const Eye& eye, std::size_t row) {
    const Motion& m = s.vehicles.motion[row];
    const Gaze gaze = carry(eye, m.place, m.ahead);
    switch (eye.channel) {
        case Channel::obstacle:
            return s.outlines.total(eye, gaze);
        case Channel::memory:
            return read_memory(s, eye, gaze, row);
        case Channel::touch:
            return read_bumper(s, eye, row);
        case Channel::floor:
            return as_response(eye, s.ground.floor_at(s.seam.inside(gaze.from)).reflectance);
        case Channel::energy:
            return as_response(eye, s.vehicles.energy[row]);
        default:
            return read_field(s, eye, gaze, row) + (eye.is_lit ? s.scene->arena.ambient : 0.0f);
    }
}

// Everyone's touches, found by either of the two that touch.
void list_touches(WorldState& s) {
    s.touched = s.touching;
    for (const Touch& touch : s.touching)
        if (touch.other != no_vehicle) s.touched.push_back({touch.other, touch.one});
    std::sort(s.touched.begin(), s.touched.end());
}

void fill_fields(WorldState& s) {
    for (int c = 0; c < channel_count; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        if (!s.sensed_channel[channel] || !is_field(static_cast<Channel>(c))) continue;
        gather(s, static_cast<Channel>(c), s.stimuli);
        s.fields[channel].fill(s.stimuli);
    }
    if (s.sensed_channel[static_cast<std::size_t>(Channel::touch)]) list_touches(s);
}

// Chance for one vehicle's sensors in one tick: looking twice sees the same.
maths::Random noise_for(const WorldState& s, std::size_t row) {
    const auto id = static_cast<std::uint32_t>(s.vehicles.id[row]);
    return {s.seed ^ 0x6e6f697365ULL, (s.tick << 32U) | id};
}

// What a slow sensor saw a while ago, in exchange for what it sees now. A ring of as many readings as it is ticks late.
float exchange(const WorldState& s, std::vector<float>& late, std::size_t first, const Eye& eye, float now, bool keep) {
    float& slot = late[first + s.tick % eye.late];
    const float then = slot;
    if (keep) slot = now;
    return then;
}

void look(WorldState& s, bool keep_for_later) {
    s.eyes_are_stale = false;
    fill_fields(s);
    Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const CompiledKind& kind = s.kinds[s.kind(row)];
        float* reading = v.sensed.data() + v.first_sensed[row];
        std::size_t first_late = v.first_late[row];
        maths::Random chance;
        if (kind.has_noise) chance = noise_for(s, row);
        for (const Eye& eye : kind.eyes) {
            float value = read(s, eye, row);
            if (eye.noise > 0) value += eye.noise * chance.normal();
            value = std::clamp(value, 0.0f, 1.0f);  // signals add up and saturate
            if (eye.late > 0) {
                value = exchange(s, v.late, first_late, eye, value, keep_for_later);
                first_late += eye.late;
            }
            *reading++ = value;
        }
    }
}

}  // namespace

void sense(WorldState& s) { look(s, true); }
void glance(WorldState& s) { look(s, false); }

}  // namespace braitenlab
