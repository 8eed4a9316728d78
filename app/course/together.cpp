#include "app/course/together.h"

#include <utility>

namespace braitenlab {

namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

// Adds the vehicles of another world to a snapshot.
void add_vehicles(Snapshot& all, const Snapshot& more) {
    const VehicleId ids = all.vehicles.empty() ? 0 : all.vehicles.back().id + 1;
    const auto brains = static_cast<int>(all.brains.size()), designs = static_cast<int>(all.designs.size());
    const auto sensed = static_cast<int>(all.sensed.size()), neurons = static_cast<int>(all.neurons.size());
    for (VehicleView vehicle : more.vehicles) {
        vehicle.id += ids;
        vehicle.brain += brains;
        if (vehicle.design >= 0) vehicle.design += designs;
        vehicle.first_sensed += sensed;
        vehicle.first_neuron += neurons;
        all.vehicles.push_back(vehicle);
    }
    append(all.brains, more.brains), append(all.designs, more.designs);
    append(all.sensed, more.sensed), append(all.neurons, more.neurons);
    for (VehicleLook look : more.looks) look.vehicle += ids, all.looks.push_back(look);
    for (MarkView mark : more.marks) mark.owner += ids, all.marks.push_back(mark);
    for (BiteView bite : more.bites) bite.one += ids, bite.other += ids, all.bites.push_back(bite);
    for (StrikeView strike : more.strikes) {
        strike.vehicle += ids;
        if (strike.other != no_vehicle) strike.other += ids;
        all.strikes.push_back(strike);
    }
    all.predators += more.predators, all.prey += more.prey;
}

}  // namespace

Snapshot merged(const std::vector<Snapshot>& parts) {
    Snapshot all = parts.front();
    for (std::size_t i = 1; i < parts.size(); ++i) add_vehicles(all, parts[i]);
    return all;
}

Together begin_together(const Exercise& exercise, const Submission& submission, const Grade& grade) {
    Together together;
    const Scene scene = scene_with(exercise, submission);
    for (const StartResult& start : grade.starts) {
        if (together.worlds.size() == most_together) break;
        if (auto world = World::create(scene, start.seed)) together.worlds.push_back(std::move(*world));
    }
    if (!together.worlds.empty()) show(together);
    return together;
}

void show(Together& together) {
    std::vector<Snapshot> parts(together.worlds.size());
    for (std::size_t i = 0; i < parts.size(); ++i) together.worlds[i].capture(parts[i]);
    together.shown = merged(parts);
}

void step(Together& together) {
    for (World& world : together.worlds) world.step();
    show(together);
}

}  // namespace braitenlab
