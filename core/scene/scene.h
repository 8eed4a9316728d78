// A scene as it is edited and as a file holds it: plain values. Nothing here is derived or changed by a tick.
//
// SI units; plane coordinates x, y in metres with the origin in the middle of the arena; angles in radians
// counter-clockwise from +x (files hold degrees). Range of every value: core/scene/schema.h; defaults: here.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/brain/graph.h"
#include "core/maths/vec.h"
#include "core/scene/enums.h"

namespace braitenlab {

// A measured reading of a sensor with SensorResponse::table.
struct ResponsePoint {
    float distance = 0;  // m
    float reading = 0;   // 0..1, of a stimulus of strength 1 on the sensor's axis
    friend bool operator==(const ResponsePoint&, const ResponsePoint&) = default;
};

// A sensor on a vehicle. Coordinates are in the vehicle's frame: x ahead, y left. Its origin is the middle of the
// chassis and the centre of mass; wheels may be anywhere, so an axle behind the middle has wheels of negative x.
struct Sensor {
    std::string name;  // "SL", "SR", …: the brain's sensor node of this name takes the reading
    Channel channel = Channel::light;
    SensorShape shape = SensorShape::sector;
    SensorResponse response = SensorResponse::graded;
    float x = 0.30f, y = 0;   // m
    float angle = 0;          // of the axis, relative to the vehicle's heading
    float fov = 1.7453293f;   // full opening angle of sector or triangle, (0, 2 pi]; of a triangle below pi
    float range = 12;         // m; the reading is 0 beyond. Of a triangle: length of its two sides
    float half_distance = 3;  // m; the d0 of 1/(1 + (d/d0)^2)
    float noise = 0;          // standard deviation of the noise added to a reading; the sum is clamped to 0..1
    float latency = 0;        // s between a reading and the brain's input, 0..1
    float gain_spread = 0;    // ± share by which the readings of each vehicle's sensor differ, random
    float gamma = 1;          // exponent of a photocell's curve
    bool hard_range = false;  // a graded reading does not fade towards the range
    float interval = 0;       // s between two samples, 0..1; the last one is held; 0: a sample at every tick
    float half_lux = 268;     // lx at which a photocell reads 0.5; default: a GL5528 over 1.5 kOhm
    int bits = 0;             // of the converter, which rounds a reading down to one of 2^bits steps; 0: none
    std::vector<ResponsePoint> points{};  // of SensorResponse::table, by distance; the reading is 0 beyond the last
    friend bool operator==(const Sensor&, const Sensor&) = default;
};

struct Wheel {
    float x = 0, y = 0;    // m, contact point
    float radius = 0.20f;  // m
    float width = 0.09f;   // m
    Motor motor = Motor::none;
    float grip = 0;      // friction coefficient mu, along and across; 0 for a castor
    float load = 0.25f;  // share of the vehicle's weight on this wheel; all wheels add up to 1
    float area = 0.01f;  // m^2 of contact, for rolling drag
    friend bool operator==(const Wheel&, const Wheel&) = default;
};

// The body of a vehicle. Default: the standard vehicle, a differential drive with a castor ahead and one behind.
struct Body {
    float length = 1.0f, width = 0.7f;  // m, of the chassis, whose middle is the vehicle's origin
    float mass = 10;                    // kg
    float top_speed = 3;                // m/s, of a wheel commanded to 1, at the nominal voltage
    float motor_force = 24;             // N, maximum of one motor, at the nominal voltage
    float mismatch = 0;                 // ± share of top_speed by which each motor of each vehicle differs, random
    float dead_band = 0;                // a motor does not turn for commands of smaller size
    std::vector<Wheel> wheels{
        {0, 0.30f, 0.20f, 0.10f, Motor::left, 0.9f, 0.4f, 0.010f},
        {0, -0.30f, 0.20f, 0.10f, Motor::right, 0.9f, 0.4f, 0.010f},
        {0.38f, 0, 0.07f, 0.05f, Motor::none, 0, 0.1f, 0.004f},
        {-0.38f, 0, 0.07f, 0.05f, Motor::none, 0, 0.1f, 0.004f},
    };
    float friction_spread = 0;  // ± share by which grip and rolling drag of each wheel of each vehicle differ, random
    float voltage = 0;          // V, at the motors; 0: the nominal one
    float nominal_voltage = 6;  // V
    friend bool operator==(const Body&, const Body&) = default;
};

// A source mounted on a vehicle.
struct CarriedLamp {
    std::string name;
    Channel channel = Channel::light;
    float x = 0, y = 0;  // m, in the vehicle's frame
    float strength = 1;  // 0..1
    float candela = 0;   // as Source
    friend bool operator==(const CarriedLamp&, const CarriedLamp&) = default;
};

// A point on the path of a vehicle with Driver::path; after the last follows the first.
struct Waypoint {
    float x = 0, y = 0;  // m
    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

// The marks that a vehicle keeps where it met obstacles; its sensors on the channel `memory` sense them like sources. A
// contact makes a mark unless one is within mark_spacing(); that one is set back to full strength instead. A mark ends
// after seven halvings of its strength.
struct PlaceMemory {
    int marks = 0;          // maximum; a new mark replaces the oldest; 0: no memory
    float fade = 20;        // s, half-life of a mark's strength
    float strength = 0.7f;  // of a new mark, 0..1
    friend bool operator==(const PlaceMemory&, const PlaceMemory&) = default;
};

// A design that any number of vehicles share.
struct Kind {
    std::string name;
    Role role = Role::none;
    Driver driver = Driver::brain;
    float share = 0;     // weight of this kind in the random population, relative to other kinds
    std::string colour;  // of the body, "#rrggbb"; empty: by role. Display only
    Body body{};
    PlaceMemory memory{};
    std::vector<Sensor> sensors;
    std::vector<CarriedLamp> lamps;
    std::vector<Waypoint> waypoints;  // for Driver::path
    BrainGraph brain;
    // The window shows nothing of its brain, and a file holds it sealed (core/scene/sealed.h). The run does not depend
    // on it; a saved run does not hold it.
    bool hidden = false;
    friend bool operator==(const Kind&, const Kind&) = default;
};

// A vehicle with a given start pose; spreads let the pose vary with the seed.
struct Start {
    std::string name;
    std::string kind;
    float x = 0, y = 0, heading = 0;
    std::string facing;                            // name of a source: heading is then relative to the direction to it
    float place_spread = 0;                        // m; x and y each vary by up to ± this
    float heading_spread = 0;                      // the heading varies by up to ± this
    std::optional<Driver> driver{};                // nullopt: that of its kind
    std::optional<BrainGraph> brain{};             // nullopt: that of its kind
    std::optional<std::vector<Sensor>> sensors{};  // nullopt: those of its kind
    std::string colour{};                          // of the body, "#rrggbb"; empty: that of its kind. Display only
    friend bool operator==(const Start&, const Start&) = default;
};

// How the window shows one vehicle. Display only.
struct Look {
    std::string label{};   // its name; empty: none of its own
    std::string colour{};  // of the body, "#rrggbb"; empty: that of its kind
    friend bool operator==(const Look&, const Look&) = default;
};

// A vehicle of the random population with values of its own.
struct Member {
    std::string name;  // its number in the population, from 0, as a decimal
    std::string kind;  // empty: chosen by the shares
    bool placed = false;
    float x = 0, y = 0, heading = 0;               // its start pose if `placed`, else a random one
    std::optional<Driver> driver{};                // nullopt: that of its kind
    std::optional<BrainGraph> brain{};             // nullopt: that of its kind
    std::optional<std::vector<Sensor>> sensors{};  // nullopt: those of its kind
    std::string label{}, colour{};                 // as Look
    friend bool operator==(const Member&, const Member&) = default;
};

// A time in which a source is on.
struct OnTime {
    float from = 0, until = 0;  // s of simulated time; from < until
    friend bool operator==(const OnTime&, const OnTime&) = default;
};

// A stimulus at a fixed point of the world.
struct Source {
    std::string name;
    Channel channel = Channel::light;
    float x = 0, y = 0;
    float strength = 1;        // 0..1, reading of a sensor at the source
    bool solid = false;        // a post of source_radius() that vehicles collide with
    std::vector<OnTime> on{};  // its strength is 0 at other times; empty: always on
    float candela = 0;         // luminous intensity at strength 1, for photocells; 0: not stated, by strength alone
    friend bool operator==(const Source&, const Source&) = default;
};

inline constexpr float solid_source_radius = 0.15f;  // m, in an arena with sides from full_scale_side
inline constexpr float full_scale_side = 5;          // m

// A corner of an obstacle or a zone, in the object's own frame.
struct PolygonCorner {
    float x = 0, y = 0;  // m
    friend bool operator==(const PolygonCorner&, const PolygonCorner&) = default;
};

// A box, or a convex polygon where corners are given.
struct Obstacle {
    std::string name;
    float x = 0, y = 0, heading = 0;
    float length = 1, width = 1;         // m, of the box, along and across its heading
    std::vector<PolygonCorner> corners;  // empty: a box; else 3..8, counter-clockwise, convex
    float mass = 0;                      // kg; 0: fixed; else vehicles can push it
    friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

// An area of the floor with its own properties: a rectangle, an ellipse, or a convex polygon where corners are given.
// Where zones overlap, the surface is that of the last one in the list; the effects of the others add up.
struct Zone {
    std::string name;
    float x = 0, y = 0, heading = 0;
    float length = 1, width = 1;  // m, along and across its heading
    bool round = false;           // an ellipse with these axes instead of a rectangle; not used with corners
    Surface surface = Surface::none;
    float recharge = 0;                    // energy per second for every vehicle in it
    float wind_x = 0, wind_y = 0;          // N on every vehicle in it, along the world's axes
    float slope = 0;                       // rad; downhill is along the heading
    float pull = 0;                        // N towards its centre; negative: away from it
    std::vector<PolygonCorner> corners{};  // empty: a rectangle or an ellipse; else 3..8, counter-clockwise, convex
    friend bool operator==(const Zone&, const Zone&) = default;
};

struct Arena {
    float width = 20, height = 20;  // m, along x and y
    Boundary edge = Boundary::wall;
    bool round = false;        // the ellipse with the axes width × height; not with Boundary::torus
    float friction = 40;       // rolling drag in N·s/m per m² of contact
    float grip = 1;            // factor on every wheel's grip; ice is 0.1
    float reflectance = 0.8f;  // 0..1, reading of a floor sensor
    float ambient = 0;         // 0..1, added to the readings of all sensors for light or a colour
    float lux = 0;             // illuminance of photocells by ambient light, in addition
    friend bool operator==(const Arena&, const Arena&) = default;
};

// What has no size of its own has this share of its usual size in the arena: 1 where the shorter side has 5 m or more,
// in proportion to it below, so that a lamp on a table is no larger than a robot.
float scale_of(const Arena&);
// Radius of the post of a solid source, m.
inline float source_radius(const Arena& arena) { return solid_source_radius * scale_of(arena); }
// Smallest distance between two marks of one vehicle, m.
inline float mark_spacing(const Arena& arena) { return 0.5f * scale_of(arena); }

struct Ecology {
    int population = 0;    // vehicles placed at random, in addition to `starts`; 0..20000
    float drain = 0;       // energy that a vehicle loses per second
    float bite = 0.25f;    // energy a predator takes from touched prey, at most once per second
    float inactivity = 0;  // s without movement of any vehicle after which a new generation starts; 0: never
    friend bool operator==(const Ecology&, const Ecology&) = default;
};

// What the user may try in the scene; shown on its card. It does not change a run.
struct PopulationGoal {
    Role role = Role::none;  // predator or prey; none: the scene has no goal
    int count = 3;           // at least so many vehicles of the role
    float seconds = 60;      // without a break
    friend bool operator==(const PopulationGoal&, const PopulationGoal&) = default;
};

struct Scene {
    std::string name;  // "predator-prey"; the file's stem
    std::string title;
    std::string story;  // one line about the scene
    Arena arena;
    Ecology ecology;
    PopulationGoal goal;
    std::vector<Kind> kinds;
    std::vector<Start> starts;
    std::vector<Member> members;
    std::vector<Source> sources;
    std::vector<Obstacle> obstacles;
    std::vector<Zone> zones;
    friend bool operator==(const Scene&, const Scene&) = default;
};

// The floor at one point, for wheels and floor sensors.
struct FloorConstants {
    float friction, grip, reflectance;  // as in Arena
};
// The constants of a surface in this arena; row of surface_table, completed by the arena's own values.
FloorConstants floor_constants(const Arena&, Surface);

// The corners of an obstacle in its own frame, counter-clockwise; four for a box.
std::vector<maths::vec2> corners_of(const Obstacle&);
// Those of a zone; four for a rectangle and for an ellipse, whose bounding rectangle they are.
std::vector<maths::vec2> corners_of(const Zone&);

// Strength of a source at a time (s): 0 while it is off.
float strength_at(const Source&, double seconds);

// True when a sensor for `wanted` senses a source of `given`.
bool is_seen_as(Channel given, Channel wanted);

// True when obstacles hide stimuli of this channel (ChannelTraits::is_hidden).
bool is_blocked_by_obstacles(Channel);

// Index of the kind, source, obstacle or zone with this name, or −1.
int find_kind(const Scene&, const std::string& name);
int find_source(const Scene&, const std::string& name);
int find_obstacle(const Scene&, const std::string& name);
int find_zone(const Scene&, const std::string& name);

// True for "#rrggbb" with hexadecimal digits of either case.
bool is_colour(std::string_view);

// Share of top speed and motor force that the motors have at their voltage: both are proportional to it, as those of a
// direct-current motor without load and at rest.
float voltage_share(const Body&);

// The body with this length and width (m): its wheels are moved and scaled in proportion, within their ranges.
Body resized(const Body&, float length, float width);

// Number of the member in the population, from 0; −1 if its name is no such number.
int number_of(const Member&);

// The names of a kind's sensors in their order, as compile() takes them.
std::vector<std::string> sensor_names(const Kind&);

}  // namespace braitenlab
