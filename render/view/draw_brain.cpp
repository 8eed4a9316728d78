// The brain on the deck.
#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "render/view/sheet.h"

namespace braitenlab {

using maths::vec2;
using maths::vec4;

namespace {

const Sensor* sensor_named(const Kind& kind, const std::string& name) {
    const auto found = std::find_if(kind.sensors.begin(), kind.sensors.end(), [&](auto& s) { return s.name == name; });
    return found == kind.sensors.end() ? nullptr : &*found;
}

// Where a motor's wires end on the deck: just inside its first wheel, or nothing when no wheel has that motor.
std::optional<vec2> terminal(const Body& body, const std::string& motor_name) {
    const Motor motor = motor_name == "ML" ? Motor::left : motor_name == "MR" ? Motor::right : Motor::none;
    if (motor == Motor::none) return std::nullopt;
    for (const Wheel& wheel : body.wheels)
        if (wheel.motor == motor) return vec2{wheel.x - 0.10f * body.length, wheel.y * 0.52f};
    return std::nullopt;
}

}  // namespace

void add_wires(Sheet& sheet, const Subject& s) {
    if (!s.brain || s.kind.driver != Driver::brain || s.detail == 0) return;
    int layer = 0;
    for (const Wire& wire : s.brain->wires) {
        const Node *from = find_node(*s.brain, wire.from), *to = find_node(*s.brain, wire.to);
        if (wire.weight == 0 || !from || !to || from->kind != NodeKind::sensor || to->kind != NodeKind::motor) continue;
        const Sensor* sensor = sensor_named(s.kind, from->name);
        const auto end = terminal(s.kind.body, to->name);
        if (!sensor || !end) continue;
        const bool crossed = sensor->y * end->y < 0;
        const vec2 start{sensor->x - 0.07f, sensor->y * 0.86f};
        // A straight wire hugs its side, a crossed one goes diagonally: the two never look alike.
        const vec2 bend = crossed ? (start + *end) / 2 + vec2{0.03f, 0} : vec2{(start.x + end->x) / 2, end->y * 1.12f};
        const vec2 a = s.to_world(start), b = s.to_world(*end), c = s.to_world(bend);
        const float weight = std::min(std::fabs(wire.weight), limits::weight) / limits::weight;
        const float now = std::min(1.0f, std::fabs(signal(wire, node_value(sheet.now, s.view, wire.from))));
        // Each wire lies a little above the one before it, so that crossings are crossings and nothing flickers.
        const float height = (deck_height + 0.010f) * s.height_scale + 0.003f * static_cast<float>(layer++ % 8);
        const bool excites = wire.weight > 0;
        sheet.list.wires.push_back(
            {{a.x, a.y, b.x, b.y},
             {c.x, c.y, height, (0.028f + 0.05f * weight) * s.height_scale * s.detail},
             rgb_with(excites ? sheet.colours.excites : sheet.colours.inhibits, excites ? 1.0f : -1.0f),
             {now, 0, 0, 0}});
    }
}

}  // namespace braitenlab
