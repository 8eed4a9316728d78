// Trails of vehicles.
#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec4;

void add_trail(Drawing& drawing, const Subject& s, const Trail& trail) {
    if (s.pixels < 10 && !s.selected) return;  // too small for a trail
    // Trails get shorter with the number of vehicles.
    constexpr std::size_t most_points = 64 * Trail::capacity;
    const std::size_t longest =
        s.selected ? Trail::capacity
                   : std::clamp<std::size_t>(most_points / drawing.now.vehicles.size(), 6, Trail::capacity);
    const std::size_t count = std::min(trail.count(), longest) + 1;  // + 1: the current position
    const auto point = [&](std::size_t i) { return i == 0 ? s.place : trail.at(i - 1); };
    const auto side = [&](std::size_t i) {
        const vec2 along = maths::normalise(point(i == 0 ? 0 : i - 1) - point(std::min(i + 1, count - 1)));
        return vec2{along.y, -along.x};  // left of the direction back, in which the trail is drawn
    };
    const Colour colour = colour_of(drawing.colours, s.view.role);
    const float most = s.selected ? 0.75f : 0.4f;
    const auto opacity = [&](std::size_t i) {
        const float age = static_cast<float>(i) / static_cast<float>(longest);
        return most * std::max(0.0f, 1 - age) * std::max(0.0f, 1 - age);
    };
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const vec2 a = point(i), b = point(i + 1), na = side(i), nb = side(i + 1);
        if (maths::distance(a, b) > Trail::jump) continue;
        drawing.list.trails.push_back({{a.x, a.y, b.x, b.y},
                                       {na.x, na.y, nb.x, nb.y},
                                       rgb_with(colour, s.selected ? 0.075f : 0.06f),
                                       {opacity(i), opacity(i + 1), 0, 0}});
    }
}

}  // namespace braitenlab::render
