#include "render/view/framing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/scene/scene.h"
#include "render/view/label_space.h"

namespace braitenlab {

using maths::vec2;

namespace {

// All but times and the border for the walls are for an arena of full scale; see scale_of().
constexpr float around_vehicle = 0.85f, around_source = 0.95f;  // m
constexpr float around_other = 0.6f, around_lamp = 0.5f;        // m, of those that must be in the picture
constexpr float enough_on_table = 0.6f;                         // of the wanted length of a vehicle on the screen
constexpr float enough_with_source = 0.5f;                      // of it: the nearest source then stays in the picture
constexpr float enough_with_all = 0.9f;                         // of it: all sources then stay
constexpr float room_to_drive = 1.4f;                           // of it: a view that can give so much serves longer
constexpr float cover_to_drive = 0.1f;                          // of the free area, for the same reason
constexpr float nearer = 0.8f;                                  // of the distance: another source is then the nearest
constexpr float worth_of_rest = 0.12f;                          // by so much another elevation must be better
constexpr float share_of_rest = 0.05f;  // of the wanted length: so much less is enough for sources in the picture
constexpr float least_part = 0.4f;      // of the box around the action
constexpr std::array elevations{1.0f, 1.1f, 0.9f, 1.2f, 0.8f, 1.25f, 0.7f, 0.6f, 0.5f};  // rad
constexpr float beside_action = 1.2f;          // m: an obstacle closer than this may be met
constexpr float beyond_edge = 0.3f;            // m, the walls
constexpr float least_side = 4;                // m
constexpr float whole_ahead_of_action = 1.5f;  // m: the box grows by so much more, and then rests
constexpr float left_free = 0.2f;              // m: so much of the place around a vehicle may be outside the box
constexpr float seconds_ahead = 0.8f;          // a vehicle leaves the picture that would be outside so much later
constexpr float share_to_rest = 0.85f;         // of the wanted length, in a picture that is to rest longer
constexpr float ahead_of_vehicle = 1.2f;       // m: room for a vehicle that has left the picture, in its direction
constexpr float time_constant = 0.3f;          // s
constexpr std::uint64_t ticks_of_elevation = 25 * 60;  // simulated time between two changes of the elevation

constexpr FloorBox nothing{{1e9f, 1e9f}, {-1e9f, -1e9f}};

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

// True if a vehicle has left a torus at one edge and entered it at the opposite one.
bool crosses_seam(vec2 from, vec2 to, const Arena& arena) {
    const bool is_far = std::fabs(to.x - from.x) > arena.width / 2 || std::fabs(to.y - from.y) > arena.height / 2;
    return arena.edge == Boundary::torus && is_far;
}

FloorBox with_border(const FloorBox& box, float border) {
    return {box.low - vec2{border, border}, box.high + vec2{border, border}};
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

constexpr float narrow = 0.85f;  // width by height of a free area, as between the cards of a small window

bool is_narrow(Rect area) { return area.w < narrow * area.h; }

// In a narrow free area the floor covers less.
float cover_for(Rect free_area) {
    return wanted_cover * std::min(1.0f, free_area.w / std::max(free_area.h, 1.0f) / narrow);
}

float share_of(const FloorBox& box, const Snapshot& now, const VehicleView& vehicle, const FramingInput& in) {
    const CameraView seen = look(in.camera, now.scene->arena, nullptr, in.window, in.free_area, &box);
    const float wanted = std::max(in.least_share * in.free_area.w, 1.0f);
    return kind_of(now, vehicle).body.length * pixels_per_metre(seen, {vehicle.x, vehicle.y}) / wanted;
}

// A part of the box, as near to its middle as `inside` allows, which lies in the part if there is room.
FloorBox shrunk(const FloorBox& box, float part, const FloorBox& inside) {
    const vec2 half = (box.high - box.low) * (part * 0.5f), middle = (box.low + box.high) / 2.0f;
    const auto kept = [](float at, float side, float low, float high) {
        return high - low > 2 * side ? (low + high) / 2 : std::clamp(at, high - side, low + side);
    };
    const vec2 place{kept(middle.x, half.x, inside.low.x, inside.high.x),
                     kept(middle.y, half.y, inside.low.y, inside.high.y)};
    return {place - half, place + half};
}

// The box, shrunk around the vehicle until it has its wanted length on the screen.
FloorBox enlarged(FloorBox box, const Snapshot& now, const VehicleView& vehicle, const FramingInput& in) {
    FloorBox around = nothing;
    include(around, {vehicle.x, vehicle.y}, scale_of(now.scene->arena) * around_vehicle);
    for (int i = 0; i < 4; ++i) {
        const float share = share_of(box, now, vehicle, in);
        if (share >= 1) break;
        box = shrunk(box, share, around);
    }
    return box;
}

// Vehicles, sources and tape. False if there is neither a source nor tape: the whole floor is the aim.
bool include_action(FloorBox& box, const Snapshot& now) {
    const float scale = scale_of(now.scene->arena);
    for (const VehicleView& v : now.vehicles) include(box, {v.x, v.y}, scale * around_vehicle);
    for (const SourceView& s : now.sources) include(box, {s.x, s.y}, scale * around_source);
    return include_tape(box, *now.scene) || !now.sources.empty();
}

float size_of(float value) { return std::fabs(value); }
float size_of(vec2 value) { return maths::length(value); }

// Moves `value` to `goal` without a jump of its speed (per second): a spring with critical damping.
template <class Value>
void glide(Value& value, Value& speed, Value goal, float seconds) {
    constexpr float near = 0.003f, slow = 0.01f;
    const float t = seconds / time_constant, rest = std::exp(-t);
    const Value away = value - goal, pull = speed + away * (1 / time_constant);
    value = goal + (away + pull * seconds) * rest;
    speed = (speed - pull * t) * rest;
    if (size_of(value - goal) < near && size_of(speed) < slow) value = goal, speed = {};
}

// The side of a line at which dot(normal, p) is at least `least`.
struct Edge {
    vec2 normal;
    float least = 0;
};

// The part of a convex polygon on this side of the line.
std::vector<vec2> cut(const std::vector<vec2>& polygon, const Edge& edge) {
    std::vector<vec2> part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec2 from = polygon[i], to = polygon[(i + 1) % polygon.size()];
        const float a = maths::dot(edge.normal, from) - edge.least, b = maths::dot(edge.normal, to) - edge.least;
        if (a >= 0) part.push_back(from);
        if ((a >= 0) != (b >= 0)) part.push_back(from + (to - from) * (a / (a - b)));
    }
    return part;
}

float area_of(const std::vector<vec2>& polygon) {
    float twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::fabs(twice) / 2;
}

bool is_default_elevation(const Camera& camera) { return !camera.turned && camera.elevation == Camera{}.elevation; }

}  // namespace

FloorBox action_of(const Snapshot& now) {
    if (!now.scene) return whole(Arena{});
    FloorBox box = nothing;
    const bool has_aim = include_action(box, now);
    include_obstacles(box, now);
    return has_aim ? within(box, now.scene->arena) : whole(now.scene->arena);
}

float floor_cover(const CameraView& seen, const Arena& arena, Rect area) {
    const float wall = has_walls(arena.edge) ? wall_of(arena).thickness : 0;
    const vec2 half{arena.width / 2 + wall, arena.height / 2 + wall};
    // The part of the floor that lies below the area. The view of a plane is a plane's: its corners decide.
    std::vector<vec2> floor;
    for (const vec2 corner : {vec2{-half.x, -half.y}, {half.x, -half.y}, half, {-half.x, half.y}}) {
        const auto at = project(seen, corner);
        if (!at) return 0;
        floor.push_back(*at);
    }
    for (const Edge& edge :
         {Edge{{1, 0}, area.x}, {{-1, 0}, -area.x - area.w}, {{0, 1}, area.y}, {{0, -1}, -area.y - area.h}})
        floor = cut(floor, edge);
    return area_of(floor) / std::max(area.w * area.h, 1.0f);
}

Camera Framing::raised(Camera camera) const {
    if (is_default_elevation(camera)) camera.elevation = elevation_;
    return camera;
}

// The nearest source that shines; another one only once it is clearly nearer.
std::optional<int> Framing::nearest_source(const Snapshot& now, vec2 place) const {
    const SourceView* best = nullptr;
    const auto distance = [&](const SourceView& s) {
        return maths::distance(place, {s.x, s.y}) * (nearest_ == s.source ? nearer : 1.0f);
    };
    for (const SourceView& s : now.sources)
        if (s.strength != 0 && (!best || distance(s) < distance(*best))) best = &s;
    return best ? std::optional(best->source) : std::nullopt;
}

// What must be in the picture: the present vehicles and the chosen sources. Many vehicles keep the places where they
// have been, too, since the box would change all the time.
FloorBox Framing::needed_now(const Snapshot& now, const FramingInput& in, const Choice& choice) const {
    const float scale = scale_of(now.scene->arena);
    FloorBox box = now.vehicles.size() > few_vehicles ? *driven_ : nothing;
    for (const VehicleView& each : now.vehicles) {
        const vec2 place{each.x, each.y};
        const float around = scale * (each.id == in.selected ? around_vehicle : around_other);
        FloorBox own = nothing;
        include(own, place, around);
        const bool leaves = gives_room_ && !contains(goal_, within(own, now.scene->arena));
        if (leaves) include(own, place + maths::direction(each.heading) * (scale * ahead_of_vehicle), around);
        box = both(box, own);
    }
    for (const SourceView& s : now.sources)
        if (choice.sources == Sources::all || (choice.sources == Sources::nearest && nearest_ == s.source))
            include(box, {s.x, s.y}, scale * around_lamp);
    return in.beside ? both(box, *in.beside) : box;
}

FloorBox Framing::wanted(const Snapshot& now, FramingInput in, const Choice& choice) const {
    const Arena arena = now.scene ? now.scene->arena : Arena{};
    if (is_default_elevation(in.camera)) in.camera.elevation = choice.elevation;
    FloorBox box = widened(in.close_up ? within(*in.close_up, arena) : *grown_, in, arena);
    if (in.close_up || !now.scene || now.vehicles.empty()) return box;
    const FloorBox needed = within(needed_now(now, in, choice), arena);
    if (is_narrow(in.free_area)) return both(box, needed);
    const VehicleView* vehicle = now.vehicles.size() <= few_vehicles ? find_vehicle(now, in.selected) : nullptr;
    // The walls of a table and the numbers beside them are not cut off for a slightly larger robot.
    const bool is_table = scale_of(arena) < 1 && contains(box, whole(arena));
    if (is_table && (!vehicle || share_of(box, now, *vehicle, in) >= enough_on_table)) return box;
    if (choice.part < 1) {
        box = both(shrunk(box, choice.part, needed), needed);
        if (choice.fills) box = widened(box, in, arena);
    }
    return vehicle ? both(enlarged(box, now, *vehicle, in), needed) : box;
}

// The elevation and the part of the box with which the vehicle has its size and the floor covers its share of the free
// area, as nearly as possible. Sources farther than the nearest one are left out only if the vehicle is larger then,
// the nearest one only if the vehicle is very small with it.
Framing::Choice Framing::choose(const Snapshot& now, const FramingInput& in, bool is_level) const {
    const Arena arena = now.scene ? now.scene->arena : Arena{};
    const VehicleView* vehicle = now.vehicles.size() <= few_vehicles ? find_vehicle(now, in.selected) : nullptr;
    struct Rated {
        Choice choice;
        float share = 1, cover = 0, worth = -1;
    };
    const auto rate = [&](Choice choice) {
        Rated r{choice};
        FramingInput tilted = in;
        if (is_default_elevation(in.camera)) tilted.camera.elevation = choice.elevation;
        const FloorBox box = wanted(now, tilted, choice);
        float share_of_room = 1;
        if (vehicle && now.scene) {
            r.share = std::min(1.0f, share_of(box, now, *vehicle, tilted));
            FramingInput larger = tilted;
            larger.least_share *= room_to_drive;
            share_of_room = std::min(1.0f, share_of(wanted(now, larger, choice), now, *vehicle, larger));
        }
        const CameraView seen = look(tilted.camera, arena, nullptr, in.window, in.free_area, &box);
        r.cover = std::min(1.0f, floor_cover(seen, arena, in.free_area) / (cover_for(in.free_area) + cover_to_drive));
        r.worth = 3 * r.share + 1.5f * r.cover + 0.5f * share_of_room -
                  0.1f * std::fabs(choice.elevation - Camera{}.elevation);
        if (rests_ && choice.elevation == choice_.elevation) r.worth += worth_of_rest;
        return r;
    };
    // The largest part that covers enough, or the whole; the whole once something has left the picture.
    const auto best_part = [&](Choice choice) {
        const Rated whole_box = rate(choice);
        if (is_narrow(in.free_area) || gives_room_) return whole_box;
        choice.part = least_part;
        Rated best = rate(choice);
        float enough = least_part, too_much = 1;
        for (int i = 0; best.cover >= 1 && whole_box.cover < 1 && i < 5; ++i) {
            choice.part = (enough + too_much) / 2;
            const Rated between = rate(choice);
            (between.cover >= 1 ? enough : too_much) = choice.part;
            if (between.cover >= 1) best = between;
        }
        return whole_box.cover < 1 && best.worth > whole_box.worth + 0.02f ? best : whole_box;
    };
    const auto best_with = [&](Sources sources) {
        Rated best;
        for (const float elevation : elevations) {
            if (!is_default_elevation(in.camera) && elevation != elevations.front()) continue;
            if (is_default_elevation(in.camera) && is_level && elevation != choice_.elevation) continue;
            for (const bool fills : {false, true})
                if (const Rated r = best_part({elevation, 1, sources, fills}); r.worth > best.worth) best = r;
        }
        return best;
    };
    // The sources in the picture stay the same, too, unless another choice is clearly better.
    const auto is_enough = [&](const Rated& r, float enough) {
        return r.share >= enough - (rests_ && r.choice.sources == choice_.sources ? share_of_rest : 0);
    };
    Rated best = best_with(Sources::all);
    if (is_narrow(in.free_area) || is_enough(best, enough_with_all) || now.sources.empty()) return best.choice;
    const auto take_if_larger = [&](const Rated& other) {
        if (other.share > best.share + 0.02f) best = other;
    };
    take_if_larger(best_with(Sources::nearest));
    if (!is_enough(best, enough_with_source)) take_if_larger(best_with(Sources::none));
    return best.choice;
}

// Whether the picture to which the camera glides shows all vehicles, the nearest source where one stays in the picture,
// and what is shown beside the run.
bool Framing::is_in_sight(const Snapshot& now, const FramingInput& in) const {
    if (!now.scene || in.close_up) return true;
    const Arena& arena = now.scene->arena;
    Camera camera = in.camera;
    if (is_default_elevation(camera)) camera.elevation = choice_.elevation;
    const CameraView seen = look(camera, arena, nullptr, in.window, in.free_area, &goal_);
    const auto holds = [&](vec2 place, float radius) {
        FloorBox box = nothing;
        include(box, place, scale_of(arena) * radius);
        return contains(goal_, within(box, arena));
    };
    const auto shows = [&](const Rect& r) {
        const Rect& area = in.free_area;
        return r.x >= area.x && r.y >= area.y && r.x + r.w <= area.x + area.w && r.y + r.h <= area.y + area.h;
    };
    const auto shows_vehicle = [&](const VehicleView& each) {
        if (holds({each.x, each.y}, around_other)) return true;
        VehicleView soon = each;
        const vec2 way = maths::direction(each.heading) * (each.speed * seconds_ahead);
        soon.x += way.x, soon.y += way.y;
        return shows(picture_of(now, seen, each)) && shows(picture_of(now, seen, soon));
    };
    const auto shows_source = [&](const SourceView& s) {
        return nearest_ != s.source || holds({s.x, s.y}, around_lamp) || shows(picture_of(now, seen, s));
    };
    return std::all_of(now.vehicles.begin(), now.vehicles.end(), shows_vehicle) &&
           (choice_.sources == Sources::none || std::all_of(now.sources.begin(), now.sources.end(), shows_source)) &&
           (!in.beside || contains(goal_, within(*in.beside, arena)));
}

FloorBox Framing::follow(const Snapshot& now, const FramingInput& in) {
    const std::string name = now.scene ? now.scene->name : std::string{};
    if (now.seed != seed_ || now.generation != generation_ || name != scene_) start_over();
    // A run that is back at its start has the picture of the start, which the camera reaches by a glide.
    if (now.tick == 0 && tick_ > 0) grown_.reset(), place_.reset(), rests_ = false;
    seed_ = now.seed, generation_ = now.generation, scene_ = name, tick_ = now.tick;
    const bool moved = in.camera.zoom != 1 || !(in.camera.pan == vec2{});
    if (shown_ && (in.held || moved)) return speed_ = {}, turning_ = 0, *shown_;

    const Arena arena = now.scene ? now.scene->arena : Arena{};
    const VehicleView* vehicle = find_vehicle(now, in.selected);
    FloorBox action = action_of(now);
    if (in.beside) action = within(both(action, *in.beside), arena);
    const std::optional<FloorBox> before = grown_;
    if (!grown_)
        grown_ = action, driven_ = nothing, nearest_.reset();
    else if (!contains(with_border(*grown_, scale_of(arena) * left_free), action))
        grown_ = both(both(*grown_, action), within(beyond(*grown_, action, scale_of(arena)), arena));
    if (now.scene) include_action(*driven_, now);
    const bool are_few = now.vehicles.size() <= few_vehicles;
    const auto nearest = vehicle && are_few ? nearest_source(now, {vehicle->x, vehicle->y}) : std::nullopt;
    const Reason reason{in.free_area, in.camera.elevation, in.camera.mode, in.least_share, in.close_up.has_value()};
    const bool is_new = !shown_ || !before || !(reason == reason_);
    if (!in.paused) glides_ = false;
    if (in.paused && is_new) glides_ = true;
    if (in.paused && !glides_ && contains(with_border(*shown_, scale_of(arena) * left_free), action))
        return speed_ = {}, turning_ = 0, *shown_;
    nearest_ = nearest;
    if (is_new || !is_in_sight(now, in)) {
        if (is_new || now.tick < raised_at_.value_or(0)) raised_at_.reset();
        gives_room_ = !is_new;
        FramingInput roomy = in;
        if (gives_room_) roomy.least_share *= share_to_rest;
        const Choice next = choose(now, roomy, raised_at_ && now.tick < *raised_at_ + ticks_of_elevation);
        if (!is_new && next.elevation != choice_.elevation) raised_at_ = now.tick;
        choice_ = next, rests_ = true, reason_ = reason;
        goal_ = wanted(now, roomy, choice_);
    } else if (in.close_up) {
        goal_ = wanted(now, in, choice_);
    }
    // A glide would not show the vehicle until its end.
    const std::optional<vec2> place = vehicle && are_few ? std::optional(vec2{vehicle->x, vehicle->y}) : std::nullopt;
    const bool has_crossed = place && place_ && crosses_seam(*place_, *place, arena);
    place_ = place;
    if (!shown_ || in.seconds <= 0 || has_crossed) {
        speed_ = {}, turning_ = 0, elevation_ = choice_.elevation, glides_ = false;
        return *(shown_ = goal_);
    }
    glide(shown_->low, speed_.low, goal_.low, in.seconds);
    glide(shown_->high, speed_.high, goal_.high, in.seconds);
    glide(elevation_, turning_, choice_.elevation, in.seconds);
    if (*shown_ == goal_ && elevation_ == choice_.elevation) glides_ = false;
    return *shown_;
}

}  // namespace braitenlab
