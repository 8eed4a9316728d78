#include <algorithm>
#include <cmath>
#include <optional>

#include "core/maths/angle.h"
#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec4;

bool is_covered(const Subject& s, std::size_t sensor) {
    return s.plan && sensor < s.plan->covered.size() && s.plan->covered[sensor];
}

float sensed(const Drawing& drawing, const Subject& s, std::size_t sensor) {
    if (is_covered(s, sensor)) return 0;
    const std::size_t i = static_cast<std::size_t>(s.view.first_sensed) + sensor;
    return i < drawing.now.sensed.size() ? std::clamp(drawing.now.sensed[i], 0.0f, 1.0f) : 0.0f;
}

int side_of(const Sensor& sensor) { return (sensor.y > 0.01f) - (sensor.y < -0.01f); }

bool in_sight(const Drawing& drawing, vec2 place, float radius) {
    if (drawing.picture.camera_view.window.w <= 0) return true;
    const maths::vec3 p = to_gl(place);
    const vec4 clip = drawing.to_clip * vec4{p.x, p.y, p.z, 1};
    const auto& lens = drawing.picture.camera_view.projection;
    // Largest extent of the radius in clip coordinates.
    const float w = clip.w + radius * std::fabs(lens[2].w);
    return w > 0 && std::fabs(clip.x) <= w + radius * (lens[0].x + std::fabs(lens[2].x)) &&
           std::fabs(clip.y) <= w + radius * (lens[1].y + std::fabs(lens[2].y));
}

namespace {

// Layout pixels: a smaller vehicle is drawn as a flat sign.
float sign_below(Quality quality) { return quality == Quality::high ? 11.0f : 18.0f; }

// Detail by length on the screen; small parts of a small vehicle fade out.
float detail_of(float pixels) {
    constexpr float none_below = 38, all_above = 54;  // layout pixels
    const float t = std::clamp((pixels - none_below) / (all_above - none_below), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

Colour body_colour(const Drawing& drawing, const Subject& s) {
    Colour colour = colour_of(drawing.colours, drawing.now, s.view);
    if (s.view.driver == Driver::parked) colour = mix(colour, drawing.colours.wall, 0.6f);
    // Paler at low energy.
    return mix(mix(colour, drawing.colours.wall, 0.45f), colour, 0.3f + 0.7f * std::min(1.0f, s.view.energy * 2));
}

void add_sign(Drawing& drawing, const Subject& s) {
    vec4 seen{0, 0, 0, 0};  // left, right
    for (std::size_t i = 0; i < s.kind.sensors.size(); ++i) {
        const float now = std::sqrt(sensed(drawing, s, i));
        if (side_of(s.kind.sensors[i]) >= 0) seen.x = std::max(seen.x, now);
        if (side_of(s.kind.sensors[i]) <= 0) seen.y = std::max(seen.y, now);
    }
    drawing.list.signs[static_cast<std::size_t>(s.view.role)].push_back(
        {{s.place.x, s.place.y, s.ahead.x, s.ahead.y},
         {s.kind.body.length, s.kind.body.width, s.height_scale, s.pixels},
         rgb_with(body_colour(drawing, s), s.view.driver == Driver::parked ? 0.0f : 1.0f),
         seen});
}

// True if the coarse mesh of a plain vehicle looks as its full mesh does.
bool is_coarse(const Drawing& drawing, const Subject& s) {
    constexpr float largest = 100;  // display pixels
    return s.pixels * drawing.picture.pixel_scale <= largest;
}

void add_hull(Drawing& drawing, const Subject& s) {
    if (!s.fine && !is_coarse(drawing, s)) drawing.list.coarse = false;
    const bool parked = s.view.driver == Driver::parked;
    auto& of_role = s.fine ? drawing.list.bodies : drawing.list.hulls;
    of_role[static_cast<std::size_t>(s.view.role)].push_back(
        {{s.place.x, s.place.y, s.ahead.x, s.ahead.y},
         {s.kind.body.length, s.kind.body.width, s.height_scale, std::clamp(s.view.energy, 0.0f, 1.0f)},
         rgb_with(body_colour(drawing, s), parked ? 0.0f : 1.0f),
         {s.detail, s.fine ? 1.0f : 0.0f, 0, 0}});
}

void add_wheels(Drawing& drawing, const Subject& s) {
    for (const Wheel& wheel : s.kind.body.wheels) {
        const bool castor = wheel.motor == Motor::none;
        if (castor && !s.fine && is_coarse(drawing, s)) continue;  // hidden below the hull
        const vec2 at = s.to_world({wheel.x, wheel.y});
        const float turned = castor ? 0 : s.view.wheel_angle[wheel.motor == Motor::right];
        // The mesh is closed on its left side: a wheel on the right is rotated by 180°, which reverses its rolling.
        const float side = wheel.y < 0 ? -1.0f : 1.0f;
        (s.fine ? drawing.list.tyres : drawing.list.wheels)
            .push_back({{at.x, at.y, side * s.ahead.x, side * s.ahead.y},
                        {wheel.radius, wheel.width, side * turned, s.detail}});
    }
}

// At low detail all sensors of a side (left, right, middle) are one dot at the first of them, with the largest reading.
// The index of the sensor with the largest reading on the side of sensor i; nullopt when i is not the first there.
std::optional<std::size_t> strongest_beside(const Drawing& drawing, const Subject& s, std::size_t i) {
    const auto& sensors = s.kind.sensors;
    std::size_t strongest = i;
    for (std::size_t k = 0; k < sensors.size(); ++k) {
        if (side_of(sensors[k]) != side_of(sensors[i])) continue;
        if (k < i) return std::nullopt;
        if (sensed(drawing, s, k) > sensed(drawing, s, strongest)) strongest = k;
    }
    return strongest;
}

// Radius of a sensor, m on the standard vehicle; at most `largest`, smaller where sensors are close together.
float eye_radius(const Kind& kind, std::size_t i, float largest = 0.095f) {
    float radius = largest;
    for (std::size_t k = 0; k < kind.sensors.size(); ++k) {
        const Sensor &a = kind.sensors[i], &b = kind.sensors[k];
        if (k != i) radius = std::min(radius, 0.55f * std::hypot(a.x - b.x, a.y - b.y));
    }
    return std::max(radius, 0.05f);
}

// Radius of an eye as a factor of that on the standard vehicle: larger where the vehicle is small on the screen, so
// that an overview shows where it looks.
float eye_scale(float pixels) {
    constexpr float small = 28, large = 80, most = 1.4f;  // small, large: layout pixels
    return most + (1 - most) * std::clamp((pixels - small) / (large - small), 0.0f, 1.0f);
}

// Balls with a lid above the places of the sensors; of a small vehicle one a side, which shows the strongest reading.
void add_eyeballs(Drawing& drawing, const Subject& s) {
    constexpr float above_deck = 0.02f;   // m
    constexpr float each_eye_above = 54;  // layout pixels
    const float largest = 0.125f * eye_scale(s.pixels);
    const Colour lid = body_colour(drawing, s);
    const bool one_a_side = s.pixels < each_eye_above && !s.selected;
    for (std::size_t i = 0; i < s.kind.sensors.size(); ++i) {
        const auto strongest = one_a_side ? strongest_beside(drawing, s, i) : std::optional(i);
        if (!strongest) continue;
        const Sensor& sensor = s.kind.sensors[i];
        const vec2 at = s.to_world({sensor.x, sensor.y});
        const vec2 towards = maths::rotate(maths::direction(sensor.angle), s.ahead);
        const float radius = one_a_side ? largest : eye_radius(s.kind, i, largest);
        const float height = (deck_height + radius + above_deck) * s.height_scale;
        add_eye_shadows(drawing, s, sensor, radius, height);
        drawing.list.eyeballs.push_back(
            {{at.x, at.y, towards.x, towards.y},
             {radius * s.height_scale, height, std::sqrt(sensed(drawing, s, *strongest)), 0},
             rgb_with(colour_of(drawing.colours, s.kind.sensors[*strongest].channel),
                      is_covered(s, *strongest) ? 0.0f : 1.0f),
             rgb_with(lid, 0)});
    }
}

void add_eyes(Drawing& drawing, const Subject& s) {
    if (s.driven) return;  // at the camera they would fill the picture
    if (s.fine) return add_eyeballs(drawing, s);
    for (std::size_t i = 0; i < s.kind.sensors.size(); ++i) {
        const Sensor& sensor = s.kind.sensors[i];
        const auto dot = s.detail < 1 ? strongest_beside(drawing, s, i) : std::nullopt;
        const std::size_t glowing = s.detail < 0.5f ? dot.value_or(i) : i;
        const float size = dot ? 1.4f - 0.4f * s.detail : s.detail;
        if (size == 0) continue;
        // Dots are slightly inside the hull and leave its outline visible.
        const vec2 own{sensor.x, sensor.y}, inside{sensor.x - 0.04f * s.kind.body.length, sensor.y * 0.74f};
        const vec2 at = s.to_world(inside + (own - inside) * s.detail);
        const vec2 towards = maths::rotate(maths::direction(sensor.angle), s.ahead);
        const float seen = std::sqrt(sensed(drawing, s, glowing)), open = is_covered(s, glowing) ? 0.0f : 1.0f;
        drawing.list.eyes.push_back(
            {{at.x, at.y, towards.x, towards.y},
             {(dot ? 0.095f + (eye_radius(s.kind, i) - 0.095f) * s.detail : eye_radius(s.kind, i)) * s.height_scale *
                  size,
              (deck_height + 0.035f) * s.height_scale, seen, s.detail},
             rgb_with(colour_of(drawing.colours, s.kind.sensors[glowing].channel), open)});
    }
}

void add_lamps(Drawing& drawing, const Subject& s) {
    for (const CarriedLamp& lamp : s.kind.lamps)
        add_source(drawing, lamp.channel, s.to_world({lamp.x, lamp.y}), deck_height * s.height_scale, lamp.strength,
                   0.5f);
}

void add_ring(Drawing& drawing, const Subject& s) {
    if (s.driven || (!s.selected && !s.hovered)) return;
    const float radius = 0.5f * std::hypot(s.kind.body.length, s.kind.body.width) + 0.12f * around(drawing, s);
    const bool first = s.selected && !drawing.picture.settings.selection.object;  // what Delete would take
    const MarkKind kind = first ? MarkKind::ring : MarkKind::thin_ring;
    drawing.list.rings.push_back(
        {{s.place.x, s.place.y, s.ahead.x, s.ahead.y},
         {radius, radius, (first ? 0.010f : 0.007f) * around(drawing, s), static_cast<float>(kind)},
         first ? rgb_with(drawing.colours.selected, 1) : rgb_with(drawing.colours.second_text, 0.9f)});
}

// Seconds for which a bite or a strike is shown, fewer than Snapshot holds them.
constexpr float event_seconds = 0.6f;

// A ring that grows by `growth` m and fades; with reduced motion it only ends.
void add_event(Drawing& drawing, vec2 place, float radius, float growth, float age, Colour colour) {
    if (age >= event_seconds) return;
    const float shown = std::clamp(age / event_seconds, 0.0f, 1.0f), grown = drawing.picture.reduce_motion ? 0 : shown;
    const float reach = radius + growth * grown;
    drawing.list.rings.push_back({{place.x, place.y, 1, 0},
                                  {reach, reach, 0.04f, static_cast<float>(MarkKind::ring)},
                                  rgb_with(colour, 1 - grown * grown)});
}

// True if vehicles other than the selected one may have rounded meshes: at low quality only in scenes of few vehicles,
// so that two that are compared look alike.
bool may_be_fine(const Drawing& drawing) {
    constexpr std::size_t few = 3;
    return drawing.picture.quality != Quality::low || drawing.now.vehicles.size() <= few;
}

// True if a vehicle of this length on the screen has rounded meshes. Below high quality a small one has none, also the
// selected one: without the pale rim of plain meshes it would be the darkest vehicle.
bool is_fine(const Drawing& drawing, float pixels, bool selected) {
    constexpr float medium_above = 34;  // layout pixels
    if (drawing.picture.quality == Quality::high) return true;
    return pixels >= medium_above && (selected || may_be_fine(drawing));
}

// A vehicle that has just struck something moves to and fro along its heading for a moment; m.
float shake_of(const Drawing& drawing, VehicleId vehicle) {
    constexpr float seconds = 0.25f, reach = 0.05f, turns = 3;
    for (const StrikeView& strike : drawing.struck) {
        if (strike.vehicle != vehicle && strike.other != vehicle) continue;
        const float left = 1 - strike.age / seconds;
        if (left > 0) return -reach * left * std::cos(2 * maths::pi * turns * strike.age / seconds);
    }
    return 0;
}

Subject subject_of(const Drawing& drawing, const VehicleView& view) {
    static const Kind plain;
    const auto kind = static_cast<std::size_t>(view.kind), brain = static_cast<std::size_t>(view.brain);
    const bool known = drawing.now.scene && kind < drawing.now.scene->kinds.size();
    const Kind& its_kind = known ? kind_of(drawing.now, view) : plain;
    const vec2 ahead = maths::direction(view.heading);
    const vec2 place = vec2{view.x, view.y} + ahead * shake_of(drawing, view.id);
    const float scale = pixels_per_metre(drawing.picture.camera_view, place);
    const float pixels = scale > 0 ? its_kind.body.length * scale / drawing.picture.pixel_scale : 1e3f;
    const bool selected = view.id == drawing.picture.settings.selection.vehicle;
    const float judged = drawing.common_pixels > 0 && !selected ? drawing.common_pixels : pixels;
    const bool sign = judged < sign_below(drawing.picture.quality);
    const bool fine = !sign && is_fine(drawing, judged, selected);
    return {view,
            its_kind,
            brain < drawing.now.brains.size() ? drawing.now.brains[brain].get() : nullptr,
            place,
            ahead,
            height_scale_of(its_kind.body),
            pixels,
            fine ? 1.0f : detail_of(pixels),
            sign,
            fine,
            selected,
            view.id == drawing.picture.hovered,
            view.id == drawing.picture.driver};
}

bool is_brain_hidden(const Drawing& drawing, const Subject& s) {
    const std::vector<bool>& hidden = drawing.picture.hidden_brains;
    const auto kind = static_cast<std::size_t>(s.view.kind);
    return kind < hidden.size() && hidden[kind];
}

void add_body(Drawing& drawing, const Subject& s) {
    if (s.sign) return add_sign(drawing, s);
    add_hull(drawing, s);
    add_wheels(drawing, s);
    add_eyes(drawing, s);
    if (!is_brain_hidden(drawing, s)) add_wires(drawing, s);
    add_driver_sign(drawing, s);
    add_stopped_wheels(drawing, s);
    add_shadows(drawing, s);
}

void add_here(Drawing& drawing, const Subject& s) {
    if (in_sight(drawing, s.place, s.kind.body.length + 0.5f)) add_body(drawing, s);
    add_lamps(drawing, s);
    if (!is_brain_hidden(drawing, s)) add_wheel_arrows(drawing, s);
}

float farthest_eye(const Kind& kind) {
    float range = 0;
    for (const Sensor& sensor : kind.sensors) range = std::max(range, sensor.range);
    return range;
}

// Repeats what reaches over an edge of a torus at the opposite edge. The ring is only around the vehicle itself, as its
// number is beside it only.
void add_beyond_edges(Drawing& drawing, Subject s, const Arena& arena) {
    const float body = s.kind.body.length, eye = farthest_eye(s.kind);
    const vec2 home = s.place;
    const auto reaches_in = [&](float reach) {
        return std::fabs(s.place.x) < arena.width / 2 + reach && std::fabs(s.place.y) < arena.height / 2 + reach;
    };
    for (const float x : {-arena.width, 0.0f, arena.width})
        for (const float y : {-arena.height, 0.0f, arena.height}) {
            if (x == 0 && y == 0) continue;
            s.place = home + vec2{x, y};
            if (reaches_in(body)) add_here(drawing, s);
            if (reaches_in(eye)) add_fields(drawing, s);
        }
}

// The mean length of the vehicles on the screen, layout pixels; 0 if they differ by more than a factor of two.
float common_length(const Drawing& drawing) {
    float sum = 0, least = 1e9f, most = 0;
    for (const VehicleView& view : drawing.now.vehicles) {
        const float pixels = subject_of(drawing, view).pixels;
        sum += pixels, least = std::min(least, pixels), most = std::max(most, pixels);
    }
    return most <= 2 * least ? sum / static_cast<float>(std::max<std::size_t>(drawing.now.vehicles.size(), 1)) : 0;
}

// Around both vehicles.
void add_bites(Drawing& drawing) {
    for (const BiteView& bite : drawing.now.bites)
        for (const VehicleId id : {bite.one, bite.other})
            if (const VehicleView* view = find_vehicle(drawing.now, id)) {
                const Body& body = subject_of(drawing, *view).kind.body;
                const float radius = 0.5f * std::hypot(body.length, body.width) + 0.24f;
                add_event(drawing, {view->x, view->y}, radius, 0.3f, bite.age, drawing.colours.predator);
            }
}

bool is_bite(const Drawing& drawing, const StrikeView& strike) {
    return std::any_of(drawing.now.bites.begin(), drawing.now.bites.end(),
                       [&](const BiteView& bite) { return bite.one == strike.vehicle && bite.other == strike.other; });
}

// A disc at the point where two vehicles touch: many may touch at once, so it is small and short, and left out where
// motion is reduced.
void add_flash(Drawing& drawing, const StrikeView& strike) {
    constexpr float seconds = 0.3f, radius = 0.16f;  // m
    if (drawing.picture.reduce_motion || strike.age >= seconds || is_bite(drawing, strike)) return;
    const float left = 1 - std::clamp(strike.age / seconds, 0.0f, 1.0f);
    drawing.list.rings.push_back({{strike.x, strike.y, 1, 0},
                                  {radius, radius, radius, static_cast<float>(MarkKind::ring)},
                                  rgb_with(drawing.colours.text, 0.9f * left)});
}

// Light at the point of contact with a wall, post or obstacle.
void add_spark(Drawing& drawing, const StrikeView& strike) {
    constexpr float seconds = 0.2f, height = 0.2f, size = 1.1f;  // m
    if (drawing.picture.reduce_motion || strike.age >= seconds) return;
    const float left = 1 - strike.age / seconds;
    drawing.list.halos.push_back(
        {{strike.x, strike.y, height, size}, rgb_with(drawing.colours.warning, 0.9f * left), {}});
}

// The youngest strikes of this moment, which shake the vehicles; none where motion is reduced, and few in a crowd.
void find_struck(Drawing& drawing) {
    constexpr float seconds = 0.25f;
    constexpr std::size_t most = 8;
    if (drawing.picture.reduce_motion) return;
    for (const StrikeView& strike : drawing.now.strikes)
        if (strike.age < seconds) drawing.struck.push_back(strike);
    if (drawing.struck.size() > most) drawing.struck.clear();
}

// Around the point of contact.
void add_strikes(Drawing& drawing) {
    for (const StrikeView& strike : drawing.now.strikes) {
        if (strike.other != no_vehicle) {
            add_flash(drawing, strike);
        } else {
            add_spark(drawing, strike);
            add_event(drawing, {strike.x, strike.y}, 0.35f, 0.5f, strike.age, drawing.colours.warning);
        }
    }
}

}  // namespace

void add_vehicles(Drawing& drawing, const Trails& trails) {
    find_struck(drawing);
    if (may_be_fine(drawing)) drawing.common_pixels = common_length(drawing);
    for (const VehicleView& view : drawing.now.vehicles) {
        Subject s = subject_of(drawing, view);
        s.plan = plan_of(drawing, s);
        add_here(drawing, s);
        add_ring(drawing, s);
        add_fields(drawing, s);
        if (const Trail* trail = drawing.picture.settings.overlays.trails ? trails.of(view.id) : nullptr)
            add_trail(drawing, s, *trail);
        if (drawing.now.scene && drawing.now.scene->arena.edge == Boundary::torus)
            add_beyond_edges(drawing, s, drawing.now.scene->arena);
    }
    add_bites(drawing);
    add_strikes(drawing);
}

}  // namespace braitenlab::render
