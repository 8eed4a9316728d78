#include "app/what_changed.h"

#include <algorithm>

#include "core/brain/four_neurons.h"
#include "core/scene/sensor_pairs.h"

namespace braitenlab {

namespace {

// Two brains that differ.
struct ChangedBrain {
    const BrainGraph* before = nullptr;  // null: none differs
    const BrainGraph* after = nullptr;
    SensorPair pair{};
};

ChangedBrain changed_brain(const Snapshot& before, const Snapshot& after) {
    const auto kinds = std::min(before.kind_brains.size(), after.kind_brains.size());
    for (std::size_t i = 0; i < kinds; ++i)
        if (*before.kind_brains[i] != *after.kind_brains[i])
            return {before.kind_brains[i].get(), after.kind_brains[i].get(), chosen_pair(after.scene->kinds[i], "")};
    for (const VehicleView& vehicle : after.vehicles) {
        const VehicleView* earlier = find_vehicle(before, vehicle.id);
        if (!earlier || *brain_of(before, *earlier) == *brain_of(after, vehicle)) continue;
        return {brain_of(before, *earlier).get(), brain_of(after, vehicle).get(),
                chosen_pair(kind_of(after, vehicle), "")};
    }
    return {};
}

// Empty if anything but dials differs.
std::string changed_dials(const ChangedBrain& changed) {
    const FourNeurons before = read_dials(*changed.before, changed.pair),
                      after = read_dials(*changed.after, changed.pair);
    BrainGraph turned_back = *changed.after;
    std::string names;
    for (const Dial dial : all_dials) {
        if (at(before, dial) == at(after, dial)) continue;
        names += (names.empty() ? "" : ", ") + std::string(name(dial));
        turn(turned_back, dial, at(before, dial), changed.pair);
    }
    return turned_back == *changed.before ? names : std::string();
}

bool has_places(const BrainGraph& brain) {
    return std::any_of(brain.nodes.begin(), brain.nodes.end(), [](const Node& node) { return node.place.has_value(); });
}

// The string key of a change of the diagram alone; empty if the brain differs otherwise, too. Without a place of its
// own each node is where Tidy puts it; the first move of a node gives them places.
std::string changed_diagram(const ChangedBrain& changed) {
    if (!same_wiring(*changed.before, *changed.after)) return {};
    return has_places(*changed.after) ? "changed.places" : "wiring.arrange";
}

bool have_sensors_changed(const Snapshot& before, const Snapshot& after) {
    const auto &earlier = before.scene->kinds, &later = after.scene->kinds;
    for (std::size_t i = 0; i < std::min(earlier.size(), later.size()); ++i)
        if (earlier[i].sensors != later[i].sensors) return true;
    return std::any_of(after.vehicles.begin(), after.vehicles.end(), [&](const VehicleView& vehicle) {
        const VehicleView* same = find_vehicle(before, vehicle.id);
        return same && same->kind == vehicle.kind && kind_of(before, *same).sensors != kind_of(after, vehicle).sensors;
    });
}

bool have_vehicles_changed(const Snapshot& before, const Snapshot& after) {
    return !std::equal(before.vehicles.begin(), before.vehicles.end(), after.vehicles.begin(), after.vehicles.end(),
                       [](const VehicleView& a, const VehicleView& b) {
                           return a.id == b.id && a.x == b.x && a.y == b.y && a.heading == b.heading;
                       });
}

}  // namespace

std::string what_changed(const Snapshot& before, const Snapshot& after) {
    const Scene &earlier = *before.scene, &later = *after.scene;
    const ChangedBrain brain = changed_brain(before, after);
    const bool sensors = have_sensors_changed(before, after);
    if (brain.before && sensors) return "changed.brain_and_sensors";
    if (brain.before) {
        if (std::string diagram = changed_diagram(brain); !diagram.empty()) return diagram;
        const std::string dials = changed_dials(brain);
        return dials.empty() ? "changed.brain" : dials;
    }
    if (sensors) return "changed.sensors";
    const bool fewer_or_more = before.vehicles.size() != after.vehicles.size();
    const bool lamps = earlier.sources != later.sources;
    if (fewer_or_more) return lamps ? "changed.vehicles_and_lamps" : "changed.vehicles";
    if (lamps) return "changed.lamps";
    if (earlier.obstacles != later.obstacles || before.obstacles != after.obstacles) return "changed.obstacles";
    if (earlier.zones != later.zones) return "changed.zones";
    if (have_vehicles_changed(before, after) || earlier.starts != later.starts) return "changed.vehicles";
    const bool is_arena = earlier.arena != later.arena || earlier.ecology != later.ecology;
    return is_arena || earlier.kinds != later.kinds ? "changed.values" : "changed.other";
}

}  // namespace braitenlab
