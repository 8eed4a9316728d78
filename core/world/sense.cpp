// Eyes read what stands in the fields of their channels.
#include <algorithm>

#include "core/maths/portable.h"
#include "core/world/state.h"

namespace braitenlab {

namespace {

// Everything that can be sensed on a channel now, in a fixed order: sources, then vehicles by row.
void gather(WorldState& s, Channel channel, std::vector<Stimulus>& out) {
    out.clear();
    for (const Source& source : s.scene->sources)
        if (is_seen_as(source.channel, channel)) out.push_back({{source.x, source.y}, source.strength, -1});
    const Role wanted = channel == Channel::predator ? Role::predator : Role::prey;
    if (channel != Channel::predator && channel != Channel::prey && channel != Channel::vehicle) return;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (channel == Channel::vehicle || s.role(row) == wanted)
            out.push_back({s.vehicles.motion[row].place, 1, static_cast<std::int32_t>(row)});
}

float read(const WorldState& s, const Eye& eye, const Gaze& gaze, std::int32_t self) {
    float sum = 0;
    if (eye.channel == Channel::obstacle) {
        for (const Outline& outline : s.outlines) sum += answer_to_outline(eye, gaze, outline);
    } else {
        s.fields[static_cast<std::size_t>(eye.channel)].near(gaze.from, eye.range, [&](const Stimulus& stimulus) {
            if (stimulus.owner != self || self < 0) sum += answer(eye, gaze, stimulus.place, stimulus.strength);
        });
    }
    return std::min(sum, 1.0f);  // signals add up and saturate
}

}  // namespace

float strength(const Moment& s, const Mark& mark) {
    const auto row = std::lower_bound(s.vehicles.id.begin(), s.vehicles.id.end(), mark.owner) - s.vehicles.id.begin();
    const auto kind = static_cast<std::size_t>(s.vehicles.kind[static_cast<std::size_t>(row)]);
    const PlaceMemory& memory = s.scene->kinds[kind].memory;
    constexpr float ln2 = 0.69314718f;
    const float age = static_cast<float>(s.tick - mark.tick) * tick_seconds;
    return memory.strength * maths::exponential(-ln2 * age / memory.fade);
}

void sense(WorldState& s) {
    s.eyes_are_stale = false;
    for (int c = 0; c < channel_count; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        if (!s.sensed_channel[channel]) continue;
        gather(s, static_cast<Channel>(c), s.stimuli);
        s.fields[channel].fill(s.stimuli);
    }
    Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        float* reading = v.sensed.data() + v.first_sensed[row];
        for (const Eye& eye : s.kinds[static_cast<std::size_t>(v.kind[row])].eyes) {
            const Gaze gaze = carry(eye, v.motion[row].place, v.motion[row].ahead);
            *reading++ = read(s, eye, gaze, static_cast<std::int32_t>(row));
        }
    }
}

}  // namespace braitenlab
