#include "core/insight/judged_run.h"

#include <utility>

namespace braitenlab::insight {

JudgedRun::JudgedRun(Result<World> world, VehicleId vehicle, std::size_t ticks) : ticks_(ticks) {
    VehicleTrace trace;
    if (!world || !world->trace(vehicle, trace)) return;
    world_ = std::move(*world);
    judge_.emplace(*world_, vehicle);
    path_.reserve(ticks_ + 1);
    add_pose();
}

bool JudgedRun::advance(std::size_t ticks) {
    for (; world_ && ticks > 0; --ticks) {
        world_->step();
        add_pose();
    }
    return !world_;
}

void JudgedRun::add_pose() {
    const bool goes_on = judge_->add(*world_);
    if (goes_on) path_.push_back(judge_->pose());
    if (goes_on && path_.size() <= ticks_) return;
    outcome_ = judge_->outcome(*world_);
    world_.reset();
}

float JudgedRun::progress() const {
    return world_ ? static_cast<float>(path_.size()) / static_cast<float>(ticks_ + 1) : 1;
}

}  // namespace braitenlab::insight
