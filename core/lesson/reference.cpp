#include "core/lesson/reference.h"

#include "core/lesson/submission.h"

namespace braitenlab {

Reference::Reference(const Exercise& exercise, std::uint64_t seed)
    : Reference(exercise, with_solution(exercise), 0, seed) {}

Reference::Reference(const Exercise& exercise, const Submission& submission, std::size_t start_index,
                     std::uint64_t seed)
    : seed_(seed) {
    auto world = World::create(scene_with(exercise, submission), seed);
    if (!world) return;
    world_ = std::move(*world);
    const Snapshot start = snapshot_of(*world_);
    for (const VehicleView& vehicle : start.vehicles)
        if (vehicle.start == static_cast<int>(start_index)) subject_ = vehicle.id;
    add_pose();
}

void Reference::add_pose() {
    VehicleTrace now;
    if (world_->trace(subject_, now))
        path_.push_back(now.pose);
    else
        world_.reset();
}

const ReferencePath& Reference::until(std::uint64_t tick) {
    while (world_ && path_.size() <= tick) {
        world_->step();
        add_pose();
    }
    return path_;
}

}  // namespace braitenlab
