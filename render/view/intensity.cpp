#include "render/view/intensity.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "core/world/eye.h"
#include "core/world/ground.h"
#include "core/world/outline.h"
#include "core/world/seam.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float most_sums = 3e5f;  // samples times stimuli of one update

bool is_light(Channel c) {
    return c == Channel::light || c == Channel::red || c == Channel::green || c == Channel::blue;
}

bool is_of_vehicles(Channel c) { return c == Channel::predator || c == Channel::prey || c == Channel::vehicle; }

const Kind* kind_of(const Snapshot& now, const VehicleView& v) {
    const auto i = static_cast<std::size_t>(v.kind);
    return now.scene && i < now.scene->kinds.size() ? &now.scene->kinds[i] : nullptr;
}

// The eye that measures: it looks all round from the vehicle's origin.
Sensor measuring_eye(const Snapshot& now, Channel channel, VehicleId asking) {
    Sensor eye;
    eye.channel = channel;
    if (const VehicleView* v = find_vehicle(now, asking))
        if (const Kind* kind = kind_of(now, *v))
            for (const Sensor& own : kind->sensors)
                if (own.channel == channel) {
                    eye = own;
                    break;
                }
    eye.name.clear();
    eye.x = eye.y = eye.angle = eye.noise = eye.latency = 0;
    eye.field = 2 * maths::pi, eye.shape = SensorShape::omni;
    return eye;
}

// Where obstacles are now: as the scene says where the moment does not.
std::vector<Pose> poses_of(const Snapshot& now) {
    std::vector<Pose> poses = now.obstacles;
    const auto& obstacles = now.scene->obstacles;
    for (std::size_t i = poses.size(); i < obstacles.size(); ++i)
        poses.push_back({obstacles[i].x, obstacles[i].y, obstacles[i].heading});
    poses.resize(obstacles.size());
    return poses;
}

Outlines outlines_of(const Scene& scene, const std::vector<Pose>& poses) {
    std::vector<Motion> motions;
    for (const Pose& pose : poses) motions.push_back(at_rest(pose));
    return Outlines(scene, motions);
}

}  // namespace

IntensityMap::Cause IntensityMap::cause_of(const Snapshot& now, Channel channel, VehicleId asking) {
    Cause cause;
    cause.channel = channel;
    if (!now.scene) return cause;
    cause.scene = now.scene;
    cause.eye = measuring_eye(now, channel, asking);
    if (channel == Channel::obstacle || is_blocked_by_obstacles(channel)) cause.obstacles = poses_of(now);
    if (channel == Channel::memory) {
        for (const MarkView& m : now.marks)
            if (m.owner == asking) cause.stimuli.push_back({{m.x, m.y}, m.strength});
        return cause;
    }
    for (const SourceView& s : now.sources)
        if (is_seen_as(s.channel, channel)) cause.stimuli.push_back({{s.x, s.y}, s.strength});
    const Role wanted = channel == Channel::predator ? Role::predator : Role::prey;
    for (const VehicleView& v : now.vehicles) {
        if (v.id == asking) continue;
        if (is_of_vehicles(channel) && (channel == Channel::vehicle || v.role == wanted))
            cause.stimuli.push_back({{v.x, v.y}, 1});
        const Kind* kind = kind_of(now, v);
        if (!kind) continue;
        for (const CarriedLamp& lamp : kind->lamps)
            if (is_seen_as(lamp.channel, channel))
                cause.stimuli.push_back(
                    {vec2{v.x, v.y} + maths::rotate({lamp.x, lamp.y}, maths::direction(v.heading)), lamp.strength});
    }
    return cause;
}

bool IntensityMap::update(const Snapshot& now, Channel channel, VehicleId asking) {
    Cause cause = cause_of(now, channel, asking);
    if (grid_.columns > 0 && cause == cause_) return false;
    cause_ = std::move(cause);
    if (!cause_.scene) {
        grid_ = {2, 2, {0, 0, 0, 0}};
        return true;
    }
    const Arena& arena = cause_.scene->arena;
    const Eye eye(cause_.eye);
    const Outlines outlines = outlines_of(*cause_.scene, cause_.obstacles);
    const Ground ground(*cause_.scene);
    const Seam seam(arena);
    const auto felt_at = [&](vec2 place) {
        const Gaze gaze = carry(eye, place, {1, 0});
        if (channel == Channel::floor) return ground.floor_at(place).reflectance;
        if (channel == Channel::obstacle) return outlines.total(eye, gaze);
        const bool may_hide = is_blocked_by_obstacles(channel) && outlines.any_obstacle_near(place, eye.range);
        float sum = is_light(channel) ? arena.ambient : 0;
        for (const Stimulus& s : cause_.stimuli) {
            const vec2 at = place + seam.shortest(s.place - place);
            const float strength = answer(eye, gaze, at, s.strength);
            if (strength > 0 && !(may_hide && outlines.hide(place, at))) sum += strength;
        }
        return sum;
    };

    const std::size_t in_the_way = is_blocked_by_obstacles(channel) ? cause_.obstacles.size() : 0;
    const std::size_t sums =
        channel == Channel::obstacle ? cause_.obstacles.size() + 4 : cause_.stimuli.size() * (1 + in_the_way);
    const float samples = most_sums / static_cast<float>(std::max<std::size_t>(sums, 1));
    const float aspect = arena.width / arena.height;
    const auto side = [](float wanted, int most) { return std::clamp(static_cast<int>(wanted), 24, most); };
    grid_.columns = side(std::sqrt(samples * aspect), Intensity::most_columns);
    grid_.rows = side(std::sqrt(samples / aspect), Intensity::most_rows);
    grid_.values.resize(static_cast<std::size_t>(grid_.columns * grid_.rows));
    std::size_t i = 0;
    for (int row = 0; row < grid_.rows; ++row)
        for (int column = 0; column < grid_.columns; ++column) {
            const float x = static_cast<float>(column) / static_cast<float>(grid_.columns - 1) - 0.5f;
            const float y = static_cast<float>(row) / static_cast<float>(grid_.rows - 1) - 0.5f;
            grid_.values[i++] = std::min(felt_at({x * arena.width, y * arena.height}), 1.0f);
        }
    return true;
}

bool has_field(Channel channel) { return channel != Channel::touch && channel != Channel::energy; }

std::vector<Channel> channels_with_field(const Snapshot& now) {
    std::vector<Channel> found;
    if (!now.scene) return found;
    const Scene& scene = *now.scene;
    const auto any_seen_as = [&](const auto& things, Channel c) {
        return std::any_of(things.begin(), things.end(),
                           [&](const auto& thing) { return is_seen_as(thing.channel, c); });
    };
    const auto sensed = [&](Channel c) {
        return std::any_of(scene.kinds.begin(), scene.kinds.end(), [&](const Kind& kind) {
            return std::any_of(kind.sensors.begin(), kind.sensors.end(),
                               [&](const Sensor& s) { return s.channel == c; });
        });
    };
    for (int i = 0; i < channel_count; ++i) {
        const auto c = static_cast<Channel>(i);
        if (!has_field(c)) continue;
        // Colours of light are told apart only where somebody does.
        const bool is_colour = is_light(c) && c != Channel::light;
        const bool carried = std::any_of(scene.kinds.begin(), scene.kinds.end(),
                                         [&](const Kind& kind) { return any_seen_as(kind.lamps, c); });
        const bool given = any_seen_as(now.sources, c) || carried;
        if (is_colour ? given && sensed(c) : given || sensed(c)) found.push_back(c);
    }
    return found;
}

}  // namespace braitenlab
