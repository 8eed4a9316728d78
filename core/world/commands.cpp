// Execution of commands. A command is executed completely, or returns an error and changes nothing.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/world/cosmetic_edits.h"
#include "core/world/edits.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

namespace {

// Replaces a vehicle's brain. Its neurons are reset unless both brains have the same units and learning wires.
void give_brain(WorldData& s, std::size_t row, SharedBrain brain) {
    Vehicles& v = s.vehicles;
    const Brain& old = v.brain[row]->flat;
    if (old.unit_ids != brain->flat.unit_ids || old.learning_wires != brain->flat.learning_wires) {
        const std::uint32_t begin = v.first_neuron[row];
        const auto old_size = static_cast<std::uint32_t>(old.state_size());
        const auto new_size = static_cast<std::uint32_t>(brain->flat.state_size());
        v.neurons.erase(v.neurons.begin() + begin, v.neurons.begin() + begin + old_size);
        v.neurons.insert(v.neurons.begin() + begin, new_size, 0.0f);
        for (std::size_t later = row + 1; later < v.size(); ++later) v.first_neuron[later] += new_size - old_size;
    }
    v.brain[row] = std::move(brain);
}

// Edits all brains of the target. Vehicles that share a brain share the edited one. Changes nothing when an edited
// brain does not compile, or when a tick would take too long with it.
template <class Edit>
std::optional<Error> edit_brains(WorldData& s, const Target& target, Edit edit) {
    struct Change {
        SharedBrain before, after;
    };
    std::vector<Change> changes;
    const auto changed = [&](const SharedBrain& before, const Kind& design) -> Result<SharedBrain> {
        for (const Change& c : changes)
            if (c.before == before) return c.after;
        BrainGraph graph = before->graph;
        edit(graph);
        auto after = compile_brain(graph, design);
        if (after) changes.push_back({before, *after});
        return after;
    };

    PresentParts parts = present_parts(s);
    if (target.vehicle != no_vehicle) {
        const auto row = s.row_of(target.vehicle);
        if (!row) return unknown_vehicle(target.vehicle);
        const auto brain = changed(s.vehicles.brain[*row], s.design(*row));
        if (!brain) return brain.error();
        parts.of_vehicles[*row].brain = own_graph(*brain, s.kind_brains[s.kind(*row)]);
        if (auto error = check_size(*s.scene, parts)) return error;
        give_brain(s, *row, *brain);
        return std::nullopt;
    }
    if (target.kind < 0 || target.kind >= static_cast<int>(s.kinds.size()))
        return Error{fmt::format("the scene has no kind number {}", target.kind)};
    const auto kind = static_cast<std::size_t>(target.kind);
    const auto of_kind = changed(s.kind_brains[kind], s.scene->kinds[kind]);
    if (!of_kind) return of_kind.error();
    parts.of_kinds[kind] = &(*of_kind)->graph;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        if (s.kind(row) != kind) continue;
        const auto brain = changed(s.vehicles.brain[row], s.design(row));
        if (!brain) return brain.error();
        parts.of_vehicles[row].brain = own_graph(*brain, *of_kind);
    }
    if (auto error = check_size(*s.scene, parts)) return error;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (s.kind(row) == kind) give_brain(s, row, *changed(s.vehicles.brain[row], s.design(row)));
    s.kind_brains[kind] = *of_kind;
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const TurnDial& c) {
    if (!std::isfinite(c.value)) return Error{"a dial takes finite numbers only"};
    return edit_brains(s, c.target, [&](BrainGraph& graph) { turn(graph, c.dial, c.value, c.pair); });
}

std::optional<Error> execute(WorldData& s, const SetBrain& c) {
    return edit_brains(s, c.target, [&](BrainGraph& graph) { graph = c.brain; });
}

std::optional<Error> execute(WorldData& s, const PlaceNodes& c) { return execute_cosmetic(s, c); }
std::optional<Error> execute(WorldData& s, const Retitle& c) { return execute_cosmetic(s, c); }

std::optional<Error> execute(WorldData& s, const ChooseDriver& c) {
    const auto row = s.row_of(c.vehicle);
    if (!row) return unknown_vehicle(c.vehicle);
    s.vehicles.driver[*row] = c.driver;
    s.vehicles.steered[*row] = {};
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const Steer& c) {
    const auto row = s.row_of(c.vehicle);
    if (!row) return unknown_vehicle(c.vehicle);
    if (!std::isfinite(c.left) || !std::isfinite(c.right)) return Error{"a wheel takes finite numbers only"};
    s.vehicles.steered[*row] = {std::clamp(c.left, -1.0f, 1.0f), std::clamp(c.right, -1.0f, 1.0f)};
    return std::nullopt;
}

std::optional<Error> execute(WorldData& s, const NewPopulation&) {
    new_generation(s);
    return std::nullopt;
}

}  // namespace

std::optional<Error> execute(WorldData& s, const Command& command) {
    return std::visit([&s](const auto& c) { return execute(s, c); }, command);
}

}  // namespace braitenlab::world

namespace braitenlab {

Command::Command(const Command&) = default;
Command::Command(Command&&) noexcept = default;
Command& Command::operator=(const Command&) = default;
Command& Command::operator=(Command&&) noexcept = default;
Command::~Command() = default;

}  // namespace braitenlab
