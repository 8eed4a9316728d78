// Digest of all values that determine the further run. Excluded: readings and wheel commands, which every tick computes
// again; names and texts; positions of nodes on the canvas.
#include <cstring>

#include "core/scene/schema.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

namespace {

// FNV-1a over 64 bits (G. Fowler, L. C. Noll, K.-P. Vo), one word at a time.
struct Digest {
    std::uint64_t value = 14695981039346656037ULL;
    void add(std::uint64_t word) { value = (value ^ word) * 1099511628211ULL; }
    void add(float number) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        add(static_cast<std::uint64_t>(bits));
    }
    void add(double number) {
        if (const auto single = static_cast<float>(number); static_cast<double>(single) == number) return add(single);
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        add(bits);
    }
    void add(maths::vec2 v) { add(v.x), add(v.y); }
    void add(std::int64_t number) { add(static_cast<std::uint64_t>(number)); }
    void add(std::int32_t number) { add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(number))); }
    void add(const std::string& text) {
        add(static_cast<std::uint64_t>(text.size()));
        for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    }
};

// A visitor of core/scene/schema.h: adds every value of a struct. Brains and the sensors of single vehicles are added
// separately, because those of the scene are not up to date in a running world.
template <class T>
struct StructDigest {
    const T& object;
    Digest& digest;

    void number(const char*, auto T::*member, const char*, Range, const char*) { digest.add(object.*member); }
    void angle(const char*, float T::*member, Range, const char*) { digest.add(object.*member); }
    void place(const char*, std::optional<maths::vec2> T::*, Range, const char*) {}
    void flag(const char*, bool T::*member, const char*) { digest.add(static_cast<std::int32_t>(object.*member)); }
    void word(const char*, auto T::*member, const char*) { digest.add(static_cast<std::int32_t>(object.*member)); }
    template <class Enum>
    void word(const char*, std::optional<Enum> T::*member, const char*) {
        if (object.*member) digest.add(static_cast<std::int32_t>(*(object.*member)));
    }
    void text(const char*, std::string T::*member, std::size_t, const char*) { digest.add(object.*member); }
    void colour(const char*, std::string T::*, const char*) {}
    void part(auto T::*member) { add_described(digest, object.*member); }
    void table(const char*, auto T::*member, const char*) { add_described(digest, object.*member); }
    template <class Element>
    void named(const char*, std::vector<Element> T::*member, std::size_t, const char*) {
        add_all(digest, object.*member);
    }
    template <class Element>
    void named(const char*, std::optional<std::vector<Element>> T::*, std::size_t, const char*) {}
    void list(const char*, auto T::*member, std::size_t, const char*) { add_all(digest, object.*member); }
    void brain(const char*, auto T::*, const char*) {}
};

template <class T>
void add_described(Digest& digest, const T& object) {
    if constexpr (requires { object.name; }) digest.add(object.name);
    StructDigest<T> visitor{object, digest};
    describe(visitor, Of<T>{});
}

template <class Element>
void add_all(Digest& digest, const std::vector<Element>& elements) {
    digest.add(static_cast<std::uint64_t>(elements.size()));
    for (const Element& element : elements) add_described(digest, element);
}

void add(Digest& digest, const Scene& scene) {  // without its name, title and story
    add_described(digest, scene.arena);
    add_described(digest, scene.ecology);
    add_all(digest, scene.kinds);
    add_all(digest, scene.starts);
    add_all(digest, scene.sources);
    add_all(digest, scene.obstacles);
    add_all(digest, scene.zones);
}

void add(Digest& digest, const BrainGraph& graph) {
    for (const Node& n : graph.nodes) add_described(digest, n);
    for (const Wire& w : graph.wires) {
        digest.add(w.from), digest.add(w.to);
        add_described(digest, w);
    }
}

void add(Digest& digest, const mechanics::Motion& motion) {
    digest.add(motion.position);
    digest.add(motion.ahead);
    digest.add(motion.velocity);
    digest.add(motion.angular_velocity);
    digest.add(motion.heading);
}

void add(Digest& digest, const std::array<float, 2>& pair) { digest.add(pair[0]), digest.add(pair[1]); }
void add(Digest& digest, Driver driver) { digest.add(static_cast<std::int32_t>(driver)); }
template <class Number>
void add(Digest& digest, Number number) {
    digest.add(number);
}

void add_vehicle(Digest& digest, const Vehicles& v, std::size_t row) {
    each_vehicle_value([&](const auto& value) {
        if (value.hashed) add(digest, (v.*value.column)[row]);
    });
    add(digest, v.brain[row]->graph);
    if (v.design[row]) add_all(digest, v.design[row]->kind.sensors);
}

}  // namespace

std::uint64_t hash(const State& s) {
    Digest digest;
    add(digest, *s.scene);
    for (const SharedBrain& brain : s.kind_brains) add(digest, brain->graph);
    digest.add(s.seed);
    if (s.parts_seed != s.seed) digest.add(s.parts_seed);
    digest.add(s.tick);
    digest.add(s.generation);
    digest.add(static_cast<std::int64_t>(s.still_ticks));
    digest.add(s.next_id);
    for (const std::int64_t count :
         {s.events.captures, s.events.deaths, s.events.births, s.events.contacts, s.events.falls})
        digest.add(count);
    for (const Bite& bite : s.bites) digest.add(bite.pair.one), digest.add(bite.pair.other), digest.add(bite.tick);
    for (const mechanics::Motion& obstacle : s.obstacles) add(digest, obstacle);
    for (const Touch& touch : s.touching) digest.add(touch.one), digest.add(touch.other);
    for (const Mark& mark : s.marks) digest.add(mark.owner), digest.add(mark.position), digest.add(mark.tick);
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) add_vehicle(digest, s.vehicles, row);
    for (const float neuron : s.vehicles.neurons) digest.add(neuron);
    for (const float reading : s.vehicles.delayed) digest.add(reading);
    return digest.value;
}

}  // namespace braitenlab::world
