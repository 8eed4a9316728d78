// The schema of scene files: one line per value with its key, its struct member, its unit, its range and its meaning.
//
// A visitor does one task for all values: read (core/scene/toml_reader.h), write, check ranges, list paths, print the
// tables of docs/scene-format.md. A visitor for a struct T has these functions:
//
//     number(key, float|int|uint64 T::*, unit, range, meaning)     angle(key, float T::*, range in degrees, meaning)
//     flag(key, bool T::*, meaning)
//     word(key, enum T::*, meaning)                                text(key, string T::*, longest, meaning)
//     part(member)       keys of another struct in the same table  table(key, member, meaning)             [key]
//     named(key, vector T::*, most, meaning)   [key.NAME] …        list(key, vector T::*, most, meaning)   [[key]] …
//     brain(key, BrainGraph T::*, meaning)                         place(key, optional<vec2> T::*, range, meaning)
//     colour(key, string T::*, meaning)  "#rrggbb" or empty; display only: not part of the run and its hash
//
// word(), named() and brain() also take an optional member: without the key it is nullopt.
//
// Values come before tables, as TOML requires. Defaults are those of the structs. Unit and meaning are used in docs
// only.
#pragma once

#include <string>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/scene/scene.h"

namespace braitenlab {

// Selects the describe() of a struct.
template <class T>
struct Of {};

// A closed interval.
struct Range {
    double low, high;
    bool holds(double value) const { return value >= low && value <= high; }  // false for NaN
};

namespace limits {
inline constexpr std::size_t file_bytes = 4u << 20u;
inline constexpr int vehicles = 20000;  // in a world at a time
inline constexpr std::size_t kinds = 64, starts = 4096, sources = 1024, obstacles = 4096, wheels = 16;
inline constexpr std::size_t lamps = 16, waypoints = 256, corners = 8, zones = 1024, on_times = 64;
inline constexpr int marks = 64;
inline constexpr int converter_bits = 16;
inline constexpr std::size_t response_points = 32;
inline constexpr std::size_t name_length = 40, title_length = 120, text_length = 2000;
}  // namespace limits

inline constexpr Range weight_range{-limits::weight, limits::weight};
inline constexpr Range threshold_range{0, limits::threshold};
inline constexpr Range bias_range{-limits::bias, limits::bias};
inline constexpr Range place_range{-1000, 1000};
inline constexpr Range mount_range{-10, 10};
inline constexpr Range canvas_range{-limits::place, limits::place};

void describe(auto& v, Of<Arena>) {
    v.number("width", &Arena::width, "m", {0.5, 2000}, "along x");
    v.number("height", &Arena::height, "m", {0.5, 2000}, "along y");
    v.word("edge", &Arena::edge, "what bounds the arena");
    v.flag("round", &Arena::round, "an ellipse instead of a rectangle; not for a torus");
    v.number("friction", &Arena::friction, "N·s/m per m²", {0, 1000}, "rolling drag per contact area of a wheel");
    v.number("grip", &Arena::grip, "", {0, 2}, "factor on every wheel's grip; ice is 0.1");
    v.number("reflectance", &Arena::reflectance, "", {0, 1}, "reading of a floor sensor");
    v.number("ambient", &Arena::ambient, "", {0, 1}, "added to the readings of all sensors for light or a colour");
    v.number("lux", &Arena::lux, "lx", {0, 100000}, "illuminance of photocells by ambient light");
}

void describe(auto& v, Of<Ecology>) {
    v.number("population", &Ecology::population, "", {0, limits::vehicles},
             "vehicles placed at random; kinds by their shares");
    v.number("drain", &Ecology::drain, "1/s", {0, 1}, "energy loss of every vehicle");
    v.number("bite", &Ecology::bite, "", {0, 1}, "energy a predator takes from touched prey");
    v.number("inactivity", &Ecology::inactivity, "s", {0, 3600},
             "without movement until a new generation starts; 0: never");
}

void describe(auto& v, Of<PopulationGoal>) {
    v.word("role", &PopulationGoal::role, "of the vehicles that are counted; `none`: no goal");
    v.number("count", &PopulationGoal::count, "", {1, limits::vehicles}, "smallest number of these vehicles");
    v.number("seconds", &PopulationGoal::seconds, "s", {1, 3600}, "without a break");
}

void describe(auto& v, Of<Wheel>) {
    v.number("x", &Wheel::x, "m", mount_range, "ahead of the origin");
    v.number("y", &Wheel::y, "m", mount_range, "left of the origin");
    v.number("radius", &Wheel::radius, "m", {0.005, 5}, "from axle to floor");
    v.number("width", &Wheel::width, "m", {0.002, 5}, "along its axle");
    v.word("motor", &Wheel::motor, "the motor that turns it; none: a castor");
    v.number("grip", &Wheel::grip, "", {0, 2}, "friction coefficient; 0 for a castor");
    v.number("load", &Wheel::load, "", {0, 1}, "share of the weight on it; all wheels add up to 1");
    v.number("area", &Wheel::area, "m²", {0, 1}, "contact area, for rolling drag");
}

void describe(auto& v, Of<Body>) {
    v.number("length", &Body::length, "m", {0.05, 20}, "of the chassis");
    v.number("width", &Body::width, "m", {0.05, 20}, "of the chassis");
    v.number("mass", &Body::mass, "kg", {0.05, 1000}, "of the whole vehicle");
    v.number("top_speed", &Body::top_speed, "m/s", {0.05, 10},
             "of a wheel whose motor gets the command 1, at the nominal voltage");
    v.number("motor_force", &Body::motor_force, "N", {0.01, 10000}, "maximum of one motor, at the nominal voltage");
    v.number("mismatch", &Body::mismatch, "", {0, 0.5}, "± share of top_speed by which each motor differs");
    v.number("dead_band", &Body::dead_band, "", {0, 0.9}, "a motor does not turn for commands of smaller size");
    v.number("friction_spread", &Body::friction_spread, "", {0, 0.9},
             "± share by which grip and rolling drag of each wheel differ");
    v.number("voltage", &Body::voltage, "V", {0, 60},
             "of the battery, less that of the motor driver; 0: the nominal one");
    v.number("nominal_voltage", &Body::nominal_voltage, "V", {0.5, 60}, "that gives top_speed and motor_force");
    v.list("wheel", &Body::wheels, limits::wheels, "replace the standard four when there is at least one");
}

void describe(auto& v, Of<Sensor>) {
    v.word("channel", &Sensor::channel, "what it senses");
    v.word("shape", &Sensor::shape, "of its field of view");
    v.word("response", &Sensor::response,
           "graded by distance and direction, the full strength of anything in the field, a photocell, or a table");
    v.number("x", &Sensor::x, "m", mount_range, "ahead of the origin");
    v.number("y", &Sensor::y, "m", mount_range, "left of the origin");
    v.angle("angle", &Sensor::angle, {-180, 180}, "of its axis, to the left of straight ahead");
    v.angle("field", &Sensor::fov, {1, 360}, "full opening angle");
    v.number("range", &Sensor::range, "m", {0.05, 100}, "the reading is 0 beyond");
    v.number("half_distance", &Sensor::half_distance, "m", {0.01, 100}, "d₀ in 1/(1+(d/d₀)²)");
    v.number("noise", &Sensor::noise, "", {0, 1}, "standard deviation of the noise added to a reading");
    v.number("latency", &Sensor::latency, "s", {0, 1}, "between a reading and the brain's input");
    v.number("gain_spread", &Sensor::gain_spread, "", {0, 0.9}, "± share by which the sensor of each vehicle differs");
    v.number("gamma", &Sensor::gamma, "", {0.2, 3}, "exponent γ of a photocell; of a photoresistor about 0.7");
    v.number("half_lux", &Sensor::half_lux, "lx", {0.1, 100000}, "at which a photocell reads 0.5");
    v.flag("hard_range", &Sensor::hard_range, "a graded reading does not fade towards the range");
    v.number("interval", &Sensor::interval, "s", {0, 1}, "between two samples; 0: a sample at every tick");
    v.number("bits", &Sensor::bits, "", {0, limits::converter_bits},
             "of the converter, which reads one of 2^bits steps; 0: no steps");
    v.list("point", &Sensor::points, limits::response_points, "a measured reading, for the response `table`");
}

void describe(auto& v, Of<ResponsePoint>) {
    v.number("distance", &ResponsePoint::distance, "m", {0, 100}, "from the sensor; ascending from point to point");
    v.number("reading", &ResponsePoint::reading, "", {0, 1}, "there, of a stimulus of strength 1 on the axis");
}

void describe(auto& v, Of<CarriedLamp>) {
    v.word("channel", &CarriedLamp::channel, "what it gives off");
    v.number("x", &CarriedLamp::x, "m", mount_range, "ahead of the origin");
    v.number("y", &CarriedLamp::y, "m", mount_range, "left of the origin");
    v.number("strength", &CarriedLamp::strength, "", {0, 1}, "reading of a sensor at the source");
    v.number("candela", &CarriedLamp::candela, "cd", {0, 1000000},
             "intensity at strength 1, for photocells; 0: by strength");
}

void describe(auto& v, Of<Waypoint>) {
    v.number("x", &Waypoint::x, "m", place_range, "position");
    v.number("y", &Waypoint::y, "m", place_range, "position");
}

void describe(auto& v, Of<PlaceMemory>) {
    v.number("marks", &PlaceMemory::marks, "", {0, limits::marks},
             "maximum; a new mark replaces the oldest; 0: no memory");
    v.number("fade", &PlaceMemory::fade, "s", {0.1, 3600}, "half-life of a mark's strength");
    v.number("strength", &PlaceMemory::strength, "", {0, 1}, "of a new mark");
}

void describe(auto& v, Of<Kind>) {
    v.word("role", &Kind::role, "how it appears to others; predators bite prey");
    v.word("driver", &Kind::driver, "what commands its motors");
    v.number("share", &Kind::share, "", {0, 1000}, "weight in the random population, relative to the other kinds");
    v.colour("colour", &Kind::colour, "of its body; default: by its role");
    v.table("body", &Kind::body, "chassis and wheels");
    v.table("memory", &Kind::memory, "marks where it met obstacles, sensed on the channel `memory`");
    v.named("sensor", &Kind::sensors, limits::sensors,
            "a sensor; the brain's sensor node of this name takes its reading");
    v.named("lamp", &Kind::lamps, limits::lamps, "a source mounted on it");
    v.list("waypoint", &Kind::waypoints, limits::waypoints, "the path of a vehicle with the driver `path`");
    v.brain("brain", &Kind::brain, "computes motor commands from sensor readings");
}

void describe(auto& v, Of<Start>) {
    v.text("kind", &Start::kind, limits::name_length, "name of its kind; required");
    v.number("x", &Start::x, "m", place_range, "start position");
    v.number("y", &Start::y, "m", place_range, "start position");
    v.angle("heading", &Start::heading, {-360, 360}, "counter-clockwise from +x, or from the direction to `facing`");
    v.text("facing", &Start::facing, limits::name_length, "name of a source that heading 0 points to");
    v.number("place_spread", &Start::place_spread, "m", {0, 1000}, "x and y vary with the seed by up to ± this");
    v.angle("heading_spread", &Start::heading_spread, {0, 180}, "the heading varies with the seed by up to ± this");
    v.word("driver", &Start::driver, "what commands its motors; default: as its kind");
    v.colour("colour", &Start::colour, "of its body; default: as its kind");
    v.named("sensor", &Start::sensors, limits::sensors, "a sensor of its own; then it has none of its kind's");
    v.brain("brain", &Start::brain, "its own brain; default: that of its kind");
}

void describe(auto& v, Of<Member>) {
    v.text("kind", &Member::kind, limits::name_length, "name of its kind; default: chosen by the shares");
    v.flag("placed", &Member::placed, "it starts at the pose below instead of a random one");
    v.number("x", &Member::x, "m", place_range, "start position");
    v.number("y", &Member::y, "m", place_range, "start position");
    v.angle("heading", &Member::heading, {-360, 360}, "counter-clockwise from +x");
    v.word("driver", &Member::driver, "what commands its motors; default: as its kind");
    v.text("label", &Member::label, limits::name_length, "its name in the window; default: none");
    v.colour("colour", &Member::colour, "of its body; default: as its kind");
    v.named("sensor", &Member::sensors, limits::sensors, "a sensor of its own; then it has none of its kind's");
    v.brain("brain", &Member::brain, "its own brain; default: that of its kind");
}

void describe(auto& v, Of<OnTime>) {
    v.number("from", &OnTime::from, "s", {0, 3600}, "when it goes on");
    v.number("until", &OnTime::until, "s", {0, 3600}, "when it goes off");
}

void describe(auto& v, Of<Source>) {
    v.word("channel", &Source::channel, "what it gives off");
    v.number("x", &Source::x, "m", place_range, "position");
    v.number("y", &Source::y, "m", place_range, "position");
    v.number("strength", &Source::strength, "", {0, 1}, "reading of a sensor at the source");
    v.number("candela", &Source::candela, "cd", {0, 1000000},
             "intensity at strength 1, for photocells; 0: by strength");
    v.flag("solid", &Source::solid, "a post that vehicles collide with, of 0.15 m radius where the arena has 5 m");
    v.list("on", &Source::on, limits::on_times, "a time in which it is on; default: always on");
}

void describe(auto& v, Of<PolygonCorner>) {
    v.number("x", &PolygonCorner::x, "m", place_range, "relative to the object's centre, along its heading");
    v.number("y", &PolygonCorner::y, "m", place_range, "relative to the object's centre, to the left of its heading");
}

void describe(auto& v, Of<Obstacle>) {
    v.number("x", &Obstacle::x, "m", place_range, "centre");
    v.number("y", &Obstacle::y, "m", place_range, "centre");
    v.angle("heading", &Obstacle::heading, {-360, 360}, "of its length, counter-clockwise from +x");
    v.number("length", &Obstacle::length, "m", {0.02, 2000}, "along its heading");
    v.number("width", &Obstacle::width, "m", {0.02, 2000}, "across its heading");
    v.number("mass", &Obstacle::mass, "kg", {0, 10000}, "0: fixed; else vehicles can push it");
    v.list("corner", &Obstacle::corners, limits::corners, "of a convex polygon instead of a box; counter-clockwise");
}

void describe(auto& v, Of<Zone>) {
    v.number("x", &Zone::x, "m", place_range, "centre");
    v.number("y", &Zone::y, "m", place_range, "centre");
    v.angle("heading", &Zone::heading, {-360, 360}, "of its length, counter-clockwise from +x");
    v.number("length", &Zone::length, "m", {0.02, 2000}, "along its heading");
    v.number("width", &Zone::width, "m", {0.02, 2000}, "across its heading");
    v.flag("round", &Zone::round, "an ellipse with these axes");
    v.word("surface", &Zone::surface, "what covers it; where zones overlap, that of the last one");
    v.number("recharge", &Zone::recharge, "1/s", {0, 10}, "energy gained by every vehicle in it");
    v.number("wind_x", &Zone::wind_x, "N", {-200, 200}, "force on every vehicle in it, along x");
    v.number("wind_y", &Zone::wind_y, "N", {-200, 200}, "force on every vehicle in it, along y");
    v.angle("slope", &Zone::slope, {0, 45}, "downhill is along its heading");
    v.number("pull", &Zone::pull, "N", {-200, 200}, "force towards its centre; negative: away from it");
    v.list("corner", &Zone::corners, limits::corners, "of a convex polygon instead of a rectangle; counter-clockwise");
}

void describe(auto& v, Of<Scene>) {
    v.text("name", &Scene::name, limits::name_length, "default: the file's stem");
    v.text("title", &Scene::title, limits::title_length, "shown in the window");
    v.text("story", &Scene::story, limits::text_length, "one line about the scene");
    v.table("arena", &Scene::arena, "the floor and its boundary");
    v.table("ecology", &Scene::ecology, "population and energy");
    v.table("goal", &Scene::goal, "what to try, shown on the scene's card; it does not change a run");
    v.named("kind", &Scene::kinds, limits::kinds, "a design that many vehicles share");
    v.named("vehicle", &Scene::starts, limits::starts, "a vehicle with a given start pose");
    v.named("member", &Scene::members, limits::vehicles,
            "a vehicle of the random population with values of its own; its name is its number, from 0");
    v.named("source", &Scene::sources, limits::sources, "a stimulus at a fixed point");
    v.named("obstacle", &Scene::obstacles, limits::obstacles, "a box or convex polygon");
    v.named("zone", &Scene::zones, limits::zones, "an area of the floor with its own properties");
}

// A brain as a file holds it: the four neurons, then all further nodes and wires. Conversion from and to a graph:
// core/scene/brain_text.h.
struct NodeText {
    Node node{.id = -1, .kind = NodeKind::neuron, .name = {}};  // −1: the largest id before it + 1
};

struct WireText {
    std::string from, to;  // names of nodes
    Wire wire;
};

struct BrainText {
    FourNeurons dials;
    std::vector<Dial> given;  // the dials that are in the file, also those of value 0
    std::optional<maths::vec2> place_SL, place_SR, place_ML, place_MR;
    std::vector<NodeText> nodes;
    std::vector<WireText> wires;
};

void describe(auto& v, Of<FourNeurons>) {
    v.number("LL", &FourNeurons::LL, "", weight_range, "the wire from the left eye to the left motor");
    v.number("LR", &FourNeurons::LR, "", weight_range, "the wire from the right eye to the left motor");
    v.number("RL", &FourNeurons::RL, "", weight_range, "the wire from the left eye to the right motor");
    v.number("RR", &FourNeurons::RR, "", weight_range, "the wire from the right eye to the right motor");
    v.number("threshold_LL", &FourNeurons::threshold_LL, "", threshold_range,
             "of LL: an input of smaller size counts as 0");
    v.number("threshold_LR", &FourNeurons::threshold_LR, "", threshold_range, "of LR");
    v.number("threshold_RL", &FourNeurons::threshold_RL, "", threshold_range, "of RL");
    v.number("threshold_RR", &FourNeurons::threshold_RR, "", threshold_range, "of RR");
    v.number("LM", &FourNeurons::LM, "", bias_range, "added to the left motor");
    v.number("RM", &FourNeurons::RM, "", bias_range, "added to the right motor");
}

void describe(auto& v, Of<Curve>) {
    v.word("curve", &Curve::response, "output as a function of the input x");
    v.number("peak", &Curve::peak, "", {-limits::peak, limits::peak},
             "position of the step, the sigmoid's middle or the hump");
    v.number("width", &Curve::width, "", {0.001, limits::width}, "of the sigmoid or the hump");
}

void describe(auto& v, Of<Node>) {
    v.text("name", &Node::name, limits::name_length, "required; of a sensor node: the name of the vehicle's sensor");
    v.number("id", &Node::id, "", {0, 1e9}, "default: the largest id before it + 1");
    v.word("kind", &Node::kind, "the motors are ML and MR");
    v.part(&Node::curve);
    v.number("bias", &Node::bias, "", bias_range, "added to its sum");
    v.number("time_constant", &Node::time_constant, "s", {0, limits::time_constant}, "of its leaky memory; 0: none");
    v.flag("silenced", &Node::silenced, "a lesion: a covered eye, a stopped motor, a neuron that gives 0");
    v.place("place", &Node::place, canvas_range, "centre on the wiring canvas: to the right, down");
}

void describe(auto& v, Of<Wire>) {
    v.number("weight", &Wire::weight, "", weight_range, "factor on the input");
    v.number("threshold", &Wire::threshold, "", threshold_range, "an input of smaller size counts as 0");
    v.part(&Wire::curve);
    v.flag("cut", &Wire::cut, "a lesion: it delivers 0");
    v.number("learning_rate", &Wire::learning_rate, "1/s", {0, limits::learning_rate},
             "of a Hebbian wire; 0: does not learn");
    v.number("decay", &Wire::decay, "1/s", {0, limits::decay}, "rate at which the learned weight fades");
}

void describe(auto& v, Of<NodeText>) { v.part(&NodeText::node); }

void describe(auto& v, Of<WireText>) {
    v.text("from", &WireText::from, limits::name_length, "a node's name");
    v.text("to", &WireText::to, limits::name_length, "a node's name");
    v.part(&WireText::wire);
}

void describe(auto& v, Of<BrainText>) {
    v.part(&BrainText::dials);
    v.place("place_SL", &BrainText::place_SL, canvas_range, "centre of SL on the wiring canvas: to the right, down");
    v.place("place_SR", &BrainText::place_SR, canvas_range, "of SR");
    v.place("place_ML", &BrainText::place_ML, canvas_range, "of ML");
    v.place("place_MR", &BrainText::place_MR, canvas_range, "of MR");
    v.list("node", &BrainText::nodes, limits::sensors + limits::neurons + 2, "a further sensor, neuron or motor");
    v.list("wire", &BrainText::wires, limits::wires, "from one node to another or to itself");
}

// The content of a brain file.
struct BrainFile {
    BrainGraph brain;
};

void describe(auto& v, Of<BrainFile>) { v.brain("brain", &BrainFile::brain, "as in a kind"); }

}  // namespace braitenlab
