#include "core/scene/size_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/messages.h"
#include "core/scene/arena.h"
#include "core/scene/enums.h"
#include "core/scene/scene.h"

namespace braitenlab {

namespace {

double vehicle_count(const Scene& scene) { return static_cast<double>(scene.starts.size()) + scene.ecology.population; }

PresentParts parts_of(const Scene& scene) {
    PresentParts parts;
    for (const Kind& kind : scene.kinds) parts.of_kinds.push_back(&kind.brain);
    const auto add_own = [&](const auto& one) {
        if (one.brain || one.sensors)
            parts.of_vehicles.push_back({one.brain ? &*one.brain : nullptr, one.sensors ? &*one.sensors : nullptr});
    };
    for (const Start& start : scene.starts) add_own(start);
    for (const Member& member : scene.members) add_own(member);
    return parts;
}

// A world keeps about a dozen copies of its state; the limit keeps an untrusted file from filling the memory.
std::optional<Fault> memory_fault(const Scene& scene, const PresentParts& parts) {
    constexpr double most = 1 << 24;  // numbers, in all brains and all sensors' latencies
    double largest = 0;
    const auto numbers_of = [](const BrainGraph* brain, const std::vector<Sensor>* sensors) {
        double numbers = brain ? static_cast<double>(brain->nodes.size() + brain->wires.size()) : 0;
        if (sensors)
            for (const Sensor& sensor : *sensors) numbers += 1 + static_cast<double>(sensor.latency) / tick_seconds;
        return numbers;
    };
    for (std::size_t k = 0; k < scene.kinds.size(); ++k)
        largest = std::max(largest, numbers_of(parts.of_kinds[k], &scene.kinds[k].sensors));
    for (const PresentParts::Own& own : parts.of_vehicles)
        largest = std::max(largest, numbers_of(own.brain, own.sensors));
    const double vehicles = vehicle_count(scene);
    if (vehicles * largest <= most) return std::nullopt;
    return Fault{"ecology.population", message_of("too_much_memory", std::llround(vehicles), std::llround(largest),
                                                  static_cast<long>(most / largest))};
}

double floor_area(const Body& body) { return static_cast<double>(body.length) * body.width; }

// Vehicles that cannot stand side by side overlap, and physics pushes each away from all the others in it: a tick of
// 20,000 in 20 × 20 m would take longer than half a minute. Scenes of a few vehicles are not judged.
std::optional<Fault> density_fault(const Scene& scene) {
    constexpr int always_allowed = 100;
    const int vehicles = static_cast<int>(scene.starts.size()) + scene.ecology.population;
    if (vehicles <= always_allowed) return std::nullopt;
    double shares = 0, of_one = 0, placed = 0;
    for (const Kind& kind : scene.kinds)
        shares += static_cast<double>(kind.share), of_one += static_cast<double>(kind.share) * floor_area(kind.body);
    of_one = shares > 0 ? of_one / shares : scene.kinds.empty() ? 0 : floor_area(scene.kinds.front().body);
    for (const Start& start : scene.starts)
        placed += floor_area(scene.kinds[static_cast<std::size_t>(find_kind(scene, start.kind))].body);
    const double round = scene.arena.round ? maths::pi_d / 4 : 1;
    const double floor = static_cast<double>(scene.arena.width) * static_cast<double>(scene.arena.height) * round;
    const double covered = placed + of_one * scene.ecology.population;
    if (covered <= floor) return std::nullopt;
    const int most = std::max(always_allowed, static_cast<int>(vehicles * floor / covered));
    const auto [area, arena] = told_apart(covered, floor, Digits::behind_point, 0);
    return Fault{"ecology.population", message_of("too_dense", vehicles, area, arena, most)};
}

// Where the file places vehicles: squares of the floor as long as the longest vehicle, and how many stand in each.
class PlacedVehicles {
public:
    explicit PlacedVehicles(const Scene& scene) {
        for (const Kind& kind : scene.kinds) {
            side_ = std::max({side_, kind.body.length, kind.body.width});
            smallest_ = std::min(smallest_, floor_area(kind.body));
        }
        const auto place = [&](const auto& own) {
            const int vehicles = ++squares_[{std::llround(own.x / side_), std::llround(own.y / side_)}];
            most_ = std::max(most_, vehicles);
        };
        for (const Start& start : scene.starts) place(start);
        for (const Member& member : scene.members)
            if (member.placed) place(member);
    }

    float side() const { return side_; }  // m
    int most() const { return most_; }    // in one square
    // How many times as many as find room side by side, where most are; at least 1.
    double crowding() const { return std::max(1.0, most_ / room()); }
    double smallest() const { return smallest_; }  // m², floor of the smallest vehicle

    // Calls each(vehicles, others) for the vehicles of each square and those of the nine squares around, less those
    // that find room there side by side, where physics keeps them: these overlap.
    void for_each_overlap(const auto& each) const {
        if (most_ <= room()) return;
        for (const auto& [at, vehicles] : squares_) {
            double near = 0;
            for (std::int64_t x = at.first - 1; x <= at.first + 1; ++x) {
                const auto end = squares_.upper_bound({x, at.second + 1});
                for (auto other = squares_.lower_bound({x, at.second - 1}); other != end; ++other)
                    near += other->second;
            }
            if (near > 9 * room()) each(static_cast<double>(vehicles), near - 9 * room());
        }
    }

private:
    double room() const { return static_cast<double>(side_) * static_cast<double>(side_) / smallest_; }  // of a square

    float side_ = 0;
    double smallest_ = std::numeric_limits<double>::max();
    std::map<std::pair<std::int64_t, std::int64_t>, int> squares_;  // vehicles by place, in sides
    int most_ = 0;
};

// The same for vehicles that the file places: only so many on the floor of one.
std::optional<Fault> crowd_fault(const PlacedVehicles& placed) {
    constexpr int most = 32;
    if (placed.most() <= most) return std::nullopt;
    return Fault{"", message_of("too_crowded", most, fmt::format("{:.3g}", placed.side()))};
}

// What parts of a tick cost, each measured in scenes that consist of it (tests/core/size_limits_test.cpp). The unit is
// the comparison of a sensor with a stimulus, 2.5 ns on a core of 2.1 GHz.
namespace cost {
constexpr double vehicle = 350, pair = 600, movable_pair = 1200;  // pair: of bodies that may touch
constexpr double fixed_pair = 10;    // of obstacles that overlap, which the first tick finds
constexpr double contact = 1;        // of a body, for each new one: Box2D compares it with those that the body has
constexpr double impact = 10;        // of vehicles that zones push: for each vehicle that may hit something meanwhile
constexpr double slow_stimulus = 6;  // of a photocell or a table, or on a torus
constexpr double hiding_side = 0.4;  // of an obstacle that may be before a stimulus
constexpr double outline_side = 14, noise = 6, mark = 16, in_zone = 8;
constexpr double node = 10, wire = 2, curved_wire = 12;
constexpr double birth = 1800;  // of a vehicle of a new generation
}  // namespace cost

// Half the sides of the rectangle around a polygon, in its frame.
maths::vec2 extent_of(const std::vector<maths::vec2>& corners) {
    maths::vec2 most;
    for (const maths::vec2 c : corners) most = {std::max(most.x, std::fabs(c.x)), std::max(most.y, std::fabs(c.y))};
    return most;
}

double area_of(const std::vector<maths::vec2>& corners) {
    float twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twice += maths::cross(corners[i], corners[(i + 1) % corners.size()]);
    return static_cast<double>(twice / 2);
}

// Pairs of obstacles that are near each other. A drag of an obstacle asks at each of its steps, so only those are
// compared that overlap along one axis.
class ObstaclePairs {
public:
    explicit ObstaclePairs(const std::vector<Obstacle>& obstacles) {
        maths::vec2 low{std::numeric_limits<float>::max(), std::numeric_limits<float>::max()}, high = -low;
        for (const Obstacle& each : obstacles) {
            low = {std::min(low.x, each.x), std::min(low.y, each.y)};
            high = {std::max(high.x, each.x), std::max(high.y, each.y)};
        }
        const bool is_tall = high.y - low.y > high.x - low.x;
        for (const Obstacle& each : obstacles) {
            const auto corners = corners_of(each);
            const float reach = margin + maths::length(extent_of(corners));
            const maths::vec2 at = is_tall ? maths::vec2{each.y, each.x} : maths::vec2{each.x, each.y};
            all_.push_back({at, reach, each.mass > 0});
            if (each.mass <= 0) continue;
            reaches_.push_back(reach);
            areas_.push_back(area_of(corners));
        }
        std::sort(all_.begin(), all_.end(), [](const auto& a, const auto& b) { return a.begin() < b.begin(); });
        std::sort(reaches_.begin(), reaches_.end());
        std::sort(areas_.begin(), areas_.end());
    }

    double work() const {
        double all = 0, movable = 0;  // at the places of the scene, where obstacles may overlap
        each_near(all_, 0, [&](std::size_t i, std::size_t j) {
            ++all;
            movable += all_[i].is_movable || all_[j].is_movable;
        });
        if (!reaches_.empty()) movable = std::max(movable, when_pushed());
        return cost::fixed_pair * all + cost::movable_pair * movable;
    }

private:
    static constexpr float margin = 0.1f;  // m, by which Box2D grows a body in its search for pairs
    struct Circle {
        maths::vec2 at;  // m; x along the longer side of the rectangle around all
        float reach;     // m, with the margin
        bool is_movable;
        float begin() const { return at.x - reach; }
    };
    // Calls f with each two that are nearer than `between` (m).
    template <class F>
    static void each_near(const std::vector<Circle>& by_begin, float between, F f) {
        for (std::size_t i = 0; i < by_begin.size(); ++i) {
            const Circle& a = by_begin[i];
            const float end = a.at.x + a.reach + between;
            for (std::size_t j = i + 1; j < by_begin.size() && by_begin[j].begin() < end; ++j) {
                const maths::vec2 apart = a.at - by_begin[j].at;
                const float reach = a.reach + by_begin[j].reach + between;
                if (maths::dot(apart, apart) < reach * reach) f(i, j);
            }
        }
    }
    // At most, wherever vehicles push them. Physics keeps those apart that are pushed: the smaller ones near one,
    // whole, find room in thrice its circle.
    double when_pushed() const {
        std::vector<double> of_smallest = areas_;  // of the first, the first two …
        for (std::size_t i = 1; i < of_smallest.size(); ++i) of_smallest[i] += of_smallest[i - 1];
        double pairs = static_cast<double>(reaches_.size()) * densest_fixed();
        for (std::size_t i = 0; i < reaches_.size(); ++i) {
            const auto around = static_cast<double>(3 * reaches_[i] - margin);
            const auto room = std::upper_bound(of_smallest.begin(), of_smallest.end(), maths::pi_d * around * around);
            pairs += std::min(static_cast<double>(i), static_cast<double>(room - of_smallest.begin()));
        }
        return pairs;
    }
    // The most fixed obstacles that one which is pushed can be near at a time.
    double densest_fixed() const {
        std::vector<Circle> fixed;
        std::copy_if(all_.begin(), all_.end(), std::back_inserter(fixed), [](const auto& c) { return !c.is_movable; });
        std::vector<int> beside(fixed.size(), 1);
        each_near(fixed, 2 * reaches_.back(), [&](std::size_t i, std::size_t j) { ++beside[i], ++beside[j]; });
        return beside.empty() ? 0 : *std::max_element(beside.begin(), beside.end());
    }

    std::vector<Circle> all_;     // by their begin
    std::vector<float> reaches_;  // m, of those that can be pushed, ascending
    std::vector<double> areas_;   // m², of these, ascending
};

// The work of a tick at most, wherever vehicles gather and push obstacles: of sensors, brains, wheels and bodies near
// each other.
class WorkOfATick {
public:
    WorkOfATick(const Scene& scene, const PresentParts& parts, const PlacedVehicles& placed)
        : scene_(scene), parts_(parts), placed_(placed), vehicles_(vehicle_count(scene)) {
        const auto force = [](const Zone& z) { return std::fabs(z.wind_x) + std::fabs(z.wind_y) + std::fabs(z.pull); };
        float push = 0, fastest = 0;  // N, m/s
        double beyond = 0;            // wheels beside a chassis, which are bodies of their own
        for (const Zone& zone : scene.zones) push += force(zone);
        for (const Kind& kind : scene.kinds) {
            const Body& body = kind.body;
            marks_ = std::max(marks_, static_cast<double>(kind.memory.marks));
            side_ = std::max(side_, std::hypot(body.length, body.width));
            fastest = std::max({fastest, body.top_speed * voltage_share(body), push / body.mass});  // after a second
            double outside = 0;
            for (const Wheel& w : body.wheels) {
                const maths::vec2 sides{2 * (std::fabs(w.x) + w.radius), 2 * std::fabs(w.y) + w.width};
                side_ = std::max(side_, maths::length(sides));
                outside += sides.x > body.length + 0.01f || sides.y > body.width + 0.01f;
            }
            beyond = std::max(beyond, outside);
        }
        // Box2D adds a margin of 0.1 m to a body, and four times the way of a tick, which is 2 m at most.
        const float body = side_ + 0.2f + 4 * std::min(fastest * tick_seconds, 2.0f);
        const float cell = std::max(scene.arena.width, scene.arena.height) / 64;  // m
        touched_ = std::min(vehicles_, static_cast<double>(4 * body * body) * vehicles_ / floor()) / 2;
        touched_ *= 1 + beyond / 4;
        for (const Obstacle& obstacle : scene.obstacles) {
            hiding_sides_ += static_cast<double>(corners_of(obstacle).size());
            touched_ += (1 + beyond) * share_in(extent_of(corners_of(obstacle)), body);
        }
        const float post = source_radius(scene.arena);
        for (const Source& source : scene.sources)
            if (source.solid) touched_ += (1 + beyond) * share_in({post, post}, body);
        for (const Zone& zone : scene.zones) {
            const maths::vec2 extent = extent_of(corners_of(zone));
            zones_ += share_in(extent, cell) * images(maths::length(extent));
            if (force(zone) > 0) impacts_ += vehicles_ * share_in(extent, 0);
        }
        const std::size_t walls = scene.arena.round ? round_corners(scene.arena).size() : 4;
        sides_ = hiding_sides_ + static_cast<double>(has_walls(scene.arena.edge) ? walls : 0);
        for (const Source& source : scene.sources) sides_ += source.solid ? 8 : 0;
        for (const ChannelTraits& row : channel_table) {
            const auto is_seen = [&](const auto& lamp) { return is_seen_as(lamp.channel, row.value); };
            const auto channel = static_cast<std::size_t>(row.value);
            fixed_[channel] = static_cast<double>(std::count_if(scene.sources.begin(), scene.sources.end(), is_seen));
            for (const Kind& kind : scene.kinds)
                carried_[channel] =
                    std::max(carried_[channel],
                             static_cast<double>(std::count_if(kind.lamps.begin(), kind.lamps.end(), is_seen)));
        }
        for (const Channel body_of : {Channel::predator, Channel::prey, Channel::vehicle})
            ++carried_[static_cast<std::size_t>(body_of)];
    }

    double total() const {
        double own = 0, largest = 0;
        for (const PresentParts::Own& one : parts_.of_vehicles)
            own += (one.sensors ? of(*one.sensors) : 0) + (one.brain ? of(*one.brain) : 0);
        for (std::size_t k = 0; k < scene_.kinds.size(); ++k) {
            const Kind& kind = scene_.kinds[k];
            largest = std::max(largest, of(kind.sensors) + of(*parts_.of_kinds[k]) +
                                            cost::in_zone * zones_ * static_cast<double>(kind.body.wheels.size() + 2));
        }
        const double born = cost::birth * new_generations();
        return vehicles_ * (cost::vehicle + of_touched(touched_) + cost::impact * impacts_ + largest + born) + own +
               of_overlaps() + ObstaclePairs(scene_.obstacles).work();
    }

private:
    // In a tick, at most, where no vehicle moves.
    double new_generations() const {
        const float inactivity = scene_.ecology.inactivity;
        return inactivity > 0 ? static_cast<double>(std::min(1.0f, tick_seconds / inactivity)) : 0;
    }
    static double of_touched(double bodies) { return cost::pair * bodies + cost::contact * bodies * bodies; }
    // Of vehicles that the file places in each other. Two share a pair.
    double of_overlaps() const {
        double sum = 0;
        placed_.for_each_overlap([&](double vehicles, double others) { sum += vehicles * of_touched(others / 2); });
        return sum;
    }
    double floor() const { return static_cast<double>(scene_.arena.width) * static_cast<double>(scene_.arena.height); }
    // The share of the vehicles that find room in this rectangle, grown by `margin` (m).
    double share_in(maths::vec2 extent, float margin) const {
        const auto area = static_cast<double>((2 * extent.x + margin) * (2 * extent.y + margin));
        return std::min(1.0, placed_.crowding() * area / (placed_.smallest() * vehicles_));
    }
    // How often something within `reach` (m) is found across the seams of a torus.
    double images(float reach) const {
        if (scene_.arena.edge != Boundary::torus) return 1;
        return std::min(9.0, 1 + static_cast<double>(4 * reach * reach) / floor());
    }

    double of(const std::vector<Sensor>& sensors) const {
        double sum = 0;
        for (const Sensor& sensor : sensors)
            sum += 1 + of(sensor) + (sensor.noise > 0 || sensor.gain_spread > 0 ? cost::noise : 0);
        return sum;
    }
    double of(const Sensor& sensor) const {
        if (sensor.channel == Channel::obstacle || sensor.channel == Channel::touch)
            return cost::outline_side * sides_ * images(sensor.range);
        if (sensor.channel == Channel::memory) return cost::mark * marks_;
        if (sensor.channel == Channel::floor) return cost::in_zone * zones_;
        if (!row_of(sensor.channel).is_summed) return 0;
        const auto channel = static_cast<std::size_t>(sensor.channel);
        const double reach = static_cast<double>(sensor.range + side_);
        const double near = std::min(vehicles_, maths::pi_d * reach * reach / placed_.smallest());  // side by side
        const bool is_slow = scene_.arena.edge == Boundary::torus || sensor.response == SensorResponse::photocell ||
                             sensor.response == SensorResponse::table;
        double of_one = is_slow ? cost::slow_stimulus : 1;
        if (is_blocked_by_obstacles(sensor.channel))
            of_one += cost::hiding_side * hiding_sides_ * images(sensor.range / 2);
        return (fixed_[channel] + near * carried_[channel]) * of_one;
    }
    static double of(const BrainGraph& brain) {
        double sum = cost::node * static_cast<double>(brain.nodes.size());
        for (const Wire& wire : brain.wires)
            sum += wire.curve.response == Response::linear ? cost::wire : cost::curved_wire;
        return sum;
    }

    const Scene& scene_;
    const PresentParts& parts_;
    const PlacedVehicles& placed_;
    double vehicles_;
    float side_ = 0;                                                // m, longest of any vehicle
    double touched_ = 0, impacts_ = 0, zones_ = 0;                  // bodies beside a vehicle, zones below it
    double sides_ = 0, hiding_sides_ = 0, marks_ = 0;               // of all outlines, of obstacles; of a memory
    std::array<double, channel_table.size()> fixed_{}, carried_{};  // stimuli by channel; of one vehicle
};

// A tick is not interrupted, so its work decides how soon the window answers. Without a limit a short file of 20,000
// vehicles that see 100 m far asks for a tick of minutes.
std::optional<Fault> work_fault(const Scene& scene, const PresentParts& parts, const PlacedVehicles& placed) {
    const double work = WorkOfATick(scene, parts, placed).total();
    if (work <= most_work) return std::nullopt;
    return Fault{"ecology.population", too_much_work(std::llround(vehicle_count(scene)), work, most_work)};
}

}  // namespace

Message too_much_work(long long vehicles, double work, double most) {
    const auto [millions, limit] = told_apart(std::ceil(work / 1e6), most / 1e6, Digits::behind_point, 0);
    return message_of("too_much_work", vehicles, millions, limit);
}

double work_of_a_tick(const Scene& scene) { return work_of_a_tick(scene, parts_of(scene)); }

double work_of_a_tick(const Scene& scene, const PresentParts& parts) {
    return WorkOfATick(scene, parts, PlacedVehicles(scene)).total();
}

std::optional<Fault> size_fault(const Scene& scene) { return size_fault(scene, parts_of(scene)); }

std::optional<Fault> size_fault(const Scene& scene, const PresentParts& parts) {
    const PlacedVehicles placed(scene);
    if (auto fault = crowd_fault(placed)) return fault;
    if (auto fault = density_fault(scene)) return fault;
    if (auto fault = memory_fault(scene, parts)) return fault;
    return work_fault(scene, parts, placed);
}

}  // namespace braitenlab
