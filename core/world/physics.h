// Rigid bodies. Only physics.cpp includes Box2D. Inside core/world only.
//
// Each vehicle is one body with a fixture for the chassis and one for each wheel that extends beyond it. This is
// equivalent to five bodies with locked joints and much cheaper. A wheel inside the chassis has no fixture: it cannot
// have a contact alone, and it would cost as much in Box2D's tree as the chassis. Gravity is 0: the plane is
// horizontal.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/world/state.h"

namespace braitenlab::world {

// Contact of a vehicle with the environment, and where (m).
struct Bump {
    VehicleId vehicle = no_vehicle;
    maths::vec2 at;
    VehicleId other = no_vehicle;  // the vehicle that is struck, with the larger id
};

// True when a body can be so fast that it moves deep into an obstacle or through it in one tick; Physics then computes
// the time of each impact.
bool may_skip_an_impact(const Scene&);

class Physics {
public:
    // Builds walls, posts and obstacles; `obstacles` are the motions of Scene::obstacles.
    Physics(const Scene&, const std::vector<mechanics::Motion>& obstacles);
    ~Physics();
    Physics(Physics&&) noexcept;
    Physics& operator=(Physics&&) noexcept;

    // Rows of bodies are those of the vehicles. A removal decrements the later rows. Rows can be added in any order.
    void add(std::size_t row, VehicleId, const Body&, const mechanics::Motion&);
    void remove(const std::vector<std::size_t>& rows);  // ascending
    void set_pose(std::size_t row, const Pose&);        // at rest
    // Changes the position and keeps the velocity: a vehicle that crosses the seam of a torus.
    void set_position(std::size_t row, maths::vec2);
    void set_obstacle_position(std::size_t index, maths::vec2);

    // Headings are in −π..π: a body that has left the range is turned back by a whole turn.
    mechanics::Motion motion(std::size_t row);
    mechanics::Motion obstacle(std::size_t index);
    void push(std::size_t row, maths::vec2 force, float torque);  // N and N·m, for the next step

    // One step of tick_seconds. Updates `touching` (sorted); `begun` receives the contacts that began in this step.
    void step(std::vector<Touch>& touching, std::vector<Touch>& begun);

    // The contacts that began in the last step, as `begun`, each at one of its contact points.
    void find_strikes(const std::vector<Touch>& begun, std::vector<Bump>& strikes) const;

    // Contacts with walls, posts and obstacles after the last step: one per vehicle, by ascending id, at the mean of
    // all its contact points.
    void find_bumps(std::vector<Bump>&) const;

private:
    struct Impl;  // Box2D's world and the contact listener
    std::unique_ptr<Impl> impl_;
};

}  // namespace braitenlab::world
