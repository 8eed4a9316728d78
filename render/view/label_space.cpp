#include "render/view/label_space.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/maths/angle.h"
#include "render/view/pick.h"

namespace braitenlab {

using maths::vec2;

namespace {

float overlap(const Rect& a, const Rect& b) {
    const float w = std::min(a.x + a.w, b.x + b.w) - std::max(a.x, b.x);
    const float h = std::min(a.y + a.h, b.y + b.h) - std::max(a.y, b.y);
    return std::max(w, 0.0f) * std::max(h, 0.0f);
}

Rect around(const CameraView& seen, maths::vec2 place, float height, float half_width, float half_height) {
    const auto at = project(seen, place, height);
    const float pixels = pixels_per_metre(seen, place, height);
    if (!at) return {};
    return {at->x - half_width * pixels, at->y - half_height * pixels, 2 * half_width * pixels,
            2 * half_height * pixels};
}

// The rectangle around a piece of an obstacle: half its length along the longer side, whose middle is `middle` from the
// obstacle's, and half its width; m. nullopt behind the camera.
std::optional<Rect> around_block(const CameraView& seen, const Pose& obstacle, bool is_long, float middle,
                                 float half_length, float half_width, float top) {
    const vec2 ahead = maths::direction(obstacle.heading);
    vec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    for (const float along : {middle - half_length, middle + half_length})
        for (const float across : {-half_width, half_width})
            for (const float height : {0.0f, top}) {
                const vec2 own = is_long ? vec2{along, across} : vec2{across, along};
                const auto at = project(seen, vec2{obstacle.x, obstacle.y} + maths::rotate(own, ahead), height);
                if (!at) return std::nullopt;
                low = {std::min(low.x, at->x), std::min(low.y, at->y)};
                high = {std::max(high.x, at->x), std::max(high.y, at->y)};
            }
    return Rect{low.x, low.y, high.x - low.x, high.y - low.y};
}

}  // namespace

Rect picture_of(const Snapshot& now, const CameraView& seen, const VehicleView& vehicle) {
    constexpr float flattened = 0.85f;  // the camera looks down at a slant
    const float half = 0.5f * kind_of(now, vehicle).body.length;
    return around(seen, {vehicle.x, vehicle.y}, vehicle_middle * scale_of(now.scene->arena), half, flattened * half);
}

Rect picture_of(const Snapshot& now, const CameraView& seen, const SourceView& source) {
    constexpr float radius = 0.26f;
    const float scale = scale_of(now.scene->arena);
    return around(seen, {source.x, source.y}, bulb_height * scale, radius * scale, radius * scale);
}

void LabelSpace::keep_free(const Snapshot& now, const CameraView& seen) {
    constexpr std::size_t crowd = 200;
    if (!now.scene) return;
    if (now.vehicles.size() <= crowd)
        for (const VehicleView& vehicle : now.vehicles) keep_free(picture_of(now, seen, vehicle));
    for (const SourceView& source : now.sources) keep_free(picture_of(now, seen, source));
}

void LabelSpace::keep_obstacles_free(const Snapshot& now, const CameraView& seen) {
    constexpr int most_pieces = 24;
    if (!now.scene) return;
    const float top = obstacle_height(now.scene->arena);
    const std::size_t count = std::min(now.scene->obstacles.size(), now.obstacles.size());
    for (std::size_t i = 0; i < count; ++i) {
        const Obstacle& box = now.scene->obstacles[i];
        const Pose& at = now.obstacles[i];
        const bool is_long = box.length >= box.width;
        const float along = std::max(box.length, box.width), across = std::min(box.length, box.width);
        const int pieces = std::clamp(static_cast<int>(std::ceil(along / std::max(across, 1e-3f))), 1, most_pieces);
        const float half = 0.5f * along / static_cast<float>(pieces);
        for (int piece = 0; piece < pieces; ++piece) {
            const float middle = static_cast<float>(2 * piece + 1) * half - 0.5f * along;
            if (const auto around = around_block(seen, at, is_long, middle, half, 0.5f * across, top))
                keep_free(*around);
        }
    }
}

void LabelSpace::keep_line_free(std::span<const vec2> points, float width) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const vec2 from = points[i - 1], way = points[i] - from;
        const float length = maths::length(way);
        const int pieces = std::max(1, static_cast<int>(std::ceil(length / (2 * width))));
        for (int piece = 0; piece < pieces; ++piece) {
            const vec2 a = from + way * (static_cast<float>(piece) / static_cast<float>(pieces)),
                       b = from + way * (static_cast<float>(piece + 1) / static_cast<float>(pieces));
            keep_free({std::min(a.x, b.x) - width / 2, std::min(a.y, b.y) - width / 2, std::fabs(a.x - b.x) + width,
                       std::fabs(a.y - b.y) + width});
        }
    }
}

bool LabelSpace::is_free(const Rect& place) const { return cost(place) <= 0; }

float LabelSpace::cost(const Rect& place) const {
    constexpr float of_label = 8;
    float sum = 0;
    for (const Rect& label : labels_) sum += of_label * overlap(place, label);
    for (const Rect& thing : things_) sum += overlap(place, thing);
    return sum;
}

}  // namespace braitenlab
