// A digest of everything that decides the future of a run. Readings and wheel commands are not part of it: every tick
// makes them anew.
#include <cstring>

#include "core/world/world_data.h"

namespace braitenlab::world {

namespace {

// FNV-1a over 64 bits (G. Fowler, L. C. Noll, K.-P. Vo), a word at a time.
struct Digest {
    std::uint64_t value = 14695981039346656037ULL;
    void add(std::uint64_t word) { value = (value ^ word) * 1099511628211ULL; }
    void add(float number) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        add(static_cast<std::uint64_t>(bits));
    }
    void add(maths::vec2 v) { add(v.x), add(v.y); }
    void add(std::int64_t number) { add(static_cast<std::uint64_t>(number)); }
    void add(std::int32_t number) { add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(number))); }
};

void add(Digest& digest, const Curve& curve) {
    digest.add(static_cast<std::int32_t>(curve.response)), digest.add(curve.peak), digest.add(curve.width);
}

void add(Digest& digest, const BrainGraph& graph) {
    for (const Node& n : graph.nodes) {
        digest.add(n.id), digest.add(n.bias), digest.add(n.time_constant);
        digest.add(static_cast<std::int32_t>(n.silenced));
        add(digest, n.curve);
    }
    for (const Wire& w : graph.wires) {
        digest.add(w.from), digest.add(w.to), digest.add(w.weight), digest.add(w.threshold);
        digest.add(static_cast<std::int32_t>(w.cut)), digest.add(w.learning_rate), digest.add(w.decay);
        add(digest, w.curve);
    }
}

void add(Digest& digest, const mechanics::Motion& motion) {
    digest.add(motion.position);
    digest.add(motion.ahead);
    digest.add(motion.velocity);
    digest.add(motion.angular_velocity);
    digest.add(motion.heading);
}

}  // namespace

std::uint64_t hash(const State& s) {
    Digest digest;
    digest.add(s.seed);
    digest.add(s.tick);
    digest.add(s.generation);
    digest.add(static_cast<std::int64_t>(s.still_ticks));
    digest.add(s.next_id);
    for (const std::int64_t count :
         {s.events.captures, s.events.deaths, s.events.births, s.events.contacts, s.events.falls})
        digest.add(count);
    for (const Bite& bite : s.bites) digest.add(bite.pair.one), digest.add(bite.pair.other), digest.add(bite.tick);
    for (const Source& source : s.scene->sources) digest.add(source.x), digest.add(source.y);
    for (const mechanics::Motion& obstacle : s.obstacles) add(digest, obstacle);
    for (const Touch& touch : s.touching) digest.add(touch.one), digest.add(touch.other);
    for (const Mark& mark : s.marks) digest.add(mark.owner), digest.add(mark.position), digest.add(mark.tick);
    const Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        digest.add(v.id[row]);
        digest.add(v.kind[row]);
        add(digest, v.motion[row]);
        digest.add(static_cast<std::int32_t>(v.driver[row]));
        digest.add(v.steered[row][0]), digest.add(v.steered[row][1]);
        digest.add(v.waypoint[row]);
        digest.add(v.energy[row]);
        add(digest, v.brain[row]->graph);
    }
    for (const float neuron : v.neurons) digest.add(neuron);
    for (const float reading : v.delayed) digest.add(reading);
    return digest.value;
}

}  // namespace braitenlab::world
