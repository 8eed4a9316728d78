// The selected vehicle's brain on many robots whose parts differ: computed in the background, and robots replayed in
// the scene. The open run stays as it is.
#pragma once

#include <cstdint>
#include <optional>

#include "app/jobs/asked.h"
#include "app/jobs/robots.h"
#include "core/insight/robustness.h"

namespace braitenlab {

struct Workspace;
struct RobotsRequest;
struct RobotsView;

// What may change the question: it is made anew after a change of one of these only.
struct RobotsKey {
    std::int64_t edits = 0;           // Document::edits
    std::uint64_t run = 0, seed = 0;  // Document::run_id
    VehicleId vehicle = no_vehicle;
    float reality = 0;
    friend bool operator==(const RobotsKey&, const RobotsKey&) = default;
};

struct RobotTrial {
    float reality = 1;             // insight::RobotsQuestion
    bool is_on = false;            // asked for; every change then begins the trial anew
    std::optional<int> hovered{};  // robot under the pointer, set once per frame

    Asked<insight::RobotsQuestion, insight::RobotsReport> report{};
    std::uint64_t run = 0;                // Document::run_id of the question
    std::optional<RobotsKey> compared{};  // when the question was made
    double began = 0;                     // wall seconds when it was asked
};

// Call once per turn, after Jobs::deliver. Without the card the trial ends, and so does a replay.
void update_robots(RobotTrial&, Workspace&, Jobs&);

// Changes the reality, begins or ends the trial, replays a robot from its start, or ends the replay.
void handle_robots(RobotTrial&, Workspace&, const RobotsRequest&);

// Begins the replay of the present robots once more.
void restart_replay(RobotTrial&, Workspace&);

bool is_computing(const RobotTrial&);

// nullopt: not shown, or it may not be shown now. Points into the trial.
std::optional<RobotsView> robots_of(const RobotTrial&, const Workspace&);

}  // namespace braitenlab
