#include "core/lesson/path_distance.h"

#include <algorithm>
#include <limits>

#include "core/maths/geometry.h"

namespace braitenlab {

namespace {

using maths::vec2;

constexpr float finest_step = 0.02f;  // m

// Points in equal steps along the path, from its first point on.
std::vector<vec2> in_equal_steps(std::span<const vec2> path, std::size_t most_points) {
    std::vector<vec2> points{path.front()};
    const float step = std::max(finest_step, path_length(path) / static_cast<float>(most_points));
    float missing = step;  // m along the path to the next point
    for (std::size_t i = 1; i < path.size(); ++i) {
        vec2 from = path[i - 1];
        float left = maths::distance(from, path[i]);
        for (; left >= missing; left -= missing, missing = step) {
            from = from + (path[i] - from) * (missing / left);
            points.push_back(from);
        }
        missing -= left;
    }
    return points;
}

// Mean distance of the points to the nearest point of the line through the others.
float mean_distance_to(const std::vector<vec2>& others, const std::vector<vec2>& points) {
    double sum = 0;
    for (const vec2 point : points) {
        float nearest = std::numeric_limits<float>::max();
        for (std::size_t i = 0; i < others.size(); ++i) {
            const vec2 next = others[std::min(i + 1, others.size() - 1)];
            nearest = std::min(nearest, maths::distance(point, maths::nearest_on_segment(point, others[i], next)));
        }
        sum += static_cast<double>(nearest);
    }
    return static_cast<float>(sum / static_cast<double>(points.size()));
}

// Mean cosine of the angle between each piece of `points` and the nearest piece of `others`, −1..1.
float mean_cosine(const std::vector<vec2>& others, const std::vector<vec2>& points) {
    const auto middle = [](const std::vector<vec2>& path, std::size_t i) { return (path[i] + path[i + 1]) * 0.5f; };
    const auto way = [](const std::vector<vec2>& path, std::size_t i) {
        const vec2 piece = path[i + 1] - path[i];
        return piece * (1 / std::max(1e-6f, maths::length(piece)));
    };
    double sum = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        std::size_t nearest = 0;
        for (std::size_t k = 1; k + 1 < others.size(); ++k)
            if (maths::distance(middle(points, i), middle(others, k)) <
                maths::distance(middle(points, i), middle(others, nearest)))
                nearest = k;
        const vec2 one = way(points, i), other = way(others, nearest);
        sum += static_cast<double>(one.x * other.x + one.y * other.y);
    }
    return static_cast<float>(sum / static_cast<double>(points.size() - 1));
}

}  // namespace

bool runs_against(std::span<const vec2> a, std::span<const vec2> b) {
    constexpr float against = -0.5f;
    constexpr std::size_t compared_points = 1000;
    if (a.empty() || b.empty()) return false;
    const std::vector<vec2> one = in_equal_steps(a, compared_points), other = in_equal_steps(b, compared_points);
    if (one.size() < 2 || other.size() < 2) return false;
    return (mean_cosine(one, other) + mean_cosine(other, one)) / 2 < against;
}

float path_distance(std::span<const vec2> a, std::span<const vec2> b, std::size_t most_points) {
    if (a.empty() || b.empty()) return 0;
    const std::vector<vec2> one = in_equal_steps(a, most_points), other = in_equal_steps(b, most_points);
    return (mean_distance_to(one, other) + mean_distance_to(other, one)) / 2;
}

std::vector<vec2> positions(const ReferencePath& path, std::size_t count, std::size_t step) {
    std::vector<vec2> places;
    const std::size_t end = std::min(count, path.size());
    for (std::size_t i = 0; i < end; i += step) places.push_back({path[i].x, path[i].y});
    if (end > 0 && (end - 1) % step != 0) places.push_back({path[end - 1].x, path[end - 1].y});
    return places;
}

float path_length(std::span<const vec2> path) {
    float length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) length += maths::distance(path[i - 1], path[i]);
    return length;
}

}  // namespace braitenlab
