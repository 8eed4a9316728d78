// What is selected: always a vehicle, and perhaps a lamp or an obstacle besides.
#include <algorithm>

#include "app/lab_parts.h"

namespace braitenlab {

namespace {

// Numbers of sources and obstacles shift when others come and go; names do not.
void keep_thing(Lab& lab) {
    if (!lab.thing) return;
    const Scene& scene = *lab.session.snapshot().scene;
    lab.thing.index =
        lab.thing.kind == ThingKind::source ? find_source(scene, lab.thing_name) : find_obstacle(scene, lab.thing_name);
    if (lab.thing.index < 0) lab.thing = {};
}

}  // namespace

const VehicleView* selected_vehicle(const Lab& lab) { return find_vehicle(lab.session.snapshot(), lab.selected); }

void take(Lab& lab, const Thing& thing) {
    lab.thing = {};
    const Snapshot& now = lab.session.snapshot();
    if (!place_of(now, thing) || thing.kind == ThingKind::vehicle) return;
    const auto index = static_cast<std::size_t>(thing.index);
    lab.thing = thing;
    lab.thing_name =
        thing.kind == ThingKind::source ? now.scene->sources[index].name : now.scene->obstacles[index].name;
}

void select(Lab& lab, const Thing& thing) {
    take(lab, thing);
    if (thing.kind == ThingKind::vehicle) lab.selected = thing.index;
}

Thing chosen(const Lab& lab) { return lab.thing ? lab.thing : vehicle_thing(lab.selected); }

void select_neighbour(Lab& lab, int step) {
    const auto& vehicles = lab.session.snapshot().vehicles;
    if (vehicles.empty()) return;
    const auto here =
        std::find_if(vehicles.begin(), vehicles.end(), [&](const auto& v) { return v.id == lab.selected; });
    const auto count = static_cast<int>(vehicles.size());
    const int index = here == vehicles.end() ? 0 : static_cast<int>(here - vehicles.begin()) + step + count;
    select(lab, vehicle_thing(vehicles[static_cast<std::size_t>(index % count)].id));
}

void keep_selection(Lab& lab) {
    keep_thing(lab);
    const auto& vehicles = lab.session.snapshot().vehicles;
    if (!selected_vehicle(lab)) lab.selected = vehicles.empty() ? no_vehicle : vehicles.front().id;
}

}  // namespace braitenlab
