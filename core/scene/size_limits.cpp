#include "core/scene/size_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/scene.h"

namespace braitenlab {

namespace {

double vehicle_count(const Scene& scene) { return static_cast<double>(scene.starts.size()) + scene.ecology.population; }

// A world keeps about a dozen copies of its state; the limit keeps an untrusted file from filling the memory.
std::optional<Fault> memory_fault(const Scene& scene) {
    constexpr double most = 1 << 24;  // numbers, in all brains and all sensors' latencies
    double largest = 0;
    const auto numbers_of = [](const BrainGraph* brain, const std::vector<Sensor>* sensors) {
        double numbers = brain ? static_cast<double>(brain->nodes.size() + brain->wires.size()) : 0;
        if (sensors)
            for (const Sensor& sensor : *sensors) numbers += 1 + static_cast<double>(sensor.latency) / tick_seconds;
        return numbers;
    };
    for (const Kind& kind : scene.kinds) largest = std::max(largest, numbers_of(&kind.brain, &kind.sensors));
    const auto count_own = [&](const auto& own) {
        largest =
            std::max(largest, numbers_of(own.brain ? &*own.brain : nullptr, own.sensors ? &*own.sensors : nullptr));
    };
    for (const Start& start : scene.starts) count_own(start);
    for (const Member& member : scene.members) count_own(member);
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
    return Fault{"ecology.population",
                 message_of("too_dense", vehicles, std::llround(covered), std::llround(floor), most)};
}

// The same for vehicles that the file places: only so many on the floor of one.
std::optional<Fault> crowd_fault(const Scene& scene) {
    constexpr std::size_t most = 32;
    float side = 0;  // m
    for (const Kind& kind : scene.kinds) side = std::max({side, kind.body.length, kind.body.width});
    std::vector<std::pair<std::int64_t, std::int64_t>> squares;
    const auto place = [&](const auto& own) {
        squares.emplace_back(std::llround(own.x / side), std::llround(own.y / side));
    };
    for (const Start& start : scene.starts) place(start);
    for (const Member& member : scene.members)
        if (member.placed) place(member);
    if (squares.size() <= most) return std::nullopt;
    std::sort(squares.begin(), squares.end());
    for (std::size_t i = most; i < squares.size(); ++i)
        if (squares[i - most] == squares[i])
            return Fault{"", message_of("too_crowded", most, fmt::format("{:.3g}", side))};
    return std::nullopt;
}

// What the sensors and wheels of one vehicle compare in a tick at most, one after the other: a sensor each stimulus and
// outline that may be in its range, and each stimulus with each obstacle that may hide it; a wheel each zone.
class WorkOfAVehicle {
public:
    WorkOfAVehicle(const Scene& scene, double vehicles) : scene_(scene), vehicles_(vehicles) {
        for (const Kind& kind : scene.kinds) {
            side_ = std::max({side_, kind.body.length, kind.body.width});
            smallest_ = std::min(smallest_, floor_area(kind.body));
        }
        for (const ChannelTraits& row : channel_table) {
            const auto is_seen = [&](const auto& lamp) { return is_seen_as(lamp.channel, row.value); };
            const auto channel = static_cast<std::size_t>(row.value);
            fixed_[channel] = static_cast<double>(std::count_if(scene.sources.begin(), scene.sources.end(), is_seen));
            for (const Kind& kind : scene.kinds)
                carried_[channel] =
                    std::max(carried_[channel],
                             static_cast<double>(std::count_if(kind.lamps.begin(), kind.lamps.end(), is_seen)));
        }
        for (const Channel body : {Channel::predator, Channel::prey, Channel::vehicle})
            ++carried_[static_cast<std::size_t>(body)];
    }

    double of(const std::vector<Sensor>& sensors) const {
        double sum = 0;
        for (const Sensor& sensor : sensors) sum += of(sensor);
        return sum;
    }
    double of(const Kind& kind) const {
        constexpr std::size_t standard_wheels = 4;
        const std::size_t wheels = kind.body.wheels.empty() ? standard_wheels : kind.body.wheels.size();
        return of(kind.sensors) + static_cast<double>(wheels * scene_.zones.size());
    }

private:
    double of(const Sensor& sensor) const {
        constexpr double outline = 32;  // the nearest point of an outline takes as long as so many stimuli
        const auto obstacles = static_cast<double>(scene_.obstacles.size());
        if (sensor.channel == Channel::obstacle || sensor.channel == Channel::touch) return 1 + outline * obstacles;
        if (!row_of(sensor.channel).is_summed) return 1;
        const auto channel = static_cast<std::size_t>(sensor.channel);
        const double reach = static_cast<double>(sensor.range + side_);
        const double near = std::min(vehicles_, maths::pi_d * reach * reach / smallest_);  // side by side
        const double stimuli = fixed_[channel] + near * carried_[channel];
        return is_blocked_by_obstacles(sensor.channel) ? stimuli * (1 + obstacles) : stimuli;
    }

    const Scene& scene_;
    double vehicles_;
    float side_ = 0;                                                // m, longest of any vehicle
    double smallest_ = std::numeric_limits<double>::max();          // m², floor of the smallest vehicle
    std::array<double, channel_table.size()> fixed_{}, carried_{};  // stimuli by channel; of one vehicle
};

// A tick is not interrupted, so its work decides how soon the window answers. Without a limit a short file of 20,000
// vehicles that see 100 m far asks for a tick of minutes.
std::optional<Fault> work_fault(const Scene& scene) {
    constexpr double most = 40e6;  // 0.1 to 0.3 s on a core of 2.1 GHz
    const double vehicles = vehicle_count(scene);
    const WorkOfAVehicle work(scene, vehicles);
    double largest = 0;
    for (const Kind& kind : scene.kinds) largest = std::max(largest, work.of(kind));
    for (const Start& start : scene.starts)
        if (start.sensors) largest = std::max(largest, work.of(*start.sensors));
    for (const Member& member : scene.members)
        if (member.sensors) largest = std::max(largest, work.of(*member.sensors));
    if (vehicles * largest <= most) return std::nullopt;
    return Fault{"ecology.population", message_of("too_much_work", std::llround(vehicles),
                                                  std::llround(vehicles * largest / 1e6), std::llround(most / 1e6))};
}

}  // namespace

std::optional<Fault> size_fault(const Scene& scene) {
    if (auto fault = crowd_fault(scene)) return fault;
    if (auto fault = density_fault(scene)) return fault;
    if (auto fault = memory_fault(scene)) return fault;
    return work_fault(scene);
}

}  // namespace braitenlab
