// The rigid bodies: Box2D lives behind this header and nowhere else.
//
// One body a vehicle with a fixture for the chassis and one for each wheel that sticks out of it: the rigid limit of five
// bodies joined by locked joints, at a fraction of their cost. What the chassis covers needs no fixture, since nothing
// can touch it alone, and each would cost as much in Box2D's tree as the chassis does. Gravity is off: the plane is seen from above.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"
#include "core/world/motion.h"

namespace braitenlab {

class Physics {
public:
    // Builds walls, posts and obstacles, the obstacles moving as given (as Scene::obstacles).
    Physics(const Scene&, const std::vector<Motion>& obstacles);
    ~Physics();
    Physics(Physics&&) noexcept;
    Physics& operator=(Physics&&) noexcept;

    // Bodies stand in rows, as the vehicles do; a removed one closes the gap. They may be added in any order.
    void add(std::size_t row, VehicleId, const Body&, const Motion&);
    void remove(const std::vector<std::size_t>& rows);  // which ascend
    void place(std::size_t row, const Pose&);           // at rest
    // To another place, going on as fast: what leaves a torus on one side.
    void shift(std::size_t row, maths::vec2 to);
    void shift_obstacle(std::size_t index, maths::vec2 to);

    Motion motion(std::size_t row) const;
    Motion obstacle(std::size_t index) const;
    void push(std::size_t row, maths::vec2 force, float torque);  // N and N·m, for the next step

    // One step of tick_seconds. `touching`, sorted, is brought up to date; `begun` gets what began in this step.
    void step(std::vector<Touch>& touching, std::vector<Touch>& begun);

    // Who touches walls, posts and obstacles after the last step: each vehicle once, by ascending id, at the middle of
    // all its points of contact.
    void find_bumps(std::vector<Bump>&) const;

private:
    struct Box;  // Box2D's world and the listener
    std::unique_ptr<Box> box_;
};

}  // namespace braitenlab
