// Commands from outside, each carried out whole or refused with a reason.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/maths/angle.h"
#include "core/world/edits.h"
#include "core/world/state.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_vehicles = 20000;

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

bool is_finite(const Pose& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.heading); }

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

std::optional<Error> carry_out(WorldState& s, const AddVehicle& c) {
    if (s.kinds.empty()) return Error{"the scene has no kind of vehicle to add; write one into its file"};
    if (c.kind >= static_cast<int>(s.kinds.size()))
        return Error{fmt::format("the scene has no kind number {}", c.kind)};
    if (s.vehicles.size() >= most_vehicles)
        return Error{fmt::format("{} vehicles are the most a world holds; remove some first", most_vehicles)};
    if (c.at && !is_finite(*c.at)) return Error{"a place takes finite numbers only"};
    if (!(c.energy >= 0 && c.energy <= 1)) return Error{"energy is a number from 0 to 1"};
    const int kind = c.kind >= 0 ? c.kind : kind_due(s);
    SharedDesign design = s.newcomers[static_cast<std::size_t>(kind)];
    if (c.brain) {
        auto own = make_design(*c.brain, s.scene->kinds[static_cast<std::size_t>(kind)]);
        if (!own) return own.error();
        design = *own;
    }
    const VehicleId id = s.next_id++;
    add_vehicle(s, kind, -1, id, std::move(design), c.at ? *c.at : free_place(s, id));
    s.vehicles.energy.back() = c.energy;
    return std::nullopt;
}

std::optional<Error> carry_out(WorldState& s, const RemoveVehicle& c) {
    if (s.vehicles.size() == 0) return Error{"there is no vehicle left to remove"};
    const auto row = c.vehicle == no_vehicle ? std::optional(s.vehicles.size() - 1) : s.row_of(c.vehicle);
    if (!row) return gone(c.vehicle);
    remove_vehicle(s, *row);
    return std::nullopt;
}

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
