// Signs of the drivers, flat on the deck. A vehicle that its brain drives shows its wires instead.
#include <algorithm>
#include <span>

#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;

namespace {

// A stroke of a sign: a quadratic curve in the unit square, x ahead, y left.
struct Stroke {
    vec2 from, bend, to;
    bool has_head = false;  // an arrowhead at its end
};

constexpr Stroke straight(vec2 from, vec2 to) { return {from, {(from.x + to.x) / 2, (from.y + to.y) / 2}, to}; }

// A steering wheel: a person drives.
constexpr Stroke manual_sign[]{
    {{0.9f, 0}, {0.9f, 0.9f}, {0, 0.9f}},     {{0, 0.9f}, {-0.9f, 0.9f}, {-0.9f, 0}},
    {{-0.9f, 0}, {-0.9f, -0.9f}, {0, -0.9f}}, {{0, -0.9f}, {0.9f, -0.9f}, {0.9f, 0}},
    straight({0, 0.9f}, {0, -0.9f}),          straight({0, 0}, {-0.9f, 0}),
};
// A winding line to an arrowhead: the path.
constexpr Stroke path_sign[]{
    {{-0.9f, 0.5f}, {0.3f, 1.2f}, {0, 0}},
    {{0, 0}, {-0.3f, -1.2f}, {0.95f, -0.5f}, true},
};
// A zigzag: random turns.
constexpr Stroke wander_sign[]{
    straight({-0.9f, -0.6f}, {-0.45f, 0.6f}),
    straight({-0.45f, 0.6f}, {0, -0.6f}),
    straight({0, -0.6f}, {0.45f, 0.6f}),
    straight({0.45f, 0.6f}, {0.9f, -0.6f}),
};
// The letter P, upright when seen from behind.
constexpr Stroke parked_sign[]{
    straight({-0.9f, 0.45f}, {0.9f, 0.45f}),
    straight({0.9f, 0.45f}, {0.9f, -0.1f}),
    {{0.9f, -0.1f}, {0.9f, -0.65f}, {0.45f, -0.65f}},
    {{0.45f, -0.65f}, {0, -0.65f}, {0, -0.1f}},
    straight({0, -0.1f}, {0, 0.45f}),
};

std::span<const Stroke> strokes_of(Driver driver) {
    switch (driver) {
        case Driver::manual:
            return manual_sign;
        case Driver::path:
            return path_sign;
        case Driver::wander:
            return wander_sign;
        case Driver::parked:
            return parked_sign;
        case Driver::brain:
            break;
    }
    return {};
}

// White on a dark disc, so that it shows on every body colour in both themes.
constexpr Colour sign_colour = rgb(0xFFFFFF), plate_colour = rgb(0x10151C);
constexpr float plain_end = 0, arrow_end = 1;  // in place of a wire's sign

}  // namespace

void add_driver_sign(Drawing& drawing, const Subject& s) {
    if (s.driven) return;
    const std::span<const Stroke> strokes = strokes_of(s.view.driver);
    if (strokes.empty()) return;
    const float half = 0.36f * std::min(s.kind.body.length, s.kind.body.width);
    const float height = (deck_height + 0.03f) * s.height_scale, below = (deck_height + 0.015f) * s.height_scale;
    drawing.list.neurons.push_back({{s.place.x, s.place.y, below, 1.3f * half}, rgb_with(plate_colour, 0)});
    for (const Stroke& stroke : strokes) {
        const vec2 a = s.to_world(half * stroke.from), b = s.to_world(half * stroke.to);
        const vec2 c = s.to_world(half * stroke.bend);
        drawing.list.wires.push_back({{a.x, a.y, b.x, b.y},
                                      {c.x, c.y, height, 0.38f * half},
                                      rgb_with(sign_colour, stroke.has_head ? arrow_end : plain_end),
                                      {}});
    }
}

}  // namespace braitenlab::render
