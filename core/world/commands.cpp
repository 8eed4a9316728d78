// Commands from outside, each carried out whole or refused with a reason.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/angle.h"
#include "core/world/edits.h"
#include "core/world/node_places.h"
#include "core/world/state.h"

namespace braitenlab {

namespace {

// Gives a vehicle another brain; its neurons begin anew unless the brains have the same units and learning wires.
void give_brain(WorldState& s, std::size_t row, SharedDesign design) {
    Vehicles& v = s.vehicles;
    const Brain& old = v.design[row]->brain;
    if (old.unit_ids != design->brain.unit_ids || old.learning_wires != design->brain.learning_wires) {
        const std::uint32_t begin = v.first_neuron[row];
        const auto old_size = static_cast<std::uint32_t>(old.state_size());
        const auto new_size = static_cast<std::uint32_t>(design->brain.state_size());
        v.neurons.erase(v.neurons.begin() + begin, v.neurons.begin() + begin + old_size);
        v.neurons.insert(v.neurons.begin() + begin, new_size, 0.0f);
        for (std::size_t later = row + 1; later < v.size(); ++later) v.first_neuron[later] += new_size - old_size;
    }
    v.design[row] = std::move(design);
}

Error gone(VehicleId id) { return {fmt::format("vehicle {} is no longer in the world; select another one", id)}; }

// Rebuilds every brain that the target names with `edit`; vehicles that share a brain go on sharing one. Nothing
// changes unless every new brain compiles.
template <class Edit>
std::optional<Error> edit_brains(WorldState& s, const Target& target, Edit edit) {
    struct Change {
        SharedDesign before, after;
    };
    std::vector<Change> changes;
    const auto changed = [&](const SharedDesign& before, int kind) -> Result<SharedDesign> {
        for (const Change& c : changes)
            if (c.before == before) return c.after;
        BrainGraph graph = before->graph;
        edit(graph);
        auto after = make_design(graph, s.scene->kinds[static_cast<std::size_t>(kind)]);
        if (after) changes.push_back({before, *after});
        return after;
    };

    if (target.vehicle != no_vehicle) {
        const auto row = s.row_of(target.vehicle);
        if (!row) return gone(target.vehicle);
        const auto design = changed(s.vehicles.design[*row], s.vehicles.kind[*row]);
        if (!design) return design.error();
        give_brain(s, *row, *design);
        return std::nullopt;
    }
    if (target.kind < 0 || target.kind >= static_cast<int>(s.kinds.size()))
        return Error{fmt::format("the scene has no kind number {}", target.kind)};
    SharedDesign& newcomers = s.newcomers[static_cast<std::size_t>(target.kind)];
    const auto of_kind = changed(newcomers, target.kind);
    if (!of_kind) return of_kind.error();
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (s.vehicles.kind[row] == target.kind)
            if (auto design = changed(s.vehicles.design[row], target.kind); !design) return design.error();
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (s.vehicles.kind[row] == target.kind) give_brain(s, row, *changed(s.vehicles.design[row], target.kind));
    newcomers = *of_kind;
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const TurnDial& c) {
    if (!std::isfinite(c.value)) return Error{"a dial takes finite numbers only"};
    return edit_brains(s, c.target, [&](BrainGraph& graph) { turn(graph, c.dial, c.value); });
}

std::optional<Error> carry_out(WorldState& s, const SetBrain& c) {
    return edit_brains(s, c.target, [&](BrainGraph& graph) { graph = c.brain; });
}

std::optional<Error> carry_out(WorldState& s, const PlaceNodes& c) { return place_nodes(s, c); }

std::optional<Error> carry_out(WorldState& s, const MoveVehicle& c) {
    const auto row = s.row_of(c.vehicle);
    if (!row) return gone(c.vehicle);
    if (!is_finite({c.x, c.y, c.heading})) return Error{"a place takes finite numbers only"};
    s.physics.place(*row, {c.x, c.y, maths::wrap_angle(c.heading)});
    read_motion(s, *row);
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const ChooseDriver& c) {
    const auto row = s.row_of(c.vehicle);
    if (!row) return gone(c.vehicle);
    s.vehicles.driver[*row] = c.driver;
    s.vehicles.hand[*row] = {};
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const Steer& c) {
    const auto row = s.row_of(c.vehicle);
    if (!row) return gone(c.vehicle);
    if (!std::isfinite(c.left) || !std::isfinite(c.right)) return Error{"a wheel takes finite numbers only"};
    s.vehicles.hand[*row] = {std::clamp(c.left, -1.0f, 1.0f), std::clamp(c.right, -1.0f, 1.0f)};
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const NewPopulation&) {
    repopulate(s);
    return std::nullopt;
}

}  // namespace

std::optional<Error> carry_out(WorldState& s, const Command& command) {
    return std::visit([&s](const auto& c) { return carry_out(s, c); }, command);
}

}  // namespace braitenlab
