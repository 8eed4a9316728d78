#include "render/view/trail_colour.h"

#include <algorithm>
#include <cmath>

namespace braitenlab::render {

TrailMoment trail_moment_of(const Snapshot& now, const VehicleView& vehicle) {
    TrailMoment moment{.motor = vehicle.motor, .speed = vehicle.speed};
    if (!now.scene) return moment;
    const std::size_t count = std::min(kind_of(now, vehicle).sensors.size(), recorded_sensors);
    const auto first = static_cast<std::size_t>(vehicle.first_sensed);
    for (std::size_t i = 0; i < count && first + i < now.sensed.size(); ++i)
        moment.readings[i] =
            static_cast<std::uint8_t>(std::lround(254 * std::clamp(now.sensed[first + i], 0.0f, 1.0f)));
    return moment;
}

std::optional<float> share_of_scale(const TrailColour& colour, const TrailMoment& moment,
                                    const std::vector<Sensor>& sensors, float top_speed) {
    switch (colour.value) {
        case TrailValue::plain:
            break;
        case TrailValue::wheels:
            return std::clamp(0.5f + 0.5f * (moment.motor[1] - moment.motor[0]), 0.0f, 1.0f);
        case TrailValue::speed:
            return std::clamp(std::fabs(moment.speed) / std::max(top_speed, 0.01f), 0.0f, 1.0f);
        case TrailValue::reading: {
            const auto found = std::find_if(sensors.begin(), sensors.end(),
                                            [&](const Sensor& sensor) { return sensor.name == colour.sensor; });
            const auto number = static_cast<std::size_t>(found - sensors.begin());
            if (found == sensors.end() || number >= recorded_sensors) break;
            if (moment.readings[number] == TrailMoment::unknown) break;
            return static_cast<float>(moment.readings[number]) / 254.0f;
        }
    }
    return std::nullopt;
}

float top_speed_of(const Snapshot& now) {
    float fastest = 0;
    if (now.scene)
        for (const Kind& kind : now.scene->kinds)
            fastest = std::max(fastest, kind.body.top_speed * voltage_share(kind.body));
    return fastest > 0 ? fastest : Body{}.top_speed;
}

Colour colour_of_share(TrailValue value, float share, Theme theme) {
    const bool dark = theme == Theme::dark;
    using Scale = std::array<Colour, 3>;  // lower end, middle, upper end
    const Scale wheels =
        dark ? Scale{rgb(0x8F9BFF), rgb(0xD3D8E0), rgb(0xFFA62B)} : Scale{rgb(0x3A3FC4), rgb(0x8D929C), rgb(0xB35C00)};
    const Scale amount =
        dark ? Scale{rgb(0x7B6BC4), rgb(0xF0746E), rgb(0xFCE69A)} : Scale{rgb(0xCE8130), rgb(0xC0436B), rgb(0x2D1B6B)};
    const Scale& scale = value == TrailValue::wheels ? wheels : amount;
    const float at = 2 * std::clamp(share, 0.0f, 1.0f);
    return at < 1 ? mix(scale[0], scale[1], at) : mix(scale[1], scale[2], at - 1);
}

}  // namespace braitenlab::render
