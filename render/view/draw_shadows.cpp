// Shadows of vehicles on the floor.
#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;

namespace {

bool is_day(const Drawing& drawing) { return drawing.picture.theme == Theme::light; }

// Strength of a shadow that the sun casts: at dusk it is weak.
float sun_strength(const Drawing& drawing) { return is_day(drawing) ? 0.65f : 0.30f; }

// A shadow with soft edges. `half`: half its length and width along the axes of the vehicle, m; `softness`: m, in a
// small arena on the standard vehicle; `strength`: 1 takes as much light as a shadow of the palette.
void add_soft(Drawing& drawing, const Subject& s, vec2 at, vec2 half, float softness, float strength, Colour colour) {
    drawing.list.marks.push_back({{at.x, at.y, s.ahead.x, s.ahead.y},
                                  {half.x, half.y, softness * around(drawing, s), static_cast<float>(MarkKind::shadow)},
                                  rgb_with(colour, strength * colour.a)});
}

}  // namespace

void add_shadows(Drawing& drawing, const Subject& s) {
    constexpr float top = 0.3f;   // height of a rounded body with its eyes, m
    constexpr float edge = 0.2f;  // height of the upper edge of the body, m
    const Body& body = s.kind.body;
    const Colour shade = drawing.colours.shadow;
    if (!s.fine) return add_soft(drawing, s, s.place, {body.length / 2, body.width / 2}, 0.16f, 1, shade);
    // The rounded body is narrower than its wheels.
    const bool day = is_day(drawing);
    const vec2 hull{0.46f * body.length, 0.40f * body.width}, end = away_from_sun(edge) * s.height_scale;
    // The body hides the sky: a wide shadow, by day wider, with the colour that the body reflects onto the floor.
    const Colour tinted =
        mix(shade, colour_of(drawing.colours, drawing.now, s.view), day ? 0.35f : 0.16f).with_alpha(shade.a);
    add_soft(drawing, s, s.place + 0.5f * end, hull, day ? 0.34f : 0.24f, 0.75f, tinted);
    // The body hides the sun, and it is dark below it.
    add_soft(drawing, s, s.place + end, hull, 0.13f, sun_strength(drawing), shade);
    add_soft(drawing, s, s.place, hull, 0.08f, 0.8f, shade);
    for (const Wheel& wheel : body.wheels) {
        if (wheel.motor == Motor::none) continue;
        // It is dark where the wheel touches the floor.
        const vec2 at = s.to_world({wheel.x, wheel.y}), half{0.5f * wheel.radius, 0.5f * wheel.width};
        add_soft(drawing, s, at, half, 0.05f, day ? 1.2f : 0.9f, shade);
        if (s.pixels >= least_part_shadow)
            add_soft(drawing, s, at + away_from_sun(wheel.radius), {1.4f * half.x, half.y}, 0.07f,
                     0.8f * sun_strength(drawing), shade);
    }
    // The body with its wheels hides lamps.
    add_casts(drawing, s.place, s.ahead, {0.47f * body.length, 0.46f * body.width}, top * s.height_scale);
}

void add_eye_shadow(Drawing& drawing, const Subject& s, vec2 place, float radius, float height) {
    if (s.pixels < least_part_shadow) return;
    // Moved towards the eye, so that it joins the shadow of the body.
    add_soft(drawing, s, place + away_from_sun(0.7f * height), {0.8f * radius, 0.8f * radius}, 0.10f,
             0.6f * sun_strength(drawing), drawing.colours.shadow);
}

}  // namespace braitenlab::render
