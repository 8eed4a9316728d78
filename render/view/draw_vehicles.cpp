#include <algorithm>
#include <cmath>
#include <optional>

#include "core/maths/angle.h"
#include "render/view/sheet.h"

namespace braitenlab {

using maths::vec2;
using maths::vec4;

namespace {

constexpr float deck_height = 0.27f;  // m, of the standard vehicle

// One vehicle with what it is made of.
struct Subject {
    const VehicleView& view;
    const Kind& kind;
    const BrainGraph* brain;
    vec2 place, ahead;
    float height_scale;
    float detail;  // 0 small on the screen .. 1 large enough for small parts
    bool selected, hovered, driven;

    vec2 to_world(vec2 own) const { return place + maths::rotate(own, ahead); }
};

// How large a body appears decides what is shown of it: small parts of a small body are noise, so they fade out.
float detail_of(const Picture& picture, vec2 place, float length) {
    constexpr float none_below = 38, all_above = 54;  // layout pixels
    const float scale = pixels_per_metre(picture.sight, place);
    if (scale <= 0) return 1;
    const float pixels = length * scale / picture.pixel_scale;
    const float t = std::clamp((pixels - none_below) / (all_above - none_below), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

float sensed(const Sheet& sheet, const Subject& s, std::size_t sensor) {
    const std::size_t i = static_cast<std::size_t>(s.view.first_sensed) + sensor;
    return i < sheet.now.sensed.size() ? std::clamp(sheet.now.sensed[i], 0.0f, 1.0f) : 0.0f;
}

void add_hull(Sheet& sheet, const Subject& s) {
    const bool parked = s.kind.driver == Driver::parked;
    Colour colour = colour_of(sheet.colours, s.view.role);
    if (parked) colour = mix(colour, sheet.colours.wall, 0.6f);
    // Tired vehicles pale a little; the gauge on the tail says how much is left.
    colour = mix(mix(colour, sheet.colours.wall, 0.45f), colour, 0.3f + 0.7f * std::min(1.0f, s.view.energy * 2));
    sheet.list.hulls[static_cast<std::size_t>(s.view.role)].push_back(
        {{s.place.x, s.place.y, s.ahead.x, s.ahead.y},
         {s.kind.body.length, s.kind.body.width, s.height_scale, std::clamp(s.view.energy, 0.0f, 1.0f)},
         rgb_with(colour, parked ? 0.0f : 1.0f),
         {s.detail, 0, 0, 0}});
}

void add_wheels(Sheet& sheet, const Subject& s) {
    for (const Wheel& wheel : s.kind.body.wheels) {
        const bool castor = wheel.motor == Motor::none;
        if (castor && s.detail == 0) continue;  // hidden below the hull
        const vec2 at = s.to_world({wheel.x, wheel.y});
        const float turned = castor ? 0 : s.view.wheel_angle[wheel.motor == Motor::right];
        // The mesh shows its left side: a wheel on the right is turned about, and then rolls the other way.
        const float side = wheel.y < 0 ? -1.0f : 1.0f;
        sheet.list.wheels.push_back(
            {{at.x, at.y, side * s.ahead.x, side * s.ahead.y}, {wheel.radius, wheel.width, side * turned, s.detail}});
    }
}

int side_of(const Sensor& sensor) { return (sensor.y > 0.01f) - (sensor.y < -0.01f); }

// A small vehicle shows one dot a side (left, right, middle) for all eyes there: the first, with the glow of the one
// that sees most. Which eye glows at the dot of eye i, or nothing when i is not the first.
std::optional<std::size_t> keenest_beside(const Sheet& sheet, const Subject& s, std::size_t i) {
    const auto& sensors = s.kind.sensors;
    std::size_t keenest = i;
    for (std::size_t k = 0; k < sensors.size(); ++k) {
        if (side_of(sensors[k]) != side_of(sensors[i])) continue;
        if (k < i) return std::nullopt;
        if (sensed(sheet, s, k) > sensed(sheet, s, keenest)) keenest = k;
    }
    return keenest;
}

// Eyes that crowd each other shrink, so that each can be told from the next; metres of the standard vehicle.
float eye_radius(const Kind& kind, std::size_t i) {
    float radius = 0.095f;
    for (std::size_t k = 0; k < kind.sensors.size(); ++k) {
        const Sensor &a = kind.sensors[i], &b = kind.sensors[k];
        if (k != i) radius = std::min(radius, 0.55f * std::hypot(a.x - b.x, a.y - b.y));
    }
    return std::max(radius, 0.05f);
}

void add_eyes(Sheet& sheet, const Subject& s) {
    if (s.driven) return;  // right before one's own, they would fill the picture
    for (std::size_t i = 0; i < s.kind.sensors.size(); ++i) {
        const Sensor& sensor = s.kind.sensors[i];
        const auto dot = s.detail < 1 ? keenest_beside(sheet, s, i) : std::nullopt;
        const std::size_t glowing = s.detail < 0.5f ? dot.value_or(i) : i;
        const float size = dot ? 1.4f - 0.4f * s.detail : s.detail;
        if (size == 0) continue;
        // Dots stand a little inside the hull, whose outline then says what it is.
        const vec2 own{sensor.x, sensor.y}, inside{sensor.x - 0.04f * s.kind.body.length, sensor.y * 0.74f};
        const vec2 at = s.to_world(inside + (own - inside) * s.detail);
        const vec2 towards = maths::rotate(maths::direction(sensor.angle), s.ahead);
        const float seen = std::sqrt(sensed(sheet, s, glowing));
        sheet.list.eyes.push_back(
            {{at.x, at.y, towards.x, towards.y},
             {(dot ? 0.095f + (eye_radius(s.kind, i) - 0.095f) * s.detail : eye_radius(s.kind, i)) * s.height_scale *
                  size,
              (deck_height + 0.035f) * s.height_scale, seen, s.detail},
             rgb_with(colour_of(sheet.colours, s.kind.sensors[glowing].channel), 1)});
    }
}

// Few vehicles show their whole field; in a crowd only the near part, where the eye is keenest, so that the floor stays
// readable and the picture's cost bounded.
float fill_reach(const Sheet& sheet, const Subject& s, const Sensor& sensor) {
    if (s.selected || s.hovered) return sensor.range;
    return std::min(sensor.range, std::max(1.2f, sensor.range * sheet.crowd * (0.85f + 0.15f * sheet.crowd)));
}

// Where a fill of this strength has faded below what a screen can show: nothing is painted farther out.
float visible_radius(float fill, float reach, const Sensor& sensor) {
    constexpr float least = 0.010f;  // two or three of 255 levels
    if (sensor.response == SensorResponse::boolean) return reach;
    for (float d = reach; d > 0; d -= reach / 16) {
        const float rest = 1 - d * d / (reach * reach), half = d / sensor.half_distance;
        if (fill * rest * rest / (1 + half * half) >= least) return std::min(reach, d + reach / 16);
    }
    return 0;
}

// The first eye on a side (1 left, −1 right): of the pair that a driver looks through. The number of eyes when none.
std::size_t leading_eye(const Kind& kind, int side) {
    std::size_t i = 0;
    while (i < kind.sensors.size() && side_of(kind.sensors[i]) != side) ++i;
    return i;
}

void add_fields(Sheet& sheet, const Subject& s) {
    const bool fills = sheet.picture.sensors || s.driven;
    if (!fills && !sheet.picture.outlines) return;
    for (std::size_t i = 0; i < s.kind.sensors.size(); ++i) {
        const Sensor& sensor = s.kind.sensors[i];
        const float seen = std::sqrt(sensed(sheet, s, i));
        const bool light = sheet.picture.theme == Theme::light;
        // In a crowd idle fields step back: where many overlap, their colours would only mix to mud.
        const bool chosen = s.selected || s.hovered;
        const float idle = chosen ? 0.20f : 0.09f * std::max(0.3f, sheet.crowd * sheet.crowd);
        const float strong = (chosen ? 0.60f : 0.42f) - (light ? 0.10f : 0.0f);
        const float awake = s.kind.driver == Driver::parked ? 0.4f : 1.0f;
        const float fill = fills ? (idle + (strong - idle) * seen) * awake : 0.0f;
        const bool leads = s.driven && (i == leading_eye(s.kind, 1) || i == leading_eye(s.kind, -1));
        const float line = sheet.picture.outlines || leads ? (s.selected ? 0.8f : 0.28f) + 0.2f * seen : 0.0f;
        const float reach = fill_reach(sheet, s, sensor), radius = visible_radius(fill, reach, sensor);
        if (radius == 0 && line == 0) continue;
        const vec2 at = s.to_world({sensor.x, sensor.y});
        const vec2 towards = maths::rotate(maths::direction(sensor.angle), s.ahead);
        const float half = sensor.shape == SensorShape::omni ? maths::pi : sensor.field / 2;
        const bool chord = sensor.shape == SensorShape::triangle && half < maths::pi / 2;
        sheet.list.fields.push_back({{at.x, at.y, towards.x, towards.y},
                                     {line > 0 ? sensor.range * 1.01f : radius, half,
                                      sensor.response == SensorResponse::boolean ? 0 : sensor.half_distance, reach},
                                     rgb_with(colour_of(sheet.colours, sensor.channel), fill),
                                     {line, chord ? -sensor.range * maths::cosine(half) : sensor.range, 0, 0}});
    }
}

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

void add_marks(Sheet& sheet, const Subject& s) {
    const Body& body = s.kind.body;
    const vec4 place{s.place.x, s.place.y, s.ahead.x, s.ahead.y};
    const float shadow = static_cast<float>(MarkKind::shadow);
    sheet.list.marks.push_back({place,
                                {body.length / 2, body.width / 2, 0.16f, shadow},
                                rgb_with(sheet.colours.shadow, sheet.colours.shadow.a)});
    if (s.driven) return;
    const float radius = 0.5f * std::hypot(body.length, body.width) + 0.16f;
    if (s.selected)
        sheet.list.rings.push_back(
            {place, {radius, radius, 0.013f, static_cast<float>(MarkKind::ring)}, rgb_with(sheet.colours.selected, 1)});
    else if (s.hovered)
        sheet.list.rings.push_back({place,
                                    {radius, radius, 0.007f, static_cast<float>(MarkKind::thin_ring)},
                                    rgb_with(sheet.colours.second_text, 0.9f)});
}

void add_trail(Sheet& sheet, const Subject& s, const Trail& trail) {
    // The more vehicles, the shorter their trails: a crowd's would be a carpet.
    constexpr std::size_t most_points = 64 * Trail::capacity;
    const std::size_t longest =
        s.selected ? Trail::capacity
                   : std::clamp<std::size_t>(most_points / sheet.now.vehicles.size(), 6, Trail::capacity);
    const std::size_t count = std::min(trail.count, longest) + 1;  // the place right now is the newest point
    const auto point = [&](std::size_t i) { return i == 0 ? s.place : trail.at(i - 1); };
    const auto side = [&](std::size_t i) {
        const vec2 along = maths::normalise(point(i == 0 ? 0 : i - 1) - point(std::min(i + 1, count - 1)));
        return vec2{along.y, -along.x};  // left of the way back, which is the way it is drawn
    };
    const Colour colour = colour_of(sheet.colours, s.view.role);
    const float most = s.selected ? 0.75f : 0.4f;
    const auto opacity = [&](std::size_t i) {
        const float age = static_cast<float>(i) / static_cast<float>(longest);
        return most * std::max(0.0f, 1 - age) * std::max(0.0f, 1 - age);
    };
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const vec2 a = point(i), b = point(i + 1), na = side(i), nb = side(i + 1);
        sheet.list.trails.push_back({{a.x, a.y, b.x, b.y},
                                     {na.x, na.y, nb.x, nb.y},
                                     rgb_with(colour, s.selected ? 0.075f : 0.06f),
                                     {opacity(i), opacity(i + 1), 0, 0}});
    }
}

}  // namespace

void add_vehicles(Sheet& sheet, const Trails& trails) {
    static const Kind plain;
    for (const VehicleView& view : sheet.now.vehicles) {
        const auto kind = static_cast<std::size_t>(view.kind), brain = static_cast<std::size_t>(view.brain);
        const bool known = sheet.now.scene && kind < sheet.now.scene->kinds.size();
        const Kind& its_kind = known ? sheet.now.scene->kinds[kind] : plain;
        const Subject s{view,
                        its_kind,
                        brain < sheet.now.brains.size() ? sheet.now.brains[brain].get() : nullptr,
                        {view.x, view.y},
                        maths::direction(view.heading),
                        std::min(its_kind.body.length, its_kind.body.width / 0.7f),
                        detail_of(sheet.picture, {view.x, view.y}, its_kind.body.length),
                        view.id == sheet.picture.selected,
                        view.id == sheet.picture.hovered,
                        view.id == sheet.picture.driver};
        add_hull(sheet, s);
        add_wheels(sheet, s);
        add_eyes(sheet, s);
        add_fields(sheet, s);
        add_wires(sheet, s);
        add_marks(sheet, s);
        if (const Trail* trail = sheet.picture.trails ? trails.of(view.id) : nullptr) add_trail(sheet, s, *trail);
    }
}

}  // namespace braitenlab
