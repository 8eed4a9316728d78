#include "core/insight/run_judge.h"

#include <cmath>

namespace braitenlab::insight {

RunJudge::RunJudge(const World& start, VehicleId vehicle)
    : judge_(snapshot_of(start), vehicle), vehicle_(vehicle), others_(judge_.others().size()) {}

bool RunJudge::add(const World& world) {
    for (std::size_t i = 0; i < others_.size(); ++i) {
        const bool is_there = world.trace(judge_.others()[i], now_);
        others_[i] = is_there ? maths::vec2{now_.pose.x, now_.pose.y} : maths::vec2{NAN, NAN};
    }
    is_gone_ = !world.trace(vehicle_, now_);
    return !is_gone_ && judge_.add(now_, others_);
}

Outcome RunJudge::outcome(const World& world) const { return judge_.outcome(snapshot_of(world).events, is_gone_); }

}  // namespace braitenlab::insight
