// A scene as a person edits it and a file holds it: plain values, nothing derived, nothing that a tick changes.
//
// SI units; plane coordinates x, y in metres with the origin in the middle of the arena; angles in radians
// counter-clockwise from +x (files hold degrees). Ranges and defaults of every value: core/scene/schema.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/brain/graph.h"
#include "core/maths/vec.h"
#include "core/scene/enums.h"

namespace braitenlab {

// An eye (or nose, or feeler) on a vehicle. Its frame is the vehicle's: x ahead, y left, origin amid the driven axle.
struct Sensor {
    std::string name;  // "SL", "SR", …: the brain's sensor node of this name reads it
    Channel channel = Channel::light;
    SensorShape shape = SensorShape::sector;
    SensorResponse response = SensorResponse::graded;
    float x = 0.30f, y = 0;    // m
    float angle = 0;           // the axis of view, against the vehicle's heading
    float field = 1.7453293f;  // the whole opening angle, (0, 2 pi]; of a triangle below pi
    float range = 12;          // m; it senses nothing beyond. Of a triangle the length of its arms
    float half_distance = 3;   // m; the d0 of 1/(1 + (d/d0)^2)
    float noise = 0;           // standard deviation added to every reading, which stays in 0..1
    float latency = 0;         // s until the brain gets a reading, 0..1
    friend bool operator==(const Sensor&, const Sensor&) = default;
};

struct Wheel {
    float x = 0, y = 0;    // m, contact point
    float radius = 0.16f;  // m
    float width = 0.09f;   // m
    Motor motor = Motor::none;
    float grip = 0;      // friction coefficient mu, along and across; 0 for a castor
    float load = 0.25f;  // share of the vehicle's weight that rests on it; all wheels add up to 1
    float area = 0.01f;  // m^2 of contact, for rolling drag
    friend bool operator==(const Wheel&, const Wheel&) = default;
};

// The body of a vehicle. The default is the standard vehicle: a differential drive with a castor ahead and one behind.
struct Body {
    float length = 1.0f, width = 0.7f;  // m, of the chassis; its middle is the vehicle's origin
    float mass = 10;                    // kg
    float top_speed = 3;                // m/s, of a wheel commanded to 1
    float motor_force = 24;             // N, the most one motor can push
    float mismatch = 0;                 // each motor's top speed differs by up to this share, drawn for each vehicle
    float dead_band = 0;                // a command whose size is below it leaves the motor still
    std::vector<Wheel> wheels{
        {0, 0.30f, 0.16f, 0.10f, Motor::left, 0.9f, 0.4f, 0.010f},
        {0, -0.30f, 0.16f, 0.10f, Motor::right, 0.9f, 0.4f, 0.010f},
        {0.38f, 0, 0.07f, 0.05f, Motor::none, 0, 0.1f, 0.004f},
        {-0.38f, 0, 0.07f, 0.05f, Motor::none, 0, 0.1f, 0.004f},
    };
    friend bool operator==(const Body&, const Body&) = default;
};

// A lamp that a vehicle carries.
struct CarriedLamp {
    std::string name;
    Channel channel = Channel::light;
    float x = 0, y = 0;  // m, in the vehicle's frame
    float strength = 1;  // 0..1
    friend bool operator==(const CarriedLamp&, const CarriedLamp&) = default;
};

// Where a vehicle that follows a path drives next; after the last comes the first.
struct Waypoint {
    float x = 0, y = 0;  // m
    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

// How a vehicle remembers the places where it met obstacles: eyes for `memory` sense the marks like lamps. It lays one
// where it touches something, at least half a metre from its others; nearer, the old one is fresh again. A mark is
// forgotten after seven halvings.
struct PlaceMemory {
    int marks = 0;          // the most it remembers; the oldest goes first; 0: none
    float fade = 20;        // s in which a mark's strength falls to a half
    float strength = 0.7f;  // of a fresh mark, 0..1
    friend bool operator==(const PlaceMemory&, const PlaceMemory&) = default;
};

// A design that many vehicles share.
struct Kind {
    std::string name;
    Role role = Role::none;
    Driver driver = Driver::brain;
    float share = 0;  // of the population placed at random, against the other kinds' shares
    Body body{};
    PlaceMemory memory{};
    std::vector<Sensor> sensors;
    std::vector<CarriedLamp> lamps;
    std::vector<Waypoint> waypoints;  // of the driver `path`
    BrainGraph brain;
    friend bool operator==(const Kind&, const Kind&) = default;
};

// A vehicle placed by hand. Where it starts may vary with the seed.
struct Start {
    std::string name;
    std::string kind;
    float x = 0, y = 0, heading = 0;
    std::string facing;        // a source's name: heading then counts from the direction towards it
    float place_spread = 0;    // m; x and y vary by up to this much either way
    float heading_spread = 0;  // the heading varies by up to this much either way
    friend bool operator==(const Start&, const Start&) = default;
};

// Something that stands in the world and can be sensed.
struct Source {
    std::string name;
    Channel channel = Channel::light;
    float x = 0, y = 0;
    float strength = 1;  // 0..1, what an eye right before it gets
    bool solid = false;  // a post of 0.15 m radius that nothing drives through
    friend bool operator==(const Source&, const Source&) = default;
};

inline constexpr float solid_source_radius = 0.15f;  // m

// A corner of an obstacle, in the obstacle's own frame.
struct PolygonCorner {
    float x = 0, y = 0;  // m
    friend bool operator==(const PolygonCorner&, const PolygonCorner&) = default;
};

// Something that stands in the way: a box, or a convex polygon where corners are given.
struct Obstacle {
    std::string name;
    float x = 0, y = 0, heading = 0;
    float length = 1, width = 1;         // m, of the box, along and across its heading
    std::vector<PolygonCorner> corners;  // none: a box; else 3..8, counter-clockwise, convex
    float mass = 0;                      // kg; 0: fixed, else vehicles push it about
    friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

// A patch of floor on which something is different. Where zones overlap the later one counts for surface; the rest adds
// up.
struct Zone {
    std::string name;
    float x = 0, y = 0, heading = 0;
    float length = 1, width = 1;  // m, along and across its heading
    bool round = false;           // an ellipse of that length and width
    Surface surface = Surface::none;
    float recharge = 0;            // energy a second for every vehicle on it
    float wind_x = 0, wind_y = 0;  // N on every vehicle, along the world's axes
    float slope = 0;               // rad; downhill is along the heading
    float pull = 0;                // N towards its middle; negative pushes away
    friend bool operator==(const Zone&, const Zone&) = default;
};

struct Arena {
    float width = 20, height = 20;  // m, along x and y
    Boundary edge = Boundary::wall;
    float friction = 40;       // the floor's constant: rolling drag in N·s/m per m^2 of contact
    float grip = 1;            // multiplies every wheel's grip; ice is 0.1
    float reflectance = 0.8f;  // 0..1, what a floor sensor reads
    float ambient = 0;         // 0..1, light from everywhere, added to what every eye for light or a colour sees
    friend bool operator==(const Arena&, const Arena&) = default;
};

struct Ecology {
    int population = 0;    // vehicles placed at random beyond those placed by hand, 0..20000
    float drain = 0;       // energy lost a second
    float bite = 0.25f;    // energy a predator takes from prey it touches, once a second at most
    float inactivity = 0;  // s without movement until a new generation begins; 0: never
    friend bool operator==(const Ecology&, const Ecology&) = default;
};

struct Scene {
    std::string name;   // "predator-prey"; the file's stem
    std::string title;  // for people
    std::string story;  // one line
    Arena arena;
    Ecology ecology;
    std::vector<Kind> kinds;
    std::vector<Start> starts;
    std::vector<Source> sources;
    std::vector<Obstacle> obstacles;
    std::vector<Zone> zones;
    friend bool operator==(const Scene&, const Scene&) = default;
};

// What a floor is like to a wheel and to an eye.
struct FloorConstants {
    float friction, grip, reflectance;  // as in Arena
};
// Of a surface, or of the arena's own floor for Surface::none and, but for its darkness, Surface::tape.
FloorConstants floor_constants(const Arena&, Surface);

// The corners of an obstacle in its own frame, counter-clockwise: a box's four or those it is given.
std::vector<maths::vec2> corners_of(const Obstacle&);

// Whether a source of `given` is seen by an eye for `wanted`.
bool is_seen_as(Channel given, Channel wanted);

// Whether obstacles hide what is on this channel: light and whatever is looked at, but not heat, smell and the like.
bool is_blocked_by_obstacles(Channel);

// Index of the kind, source or obstacle of this name, or −1.
int find_kind(const Scene&, const std::string& name);
int find_source(const Scene&, const std::string& name);
int find_obstacle(const Scene&, const std::string& name);

// The names of a kind's sensors, in its own order: what compile() asks for.
std::vector<std::string> sensor_names(const Kind&);

}  // namespace braitenlab
