#include "core/insight/robustness.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/brain/brain.h"
#include "core/scene/schema.h"

namespace braitenlab::insight {

namespace {

constexpr float most_mismatch = 0.5f, most_spread = 0.9f, most_dead_band = 0.9f, most_noise = 1, most_latency = 1;

bool has_errors(const Sensor& sensor) {
    return sensor.channel != Channel::touch && sensor.channel != Channel::energy && sensor.channel != Channel::memory &&
           sensor.channel != Channel::random;
}

float scaled(float own, float typical, bool is_typical, float reality, float most) {
    return std::min((is_typical ? typical : own) * reality, most);
}

int scaled_bits(int bits, float reality) {
    if (bits == 0 || reality <= 0) return 0;
    return std::clamp(static_cast<int>(std::lround(static_cast<float>(bits) - std::log2(reality))), 1,
                      braitenlab::limits::converter_bits);
}

void scale(std::vector<Sensor>& sensors, bool is_typical, float reality) {
    const Reality& typical = typical_robot;
    for (Sensor& s : sensors) {
        if (!has_errors(s)) continue;
        s.gain_spread = scaled(s.gain_spread, typical.gain_spread, is_typical, reality, most_spread);
        s.noise = scaled(s.noise, typical.noise, is_typical, reality, most_noise);
        s.latency = scaled(s.latency, typical.latency, is_typical, reality, most_latency);
        s.interval = scaled(s.interval, typical.interval, is_typical, reality, most_latency);
        s.bits = scaled_bits(is_typical ? typical.bits : s.bits, reality);
    }
}

// The start poses of this world, whatever the seed.
Scene with_poses_of(Scene scene, const Snapshot& start) {
    std::vector<Member> members;
    for (const VehicleView& vehicle : start.vehicles) {
        if (vehicle.start >= 0) {
            Start& own = scene.starts[static_cast<std::size_t>(vehicle.start)];
            own.x = vehicle.x, own.y = vehicle.y, own.heading = vehicle.heading;
            own.facing.clear();
            own.place_spread = own.heading_spread = 0;
            continue;
        }
        const std::string name = std::to_string(members.size());
        const auto own = std::find_if(scene.members.begin(), scene.members.end(),
                                      [&](const Member& member) { return member.name == name; });
        Member& member = members.emplace_back(own == scene.members.end() ? Member{.name = name} : *own);
        member.kind = scene.kinds[static_cast<std::size_t>(vehicle.kind)].name;
        member.placed = true;
        member.x = vehicle.x, member.y = vehicle.y, member.heading = vehicle.heading;
    }
    scene.members = std::move(members);
    return scene;
}

// By how much (m) the closest approach to the object differs; without an object the mean distance of both at a time.
float off_from(const RobotResult& robot, const RobotResult& ideal) {
    const float off = std::fabs(robot.outcome.closest - ideal.outcome.closest);
    if (std::isfinite(off)) return off;
    const std::size_t count = std::min(robot.path.size(), ideal.path.size());
    float sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += maths::distance(maths::vec2{robot.path[i].x, robot.path[i].y},
                               maths::vec2{ideal.path[i].x, ideal.path[i].y});
    return count > 0 ? sum / static_cast<float>(count) : 0;
}

}  // namespace

Reality reality_of(const Kind& kind) {
    const Body& body = kind.body;
    Reality reality{.mismatch = body.mismatch, .dead_band = body.dead_band, .friction_spread = body.friction_spread};
    for (const Sensor& sensor : kind.sensors) {
        reality.gain_spread = std::max(reality.gain_spread, sensor.gain_spread);
        reality.noise = std::max(reality.noise, sensor.noise);
        reality.latency = std::max(reality.latency, sensor.latency);
        reality.interval = std::max(reality.interval, sensor.interval);
        if (sensor.bits > 0) reality.bits = reality.bits > 0 ? std::min(reality.bits, sensor.bits) : sensor.bits;
    }
    return reality;
}

Scene with_reality(Scene scene, int kind, float reality) {
    Kind& robot = scene.kinds[static_cast<std::size_t>(kind)];
    const bool is_typical = is_ideal(robot);
    const Reality& typical = typical_robot;
    Body& body = robot.body;
    body.mismatch = scaled(body.mismatch, typical.mismatch, is_typical, reality, most_mismatch);
    body.dead_band = scaled(body.dead_band, typical.dead_band, is_typical, reality, most_dead_band);
    body.friction_spread = scaled(body.friction_spread, typical.friction_spread, is_typical, reality, most_spread);
    scale(robot.sensors, is_typical, reality);
    for (Start& start : scene.starts)
        if (start.kind == robot.name && start.sensors) scale(*start.sensors, is_typical, reality);
    for (Member& member : scene.members)
        if (member.kind == robot.name && member.sensors) scale(*member.sensors, is_typical, reality);
    return scene;
}

Result<std::shared_ptr<const Robots>> Robots::create(RobotsQuestion question) {
    if (question.robots < 1 || question.robots > limits::robots)
        return Error{fmt::format("a trial has 1 to {} robots", limits::robots)};
    if (!(question.reality >= 0 && question.reality <= limits::reality))
        return Error{fmt::format("reality is 0 (ideal) to {:g}; 1 is as in the scene", limits::reality)};
    const auto world = World::create(question.scene, question.seed);
    if (!world) return world.error();
    const Snapshot start = snapshot_of(*world);
    const VehicleView* vehicle = find_vehicle(start, question.vehicle);
    if (!vehicle) return Error{"the scene has no vehicle that could be tried as a robot"};
    auto robots = std::make_shared<Robots>();
    robots->question_ = std::move(question);
    robots->kind_ = vehicle->kind;
    const RobotsQuestion& q = robots->question_;
    const Scene placed = with_poses_of(q.scene, start);
    robots->scene_ = with_reality(placed, vehicle->kind, q.reality);
    robots->ideal_ = with_reality(placed, vehicle->kind, 0);
    return std::shared_ptr<const Robots>(std::move(robots));
}

RobotResult result_of(const JudgedRun& run, std::uint64_t seed, std::size_t ticks) {
    RobotResult result{.seed = seed, .outcome = run.outcome()};
    result.seconds = std::isfinite(result.outcome.time_to_touch)
                         ? result.outcome.time_to_touch
                         : static_cast<float>(static_cast<double>(ticks) * tick_seconds);
    for (std::size_t i = 0; i < run.path().size(); i += robot_path_ticks) result.path.push_back(run.path()[i]);
    return result;
}

bool is_weaker(const RobotResult& a, const RobotResult& b, const RobotResult& ideal) {
    if (a.works != b.works) return !a.works;
    if (!a.works && a.failed_step != b.failed_step) return a.failed_step < b.failed_step;
    return off_from(a, ideal) > off_from(b, ideal);
}

RobotsReport report_of(RobotResult ideal, std::vector<RobotResult> robots, bool judged) {
    RobotsReport report{.ideal = std::move(ideal), .robots = std::move(robots)};
    if (!judged) {
        report.ideal.works = true;
        for (RobotResult& robot : report.robots)
            robot.works = robot.outcome.behaviour == report.ideal.outcome.behaviour;
    }
    for (std::size_t i = 0; i < report.robots.size(); ++i) {
        report.working += report.robots[i].works;
        const auto weakest = static_cast<std::size_t>(report.weakest);
        if (is_weaker(report.robots[i], report.robots[weakest], report.ideal)) report.weakest = static_cast<int>(i);
    }
    return report;
}

}  // namespace braitenlab::insight
