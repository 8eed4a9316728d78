// Trails of vehicles.
#include <algorithm>

#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec4;

namespace {

constexpr std::size_t few_vehicles = 64;  // each of them has a trail, however small it is

// Which points of a trail are drawn: those whose number is a multiple of `stride`, at most `most`.
struct TrailPlan {
    std::size_t stride = 1, most = 0;
};

TrailPlan plan_of(const Trail& trail, std::size_t vehicles, bool selected) {
    constexpr std::size_t budget = 3072, shortest = 6, widest = 6, recent = 48;
    const std::size_t most =
        std::max(shortest, selected && vehicles > 1 ? budget / 2 : budget / std::max<std::size_t>(vehicles, 1));
    if (vehicles > few_vehicles) return {1, selected ? recent : std::min(most, recent)};
    return {std::clamp<std::size_t>((trail.count() + most - 1) / most, 1, widest), most};
}

// True if the vehicle drove from point k to point i, i < k.
bool are_joined(const Trail& trail, std::size_t i, std::size_t k) {
    for (; i < k; ++i)
        if (!trail.is_joined(i)) return false;
    return true;
}

}  // namespace

void add_trail(Drawing& drawing, const Subject& s, const Trail& trail) {
    const std::size_t vehicles = drawing.now.vehicles.size();
    if (s.pixels < 10 && vehicles > few_vehicles && !s.selected) return;  // too small for a trail
    const TrailPlan plan = plan_of(trail, vehicles, s.selected);
    std::vector<std::size_t> shown;  // numbers of the points, newest first
    for (std::size_t i = 0; i < trail.count() && shown.size() < plan.most; ++i)
        if (i == 0 || trail.serial(i) % plan.stride == 0) shown.push_back(i);
    const std::size_t count = shown.size() + 1;  // + 1: the current position
    const auto point = [&](std::size_t i) { return i == 0 ? s.place : trail.at(shown[i - 1]); };
    // True if there is a piece of the trail between points i and i + 1.
    const auto is_piece = [&](std::size_t i) {
        return i + 1 < count && (i == 0 || are_joined(trail, shown[i - 1], shown[i]));
    };
    const auto side = [&](std::size_t i) {
        const std::size_t newer = i > 0 && is_piece(i - 1) ? i - 1 : i, older = is_piece(i) ? i + 1 : i;
        const vec2 along = maths::normalise(point(newer) - point(older));
        return vec2{along.y, -along.x};  // left of the direction back, in which the trail is drawn
    };
    const TrailColour& wanted = drawing.picture.settings.overlays.trail_colour;
    const bool plain = wanted.value == TrailValue::plain;
    const float top_speed = wanted.value == TrailValue::speed ? top_speed_of(drawing.now) : 0;
    const Colour body = colour_of(drawing.colours, drawing.now, s.view);
    const Colour own = is_light(drawing) ? darker(body) : body;
    const auto colour = [&](std::size_t i) {  // of the piece between points i and i + 1
        if (plain) return own;
        const auto share = share_of_scale(wanted, trail.moment(shown[i]), s.kind.sensors, top_speed);
        return share ? colour_of_share(wanted.value, *share, drawing.picture.theme) : own;
    };
    // A short trail hardly fades. A coloured one fades less, so that its colours can be compared with the legend.
    const float newest = s.selected ? (plain ? 0.95f : 1) : 0.85f, oldest = (plain ? 0.45f : 0.8f) * newest;
    const bool fades_out = vehicles > few_vehicles;  // the recent part only: it fades out
    const auto opacity = [&](std::size_t i) {
        const float age =
            static_cast<float>(i) / static_cast<float>(std::max<std::size_t>(count, fades_out ? 24 : 200));
        return newest + ((fades_out ? 0 : oldest) - newest) * age;
    };
    // Among many vehicles trails are thinner than the vehicles they come from.
    const float width = (s.selected ? 7.0f : 5.0f) * std::max(drawing.crowd, 0.6f);
    // A round end at point i of the piece from point `of`; `away`: 1 in the direction back, −1 in the other one.
    const auto add_end = [&](std::size_t i, std::size_t of, float away) {
        const vec2 at = point(i), n = side(i) * away;
        drawing.list.trails.push_back({{at.x, at.y, at.x, at.y},
                                       {n.x, n.y, n.x, n.y},
                                       rgb_with(colour(of), width),
                                       {opacity(i), opacity(i), 1, 0}});
    };
    for (std::size_t i = 0; i + 1 < count; ++i) {
        if (!is_piece(i)) continue;
        const vec2 a = point(i), b = point(i + 1), na = side(i), nb = side(i + 1);
        if (i > 0 && !is_piece(i - 1)) add_end(i, i, -1);
        drawing.list.trails.push_back({{a.x, a.y, b.x, b.y},
                                       {na.x, na.y, nb.x, nb.y},
                                       rgb_with(colour(i), width),
                                       {opacity(i), opacity(i + 1), 0, 0}});
        if (!is_piece(i + 1) && !(fades_out && i + 2 == count)) add_end(i + 1, i, 1);
    }
}

}  // namespace braitenlab::render
