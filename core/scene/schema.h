// Every value of a scene file, described once: its key, its place in the struct, its unit, its range and its meaning.
//
// A visitor walks the descriptions and does one job for all of them: read (core/scene/toml_reader.h), write, check
// ranges, list paths, make the tables of docs/scene-format.md. A visitor for a struct T offers:
//
//     number(key, float|int|uint64 T::*, unit, range, meaning)     angle(key, float T::*, range in degrees, meaning)
//     flag(key, bool T::*, meaning)
//     word(key, enum T::*, meaning)                                text(key, string T::*, longest, meaning)
//     part(member, …)    another struct's keys in this same table  table(key, member, meaning)      [key]
//     named(key, vector T::*, most, meaning)   [key.NAME] …        list(key, vector T::*, most, meaning)   [[key]] …
//     brain(key, BrainGraph T::*, meaning)                         place(key, optional<vec2> T::*, range, meaning)
//
// Values come before tables, as TOML wants them. Defaults are those of the structs. Unit and meaning are for people.
#pragma once

#include <string>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/scene/scene.h"

namespace braitenlab {

// Says whose fields are meant.
template <class T>
struct Of {};

// Both ends belong to it.
struct Range {
    double low, high;
    bool holds(double value) const { return value >= low && value <= high; }  // false for NaN
};

namespace limits {
inline constexpr std::size_t file_bytes = 4u << 20u;
inline constexpr int vehicles = 20000;  // in a world at a time
inline constexpr std::size_t kinds = 64, starts = 4096, sources = 1024, obstacles = 4096, wheels = 16;
inline constexpr std::size_t lamps = 16, waypoints = 256, corners = 8, zones = 1024;
inline constexpr int marks = 64;
inline constexpr std::size_t name_length = 40, title_length = 120, text_length = 2000;
}  // namespace limits

inline constexpr Range weight_range{-limits::weight, limits::weight};
inline constexpr Range threshold_range{0, limits::threshold};
inline constexpr Range bias_range{-limits::bias, limits::bias};
inline constexpr Range place_range{-1000, 1000};
inline constexpr Range mount_range{-10, 10};
inline constexpr Range canvas_range{-limits::place, limits::place};

template <class Visitor>
void describe(Visitor& v, Of<Arena>) {
    v.number("width", &Arena::width, "m", {2, 2000}, "along x");
    v.number("height", &Arena::height, "m", {2, 2000}, "along y");
    v.word("edge", &Arena::edge, "what stands at the rim");
    v.number("friction", &Arena::friction, "N·s/m per m²", {0, 1000},
             "rolling drag of the floor, by the wheel's contact");
    v.number("grip", &Arena::grip, "", {0, 2}, "multiplies every wheel's grip; ice is 0.1");
    v.number("reflectance", &Arena::reflectance, "", {0, 1}, "what a floor sensor reads");
    v.number("ambient", &Arena::ambient, "", {0, 1}, "added to what every eye for light or a colour sees");
}

template <class Visitor>
void describe(Visitor& v, Of<Ecology>) {
    v.number("population", &Ecology::population, "", {0, limits::vehicles},
             "vehicles placed at random, by the kinds' shares");
    v.number("drain", &Ecology::drain, "1/s", {0, 1}, "energy that a vehicle loses");
    v.number("bite", &Ecology::bite, "", {0, 1}, "energy that a predator takes from prey it touches");
    v.number("inactivity", &Ecology::inactivity, "s", {0, 3600}, "without movement until a new generation; 0: never");
}

template <class Visitor>
void describe(Visitor& v, Of<Wheel>) {
    v.number("x", &Wheel::x, "m", mount_range, "ahead of the origin");
    v.number("y", &Wheel::y, "m", mount_range, "left of the origin");
    v.number("radius", &Wheel::radius, "m", {0.005, 5}, "from axle to floor");
    v.number("width", &Wheel::width, "m", {0.002, 5}, "along its axle");
    v.word("motor", &Wheel::motor, "which one drives it; none makes it a castor");
    v.number("grip", &Wheel::grip, "", {0, 2}, "friction coefficient; 0 for a castor");
    v.number("load", &Wheel::load, "", {0, 1}, "share of the weight that rests on it; all wheels' add up to 1");
    v.number("area", &Wheel::area, "m²", {0, 1}, "contact with the floor, for rolling drag");
}

template <class Visitor>
void describe(Visitor& v, Of<Body>) {
    v.number("length", &Body::length, "m", {0.05, 20}, "of the chassis");
    v.number("width", &Body::width, "m", {0.05, 20}, "of the chassis");
    v.number("mass", &Body::mass, "kg", {0.05, 1000}, "of the whole vehicle");
    v.number("top_speed", &Body::top_speed, "m/s", {0.05, 10}, "of a wheel whose motor is told 1");
    v.number("motor_force", &Body::motor_force, "N", {0.01, 10000}, "the most one motor can push");
    v.number("mismatch", &Body::mismatch, "", {0, 0.5}, "each motor's top speed differs by up to this share");
    v.number("dead_band", &Body::dead_band, "", {0, 0.9}, "a command whose size is below it leaves the motor still");
    v.list("wheel", &Body::wheels, limits::wheels, "if there is any, these stand instead of the standard four");
}

template <class Visitor>
void describe(Visitor& v, Of<Sensor>) {
    v.word("channel", &Sensor::channel, "what it senses");
    v.word("shape", &Sensor::shape, "of its field");
    v.word("response", &Sensor::response, "how much it sees, or only whether");
    v.number("x", &Sensor::x, "m", mount_range, "ahead of the origin");
    v.number("y", &Sensor::y, "m", mount_range, "left of the origin");
    v.angle("angle", &Sensor::angle, {-180, 180}, "the axis of view, left of straight ahead");
    v.angle("field", &Sensor::field, {1, 360}, "the whole opening angle");
    v.number("range", &Sensor::range, "m", {0.05, 100}, "it sees nothing beyond");
    v.number("half_distance", &Sensor::half_distance, "m", {0.01, 100}, "d₀ in 1/(1+(d/d₀)²)");
    v.number("noise", &Sensor::noise, "", {0, 1}, "standard deviation added to every reading");
    v.number("latency", &Sensor::latency, "s", {0, 1}, "until the brain gets a reading");
}

template <class Visitor>
void describe(Visitor& v, Of<CarriedLamp>) {
    v.word("channel", &CarriedLamp::channel, "what it gives off");
    v.number("x", &CarriedLamp::x, "m", mount_range, "ahead of the origin");
    v.number("y", &CarriedLamp::y, "m", mount_range, "left of the origin");
    v.number("strength", &CarriedLamp::strength, "", {0, 1}, "what an eye right before it gets");
}

template <class Visitor>
void describe(Visitor& v, Of<Waypoint>) {
    v.number("x", &Waypoint::x, "m", place_range, "where it leads");
    v.number("y", &Waypoint::y, "m", place_range, "where it leads");
}

template <class Visitor>
void describe(Visitor& v, Of<PlaceMemory>) {
    v.number("marks", &PlaceMemory::marks, "", {0, limits::marks}, "places remembered, the oldest goes first; 0: none");
    v.number("fade", &PlaceMemory::fade, "s", {0.1, 3600}, "in which a mark's strength falls to a half");
    v.number("strength", &PlaceMemory::strength, "", {0, 1}, "of a fresh mark");
}

template <class Visitor>
void describe(Visitor& v, Of<Kind>) {
    v.word("role", &Kind::role, "what others sense in it; predators bite prey");
    v.word("driver", &Kind::driver, "who drives");
    v.number("share", &Kind::share, "", {0, 1000}, "of the random population, against the other kinds' shares");
    v.table("body", &Kind::body, "chassis and wheels");
    v.table("memory", &Kind::memory, "where it met obstacles; sensed on the channel `memory`");
    v.named("sensor", &Kind::sensors, limits::sensors, "its eyes; the brain's sensor of this name reads it");
    v.named("lamp", &Kind::lamps, limits::lamps, "a source that it carries");
    v.list("waypoint", &Kind::waypoints, limits::waypoints, "the way of a vehicle whose driver is `path`");
    v.brain("brain", &Kind::brain, "what drives its motors");
}

template <class Visitor>
void describe(Visitor& v, Of<Start>) {
    v.text("kind", &Start::kind, limits::name_length, "the kind it is of; must be given");
    v.number("x", &Start::x, "m", place_range, "where it starts");
    v.number("y", &Start::y, "m", place_range, "where it starts");
    v.angle("heading", &Start::heading, {-360, 360}, "counter-clockwise from +x, or from the direction to `facing`");
    v.text("facing", &Start::facing, limits::name_length, "a source's name: heading 0 looks at it");
    v.number("place_spread", &Start::place_spread, "m", {0, 1000}, "x and y vary with the seed by up to this");
    v.angle("heading_spread", &Start::heading_spread, {0, 180}, "the heading varies with the seed by up to this");
}

template <class Visitor>
void describe(Visitor& v, Of<Source>) {
    v.word("channel", &Source::channel, "what it gives off");
    v.number("x", &Source::x, "m", place_range, "where it stands");
    v.number("y", &Source::y, "m", place_range, "where it stands");
    v.number("strength", &Source::strength, "", {0, 1}, "what an eye right before it gets");
    v.flag("solid", &Source::solid, "a post of 0.15 m radius that nothing drives through");
}

template <class Visitor>
void describe(Visitor& v, Of<PolygonCorner>) {
    v.number("x", &PolygonCorner::x, "m", place_range, "against the obstacle's middle, along its heading");
    v.number("y", &PolygonCorner::y, "m", place_range, "against the obstacle's middle, to the left of its heading");
}

template <class Visitor>
void describe(Visitor& v, Of<Obstacle>) {
    v.number("x", &Obstacle::x, "m", place_range, "its middle");
    v.number("y", &Obstacle::y, "m", place_range, "its middle");
    v.angle("heading", &Obstacle::heading, {-360, 360}, "of its length, counter-clockwise from +x");
    v.number("length", &Obstacle::length, "m", {0.02, 2000}, "along its heading");
    v.number("width", &Obstacle::width, "m", {0.02, 2000}, "across its heading");
    v.number("mass", &Obstacle::mass, "kg", {0, 10000}, "0: fixed, else vehicles push it about");
    v.list("corner", &Obstacle::corners, limits::corners, "of a convex polygon instead of a box, counter-clockwise");
}

template <class Visitor>
void describe(Visitor& v, Of<Zone>) {
    v.number("x", &Zone::x, "m", place_range, "its middle");
    v.number("y", &Zone::y, "m", place_range, "its middle");
    v.angle("heading", &Zone::heading, {-360, 360}, "of its length, counter-clockwise from +x");
    v.number("length", &Zone::length, "m", {0.02, 2000}, "along its heading");
    v.number("width", &Zone::width, "m", {0.02, 2000}, "across its heading");
    v.flag("round", &Zone::round, "an ellipse of that length and width");
    v.word("surface", &Zone::surface, "what covers it; of zones that overlap the last counts");
    v.number("recharge", &Zone::recharge, "1/s", {0, 10}, "energy that every vehicle on it gets");
    v.number("wind_x", &Zone::wind_x, "N", {-200, 200}, "on every vehicle, along x");
    v.number("wind_y", &Zone::wind_y, "N", {-200, 200}, "on every vehicle, along y");
    v.angle("slope", &Zone::slope, {0, 45}, "downhill is along its heading");
    v.number("pull", &Zone::pull, "N", {-200, 200}, "towards its middle; negative pushes away");
}

template <class Visitor>
void describe(Visitor& v, Of<Scene>) {
    v.text("name", &Scene::name, limits::name_length, "the file's stem unless given");
    v.text("title", &Scene::title, limits::title_length, "for people");
    v.text("story", &Scene::story, limits::text_length, "one line for people");
    v.table("arena", &Scene::arena, "the floor and its rim");
    v.table("ecology", &Scene::ecology, "who lives here, and on what");
    v.named("kind", &Scene::kinds, limits::kinds, "a design that many vehicles share");
    v.named("vehicle", &Scene::starts, limits::starts, "a vehicle placed by hand");
    v.named("source", &Scene::sources, limits::sources, "something that can be sensed");
    v.named("obstacle", &Scene::obstacles, limits::obstacles, "a box or polygon that stands in the way");
    v.named("zone", &Scene::zones, limits::zones, "a patch of floor on which something is different");
}

// A brain as a file shows it: the four neurons, then whatever nodes and wires there are beyond them.
// Turned into a graph and back by core/scene/brain_text.h.
struct NodeText {
    Node node{.id = -1, .kind = NodeKind::neuron, .name = {}};  // −1: one more than the largest before it
};

struct WireText {
    std::string from, to;  // names of nodes
    Wire wire;
};

struct BrainText {
    FourNeurons dials;
    std::vector<Dial> given;  // the dials that stand in the file, zeros included
    std::optional<maths::vec2> place_SL, place_SR, place_ML, place_MR;
    std::vector<NodeText> nodes;
    std::vector<WireText> wires;
};

template <class Visitor>
void describe(Visitor& v, Of<FourNeurons>) {
    v.number("LL", &FourNeurons::LL, "", weight_range, "the wire from the left eye to the left motor");
    v.number("LR", &FourNeurons::LR, "", weight_range, "the wire from the right eye to the left motor");
    v.number("RL", &FourNeurons::RL, "", weight_range, "the wire from the left eye to the right motor");
    v.number("RR", &FourNeurons::RR, "", weight_range, "the wire from the right eye to the right motor");
    v.number("threshold_LL", &FourNeurons::threshold_LL, "", threshold_range, "LL counts an input below it as 0");
    v.number("threshold_LR", &FourNeurons::threshold_LR, "", threshold_range, "so does LR");
    v.number("threshold_RL", &FourNeurons::threshold_RL, "", threshold_range, "so does RL");
    v.number("threshold_RR", &FourNeurons::threshold_RR, "", threshold_range, "so does RR");
    v.number("LM", &FourNeurons::LM, "", bias_range, "added to the left motor");
    v.number("RM", &FourNeurons::RM, "", bias_range, "added to the right motor");
}

template <class Visitor>
void describe(Visitor& v, Of<Curve>) {
    v.word("curve", &Curve::response, "how it answers to its input x");
    v.number("peak", &Curve::peak, "", {-limits::peak, limits::peak},
             "where the step, the sigmoid's middle or the hump stands");
    v.number("width", &Curve::width, "", {0.001, limits::width}, "of the sigmoid or the hump");
}

template <class Visitor>
void describe(Visitor& v, Of<Node>) {
    v.text("name", &Node::name, limits::name_length, "must be given; a sensor has its vehicle's name for it");
    v.number("id", &Node::id, "", {0, 1e9}, "one more than the largest before it unless given");
    v.word("kind", &Node::kind, "the motors are ML and MR");
    v.part(&Node::curve);
    v.number("bias", &Node::bias, "", bias_range, "added to its sum");
    v.number("time_constant", &Node::time_constant, "s", {0, limits::time_constant},
             "of its leaky memory; 0 answers at once");
    v.flag("silenced", &Node::silenced, "a lesion: a covered eye, a stopped motor, a neuron that gives 0");
    v.place("place", &Node::place, canvas_range, "its middle on the wiring canvas: to the right, down");
}

template <class Visitor>
void describe(Visitor& v, Of<Wire>) {
    v.number("weight", &Wire::weight, "", weight_range, "amplifies, attenuates, inverts");
    v.number("threshold", &Wire::threshold, "", threshold_range, "an input whose size is below it counts as 0");
    v.part(&Wire::curve);
    v.flag("cut", &Wire::cut, "a lesion: it delivers 0");
    v.number("learning_rate", &Wire::learning_rate, "1/s", {0, limits::learning_rate},
             "of a Hebbian wire; 0: does not learn");
    v.number("decay", &Wire::decay, "1/s", {0, limits::decay}, "how fast what it learned fades");
}

template <class Visitor>
void describe(Visitor& v, Of<NodeText>) {
    v.part(&NodeText::node);
}

template <class Visitor>
void describe(Visitor& v, Of<WireText>) {
    v.text("from", &WireText::from, limits::name_length, "a node's name");
    v.text("to", &WireText::to, limits::name_length, "a node's name");
    v.part(&WireText::wire);
}

template <class Visitor>
void describe(Visitor& v, Of<BrainText>) {
    v.part(&BrainText::dials);
    v.place("place_SL", &BrainText::place_SL, canvas_range,
            "the left eye's middle on the wiring canvas: to the right, down");
    v.place("place_SR", &BrainText::place_SR, canvas_range, "the right eye's");
    v.place("place_ML", &BrainText::place_ML, canvas_range, "the left motor's");
    v.place("place_MR", &BrainText::place_MR, canvas_range, "the right motor's");
    v.list("node", &BrainText::nodes, limits::sensors + limits::neurons + 2, "a sensor, neuron or motor more");
    v.list("wire", &BrainText::wires, limits::wires, "from any node to any other");
}

// All that a brain file holds.
struct BrainFile {
    BrainGraph brain;
};

template <class Visitor>
void describe(Visitor& v, Of<BrainFile>) {
    v.brain("brain", &BrainFile::brain, "as in a kind");
}

}  // namespace braitenlab
