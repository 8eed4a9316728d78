#include "core/lesson/resemblance.h"

#include <algorithm>
#include <cmath>

#include "core/lesson/path_distance.h"

namespace braitenlab {

namespace {

using Path = std::vector<maths::vec2>;

// At most so many points of a path are compared: 200 students are compared in seconds.
constexpr std::size_t compared_points = 80;

// The largest distance of a point of the path from its start.
float reach(const Path& path) {
    float most = 0;
    for (const maths::vec2 a : path) most = std::max(most, std::hypot(a.x - path[0].x, a.y - path[0].y));
    return most;
}

// 0..1. The distance between the shapes in proportion to their size; speed has no effect.
float path_difference(const Path& one, const Path& other) {
    if (one.empty() || other.empty()) return one.empty() == other.empty() ? 0.0f : 1.0f;
    const float size = std::max({reach(one), reach(other), 0.5f});
    return std::min(1.0f, 2 * path_distance(one, other, compared_points) / size);
}

float value_difference(float a, float b) {
    if (!std::isfinite(a) || !std::isfinite(b)) return std::isfinite(a) == std::isfinite(b) ? 0.0f : 1.0f;
    const float most = std::max(std::fabs(a), std::fabs(b));
    return most < 1e-6f ? 0.0f : std::min(1.0f, std::fabs(a - b) / most);
}

float start_distance(const StartResult& a, const StartResult& b) {
    float steps = 0, values = 0, measured = 0;
    const std::size_t count = std::min(a.verdicts.size(), b.verdicts.size());
    if (count == 0) return a.verdicts.size() == b.verdicts.size() ? 0.0f : 1.0f;
    for (std::size_t i = 0; i < count; ++i) {
        const Verdict &one = a.verdicts[i], &other = b.verdicts[i];
        steps += one.done != other.done;
        for (std::size_t m = 0; m < std::min(one.measures.size(), other.measures.size()); ++m, ++measured)
            values += value_difference(one.measures[m].value, other.measures[m].value);
    }
    return 0.5f * steps / static_cast<float>(count) + 0.25f * path_difference(a.path, b.path) +
           0.25f * values / std::max(measured, 1.0f);
}

}  // namespace

float behaviour_distance(const Grade& a, const Grade& b) {
    const std::size_t count = std::min(a.starts.size(), b.starts.size());
    float sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += start_distance(a.starts[i], b.starts[i]);
    return count == 0 ? 1.0f : sum / static_cast<float>(count);
}

std::optional<std::size_t> most_alike(const Grade& grade, const std::vector<Grade>& others) {
    std::optional<std::size_t> nearest;
    float least = alike;
    for (std::size_t i = 0; i < others.size(); ++i)
        if (const float distance = behaviour_distance(grade, others[i]); distance < least)
            least = distance, nearest = i;
    return nearest;
}

}  // namespace braitenlab
