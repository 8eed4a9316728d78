// The rigid bodies: Box2D lives behind this header and nowhere else.
//
// One body a vehicle with five fixtures, a chassis and four wheels: the rigid limit of five bodies joined by locked
// joints, at a fraction of their cost. Gravity is off: the plane is seen from above.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/maths/vec.h"
#include "core/scene/scene.h"
#include "core/world/snapshot.h"

namespace braitenlab {

struct Pose {
    float x = 0, y = 0, heading = 0;
};

// Where a body is and how it moves: m, unit vector of the heading, m/s, rad/s.
struct Motion {
    maths::vec2 place, ahead{1, 0}, velocity;
    float turning = 0;
};

// Two vehicles that touch, the lower id first; or one vehicle and the environment (other == no_vehicle).
struct Touch {
    VehicleId one = no_vehicle, other = no_vehicle;
    friend auto operator<=>(const Touch&, const Touch&) = default;
};

class Physics {
public:
    // Builds walls and obstacles.
    explicit Physics(const Scene&);
    ~Physics();

    // Bodies stand in rows, as the vehicles do; a new one comes last, a removed one closes the gap.
    void add(VehicleId, const Body&, const Pose&);
    void remove(std::size_t row);
    void place(std::size_t row, const Pose&);  // at rest

    Motion motion(std::size_t row) const;
    float heading(std::size_t row) const;                         // rad, not wrapped
    void push(std::size_t row, maths::vec2 force, float torque);  // N and N·m, for the next step

    // One step of tick_seconds.
    void step();

    // What began to touch during the last step, sorted.
    const std::vector<Touch>& begun() const { return begun_; }
    // Vehicles that touch each other now, sorted.
    const std::vector<Touch>& touching() const { return touching_; }

private:
    struct Box;  // Box2D's world and the listener
    std::unique_ptr<Box> box_;
    std::vector<Touch> begun_, touching_;
};

}  // namespace braitenlab
