// How robots of one design would do: individuals whose motors, sensors and tyres differ as those of a series do, each
// run from the same start. A brain that works in many sampled realities has a chance in the real one (A. Ligot and
// M. Birattari, "Simulation-only experiments to mimic the effects of the reality gap in the automatic design of robot
// swarms", Swarm Intelligence, 2019).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/insight/judged_run.h"
#include "core/result.h"
#include "core/scene/scene.h"
#include "core/world/world.h"

namespace braitenlab::insight {

namespace limits {
inline constexpr float reality = 2;
inline constexpr int robots = 1000;
}  // namespace limits

// The figures of a kind that an ideal robot does not have; see Body and Sensor. Of sensors the largest.
struct Reality {
    float mismatch = 0, gain_spread = 0, noise = 0, latency = 0, dead_band = 0, friction_spread = 0;
    float interval = 0;
    int bits = 0;  // the smallest; 0: no converter
    friend bool operator==(const Reality&, const Reality&) = default;
};

// A small robot with two geared TT motors and photoresistors. Motors: 200 rpm ± 10 % (data sheet of Adafruit 3777).
// Sensors: the resistance of a GL5528 at 10 lx is 10 to 20 kΩ (data sheet), which over 1.5 kΩ is ± 22 % of a reading;
// it follows light in 20 to 30 ms. Dead band: what the exported sketch leaves. It reads its sensors 50 times per second
// with 10 bit. Noise and friction are assumed.
inline constexpr Reality typical_robot{.mismatch = 0.10f,
                                       .gain_spread = 0.20f,
                                       .noise = 0.01f,
                                       .latency = 0.04f,
                                       .dead_band = 0.02f,
                                       .friction_spread = 0.20f,
                                       .interval = 0.02f,
                                       .bits = 10};

Reality reality_of(const Kind&);
inline bool is_ideal(const Kind& kind) { return reality_of(kind) == Reality{}; }

// The scene in which the figures of this kind are multiplied by `reality` (0..limits::reality), limited to their
// ranges: 0 ideal, 1 as in the scene. The steps of a converter are so many times as large, to the nearest bit. A kind
// that is ideal gets those of typical_robot instead. Sensors for touch, energy and place memory stay as they are; they
// have no such errors.
Scene with_reality(Scene, int kind, float reality);

struct RobotsQuestion {
    Scene scene;
    std::uint64_t seed = 1;          // of the start, which all robots have
    VehicleId vehicle = no_vehicle;  // in a world of the scene; it is judged, and its kind is that of the robots
    float reality = 1;               // 0..limits::reality
    int robots = 40;                 // 1..limits::robots
    std::size_t ticks = 1200;        // of a run
    friend bool operator==(const RobotsQuestion&, const RobotsQuestion&) = default;
};

// What is common to all runs. Constant, so that threads share it.
class Robots {
public:
    // Fails when the scene is invalid or has no such vehicle, and for numbers out of range.
    static Result<std::shared_ptr<const Robots>> create(RobotsQuestion);

    const RobotsQuestion& question() const { return question_; }
    int kind() const { return kind_; }  // of the vehicle

    // The scene of the robots: with the start poses of the question's seed, whatever the seed of the world. The ideal
    // robot: with reality 0.
    const Scene& scene() const { return scene_; }
    const Scene& ideal_scene() const { return ideal_; }
    // The seed of the world of robot 0, 1, …: it decides the errors of the robot's parts and the noise.
    std::uint64_t seed_of(int robot) const { return question_.seed + static_cast<std::uint64_t>(robot); }

    JudgedRun run(int robot) const {
        return {World::create(scene_, seed_of(robot)), question_.vehicle, question_.ticks};
    }
    JudgedRun ideal_run() const { return {World::create(ideal_, question_.seed), question_.vehicle, question_.ticks}; }

private:
    RobotsQuestion question_;
    int kind_ = 0;
    Scene scene_, ideal_;
};

inline constexpr std::size_t robot_path_ticks = 6;

// What one robot did.
struct RobotResult {
    std::uint64_t seed = 0;
    Outcome outcome;
    bool works = false;    // of an exercise: it passes; else its behaviour is that of the ideal robot
    int failed_step = -1;  // of an exercise, from 0; −1: none
    float seconds = 0;     // until it touched the object or passed; else the whole run
    Path path;             // one pose per robot_path_ticks
};

// The result of a complete run, without the verdict.
RobotResult result_of(const JudgedRun&, std::uint64_t seed, std::size_t ticks);

struct RobotsReport {
    RobotResult ideal;
    std::vector<RobotResult> robots;
    int working = 0;  // number of robots
    int weakest = 0;  // index of the robot that does worst; see is_weaker()

    float share() const { return static_cast<float>(working) / static_cast<float>(robots.size()); }
};

// True if `a` does worse than `b`: it fails and the other works; both fail and its step is an earlier one; else its
// closest approach differs more from that of the ideal robot, or without an object its path.
bool is_weaker(const RobotResult& a, const RobotResult& b, const RobotResult& ideal);

// Counts the robots that work. Of a scene without an exercise, `judged` is false: a robot works if its behaviour is
// that of the ideal robot.
RobotsReport report_of(RobotResult ideal, std::vector<RobotResult> robots, bool judged);

}  // namespace braitenlab::insight
