// Shadows of vehicles on the floor, and of eyes on the deck.
#include <algorithm>
#include <cmath>

#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;

namespace {

// Strength of a shadow that the sun casts: at dusk it is weak.
float sun_strength(const Drawing& drawing) { return is_light(drawing) ? 0.65f : 0.32f; }

// A shadow with soft edges. `half`: half its length and width along the axes of the vehicle, m; `softness`: m, in a
// small arena on the standard vehicle; `strength`: 1 takes as much light as a shadow of the palette.
void add_soft(Drawing& drawing, const Subject& s, vec2 at, vec2 half, float softness, float strength, Colour colour) {
    drawing.list.marks.push_back({{at.x, at.y, s.ahead.x, s.ahead.y},
                                  {half.x, half.y, softness * around(drawing, s), static_cast<float>(MarkKind::shadow)},
                                  rgb_with(colour, strength * colour.a)});
}

}  // namespace

void add_shadows(Drawing& drawing, const Subject& s) {
    constexpr float edge = 0.2f;  // height of the upper edge of the body, m
    const Body& body = s.kind.body;
    const Colour shade = drawing.colours.shadow;
    if (!s.fine) return add_soft(drawing, s, s.place, {body.length / 2, body.width / 2}, 0.16f, 1, shade);
    // The rounded body is narrower than its wheels.
    const bool day = is_light(drawing);
    const vec2 hull{0.46f * body.length, 0.40f * body.width}, end = away_from_sun(edge) * s.height_scale;
    // The body hides the sky: a wide shadow, by day wider, with the colour that the body reflects onto the floor.
    const Colour tinted =
        mix(shade, colour_of(drawing.colours, drawing.now, s.view), day ? 0.35f : 0.16f).with_alpha(shade.a);
    add_soft(drawing, s, s.place + 0.5f * end, hull, day ? 0.34f : 0.24f, 0.75f, tinted);
    // The body hides the sun, and it is dark below it.
    add_soft(drawing, s, s.place + end, hull, 0.19f, sun_strength(drawing), shade);
    add_soft(drawing, s, s.place, hull, 0.09f, day ? 1.1f : 0.9f, shade);
    for (const Wheel& wheel : body.wheels) {
        if (wheel.motor == Motor::none) continue;
        // It is dark where the wheel touches the floor.
        const vec2 at = s.to_world({wheel.x, wheel.y}), half{0.5f * wheel.radius, 0.5f * wheel.width};
        add_soft(drawing, s, at, half, 0.05f, day ? 1.2f : 0.9f, shade);
        if (s.pixels >= least_part_shadow)
            add_soft(drawing, s, at + away_from_sun(0.6f * wheel.radius), {1.4f * half.x, 1.4f * half.y}, 0.10f,
                     0.8f * sun_strength(drawing), shade);
    }
    // Lamps are high above the vehicles: a body hides them from the floor next to it, and from no eye.
    constexpr float low = 0.5f * deck_height;
    add_casts(drawing, s.place, s.ahead, {0.47f * body.length, 0.46f * body.width}, low * s.height_scale);
}

void add_eye_shadows(Drawing& drawing, const Subject& s, const Sensor& sensor, float radius, float height) {
    constexpr float deck_strength = 0.75f, spread = 1.35f;
    if (s.pixels < least_part_shadow) return;
    // On the deck: moved inwards from its edge, beyond which there is nothing to darken but for its faint rim.
    const float reach = spread * radius * s.height_scale;
    const auto inside = [reach](float place, float half) {
        const float limit = std::max(0.0f, half - deck_shade_core * reach);
        return std::clamp(place, -limit, limit);
    };
    const Body& body = s.kind.body;
    const Colour shade = drawing.colours.shadow;
    const vec2 on_deck = s.to_world({inside(sensor.x, 0.49f * body.length), inside(sensor.y, 0.37f * body.width)});
    drawing.list.deck_shades.push_back({{on_deck.x, on_deck.y, (deck_height + 0.004f) * s.height_scale, reach},
                                        rgb_with(Colour{}, deck_strength * std::sqrt(shade.a))});
    // On the floor: nearer to the eye than the sun casts it, so that it joins the shadow of the body.
    const float half = 0.8f * radius * s.height_scale;
    add_soft(drawing, s, s.to_world({sensor.x, sensor.y}) + away_from_sun(0.7f * height), {half, half}, 0.10f,
             0.6f * sun_strength(drawing), shade);
}

}  // namespace braitenlab::render
