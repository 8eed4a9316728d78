#include "core/insight/predict.h"

#include <algorithm>

namespace braitenlab::insight {

Prediction::Prediction(const Question& question) : question_(question) {
    const Checkpoint& from = question_.from;
    world_.emplace(World::restore({from.keyframe, from.keyframe_tick, {}, from.keyframe_tick}));
}

bool Prediction::advance(std::size_t steps) {
    const std::vector<LoggedCommand>& commands = question_.from.commands;
    for (; world_ && steps > 0; --steps) {
        if (has_begun_) {
            world_->step();
            add_pose();
        } else if (repeated_ < commands.size() && commands[repeated_].tick <= world_->tick()) {
            (void)world_->apply(commands[repeated_++].command);
        } else if (world_->tick() < question_.from.tick) {
            world_->step();
        } else {
            begin();
        }
    }
    return !world_;
}

void Prediction::begin() {
    if (question_.seed) world_ = world_->fork(*question_.seed);
    for (const Command& command : question_.changes) (void)world_->apply(command);
    has_begun_ = true;
    path_.reserve(question_.ticks + 1);
    add_pose();
}

void Prediction::add_pose() {
    VehicleTrace now;
    const bool is_there = world_->trace(question_.vehicle, now);
    if (is_there) path_.push_back(now.pose);
    if (!is_there || path_.size() > question_.ticks) world_.reset();
}

float Prediction::progress() const {
    if (!world_) return 1;
    const Checkpoint& from = question_.from;
    const auto all = static_cast<float>(from.tick - from.keyframe_tick + question_.ticks + 1);
    return static_cast<float>(world_->tick() - from.keyframe_tick) / all;
}

Path predict(const Question& question) {
    constexpr std::size_t piece = 1024;
    Prediction prediction(question);
    while (!prediction.advance(piece)) {
    }
    return prediction.path();
}

Question with_other_chance(Question question, std::uint64_t number) {
    constexpr std::uint64_t stream = 0x66616e;  // differs from the seeds 1, 2, … that people choose
    question.seed = (stream << 32U) + number;
    return question;
}

bool depends_on_chance(const Snapshot& now) {
    const auto is_noisy = [](const Sensor& sensor) { return sensor.noise > 0 || sensor.channel == Channel::random; };
    return std::any_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& vehicle) {
        const std::vector<Sensor>& sensors = kind_of(now, vehicle).sensors;
        return vehicle.driver == Driver::wander || std::any_of(sensors.begin(), sensors.end(), is_noisy);
    });
}

}  // namespace braitenlab::insight
