// The enumerations of a scene, each with its table: one row per enumerator with its word and its traits.
//
// A new enumerator is one line in its enumeration and one row in its table; readers, writers, menus, keys of strings,
// docs and tests follow from the table. What else it needs, if anything, is stated above the enumeration.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "core/enum_table.h"

namespace braitenlab {

// What can be sensed. A new channel also needs its colours (render/view/palette.h), and a law in the sensing code where
// it is not summed.
//
// A sensor for red, green or blue also sees white light, and a sensor for light sees all four. `memory` are the
// vehicle's own marks. `touch` is a bumper: 1 while the vehicle touches something in the sensor's field, at any range.
// `floor` is the reflectance below the sensor, `energy` the vehicle's own energy; a boolean sensor for one of these two
// is 1 from 0.5 on. `random` is a number from 0 to 1, drawn for each sample; a boolean sensor is 1 with probability
// 0.5. A vehicle senses neither its own lamps nor its own role.
enum class Channel {
    light,
    red,
    green,
    blue,
    heat,
    smell,
    oxygen,
    obstacle,
    predator,
    prey,
    vehicle,
    memory,
    touch,
    floor,
    energy,
    random
};

struct ChannelTraits {
    Channel value;
    std::string_view word;
    bool is_summed = false;        // stimuli at points add up: sources, carried lamps, vehicles of a role
    bool is_source = false;        // a source or a carried lamp gives it off; menus offer it
    bool is_light = false;         // white light or a colour; the arena's ambient light adds to it
    bool is_hidden = false;        // obstacles between stimulus and sensor hide the stimulus; vehicles never do
    bool has_field = true;         // a sensor looks in a direction; else its direction, field and range change nothing
    bool is_mapped = true;         // has a value at every point of the floor, so contours can show it
    std::string_view stem = "S";   // of the names of sensors that are added: SL and SR; SC for a single one
    std::string_view single = {};  // name of a single sensor; empty: stem and C
    bool is_paired = true;         // sensors for it are added as a pair, unless a single one is chosen
};

inline constexpr auto channel_table = std::to_array<ChannelTraits>({
    {.value = Channel::light,
     .word = "light",
     .is_summed = true,
     .is_source = true,
     .is_light = true,
     .is_hidden = true},
    {.value = Channel::red,
     .word = "red",
     .is_summed = true,
     .is_source = true,
     .is_light = true,
     .is_hidden = true,
     .stem = "D"},
    {.value = Channel::green,
     .word = "green",
     .is_summed = true,
     .is_source = true,
     .is_light = true,
     .is_hidden = true,
     .stem = "G"},
    {.value = Channel::blue,
     .word = "blue",
     .is_summed = true,
     .is_source = true,
     .is_light = true,
     .is_hidden = true,
     .stem = "B"},
    {.value = Channel::heat, .word = "heat", .is_summed = true, .is_source = true, .stem = "H"},
    {.value = Channel::smell, .word = "smell", .is_summed = true, .is_source = true, .stem = "N"},
    {.value = Channel::oxygen, .word = "oxygen", .is_summed = true, .is_source = true, .stem = "A"},
    {.value = Channel::obstacle, .word = "obstacle", .stem = "O"},
    {.value = Channel::predator, .word = "predator", .is_summed = true, .is_hidden = true, .stem = "P"},
    {.value = Channel::prey, .word = "prey", .is_summed = true, .is_hidden = true, .stem = "Y"},
    {.value = Channel::vehicle, .word = "vehicle", .is_summed = true, .is_hidden = true, .stem = "K"},
    {.value = Channel::memory, .word = "memory", .stem = "Q"},
    {.value = Channel::touch, .word = "touch", .is_mapped = false, .stem = "T", .is_paired = false},
    {.value = Channel::floor, .word = "floor", .has_field = false, .stem = "F"},
    {.value = Channel::energy,
     .word = "energy",
     .has_field = false,
     .is_mapped = false,
     .stem = "E",
     .single = "EN",
     .is_paired = false},
    {.value = Channel::random,
     .word = "random",
     .has_field = false,
     .is_mapped = false,
     .stem = "Z",
     .is_paired = false},
});
constexpr const auto& table_of(Channel) { return channel_table; }
inline constexpr int channel_count = static_cast<int>(channel_table.size());
static_assert(is_complete_table<channel_table>());

// The channels with a trait, in the order of Channel: channels_with<&ChannelTraits::is_source>.
template <bool ChannelTraits::*trait>
inline constexpr auto channels_with = [] {
    constexpr auto count =
        std::count_if(channel_table.begin(), channel_table.end(), [](auto& row) { return row.*trait; });
    std::array<Channel, static_cast<std::size_t>(count)> found{};
    std::size_t next = 0;
    for (const ChannelTraits& row : channel_table)
        if (row.*trait) found[next++] = row.value;
    return found;
}();

// How a vehicle appears to others. Predators bite prey. `wiring`: the brain decides by the pair of sensors that senses
// vehicles, predators or prey; a vehicle drawn to others is a predator, one driven away is prey (recognise()).
enum class Role { none, predator, prey, wiring };

inline constexpr auto role_table = std::to_array<Word<Role>>(
    {{Role::none, "none"}, {Role::predator, "predator"}, {Role::prey, "prey"}, {Role::wiring, "wiring"}});
constexpr const auto& table_of(Role) { return role_table; }
static_assert(is_complete_table<role_table>());

enum class SensorShape { sector, triangle, omni };

inline constexpr auto sensor_shape_table = std::to_array<Word<SensorShape>>(
    {{SensorShape::sector, "sector"}, {SensorShape::triangle, "triangle"}, {SensorShape::omni, "omni"}});
constexpr const auto& table_of(SensorShape) { return sensor_shape_table; }
static_assert(is_complete_table<sensor_shape_table>());

// How a reading depends on a stimulus in the field: `graded` falls with distance and angle off the axis, `boolean` is
// the whole strength; a `photocell` adds the light of all stimuli before its curve; `table` has measured readings by
// distance. Formulas: response_to() in the sensing code.
enum class SensorResponse { graded, boolean, photocell, table };

inline constexpr auto sensor_response_table =
    std::to_array<Word<SensorResponse>>({{SensorResponse::graded, "graded"},
                                         {SensorResponse::boolean, "boolean"},
                                         {SensorResponse::photocell, "photocell"},
                                         {SensorResponse::table, "table"}});
constexpr const auto& table_of(SensorResponse) { return sensor_response_table; }
static_assert(is_complete_table<sensor_response_table>());

// What commands a vehicle's motors: its brain, a person (the Steer command), its waypoints, chance, or nothing.
enum class Driver { brain, manual, path, wander, parked };

inline constexpr auto driver_table = std::to_array<Word<Driver>>({{Driver::brain, "brain"},
                                                                  {Driver::manual, "manual"},
                                                                  {Driver::path, "path"},
                                                                  {Driver::wander, "wander"},
                                                                  {Driver::parked, "parked"}});
constexpr const auto& table_of(Driver) { return driver_table; }
static_assert(is_complete_table<driver_table>());

// What bounds the arena. `wall`: walls. `open`: a vehicle that leaves falls off and enters again, at its start or
// elsewhere. `torus`: a vehicle that leaves on one side enters on the opposite side. `rim`: walls that are lower than
// the obstacle sensors; bumpers feel them.
enum class Boundary { wall, open, torus, rim };

inline constexpr auto boundary_table = std::to_array<Word<Boundary>>(
    {{Boundary::wall, "wall"}, {Boundary::open, "open"}, {Boundary::torus, "torus"}, {Boundary::rim, "rim"}});
constexpr bool has_walls(Boundary edge) { return edge == Boundary::wall || edge == Boundary::rim; }
constexpr const auto& table_of(Boundary) { return boundary_table; }
static_assert(is_complete_table<boundary_table>());

// What covers a zone of the floor; `none` leaves the arena's own floor.
enum class Surface { none, ice, carpet, sand, tape };

// The constants of a surface; where one is absent, the arena's own holds. Chosen so that a standard vehicle that coasts
// from top speed rolls about five times as long on ice as on the plain floor, and a third as long on carpet.
struct SurfaceTraits {
    Surface value;
    std::string_view word;
    std::optional<float> friction{};     // N·s/m per m² of wheel contact
    std::optional<float> grip{};         // factor on every wheel's grip
    std::optional<float> reflectance{};  // 0..1
};

inline constexpr auto surface_table = std::to_array<SurfaceTraits>({
    {.value = Surface::none, .word = "none"},
    {.value = Surface::ice, .word = "ice", .friction = 8.0f, .grip = 0.1f, .reflectance = 0.95f},
    {.value = Surface::carpet, .word = "carpet", .friction = 120.0f, .grip = 1.1f, .reflectance = 0.45f},
    {.value = Surface::sand, .word = "sand", .friction = 400.0f, .grip = 0.6f, .reflectance = 0.6f},
    {.value = Surface::tape, .word = "tape", .reflectance = 0.05f},
});
constexpr const auto& table_of(Surface) { return surface_table; }
static_assert(is_complete_table<surface_table>());

// The motor that turns a wheel; none for a castor, which rolls in every direction.
enum class Motor { none, left, right };

inline constexpr auto motor_table =
    std::to_array<Word<Motor>>({{Motor::none, "none"}, {Motor::left, "left"}, {Motor::right, "right"}});
constexpr const auto& table_of(Motor) { return motor_table; }
static_assert(is_complete_table<motor_table>());

}  // namespace braitenlab
