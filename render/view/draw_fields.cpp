// Sensor fields on the floor.
#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec4;

namespace {

// Radius of the fill. With many vehicles only the near part of a field is filled, which keeps the floor visible and
// bounds the cost of the picture.
float fill_reach(const Drawing& drawing, const Subject& s, const Sensor& sensor) {
    if (s.selected || s.hovered) return sensor.range;
    return std::min(sensor.range, std::max(1.2f, sensor.range * drawing.crowd * (0.85f + 0.15f * drawing.crowd)));
}

// Distance at which a fill of this strength is no longer visible; the drawn polygon ends there.
float visible_radius(float fill, float reach, const Sensor& sensor) {
    constexpr float least = 0.010f;  // two or three of 255 levels
    if (sensor.response == SensorResponse::boolean) return reach;
    for (float d = reach; d > 0; d -= reach / 16) {
        const float rest = 1 - d * d / (reach * reach), half = d / sensor.half_distance;
        if (fill * rest * rest / (1 + half * half) >= least) return std::min(reach, d + reach / 16);
    }
    return 0;
}

// The colour of a channel without most of its white: a pale colour over the blue of the dark floor becomes grey.
Colour deep(Colour c) {
    const float white = 0.8f * std::min({c.r, c.g, c.b}), most = std::max({c.r, c.g, c.b});
    const float scale = most / std::max(most - white, 1e-3f);
    return {(c.r - white) * scale, (c.g - white) * scale, (c.b - white) * scale, c.a};
}

// Index of the first sensor on a side (1 left, −1 right), or the number of sensors.
std::size_t first_sensor_on(const Kind& kind, int side) {
    std::size_t i = 0;
    while (i < kind.sensors.size() && side_of(kind.sensors[i]) != side) ++i;
    return i;
}

}  // namespace

void add_fields(Drawing& drawing, const Subject& s) {
    const bool fills = drawing.picture.settings.sensors || s.driven;
    if (!fills && !drawing.picture.settings.outlines) return;
    for (std::size_t i = 0; i < s.kind.sensors.size(); ++i) {
        const Sensor& sensor = s.kind.sensors[i];
        const float seen = std::sqrt(sensed(drawing, s, i));
        const bool light = is_light(drawing);
        const Colour channel = colour_of(drawing.colours, sensor.channel);
        // With many vehicles idle fields are fainter, because many overlapping colours turn grey.
        const bool chosen = s.selected || s.hovered;
        const float idle = (chosen ? 0.30f : 0.20f * std::max(0.2f, drawing.crowd * drawing.crowd)) * (!light   ? 1.2f
                                                                                                       : chosen ? 1.0f
                                                                                                                : 0.6f);
        const float strong = (chosen ? 0.56f : 0.46f) + (light ? 0.04f : 0.12f);
        const float awake = s.view.driver == Driver::parked ? 0.4f : 1.0f;
        const float fill = fills && !is_covered(s, i) ? (idle + (strong - idle) * seen) * awake : 0.0f;
        const bool leads = s.driven && (i == first_sensor_on(s.kind, 1) || i == first_sensor_on(s.kind, -1));
        const float line =
            drawing.picture.settings.outlines || leads ? (s.selected ? 0.8f : 0.28f) + 0.2f * seen : 0.0f;
        const float reach = fill_reach(drawing, s, sensor), radius = visible_radius(fill, reach, sensor);
        if (radius == 0 && line == 0) continue;
        const vec2 at = s.to_world({sensor.x, sensor.y});
        if (!in_sight(drawing, at, line > 0 ? sensor.range : radius)) continue;
        const vec2 towards = maths::rotate(maths::direction(sensor.angle), s.ahead);
        const float half = sensor.shape == SensorShape::omni ? maths::pi : sensor.fov / 2;
        const bool chord = sensor.shape == SensorShape::triangle && half < maths::pi / 2;
        drawing.list.fields.push_back({{at.x, at.y, towards.x, towards.y},
                                       {line > 0 ? sensor.range * 1.01f : radius, half,
                                        sensor.response == SensorResponse::boolean ? 0 : sensor.half_distance, reach},
                                       rgb_with(light ? darker(channel) : deep(channel), fill),
                                       {line, chord ? -sensor.range * maths::cosine(half) : sensor.range, 0, 0}});
    }
}

}  // namespace braitenlab::render
