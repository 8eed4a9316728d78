#include "core/session/own_values.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace braitenlab {

namespace {

// The brain of a vehicle if it differs from that of its kind.
std::optional<BrainGraph> own_brain(const Snapshot& now, const VehicleView& vehicle) {
    const auto& brain = brain_of(now, vehicle);
    const auto& of_kind = now.kind_brains[static_cast<std::size_t>(vehicle.kind)];
    if (brain == of_kind || *brain == *of_kind) return std::nullopt;
    return *brain;
}

// The sensors of a vehicle if they differ from those of its kind.
std::optional<std::vector<Sensor>> own_sensors(const Snapshot& now, const VehicleView& vehicle) {
    if (vehicle.design < 0) return std::nullopt;
    return kind_of(now, vehicle).sensors;
}

// What a vehicle has in place of the values of its kind.
struct OwnValues {
    std::optional<BrainGraph> brain;
    std::optional<std::vector<Sensor>> sensors;
    std::optional<Driver> driver;
    const Look* look = nullptr;
    bool any() const { return brain || sensors || driver || look; }
};

OwnValues own_values(const Snapshot& now, const VehicleView& v) {
    const Kind& kind = now.scene->kinds[static_cast<std::size_t>(v.kind)];
    return {own_brain(now, v), own_sensors(now, v), v.driver != kind.driver ? std::optional(v.driver) : std::nullopt,
            find_look(now.looks, v.id)};
}

}  // namespace

std::vector<int> numbers_in_population(const Snapshot& now) {
    std::vector<int> numbers;
    std::vector<bool> has_own;
    for (const VehicleView& v : now.vehicles) {
        if (v.start >= 0) continue;
        numbers.push_back(static_cast<int>(numbers.size()));
        has_own.push_back(own_values(now, v).any());
    }
    const auto population = static_cast<std::size_t>(now.scene->ecology.population);
    std::size_t free = std::min(numbers.size(), population);
    for (std::size_t i = free; i < numbers.size(); ++i) {
        if (!has_own[i]) continue;
        while (free > 0 && has_own[free - 1]) --free;
        if (free == 0) break;
        --free;
        std::swap(numbers[i], numbers[free]);
    }
    return numbers;
}

void add_own_values(Scene& scene, const Snapshot& now) {
    std::map<int, Member> members;
    for (Member& member : scene.members) {
        member.brain.reset(), member.sensors.reset(), member.driver.reset();
        member.label.clear(), member.colour.clear();
        members[number_of(member)] = std::move(member);
    }
    const std::vector<int> numbers = numbers_in_population(now);
    auto number = numbers.begin();
    for (const VehicleView& v : now.vehicles) {
        OwnValues own = own_values(now, v);
        if (v.start >= 0) {
            Start& start = scene.starts[static_cast<std::size_t>(v.start)];
            start.brain = std::move(own.brain), start.sensors = std::move(own.sensors), start.driver = own.driver;
        } else if (const int its = *number++; its < scene.ecology.population && own.any()) {
            Member& member = members[its];
            member.name = std::to_string(its), member.kind = scene.kinds[static_cast<std::size_t>(v.kind)].name;
            if (own.look) member.label = own.look->label, member.colour = own.look->colour;
            member.brain = std::move(own.brain), member.sensors = std::move(own.sensors), member.driver = own.driver;
        }
    }
    scene.members.clear();
    for (auto& [_, member] : members) scene.members.push_back(std::move(member));
}

}  // namespace braitenlab
