// Trails coloured by a value: which value, its scale and its colours.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/scene/scene.h"
#include "core/world/snapshot.h"
#include "render/view/palette.h"

namespace braitenlab {

enum class TrailValue {
    plain,    // the colour of the role
    wheels,   // right − left wheel command, −1..1; larger differences have the colour of the end
    speed,    // m/s, without its sign, 0..top_speed_of()
    reading,  // of one sensor, 0..1
};
inline constexpr std::array<std::string_view, 4> trail_value_words{"plain", "wheels", "speed", "reading"};
static_assert(has_enumerators<TrailValue, trail_value_words.size()>());
constexpr std::string_view word(TrailValue value) { return trail_value_words[static_cast<std::size_t>(value)]; }

struct TrailColour {
    TrailValue value = TrailValue::plain;
    std::string sensor{};  // Sensor::name, of TrailValue::reading; a trail of a vehicle without this sensor is plain
    friend bool operator==(const TrailColour&, const TrailColour&) = default;
};

namespace render {

// Readings are recorded of the first sensors of a vehicle.
inline constexpr std::size_t recorded_sensors = 12;

// What a vehicle did at a point of its trail.
struct TrailMoment {
    static constexpr std::uint8_t unknown = 255;
    std::array<float, 2> motor{};                                         // as VehicleView
    float speed = 0;                                                      // m/s, as VehicleView
    std::array<std::uint8_t, recorded_sensors> readings = all_unknown();  // in 254ths, or unknown

    static constexpr std::array<std::uint8_t, recorded_sensors> all_unknown() {
        std::array<std::uint8_t, recorded_sensors> none{};
        none.fill(unknown);
        return none;
    }
};
TrailMoment trail_moment_of(const Snapshot&, const VehicleView&);

// The place of the moment's value on its scale: 0 at the lower end, 1 at the upper one. `sensors`: of the vehicle, as
// kind_of().sensors. nullopt: plain, or the vehicle has no such sensor, or its reading is not recorded.
std::optional<float> share_of_scale(const TrailColour&, const TrailMoment&, const std::vector<Sensor>& sensors,
                                    float top_speed);

// The largest top speed of the kinds in the scene, m/s: one scale for all vehicles.
float top_speed_of(const Snapshot&);

// The colour of a place on the scale, 0..1. The lightness of the scale of speed and readings changes in one direction;
// the ends of the scale of the wheels are blue and orange, its middle is grey: both can be told without red and green.
Colour colour_of_share(TrailValue, float share, Theme);

}  // namespace render

}  // namespace braitenlab
