// Which sensors of a Thymio take the place of a brain's sensors: the same for Thymio II and Thymio 3.
#pragma once

#include <cstddef>
#include <optional>

#include "core/export/plan.h"
#include "core/result.h"

namespace braitenlab::robots::thymio {

enum class Side { left, right, middle };
inline constexpr std::size_t side_count = static_cast<std::size_t>(Side::middle) + 1;

struct Place {
    bool is_ground = false;  // below the robot, else in front of it
    Side side = Side::middle;
    friend bool operator==(const Place&, const Place&) = default;
};

// Sensors for light and obstacles are proximity sensors, those for floors ground sensors. The last letter of the name
// is the side: L left, R right, else the middle. Nullopt: a Thymio has no sensor for the channel.
std::optional<Place> place_of(const Input&);

// The first sensor without a place, or two for the same place, with their names.
std::optional<Error> sensor_refusal(const Plan&);

}  // namespace braitenlab::robots::thymio
