// The selected vehicle's brain on many robots whose parts differ: computed in the background, and robots replayed in
// the scene. The open run stays as it is.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "app/jobs/robots.h"
#include "core/insight/robustness.h"

namespace braitenlab {

struct Lab;
struct LabView;
struct RobotsRequest;
struct RobotsView;

struct RobotTrial {
    float reality = 1;             // insight::RobotsQuestion
    bool is_on = false;            // asked for; every change then begins the trial anew
    std::optional<int> hovered{};  // robot under the pointer, set once per frame

    std::optional<insight::RobotsQuestion> question{};  // of the report or the job
    std::uint64_t run = 0;                              // Document::run_id of the question
    std::int64_t edits = -1;                            // Document::edits, run, vehicle and reality when compared
    std::uint64_t compared_run = 0;
    VehicleId compared_vehicle = no_vehicle;
    float compared_reality = -1;
    std::shared_ptr<const insight::Robots> asked{}, robots{};  // of the job, of the report
    Job<insight::RobotsReport> job{};
    double began = 0;  // wall seconds when the job began
    std::optional<insight::RobotsReport> report{};
};

// Call once per turn, after Jobs::deliver. Without the card the trial ends, and so does a replay.
void update_robots(Lab&, Jobs&);

// Changes the reality, begins or ends the trial, replays a robot from its start, or ends the replay.
void handle_robots(Lab&, const RobotsRequest&);

// Begins the replay of the present robots once more.
void restart_replay(Lab&);

bool is_computing(const RobotTrial&);

// nullopt: not shown, or it may not be shown now. Points into the lab.
std::optional<RobotsView> robots_of(const Lab&);

}  // namespace braitenlab
