// Helpers that open a session and edit it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/maths/random.h"
#include "core/session/session.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests {

inline Session open_session(const Scene& scene, std::uint64_t seed = 3) {
    auto session = Session::open(scene, seed);
    EXPECT_TRUE(session) << session.error().text();
    return std::move(*session);
}

// A dial of the vehicle with this index.
inline float dial(const Session& session, Dial which, std::size_t vehicle = 0) {
    const Snapshot& now = session.snapshot();
    return at(read_dials(*now.brains[static_cast<std::size_t>(now.vehicles[vehicle].brain)]), which);
}

// The number of vehicles of a kind.
inline int count_of(const Session& session, int kind) {
    const auto& all = session.snapshot().vehicles;
    return static_cast<int>(
        std::count_if(all.begin(), all.end(), [kind](const VehicleView& v) { return v.kind == kind; }));
}

// A crowd of five, two of them with a start, and one or two objects of each class.
inline Scene furnished() {
    Scene scene = tests::crowd(5);
    scene.sources = {{"lamp", Channel::light, 1, 1, 1, false}, {"stove", Channel::heat, -3, 2, 1, true}};
    scene.obstacles = {{"box", 4, -4, 0.5f, 1, 2}};
    scene.zones = {{.name = "pond", .x = -2, .surface = Surface::ice}};
    scene.starts = {{"first", scene.kinds[0].name, -5, -5, 0, "lamp"}, {"second", scene.kinds[1].name, 5, 5, 1, ""}};
    return scene;
}

// A random edit with random numbers.
inline Command any_edit(const Session& session, maths::Random& chance) {
    const Snapshot& now = session.snapshot();
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<int>(chance.next() % n); };
    const auto metres = [&] { return chance.uniform(-4, 4); };
    const VehicleId vehicle =
        now.vehicles.empty() ? 0 : now.vehicles[static_cast<std::size_t>(below(now.vehicles.size()))].id;
    const int source = below(now.sources.size()), obstacle = below(now.obstacles.size());
    const int kind = below(now.scene->kinds.size()), zone = below(now.scene->zones.size());
    const auto kinds = static_cast<int>(now.scene->kinds.size());
    switch (below(32)) {
        case 21:
            return AddZone{{.x = metres(), .length = 2, .surface = Surface::ice, .wind_y = metres()}, below(3) - 1};
        case 22:
            return RemoveZone{zone};
        case 23:
            return MoveZone{zone, metres(), metres(), 1};
        case 24:
            return EditZone{zone, {.x = metres(), .width = 3, .slope = 0.1f}};
        case 25: {
            Arena to = now.scene->arena;
            to.width = chance.uniform(11, 24), to.height = chance.uniform(11, 24), to.ambient = chance.uniform(0, 1);
            return EditArena{to};
        }
        case 26:
            return EditEcology{Ecology{.drain = chance.uniform(0, 0.1f), .inactivity = 9}};
        case 27: {
            Kind copy = now.scene->kinds[static_cast<std::size_t>(kind)];
            copy.brain = *now.kind_brains[static_cast<std::size_t>(kind)];
            copy.share = 0;
            return AddKind{copy, below(3) - 1};
        }
        case 28:
            return RemoveKind{kind};
        case 29: {
            Kind to = now.scene->kinds[static_cast<std::size_t>(kind)];
            to.name = "kind-" + std::to_string(below(9));
            to.driver = below(2) == 0 ? Driver::wander : Driver::brain;
            to.body = resized(to.body, chance.uniform(0.4f, 1.2f), 0.6f);
            to.body.mismatch = 0.1f;
            to.role = below(2) == 0 ? Role::wiring : Role::prey;
            to.colour = "#112233";
            return EditKind{kind, to};
        }
        case 31: {
            MoveObjects all;
            if (!now.vehicles.empty()) all.of_vehicles.push_back({vehicle, metres(), metres(), 2});
            if (!now.sources.empty()) all.of_sources.push_back({source, metres(), metres()});
            if (!now.obstacles.empty() && below(2) == 0) all.of_obstacles.push_back({obstacle, metres(), metres(), 1});
            if (!now.scene->zones.empty() && below(2) == 0) all.of_zones.push_back({zone, metres(), metres(), 1});
            return all;
        }
        case 30:
            return SetPopulation{std::min(kind, kinds - 1), below(9)};
        case 18: {
            const int population = now.scene->ecology.population;
            if (population == 0) return AddVehicle{};
            return EditMember{below(static_cast<std::size_t>(population)),
                              Member{.placed = true, .x = metres(), .y = metres()}};
        }
        case 19: {
            if (now.vehicles.empty()) return AddVehicle{};
            auto sensors = kind_of(now, *find_vehicle(now, vehicle)).sensors;
            sensors.push_back({.name = "own" + std::to_string(sensors.size()),
                               .channel = Channel::heat,
                               .angle = chance.uniform(-1, 1),
                               .latency = below(2) == 0 ? 0 : 0.2f});
            return SetSensors{{.vehicle = vehicle}, sensors};
        }
        case 20:
            if (below(2) == 0) return SetSensors{{.vehicle = vehicle}, {}};
            return SetSensors{{.vehicle = vehicle}, now.scene->kinds[static_cast<std::size_t>(kind)].sensors};
        case 0:
            return TurnDial{{.vehicle = vehicle}, Dial::LR, chance.uniform(-2, 2)};
        case 1:
            return TurnDial{{.kind = kind}, Dial::RL, chance.uniform(-2, 2)};
        case 2:
            return AddVehicle{};
        case 3:
            return AddVehicle{kind, Pose{metres(), metres(), 1}};
        case 4:
            return RemoveVehicle{vehicle};
        case 5:
            return MoveVehicle{vehicle, metres(), metres(), 2};
        case 6:
            return TurnDial{{.vehicle = vehicle}, Dial::LL, chance.uniform(-2, 2)};
        case 7: {
            auto sensors = now.scene->kinds[static_cast<std::size_t>(kind)].sensors;
            if (!sensors.empty()) sensors[0].range = chance.uniform(1, 9);
            return SetSensors{{.kind = kind}, sensors};
        }
        case 8:
            return AddSource{{"", Channel::heat, metres(), metres(), 0.5f, below(2) == 0}, below(3) - 1};
        case 9:
            return RemoveSource{source};
        case 10:
            return MoveSource{source, metres(), metres()};
        case 11:
            return AddObstacle{{"", metres(), metres(), 0.3f, 2, 1}, below(3) - 1};
        case 12:
            return RemoveObstacle{obstacle};
        case 13:
            return MoveObstacle{obstacle, metres(), metres(), 1};
        case 14:
            return Retitle{"scene " + std::to_string(below(100))};
        case 15:
            return PlaceNodes{{.kind = kind}, {{below(4), maths::vec2{metres(), metres()}}, {below(4), {}}}};
        case 16:
            return PlaceNodes{{.vehicle = vehicle}, {{below(4), maths::vec2{metres(), metres()}}}};
        default: {
            if (now.sources.empty()) return AddVehicle{};
            Source to = now.scene->sources[static_cast<std::size_t>(source)];
            to.strength = chance.uniform(0.1f, 1);
            return EditSource{source, to};
        }
    }
}

}  // namespace braitenlab::tests
