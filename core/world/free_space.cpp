#include "core/world/free_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/maths/geometry.h"
#include "core/scene/arena.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

using maths::vec2;

namespace {

constexpr float source_reach = 0.65f;  // m, radius kept free round each source, solid or not
constexpr int most_cells_a_block = 256;

using Corners = std::vector<vec2>;

// The corners of the chassis.
Corners corners_at(const Body& body, vec2 position, vec2 ahead) {
    const float x = body.length / 2, y = body.width / 2;
    Corners corners;
    for (const vec2 own : {vec2{x, y}, vec2{-x, y}, vec2{-x, -y}, vec2{x, -y}})
        corners.push_back(position + maths::rotate(own, ahead));
    return corners;
}

// Overlap of the projections of two outlines on the normal of the edge a–b, m; negative: they are apart.
float overlap_across(const Corners& one, const Corners& other, vec2 a, vec2 b) {
    const vec2 normal = maths::normalise(vec2{a.y - b.y, b.x - a.x});
    const auto extent = [normal](const Corners& corners) {
        std::pair<float, float> range{maths::dot(corners[0], normal), maths::dot(corners[0], normal)};
        for (const vec2 corner : corners) {
            range.first = std::min(range.first, maths::dot(corner, normal));
            range.second = std::max(range.second, maths::dot(corner, normal));
        }
        return range;
    };
    const auto first = extent(one), second = extent(other);
    return std::min(first.second, second.second) - std::max(first.first, second.first);
}

// True if two convex outlines overlap by more than bodies in contact do: no edge of either separates them.
bool are_inside_each_other(const Corners& one, const Corners& other) {
    constexpr float contact = 0.02f;  // m
    for (const Corners* corners : {&one, &other})
        for (std::size_t i = 0; i < corners->size(); ++i)
            if (overlap_across(one, other, (*corners)[i], (*corners)[(i + 1) % corners->size()]) <= contact)
                return false;
    return true;
}

// True if the chassis of a vehicle at this pose would be inside another vehicle or an obstacle.
bool is_blocked(const WorldData& s, int kind, const Pose& pose) {
    const auto body_of = [&s](std::size_t of_kind) -> const Body& { return s.scene->kinds[of_kind].body; };
    const Corners chassis =
        corners_at(body_of(static_cast<std::size_t>(kind)), {pose.x, pose.y}, maths::direction(pose.heading));
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        const mechanics::Motion& m = s.vehicles.motion[row];
        const float reach = s.kinds[static_cast<std::size_t>(kind)].reach + s.kinds[s.kind(row)].reach;
        if (maths::distance(m.position, {pose.x, pose.y}) > reach) continue;
        if (are_inside_each_other(chassis, corners_at(body_of(s.kind(row)), m.position, m.ahead))) return true;
    }
    for (std::size_t i = 0; i < s.obstacles.size(); ++i) {
        Corners obstacle;
        for (const vec2 corner : corners_of(s.scene->obstacles[i]))
            obstacle.push_back(s.obstacles[i].position + maths::rotate(corner, s.obstacles[i].ahead));
        if (are_inside_each_other(chassis, obstacle)) return true;
    }
    return false;
}

}  // namespace

FreeSpace::FreeSpace(const WorldData& s) {
    const Arena& arena = s.scene->arena;
    float widest = source_reach;
    for (const CompiledKind& kind : s.kinds) widest = std::max(widest, kind.reach);
    const auto count = static_cast<float>(s.vehicles.size() + static_cast<std::size_t>(s.scene->ecology.population));
    side_ = std::max(2 * widest, std::sqrt(arena.width * arena.height / (count + 64)));
    origin_ = {-arena.width / 2, -arena.height / 2};
    columns_ = static_cast<int>(arena.width / side_) + 1;
    rows_ = static_cast<int>(arena.height / side_) + 1;
    first_disc_.assign(cell(0, rows_), -1);
    first_block_.assign(cell(0, rows_), -1);
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        occupy(s.vehicles.motion[row].position, s.kinds[s.kind(row)].reach);
    for (const Source& source : s.scene->sources) occupy({source.x, source.y}, source_reach);
    for (std::size_t i = 0; i < s.obstacles.size(); ++i) {
        Block block;
        for (const vec2 corner : corners_of(s.scene->obstacles[i]))
            block.corners.push_back(s.obstacles[i].position + maths::rotate(corner, s.obstacles[i].ahead));
        add(std::move(block));
    }
}

// Clamped before the conversion to int, which would overflow; a position outside belongs to the nearest edge cell.
int FreeSpace::column(float x) const {
    return static_cast<int>(std::clamp((x - origin_.x) / side_, 0.0f, static_cast<float>(columns_ - 1)));
}
int FreeSpace::row(float y) const {
    return static_cast<int>(std::clamp((y - origin_.y) / side_, 0.0f, static_cast<float>(rows_ - 1)));
}

void FreeSpace::occupy(vec2 position, float reach) {
    std::int32_t& first = first_disc_[cell(column(position.x), row(position.y))];
    discs_.push_back({position, reach, first});
    first = static_cast<std::int32_t>(discs_.size()) - 1;
}

void FreeSpace::add(Block block) {
    vec2 low = block.corners.front(), high = low;
    for (const vec2 corner : block.corners) {
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    const int left = column(low.x), right = column(high.x), bottom = row(low.y), top = row(high.y);
    const auto index = static_cast<std::int32_t>(blocks_.size());
    blocks_.push_back(std::move(block));
    if ((right - left + 1) * (top - bottom + 1) > most_cells_a_block) return wide_.push_back(index);
    for (int r = bottom; r <= top; ++r)
        for (int c = left; c <= right; ++c) {
            std::int32_t& first = first_block_[cell(c, r)];
            blocks_at_.push_back({index, first});
            first = static_cast<std::int32_t>(blocks_at_.size()) - 1;
        }
}

bool FreeSpace::is_near(const Block& block, vec2 position, float reach) {
    bool inside = true;
    for (std::size_t i = 0; i < block.corners.size(); ++i) {
        const vec2 a = block.corners[i], b = block.corners[(i + 1) % block.corners.size()];
        if (maths::distance(maths::nearest_on_segment(position, a, b), position) < reach) return true;
        inside &= maths::cross(b - a, position - a) >= 0;
    }
    return inside;
}

bool FreeSpace::is_free(vec2 position, float reach) const {
    for (const std::int32_t wide : wide_)
        if (is_near(blocks_[static_cast<std::size_t>(wide)], position, reach)) return false;
    const int at_column = column(position.x), at_row = row(position.y);
    for (int r = std::max(0, at_row - 1); r <= std::min(rows_ - 1, at_row + 1); ++r)
        for (int c = std::max(0, at_column - 1); c <= std::min(columns_ - 1, at_column + 1); ++c) {
            for (std::int32_t i = first_disc_[cell(c, r)]; i >= 0; i = discs_[static_cast<std::size_t>(i)].next) {
                const Disc& disc = discs_[static_cast<std::size_t>(i)];
                if (maths::distance(disc.position, position) < disc.reach + reach) return false;
            }
            for (std::int32_t i = first_block_[cell(c, r)]; i >= 0; i = blocks_at_[static_cast<std::size_t>(i)].next) {
                const auto block = static_cast<std::size_t>(blocks_at_[static_cast<std::size_t>(i)].block);
                if (is_near(blocks_[block], position, reach)) return false;
            }
        }
    return true;
}

Pose nearest_free_pose(const WorldData& s, int kind, const Pose& pose) {
    if (!is_blocked(s, kind, pose)) return pose;
    constexpr int cells = 40;  // in each direction
    const float reach = s.kinds[static_cast<std::size_t>(kind)].reach, step = reach / 2;
    const FreeSpace free_space(s);
    Pose nearest = pose;
    int least = 2 * cells * cells + 1;
    for (int i = -cells; i <= cells; ++i)
        for (int j = -cells; j <= cells; ++j) {
            if (i * i + j * j >= least) continue;
            const vec2 at{pose.x + static_cast<float>(i) * step, pose.y + static_cast<float>(j) * step};
            if (!is_inside(s.scene->arena, at, reach) || !free_space.is_free(at, reach)) continue;
            least = i * i + j * j;
            nearest.x = at.x, nearest.y = at.y;
        }
    return nearest;
}

}  // namespace braitenlab::world
