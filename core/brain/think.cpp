// One tick of a brain, over flat arrays.
#include <algorithm>
#include <vector>

#include "core/brain/brain.h"

namespace braitenlab {

namespace {

// The values of the previous and of this tick, and which of the two a unit reads.
struct TickValues {
    const Brain& brain;
    std::span<const float> sensed;
    const float* held;     // units of the previous tick
    const float* learned;  // parts of the Hebbian wires
    float* settled;        // units of this tick

    float sensor(std::size_t source) const {
        const std::int32_t index = brain.sensors[source];
        return index < 0 ? 0.0f : sensed[static_cast<std::size_t>(index)];
    }
    // Read by hidden neurons: units of the previous tick.
    float before(std::size_t source) const {
        const std::size_t sensors = brain.sensors.size();
        return source < sensors ? sensor(source) : held[source - sensors];
    }
    // Read by motors: hidden neurons of this tick, motors of the previous one.
    float now(std::size_t source) const {
        const std::size_t sensors = brain.sensors.size();
        if (source < sensors) return sensor(source);
        const std::size_t unit = source - sensors;
        return unit + 2 < brain.units.size() ? settled[unit] : held[unit];
    }
};

// A unit's new value.
template <bool learning, class Read>
float settle(const TickValues& t, std::size_t u, Read read) {
    const Brain::Unit& unit = t.brain.units[u];
    float sum = unit.bias;
    for (std::int32_t i = unit.first_tap; i < unit.end_tap; ++i) {
        const Brain::Tap& tap = t.brain.taps[static_cast<std::size_t>(i)];
        const float passed = masked(read(static_cast<std::size_t>(tap.source)), tap.threshold);
        float weight = tap.weight;
        if constexpr (learning) weight += tap.learned < 0 ? 0.0f : t.learned[tap.learned];
        sum += weight * (tap.curve.response == Response::linear ? passed : respond(tap.curve, passed));
    }
    const float target = unit.curve.response == Response::linear ? sum : respond(unit.curve, sum);
    // Bounded, so that a loop of wires with a gain above 1 stays finite.
    return std::clamp(t.held[u] + unit.follow * (target - t.held[u]), -1e3f, 1e3f);
}

template <bool learning>
void settle_all(const TickValues& t) {
    const std::size_t count = t.brain.units.size(), hidden = count - 2;
    for (std::size_t u = 0; u < hidden; ++u)
        t.settled[u] = settle<learning>(t, u, [&](std::size_t source) { return t.before(source); });
    for (std::size_t u = hidden; u < count; ++u)
        t.settled[u] = settle<learning>(t, u, [&](std::size_t source) { return t.now(source); });
}

// Changes the learned parts of a unit's Hebbian wires: see Wire::learning_rate.
template <class Read>
void learn(const TickValues& t, std::size_t u, float* learned, Read read) {
    const Brain::Unit& unit = t.brain.units[u];
    for (std::int32_t i = unit.first_tap; i < unit.end_tap; ++i) {
        const Brain::Tap& tap = t.brain.taps[static_cast<std::size_t>(i)];
        if (tap.learned < 0) continue;
        float& h = learned[tap.learned];
        const float together = read(static_cast<std::size_t>(tap.source)) * t.settled[u];
        h += t.brain.period * (tap.learning_rate * together - tap.decay * h);
        h = std::clamp(h, -limits::weight - tap.weight, limits::weight - tap.weight);
    }
}

}  // namespace

void think(const Brain& brain, std::span<const float> sensed, std::span<float> state, std::span<float, 2> motors) {
    // Units read the previous tick: new values go into a second array.
    constexpr std::size_t most = static_cast<std::size_t>(limits::neurons) + 2;
    float settled[most];
    const std::size_t count = brain.units.size(), hidden = count - 2;
    float* learned = state.data() + count;
    const TickValues t{brain, sensed, state.data(), learned, settled};
    if (brain.learning_wires.empty()) {
        settle_all<false>(t);
    } else {
        settle_all<true>(t);
        for (std::size_t u = 0; u < hidden; ++u) learn(t, u, learned, [&](std::size_t s) { return t.before(s); });
        for (std::size_t u = hidden; u < count; ++u) learn(t, u, learned, [&](std::size_t s) { return t.now(s); });
    }
    std::copy(settled, settled + count, state.begin());
    motors[0] = std::clamp(settled[hidden], -1.0f, 1.0f);
    motors[1] = std::clamp(settled[hidden + 1], -1.0f, 1.0f);
}

void settle_forward(const Brain& brain, std::span<const float> sensed, std::span<float> state) {
    const std::size_t hidden = brain.units.size() - 2, sensors = brain.sensors.size();
    const float* learned = state.data() + brain.units.size();
    const TickValues t{brain, sensed, state.data(), learned, nullptr};
    std::vector<char> is_settled(brain.units.size(), 0);
    const auto is_known = [&](const Brain::Tap& tap) {
        const auto source = static_cast<std::size_t>(tap.source);
        return source < sensors || is_settled[source - sensors] != 0;
    };
    for (bool any = true; any;) {
        any = false;
        for (std::size_t u = 0; u < hidden; ++u) {
            const Brain::Unit& unit = brain.units[u];
            if (is_settled[u] != 0 || unit.follow != 1) continue;
            if (!std::all_of(brain.taps.begin() + unit.first_tap, brain.taps.begin() + unit.end_tap, is_known))
                continue;
            state[u] = settle<true>(t, u, [&](std::size_t source) { return t.before(source); });
            is_settled[u] = 1;
            any = true;
        }
    }
}

}  // namespace braitenlab
