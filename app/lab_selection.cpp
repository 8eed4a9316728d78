// What is selected: always a vehicle, and perhaps a lamp or an obstacle besides.
#include <algorithm>
#include <string>

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

// Who has more energy than a few ticks take has not starved: it was bitten.
std::string_view fate_of(const Scene& scene, const VehicleView& dead) {
    constexpr float some_ticks = 3.0f / 60;  // s
    if (dead.role == Role::prey && dead.energy > scene.ecology.drain * some_ticks) return "notice.eaten_prey";
    return dead.role == Role::prey       ? "notice.starved_prey"
           : dead.role == Role::predator ? "notice.starved_predator"
                                         : "notice.starved_none";
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

void mourn(Lab& lab, const VehicleView& selected) {
    const Snapshot& now = lab.session.snapshot();
    if (now.vehicles.empty() || find_vehicle(now, selected.id)) return;
    // Ids ascend: the next one of the kind, else the first, else whoever comes first.
    const auto of_kind = [&](const VehicleView& v) { return v.kind == selected.kind; };
    const auto later = std::upper_bound(now.vehicles.begin(), now.vehicles.end(), selected.id,
                                        [](VehicleId id, const VehicleView& v) { return id < v.id; });
    auto next = std::find_if(later, now.vehicles.end(), of_kind);
    if (next == now.vehicles.end()) next = std::find_if(now.vehicles.begin(), now.vehicles.end(), of_kind);
    lab.selected = next == now.vehicles.end() ? now.vehicles.front().id : next->id;
    if (lab.notice.kind == NoticeKind::failure && !lab.notice.empty()) return;  // more important
    say(lab, {NoticeKind::notice, std::string(fate_of(*now.scene, selected)), std::to_string(selected.id + 1),
              std::to_string(lab.selected + 1)});
}

void keep_selection(Lab& lab) {
    keep_thing(lab);
    const auto& vehicles = lab.session.snapshot().vehicles;
    if (!selected_vehicle(lab)) lab.selected = vehicles.empty() ? no_vehicle : vehicles.front().id;
}

}  // namespace braitenlab
