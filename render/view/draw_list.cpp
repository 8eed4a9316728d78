#include "render/view/draw_list.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"

namespace braitenlab {

using maths::vec2;
using maths::vec4;

namespace {

constexpr float deck_height = 0.27f;  // m, of the standard vehicle

vec4 rgb_with(Colour c, float w) { return {c.r, c.g, c.b, w}; }

// All that is asked for again and again while one picture is made.
struct Sheet {
    DrawList& list;
    const Snapshot& now;
    const Picture& picture;
    Palette colours;
    float crowd;  // 1 for a few vehicles, less the more there are
};

// One vehicle with what it is made of.
struct Subject {
    const VehicleView& view;
    const Kind& kind;
    const BrainGraph* brain;
    vec2 place, ahead;
    float height_scale;
    bool selected, hovered;

    vec2 to_world(vec2 own) const { return place + maths::rotate(own, ahead); }
};

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
         rgb_with(colour, parked ? 0.0f : 1.0f)});
}

void add_wheels(Sheet& sheet, const Subject& s) {
    for (const Wheel& wheel : s.kind.body.wheels) {
        const bool castor = wheel.motor == Motor::none;
        if (castor && sheet.crowd < 0.5f) continue;  // hidden below the hull, and a crowd has many
        const vec2 at = s.to_world({wheel.x, wheel.y});
        const float turned = castor ? 0 : s.view.wheel_angle[wheel.motor == Motor::right];
        // The mesh shows its left side: a wheel on the right is turned about, and then rolls the other way.
        const float side = wheel.y < 0 ? -1.0f : 1.0f;
        sheet.list.wheels.push_back(
            {{at.x, at.y, side * s.ahead.x, side * s.ahead.y}, {wheel.radius, wheel.width, side * turned, 0}});
    }
}

void add_eyes(Sheet& sheet, const Subject& s) {
    for (std::size_t i = 0; i < s.kind.sensors.size(); ++i) {
        const Sensor& sensor = s.kind.sensors[i];
        const vec2 at = s.to_world({sensor.x, sensor.y});
        const vec2 towards = maths::rotate(maths::direction(sensor.angle), s.ahead);
        sheet.list.eyes.push_back(
            {{at.x, at.y, towards.x, towards.y},
             {0.095f * s.height_scale, (deck_height + 0.035f) * s.height_scale, std::sqrt(sensed(sheet, s, i)), 0},
             rgb_with(colour_of(sheet.colours, sensor.channel), 1)});
    }
}

// Few vehicles show their whole field; in a crowd only the near part, where the eye is keenest, so that the floor stays
// readable and the picture's cost bounded.
float fill_reach(const Sheet& sheet, const Subject& s, const Sensor& sensor) {
    if (s.selected || s.hovered) return sensor.range;
    return std::min(sensor.range, std::max(1.2f, sensor.range * sheet.crowd));
}

// Where a fill of this strength has faded below what a screen can show: nothing is painted farther out.
float visible_radius(float fill, float reach, const Sensor& sensor) {
    constexpr float least = 0.008f;  // two of 255 levels
    if (sensor.response == SensorResponse::boolean) return reach;
    for (float d = reach; d > 0; d -= reach / 16) {
        const float rest = 1 - d * d / (reach * reach), half = d / sensor.half_distance;
        if (fill * rest * rest / (1 + half * half) >= least) return std::min(reach, d + reach / 16);
    }
    return 0;
}

void add_fields(Sheet& sheet, const Subject& s) {
    if (!sheet.picture.sensors && !sheet.picture.outlines) return;
    for (std::size_t i = 0; i < s.kind.sensors.size(); ++i) {
        const Sensor& sensor = s.kind.sensors[i];
        const float seen = std::sqrt(sensed(sheet, s, i));
        const bool light = sheet.picture.theme == Theme::light;
        const float idle = s.selected ? 0.20f : 0.10f, strong = (s.selected ? 0.60f : 0.42f) - (light ? 0.10f : 0.0f);
        const float awake = s.kind.driver == Driver::parked ? 0.4f : 1.0f;
        const float fill = sheet.picture.sensors ? (idle + (strong - idle) * seen) * awake : 0.0f;
        const float line = sheet.picture.outlines ? (s.selected ? 0.8f : 0.28f) + 0.2f * seen : 0.0f;
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
    if (!s.brain || s.kind.driver != Driver::brain) return;
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
        const float height = (deck_height + 0.006f) * s.height_scale + 0.003f * static_cast<float>(layer++ % 8);
        const bool excites = wire.weight > 0;
        sheet.list.wires.push_back(
            {{a.x, a.y, b.x, b.y},
             {c.x, c.y, height, (0.028f + 0.05f * weight) * s.height_scale},
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
    const float radius = 0.5f * std::hypot(body.length, body.width) + 0.16f;
    if (s.selected)
        sheet.list.rings.push_back(
            {place, {radius, radius, 0.035f, static_cast<float>(MarkKind::ring)}, rgb_with(sheet.colours.selected, 1)});
    else if (s.hovered)
        sheet.list.rings.push_back({place,
                                    {radius, radius, 0.014f, static_cast<float>(MarkKind::thin_ring)},
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
                        view.id == sheet.picture.selected,
                        view.id == sheet.picture.hovered};
        add_hull(sheet, s);
        add_wheels(sheet, s);
        add_eyes(sheet, s);
        add_fields(sheet, s);
        add_wires(sheet, s);
        add_marks(sheet, s);
        if (const Trail* trail = sheet.picture.trails ? trails.of(view.id) : nullptr) add_trail(sheet, s, *trail);
    }
}

void add_sources(Sheet& sheet) {
    const bool dark = sheet.picture.theme == Theme::dark;
    for (const SourceView& source : sheet.now.sources) {
        const Colour colour = colour_of(sheet.colours, source.channel);
        const float size = 0.8f + 0.35f * source.strength, bulb = 0.52f * size;
        const auto shape = static_cast<std::size_t>(source_shape_of(source.channel));
        sheet.list.sources[shape].push_back({{source.x, source.y, size, source.strength}, rgb_with(colour, 1)});
        const vec4 place{source.x, source.y, 1, 0};
        const float pool = 1.6f + 2.4f * source.strength;
        sheet.list.marks.push_back({place,
                                    {pool, pool, 0, static_cast<float>(MarkKind::pool)},
                                    rgb_with(colour, (dark ? 0.42f : 0.26f) * (0.35f + 0.65f * source.strength))});
        sheet.list.marks.push_back({place,
                                    {0.22f * size, 0.22f * size, 0.12f, static_cast<float>(MarkKind::shadow)},
                                    rgb_with(sheet.colours.shadow, sheet.colours.shadow.a * 0.7f)});
        sheet.list.halos.push_back({{source.x, source.y, bulb, (dark ? 1.25f : 0.85f) * size},
                                    rgb_with(colour, (dark ? 0.75f : 0.5f) * (0.3f + 0.7f * source.strength))});
        if (sheet.list.lamps.size() < most_lamps)
            sheet.list.lamps.push_back({{source.x, bulb, -source.y, source.strength}, rgb_with(colour, 2.0f)});
    }
}

void add_blocks(Sheet& sheet) {
    if (!sheet.now.scene) return;
    const Scene& scene = *sheet.now.scene;
    const float half_w = scene.arena.width / 2, half_h = scene.arena.height / 2;
    if (scene.arena.edge == Edge::wall) {
        constexpr float thick = 0.09f, high = 0.28f, chamfer = 0.03f;  // half the thickness; m
        const vec4 colour = rgb_with(sheet.colours.wall, 1);
        for (const float side : {-1.0f, 1.0f}) {
            sheet.list.blocks.push_back(
                {{0, side * (half_h + thick), 1, 0}, {half_w + 2 * thick, thick, high, chamfer}, colour});
            sheet.list.blocks.push_back({{side * (half_w + thick), 0, 0, 1}, {half_h, thick, high, chamfer}, colour});
        }
    }
    for (const Obstacle& box : scene.obstacles) {
        const vec2 ahead = maths::direction(box.heading);
        const vec4 place{box.x, box.y, ahead.x, ahead.y};
        sheet.list.blocks.push_back(
            {place, {box.length / 2, box.width / 2, 0.42f, 0.045f}, rgb_with(sheet.colours.obstacle, 1)});
        sheet.list.marks.push_back({place,
                                    {box.length / 2, box.width / 2, 0.22f, static_cast<float>(MarkKind::shadow)},
                                    rgb_with(sheet.colours.shadow, sheet.colours.shadow.a * 0.8f)});
    }
}

}  // namespace

void DrawList::clear() {
    for (auto& of_role : hulls) of_role.clear();
    for (auto& of_shape : sources) of_shape.clear();
    wheels.clear(), eyes.clear(), wires.clear(), fields.clear(), blocks.clear();
    marks.clear(), rings.clear(), halos.clear(), trails.clear(), lamps.clear();
}

int source_shape_of(Channel channel) {
    return channel == Channel::heat ? 1 : channel == Channel::smell ? 2 : channel == Channel::oxygen ? 3 : 0;
}

void fill(DrawList& list, const Snapshot& now, const Picture& picture, const Trails& trails) {
    list.clear();
    const float count = static_cast<float>(now.vehicles.size());
    Sheet sheet{list, now, picture, palette(picture.theme), std::min(1.0f, std::sqrt(8 / std::max(count, 1.0f)))};
    add_sources(sheet);
    add_blocks(sheet);
    add_vehicles(sheet, trails);
}

}  // namespace braitenlab
