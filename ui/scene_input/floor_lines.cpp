#include "ui/scene_input/floor_lines.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "core/maths/angle.h"
#include "render/view/drawing.h"
#include "ui/scene_input/draw.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float farthest_joined = 2;  // m
constexpr DashedLine ghost_dashes{.width = 1.75f, .dash = 0.11f, .gap = 0.08f, .over_vehicles = true};

// Where vehicles are on the screen.
class Bodies {
public:
    explicit Bodies(const SceneInputFrame& frame) {
        constexpr std::size_t crowd = 200;
        const Snapshot& now = *frame.view.now;
        if (!now.scene || now.vehicles.size() > crowd) return;
        for (const VehicleView& vehicle : now.vehicles)
            if (const Rect body = picture_of(now, frame.camera_view, vehicle); body.w > 0) all_.push_back(body);
    }
    const Rect* at(vec2 pixel) const {
        const auto found = std::find_if(all_.begin(), all_.end(), [pixel](const Rect& body) {
            const vec2 half{body.w / 2, body.h / 2};
            const vec2 away{(pixel.x - body.x - half.x) / half.x, (pixel.y - body.y - half.y) / half.y};
            return maths::dot(away, away) < 1;
        });
        return found == all_.end() ? nullptr : &*found;
    }
    bool cover(vec2 pixel) const { return at(pixel) != nullptr; }

private:
    std::vector<Rect> all_;
};

void floor_segment(const SceneInputFrame& frame, const Ui& ui, vec2 from, vec2 to, float from_height, float to_height,
                   Colour colour, float width) {
    const auto a = project(frame.camera_view, from, from_height), b = project(frame.camera_view, to, to_height);
    if (a && b) draw_line(ui, {{a->x, a->y}, {b->x, b->y}}, colour, width, false);
}

void fill_deck(const SceneInputFrame& frame, const std::vector<vec2>& outline, Colour colour) {
    std::vector<ImVec2> points;
    for (std::size_t i = 0; i + 1 < outline.size(); ++i)
        if (const auto at = project(frame.camera_view, outline[i], render::deck_height))
            points.push_back({at->x, at->y});
    if (points.size() == 4)
        ImGui::GetBackgroundDrawList()->AddConvexPolyFilled(points.data(), 4, paint(colour.with_alpha(0.14f)));
}

}  // namespace

void draw_path_dots(const SceneInputFrame& frame, const Ui& ui, const GhostView& ghost, Colour colour) {
    constexpr std::size_t ticks_per_dot = 15, most_ticks = 3600;
    constexpr float radius_in_body = 0.035f, border_in_radius = 0.75f;  // of a vehicle's length; of a dot's radius
    constexpr float smallest = 0.8f, largest = 2;                       // radius
    const Bodies bodies(frame);
    const std::size_t last = ghost.count - 1;
    for (std::size_t tick = last / ticks_per_dot * ticks_per_dot; tick + most_ticks > last; tick -= ticks_per_dot) {
        const Pose& pose = (*ghost.path)[tick];
        const float age = static_cast<float>(last - tick) / static_cast<float>(most_ticks);
        const auto at = project(frame.camera_view, {pose.x, pose.y});
        if (at && !bodies.cover(*at)) {
            const float length = ghost.length * pixels_per_metre(frame.camera_view, {pose.x, pose.y}) / ui.scale;
            const float radius = std::clamp(radius_in_body * length, smallest, largest);
            if (frame.labels) frame.labels->take(square_around(*at, ui.px(2 * (radius + 1))));
            draw_dot(ui, {at->x, at->y}, radius, colour.with_alpha(0.8f - 0.6f * age), border_in_radius * radius);
        }
        if (tick == 0) break;
    }
}

void draw_coming_dots(const SceneInputFrame& frame, const Ui& ui, const ComingPath& coming, Colour colour) {
    constexpr std::uint64_t ticks_per_dot = 30;
    constexpr float metres = 0.055f, smallest = 2, largest = 5, apart = 3;  // radius, m and layout px; in radii
    const Bodies bodies(frame);
    std::optional<vec2> last;
    for (std::uint64_t tick = std::max(coming.first, coming.now + 1); tick < coming.first + coming.path->size();
         ++tick) {
        if (tick % ticks_per_dot != 0) continue;
        const Pose& pose = (*coming.path)[static_cast<std::size_t>(tick - coming.first)];
        const auto at = project(frame.camera_view, {pose.x, pose.y});
        if (!at || bodies.cover(*at)) continue;
        const float wanted = metres * pixels_per_metre(frame.camera_view, {pose.x, pose.y}) / ui.scale;
        const float radius = std::clamp(wanted, smallest, largest);
        if (last && maths::distance(*last, *at) < ui.px(apart * radius)) continue;
        draw_dot(ui, {at->x, at->y}, radius, colour, 1);
        last = at;
    }
}

void draw_dashes(const SceneInputFrame& frame, const Ui& ui, const std::vector<vec2>& points, Colour colour,
                 const DashedLine& look) {
    float along = 0;  // m since the begin of the last dash
    const Bodies bodies(frame);
    const auto is_hidden = [&](vec2 from, vec2 to) {
        const auto middle = project(frame.camera_view, (from + to) / 2.0f, look.height);
        return !look.over_vehicles && middle && bodies.cover(*middle);
    };
    for (std::size_t i = 1; i < points.size(); ++i) {
        const vec2 from = points[i - 1], way = points[i] - from;
        const float length = maths::length(way);
        if (length <= 0 || length > farthest_joined) continue;
        for (float done = 0; done < length;) {
            const bool drawn = along < look.dash;
            const float step = std::min(length - done, (drawn ? look.dash : look.dash + look.gap) - along);
            const vec2 a = from + way * (done / length), b = from + way * ((done + step) / length);
            if (drawn && !is_hidden(a, b)) floor_segment(frame, ui, a, b, look.height, look.height, colour, look.width);
            done += std::max(step, 1e-4f);
            along += std::max(step, 1e-4f);
            if (along >= look.dash + look.gap) along = 0;
        }
    }
}

void draw_floor_line(const SceneInputFrame& frame, const Ui& ui, const std::vector<vec2>& points, Colour colour,
                     float width) {
    const Bodies bodies(frame);
    std::vector<ImVec2> piece;
    const auto end_piece = [&] { draw_line(ui, piece, colour, width, false), piece.clear(); };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto at = project(frame.camera_view, points[i]);
        if (!at || (i > 0 && maths::distance(points[i - 1], points[i]) > farthest_joined)) end_piece();
        if (at && bodies.cover(*at))
            end_piece();
        else if (at)
            piece.push_back({at->x, at->y});
    }
    end_piece();
}

void keep_line_free(const SceneInputFrame& frame, const Ui& ui, const std::vector<vec2>& points) {
    constexpr float width = 4;  // layout pixels
    if (!frame.labels) return;
    std::vector<vec2> piece;
    const auto end_piece = [&] { frame.labels->keep_line_free(piece, ui.px(width)), piece.clear(); };
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto at = project(frame.camera_view, points[i]);
        if (!at || (i > 0 && maths::distance(points[i - 1], points[i]) > farthest_joined)) end_piece();
        if (at) piece.push_back(*at);
    }
    end_piece();
}

std::optional<Rect> body_at(const SceneInputFrame& frame, vec2 pixel) {
    const Bodies bodies(frame);
    const Rect* body = bodies.at(pixel);
    return body ? std::optional(*body) : std::nullopt;
}

Rect picture_of_body(const SceneInputFrame& frame, vec2 place, float length) {
    const auto at = project(frame.camera_view, place);
    return at ? square_around(*at, length * pixels_per_metre(frame.camera_view, place)) : Rect{};
}

void draw_ghost(const SceneInputFrame& frame, const Ui& ui, const GhostView& ghost, const GhostLook& look) {
    draw_path_dots(frame, ui, ghost, look.colour);
    const auto corner = [&](float ahead, float left) {
        const float c = std::cos(ghost.pose.heading), s = std::sin(ghost.pose.heading);
        return vec2{ghost.pose.x + c * ahead - s * left, ghost.pose.y + s * ahead + c * left};
    };
    const float x = ghost.length / 2, y = ghost.width / 2, deck = render::deck_height, floor = 0.02f;
    const std::vector<vec2> outline{corner(x, y), corner(-x, y), corner(-x, -y), corner(x, -y), corner(x, y)};
    fill_deck(frame, outline, look.colour);
    for (const float height : {floor, deck}) {
        DashedLine dashes = ghost_dashes;
        dashes.height = height;
        draw_dashes(frame, ui, outline, look.colour, dashes);
    }
    for (std::size_t i = 0; i < 4; ++i)
        floor_segment(frame, ui, outline[i], outline[i], floor, deck, look.colour, ghost_dashes.width);
    const std::vector<vec2> arrow{corner(0, 0.4f * y), corner(0.7f * x, 0), corner(0, -0.4f * y)};
    for (std::size_t i = 1; i < arrow.size(); ++i)
        floor_segment(frame, ui, arrow[i - 1], arrow[i], deck, deck, look.colour, ghost_dashes.width);
    const vec2 place{ghost.pose.x, ghost.pose.y};
    const auto at = project(frame.camera_view, place);
    if (at && frame.labels) {
        const Rect body = picture_of_body(frame, place, ghost.length);
        frame.labels->take(body);
        draw_label(frame, ui, look.words, look.edge, body, NoteSide::any, look.other);
    }
    if (at) ui.anchors.record(std::string(look.anchor), square_around(*at, ui.px(24)));
}

}  // namespace braitenlab::ui
