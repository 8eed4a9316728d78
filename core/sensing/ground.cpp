#include "core/sensing/ground.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "core/mechanics/body.h"
#include "core/sensing/seam.h"

namespace braitenlab::sensing {

using maths::vec2;

namespace {

constexpr float cells_a_side = 64;

}  // namespace

bool Ground::Patch::covers(vec2 position) const {
    const vec2 d = maths::rotate(position - middle, {ahead.x, -ahead.y});
    if (!corners.empty()) {
        for (std::size_t i = 0; i < corners.size(); ++i)
            if (maths::cross(corners[(i + 1) % corners.size()] - corners[i], d - corners[i]) < 0) return false;
        return true;
    }
    if (!round) return std::fabs(d.x) <= half_length && std::fabs(d.y) <= half_width;
    const float x = d.x / half_length, y = d.y / half_width;
    return x * x + y * y <= 1;
}

vec2 Ground::Patch::reach() const {
    const float l = half_length, w = half_width;
    return {l * std::fabs(ahead.x) + w * std::fabs(ahead.y), l * std::fabs(ahead.y) + w * std::fabs(ahead.x)};
}

Ground::Patch Ground::patch_of(const Zone& zone, const Arena& arena) {
    Patch patch;
    patch.middle = {zone.x, zone.y};
    patch.ahead = maths::direction(zone.heading);
    patch.half_length = zone.length / 2;
    patch.half_width = zone.width / 2;
    patch.round = zone.round;
    if (!zone.corners.empty()) {
        patch.corners = corners_of(zone);
        patch.half_length = patch.half_width = 0;
        for (const vec2 corner : patch.corners) {
            patch.half_length = std::max(patch.half_length, std::fabs(corner.x));
            patch.half_width = std::max(patch.half_width, std::fabs(corner.y));
        }
    }
    patch.has_surface = zone.surface != Surface::none;
    patch.floor = floor_constants(arena, zone.surface);
    patch.recharge = zone.recharge;
    patch.wind = {zone.wind_x, zone.wind_y};
    patch.sine_of_slope = maths::sine(zone.slope);
    patch.pull = zone.pull;
    return patch;
}

Ground::Ground(const Scene& scene) : plain(floor_constants(scene.arena, Surface::none)) {
    const Seam seam(scene.arena);
    for (const Zone& zone : scene.zones) {
        Patch patch = patch_of(zone, scene.arena);
        for (const vec2 middle : seam.images_of(patch.middle, patch.reach())) {
            patch.middle = middle;
            patches_.push_back(patch);
        }
        has_surfaces |= zone.surface != Surface::none;
        pushes |= zone.wind_x != 0 || zone.wind_y != 0 || zone.slope != 0 || zone.pull != 0;
        recharges |= zone.recharge != 0;
    }
    sort_into_cells(scene.arena);
}

int Ground::column(float x) const { return std::clamp(static_cast<int>((x - origin_.x) / cell_), 0, columns_ - 1); }
int Ground::row(float y) const { return std::clamp(static_cast<int>((y - origin_.y) / cell_), 0, rows_ - 1); }

// A position outside the arena belongs to the nearest cell at the border; so do zones there.
void Ground::sort_into_cells(const Arena& arena) {
    if (patches_.empty()) return;
    cell_ = std::max(arena.width, arena.height) / cells_a_side;
    origin_ = {-arena.width / 2, -arena.height / 2};
    columns_ = static_cast<int>(arena.width / cell_) + 1;
    rows_ = static_cast<int>(arena.height / cell_) + 1;
    std::vector<std::vector<std::uint32_t>> cells(static_cast<std::size_t>(columns_ * rows_));
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        const Patch& p = patches_[i];
        const vec2 reach = p.reach();
        for (int r = row(p.middle.y - reach.y); r <= row(p.middle.y + reach.y); ++r)
            for (int c = column(p.middle.x - reach.x); c <= column(p.middle.x + reach.x); ++c)
                cells[static_cast<std::size_t>(r * columns_ + c)].push_back(static_cast<std::uint32_t>(i));
    }
    for (const auto& cell : cells) {
        first_.push_back(static_cast<std::uint32_t>(of_cell_.size()));
        of_cell_.insert(of_cell_.end(), cell.begin(), cell.end());
    }
    first_.push_back(static_cast<std::uint32_t>(of_cell_.size()));
}

template <class Visit>
void Ground::at(vec2 position, Visit visit) const {
    const auto cell = static_cast<std::size_t>(row(position.y) * columns_ + column(position.x));
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i)
        if (const Patch& patch = patches_[of_cell_[i]]; patch.covers(position)) visit(patch);
}

FloorConstants Ground::floor_at(vec2 position) const {
    FloorConstants floor = plain;
    if (has_surfaces)
        at(position, [&](const Patch& patch) {
            if (patch.has_surface) floor = patch.floor;
        });
    return floor;
}

vec2 Ground::push_at(vec2 position, float mass) const {
    vec2 push;
    if (pushes)
        at(position, [&](const Patch& patch) {
            push += patch.wind;
            push += mechanics::slope_force(patch.ahead, patch.sine_of_slope, mass);
            push += mechanics::pull_force(position, patch.middle, patch.pull);
        });
    return push;
}

float Ground::recharge_at(vec2 position) const {
    float recharge = 0;
    if (recharges) at(position, [&](const Patch& patch) { recharge += patch.recharge; });
    return recharge;
}

}  // namespace braitenlab::sensing
