#include "render/view/framing.h"

#include <algorithm>
#include <cmath>

#include "core/scene/scene.h"

namespace braitenlab {

using maths::vec2;

namespace {

// All but the time and the border for the walls are for an arena of full scale; see scale_of().
constexpr float around_vehicle = 0.9f, around_source = 1.0f;  // m
constexpr float enough_share = 0.6f;                          // of the wanted length of a vehicle on the screen
constexpr float beside_action = 1.2f;                         // m: an obstacle closer than this may be met
constexpr float beyond_edge = 0.3f;                           // m, the walls
constexpr float least_side = 4;                               // m
constexpr float whole_ahead_of_action = 1.5f;                 // m: the box grows by so much more, and then rests
constexpr float time_constant = 0.5f;                         // s

void include(FloorBox& box, vec2 place, float radius) {
    box.low = {std::min(box.low.x, place.x - radius), std::min(box.low.y, place.y - radius)};
    box.high = {std::max(box.high.x, place.x + radius), std::max(box.high.y, place.y + radius)};
}

FloorBox both(FloorBox a, FloorBox b) {
    include(a, b.low, 0), include(a, b.high, 0);
    return a;
}

// `action`, moved outwards at each side at which it has left `box`: the camera then moves seldom, not in each frame.
FloorBox beyond(const FloorBox& box, FloorBox action, float scale) {
    const float ahead_of_action = scale * whole_ahead_of_action;
    if (action.low.x < box.low.x) action.low.x -= ahead_of_action;
    if (action.low.y < box.low.y) action.low.y -= ahead_of_action;
    if (action.high.x > box.high.x) action.high.x += ahead_of_action;
    if (action.high.y > box.high.y) action.high.y += ahead_of_action;
    return action;
}

// The part inside the arena with its walls.
FloorBox within(FloorBox box, const Arena& arena) {
    const float edge = scale_of(arena) * beyond_edge;
    const vec2 half{arena.width / 2 + edge, arena.height / 2 + edge};
    const auto inside = [half](vec2 p) {
        return vec2{std::clamp(p.x, -half.x, half.x), std::clamp(p.y, -half.y, half.y)};
    };
    return {inside(box.low), inside(box.high)};
}

bool contains(const FloorBox& a, const FloorBox& b) {
    return a.low.x <= b.low.x && a.low.y <= b.low.y && a.high.x >= b.high.x && a.high.y >= b.high.y;
}

FloorBox whole(const Arena& arena) {
    const vec2 half{arena.width / 2, arena.height / 2};
    return {half * -1.0f, half};
}

// One axis: a side of at least `least`, inside -limit..limit where it fits there.
void fit(float& low, float& high, float least, float limit) {
    const float side = std::min(std::max(high - low, least), std::max(2 * limit, high - low));
    const float middle = (low + high) / 2, room = std::max(0.0f, limit - side / 2);
    const float kept = std::clamp(middle, -room, room);
    low = kept - side / 2, high = kept + side / 2;
}

// Lines of tape, which vehicles follow or stay within. False if there is none.
bool include_tape(FloorBox& box, const Scene& scene) {
    bool found = false;
    for (const Zone& zone : scene.zones)
        if (zone.surface == Surface::tape)
            include(box, {zone.x, zone.y}, 0.5f * std::max(zone.length, zone.width)), found = true;
    return found;
}

void include_obstacles(FloorBox& box, const Snapshot& now) {
    const float beside = scale_of(now.scene->arena) * beside_action;
    const FloorBox near{box.low - vec2{beside, beside}, box.high + vec2{beside, beside}};
    for (std::size_t i = 0; i < now.scene->obstacles.size(); ++i) {
        const Obstacle& obstacle = now.scene->obstacles[i];
        const vec2 at =
            i < now.obstacles.size() ? vec2{now.obstacles[i].x, now.obstacles[i].y} : vec2{obstacle.x, obstacle.y};
        if (at.x < near.low.x || at.x > near.high.x || at.y < near.low.y || at.y > near.high.y) continue;
        include(box, at, 0.5f * std::hypot(obstacle.length, obstacle.width));
    }
}

// The box with the aspect ratio of the free area, which the arena fills as far as it can.
FloorBox widened(FloorBox box, const FramingInput& in, const Arena& arena) {
    const bool turned = std::fabs(std::sin(in.camera.azimuth)) < 0.7f;  // +x is not across the picture
    const bool above = in.camera.mode == CameraMode::birds_eye;
    const float aspect = in.free_area.w / std::max(in.free_area.h, 1.0f) *
                         (above ? 1.0f : std::max(std::sin(in.camera.elevation), 0.3f));
    const float least = scale_of(arena) * least_side;
    vec2 side{std::max(box.high.x - box.low.x, least), std::max(box.high.y - box.low.y, least)};
    const vec2 most{std::max(side.x, arena.width), std::max(side.y, arena.height)};
    float &across = turned ? side.y : side.x, &along = turned ? side.x : side.y;
    across = std::max(across, std::min(along * aspect, turned ? most.y : most.x));
    along = std::max(along, std::min(across / aspect, turned ? most.x : most.y));
    fit(box.low.x, box.high.x, side.x, arena.width / 2);
    fit(box.low.y, box.high.y, side.y, arena.height / 2);
    return box;
}

// Shrinks the box around the vehicle until the vehicle has this length on the screen, px, or until another vehicle or
// the other run is at its edge. All sources stay inside where the vehicle has at least `enough_share` of this length
// then, and so does a whole arena: the walls of a table and the numbers beside them are not cut off for a slightly
// larger robot.
FloorBox enlarged(FloorBox box, const Snapshot& now, const VehicleView& vehicle, float pixels, const FramingInput& in) {
    const vec2 place{vehicle.x, vehicle.y};
    const float scale = scale_of(now.scene->arena), around = scale * around_vehicle;
    const float length = kind_of(now, vehicle).body.length;
    const auto share_in = [&](const FloorBox& shown) {
        const CameraView seen = look(in.camera, now.scene->arena, nullptr, in.window, in.free_area, &shown);
        return length * pixels_per_metre(seen, place) / pixels;
    };
    if (contains(box, whole(now.scene->arena)) && share_in(box) >= enough_share) return box;
    for (int i = 0; i < 4; ++i) {
        const float share = share_in(box);
        if (share >= 1) break;
        const vec2 half = (box.high - box.low) * (share * 0.5f), middle = (box.low + box.high) / 2.0f;
        const vec2 room{std::max(0.0f, half.x - around), std::max(0.0f, half.y - around)};
        const vec2 kept{std::clamp(middle.x, place.x - room.x, place.x + room.x),
                        std::clamp(middle.y, place.y - room.y, place.y + room.y)};
        box = {kept - half, kept + half};
    }
    for (const VehicleView& other : now.vehicles) include(box, {other.x, other.y}, around);
    if (in.other_run) box = both(box, *in.other_run);
    FloorBox with_sources = box;
    for (const SourceView& s : now.sources) include(with_sources, {s.x, s.y}, scale * around_source);
    return share_in(with_sources) >= enough_share ? with_sources : box;
}

}  // namespace

FloorBox action_of(const Snapshot& now) {
    if (!now.scene) return whole(Arena{});
    FloorBox box{{1e9f, 1e9f}, {-1e9f, -1e9f}};
    const float scale = scale_of(now.scene->arena);
    for (const VehicleView& v : now.vehicles) include(box, {v.x, v.y}, scale * around_vehicle);
    for (const SourceView& s : now.sources) include(box, {s.x, s.y}, scale * around_source);
    const bool has_aim = include_tape(box, *now.scene) || !now.sources.empty();
    if (!has_aim) return whole(now.scene->arena);
    include_obstacles(box, now);
    return within(box, now.scene->arena);
}

FloorBox Framing::follow(const Snapshot& now, const FramingInput& in) {
    const std::string name = now.scene ? now.scene->name : std::string{};
    if (now.seed != seed_ || now.generation != generation_ || name != scene_) start_over();
    seed_ = now.seed, generation_ = now.generation, scene_ = name;
    const bool moved = in.camera.zoom != 1 || !(in.camera.pan == vec2{});
    if (shown_ && (in.held || moved)) return *shown_;

    const Arena arena = now.scene ? now.scene->arena : Arena{};
    FloorBox action = action_of(now);
    if (in.other_run) action = within(both(action, *in.other_run), arena);
    if (!grown_)
        grown_ = action;
    else if (!contains(*grown_, action))
        grown_ = both(both(*grown_, action), within(beyond(*grown_, action, scale_of(arena)), arena));
    FloorBox wanted = widened(in.close_up ? within(*in.close_up, arena) : *grown_, in, arena);
    const VehicleView* vehicle = find_vehicle(now, in.selected);
    if (!in.close_up && vehicle && now.scene && now.vehicles.size() <= few_vehicles)
        wanted = enlarged(wanted, now, *vehicle, in.least_share * in.free_area.w, in);
    if (!shown_ || in.seconds <= 0) return *(shown_ = wanted);
    const float t = 1 - std::exp(-in.seconds / time_constant);
    const auto step = [&](vec2 from, vec2 to) {
        return maths::distance(from, to) < 0.003f ? to : from + (to - from) * t;
    };
    return *(shown_ = FloorBox{step(shown_->low, wanted.low), step(shown_->high, wanted.high)});
}

}  // namespace braitenlab
