// Small scenes that tests build by hand.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/maths/angle.h"
#include "core/scene/scene.h"

namespace braitenlab::tests {

// The files of all shipped scenes, in a fixed order.
inline std::vector<std::filesystem::path> shipped_scenes() {
    std::vector<std::filesystem::path> paths;
    const std::filesystem::path folder = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "scenes";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

// A kind with two eyes for a channel, placed as on the standard vehicle.
inline Kind two_eyed(std::string name, const FourNeurons& brain, Channel channel = Channel::light) {
    Kind kind;
    kind.name = std::move(name);
    for (const float side : {1.0f, -1.0f}) {
        Sensor eye;
        eye.name = side > 0 ? "SL" : "SR";
        eye.channel = channel;
        eye.x = 0.30f;
        eye.y = side * 0.24f;
        eye.angle = side * maths::radians(35);
        kind.sensors.push_back(eye);
    }
    kind.brain = make_graph(brain);
    return kind;
}

// One vehicle at a pose in an arena whose walls are far away.
inline Scene alone(const FourNeurons& brain, float x = 0, float y = 0, float heading = 0) {
    Scene scene;
    scene.name = "alone";
    scene.arena.width = scene.arena.height = 200;
    scene.kinds.push_back(two_eyed("tester", brain));
    scene.starts.push_back({.name = "it", .kind = "tester", .x = x, .y = y, .heading = heading});
    return scene;
}

// Predators and prey placed at random.
inline Scene crowd(int population) {
    Scene scene;
    scene.name = "crowd";
    Kind hunter = two_eyed("hunter", {.LR = 1.5f, .RL = 1.5f, .LM = 0.3f, .RM = 0.25f}, Channel::prey);
    Kind hunted = two_eyed("hunted", {.LL = 1.0f, .RR = 1.0f, .LM = 0.2f, .RM = 0.25f}, Channel::predator);
    hunter.role = Role::predator;
    hunted.role = Role::prey;
    hunter.share = hunted.share = 1;
    scene.kinds = {hunter, hunted};
    scene.ecology.population = population;
    return scene;
}

}  // namespace braitenlab::tests
