// Snapshots and traces of a world.
#include <algorithm>
#include <optional>

#include "core/maths/angle.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

namespace {

// Index of the value `part`, which `owner` owns, in the list of values in use; adds it when new. Compares the first 64
// only: when most vehicles share a few the search is short, and when each has its own the list holds duplicates instead
// of taking O(n^2).
template <class Owner, class Part>
int index_of(const std::shared_ptr<Owner>& owner, const Part& part, std::vector<std::shared_ptr<const Part>>& used) {
    for (std::size_t i = 0; i < used.size() && i < 64; ++i)
        if (used[i].get() == &part) return static_cast<int>(i);
    used.push_back(std::shared_ptr<const Part>(owner, &part));
    return static_cast<int>(used.size()) - 1;
}

VehicleView view_of(const WorldData& s, std::size_t row, const std::array<float, 2>& motor) {
    const Vehicles& v = s.vehicles;
    const mechanics::Motion& m = v.motion[row];
    VehicleView view;
    view.id = v.id[row];
    view.kind = v.kind[row];
    view.start = v.start[row];
    view.role = s.role(row);
    view.driver = v.driver[row];
    view.x = m.position.x;
    view.y = m.position.y;
    view.heading = maths::wrap_angle(m.heading);
    view.speed = maths::dot(m.velocity, m.ahead);
    view.energy = static_cast<float>(v.energy[row]);
    view.motor = motor;
    view.wheel_angle = v.wheel_angle[row];
    view.first_sensed = static_cast<int>(v.first_sensed[row]);
    view.first_neuron = static_cast<int>(v.first_neuron[row]);
    view.neuron_count = v.brain[row]->flat.neuron_count();
    return view;
}

}  // namespace

void capture(const WorldData& s, Snapshot& out) {
    std::optional<Preview> next;
    if (s.readings_are_stale) next = preview(s);
    const std::vector<std::array<float, 2>>& motor = next ? next->motor : s.vehicles.motor;
    out.tick = s.tick;
    out.seconds = seconds_at(s.tick);
    out.seed = s.seed;
    out.generation = s.generation;
    const float limit = s.scene->ecology.inactivity;
    out.inactivity_left = limit > 0 ? std::max(0.0f, limit - static_cast<float>(s.still_ticks) * tick_seconds) : 0;
    out.events = s.events;
    out.is_preview = next.has_value();
    out.predators = out.prey = 0;
    out.vehicles.clear();
    out.brains.clear();
    out.designs.clear();
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) {
        VehicleView& view = out.vehicles.emplace_back(view_of(s, row, motor[row]));
        const SharedBrain& brain = s.vehicles.brain[row];
        view.brain = index_of(brain, brain->graph, out.brains);
        if (const SharedDesign& own = s.vehicles.design[row]) view.design = index_of(own, own->kind, out.designs);
        out.predators += s.role(row) == Role::predator;
        out.prey += s.role(row) == Role::prey;
    }
    out.sensed = next ? next->sensed : s.vehicles.sensed;
    out.neurons = next ? next->neurons : s.vehicles.neurons;
    out.kind_brains.clear();
    for (const SharedBrain& brain : s.kind_brains) out.kind_brains.emplace_back(brain, &brain->graph);
    out.sources.clear();
    for (const Source& source : s.scene->sources)
        out.sources.push_back({static_cast<int>(out.sources.size()), source.channel, source.x, source.y,
                               strength_at(source, out.seconds)});
    out.obstacles.clear();
    for (const mechanics::Motion& m : s.obstacles)
        out.obstacles.push_back({m.position.x, m.position.y, maths::wrap_angle(m.heading)});
    out.looks = s.looks;
    out.marks.clear();
    for (const Mark& mark : s.marks)
        out.marks.push_back({mark.owner, mark.position.x, mark.position.y, strength(s, mark)});
    out.bites.clear();
    for (const Bite& bite : s.bites)
        out.bites.push_back({bite.pair.one, bite.pair.other, static_cast<float>(s.tick - bite.tick) * tick_seconds});
    out.strikes.clear();
    for (const Strike& strike : s.strikes)
        out.strikes.push_back({strike.vehicle, strike.at.x, strike.at.y,
                               static_cast<float>(s.tick - strike.tick) * tick_seconds, strike.other});
    out.fallen = s.fallen;
    out.scene = s.scene;
}

bool trace(const WorldData& s, VehicleId id, VehicleTrace& out) {
    const auto row = s.row_of(id);
    if (!row) return false;
    const Vehicles& v = s.vehicles;
    const mechanics::Motion& m = v.motion[*row];
    out.tick = s.tick;
    out.pose = {m.position.x, m.position.y, maths::wrap_angle(m.heading)};
    out.motor = v.motor[*row];
    const auto first = v.sensed.begin() + static_cast<std::ptrdiff_t>(v.first_sensed[*row]);
    out.sensed.assign(first, first + static_cast<std::ptrdiff_t>(s.compiled(*row).sensors.size()));
    return true;
}

}  // namespace braitenlab::world
