#include "app/lab_selection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "app/course/lesson_view.h"
#include "ui/request.h"

namespace braitenlab {

namespace {

// Adding or removing objects changes the indices of sources, obstacles and zones, but not their names.
void keep_object(Workspace& space) {
    const Snapshot& now = space.document.session.snapshot();
    Selection& selection = space.view.selection;
    selection.object = object_named(*now.scene, selection.object.kind, space.object_name);
    std::vector<SceneObject> kept;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < selection.more.size(); ++i) {
        SceneObject object = selection.more[i];
        if (object.kind != SceneObjectKind::vehicle)
            object = object_named(*now.scene, object.kind, space.more_names[i]);
        if (!place_of(now, object) || object == chosen_object(selection)) continue;
        kept.push_back(object);
        names.push_back(space.more_names[i]);
    }
    selection.more = std::move(kept);
    space.more_names = std::move(names);
}

// Notice keys for a death: where another vehicle is selected now, and where none is.
struct DeathKeys {
    std::string_view selected, alone;
};

// Prey whose energy exceeds the use of a few ticks has been eaten; other vehicles have starved.
DeathKeys cause_of_death(const Scene& scene, const VehicleView& dead) {
    constexpr float some_ticks = 3.0f / 60;  // s
    if (dead.role == Role::prey && dead.energy > scene.ecology.drain * some_ticks)
        return {"notice.eaten_prey", "notice.eaten_prey_alone"};
    if (dead.role == Role::prey) return {"notice.starved_prey", "notice.starved_prey_alone"};
    if (dead.role == Role::predator) return {"notice.starved_predator", "notice.starved_predator_alone"};
    return {"notice.starved_none", "notice.starved_none_alone"};
}

// The nearest vehicle of the kind of `dead`; null if there is none.
const VehicleView* nearest_of_kind(const Snapshot& now, const VehicleView& dead) {
    const VehicleView* nearest = nullptr;
    float least = 0;
    for (const VehicleView& v : now.vehicles) {
        const float away = std::hypot(v.x - dead.x, v.y - dead.y);
        if (v.kind == dead.kind && (!nearest || away < least)) nearest = &v, least = away;
    }
    return nearest;
}

// The first vehicle of the kind that was selected last, so that edits stay with that kind; else the first one.
// Precondition: there is one.
VehicleId substitute(const Workspace& space) {
    const Snapshot& now = space.document.session.snapshot();
    const auto found = std::find_if(now.vehicles.begin(), now.vehicles.end(),
                                    [&](const VehicleView& v) { return kind_of(now, v).name == space.selected_kind; });
    return (found == now.vehicles.end() ? now.vehicles.front() : *found).id;
}

}  // namespace

const VehicleView* selected_vehicle(const Workspace& space) {
    return find_vehicle(space.document.session.snapshot(), space.view.selection.vehicle);
}

void select_object(Workspace& space, const SceneObject& object) {
    space.view.selection.object = {};
    space.view.selection.more.clear();
    space.more_names.clear();
    const Snapshot& now = space.document.session.snapshot();
    if (!place_of(now, object) || object.kind == SceneObjectKind::vehicle) return;
    space.view.selection.object = object;
    space.object_name = name_of(*now.scene, object);
}

void select_none(Workspace& space) {
    select_object(space, {});
    space.view.selection.vehicle = no_vehicle;
    space.deselected = Deselected::by_user;
}

void select(Workspace& space, const SceneObject& object) {
    select_object(space, object);
    if (object.kind == SceneObjectKind::vehicle) space.view.selection.vehicle = object.index;
}

void select_objects(Workspace& space, const std::vector<SceneObject>& objects) {
    const auto is_vehicle = [](const SceneObject& object) { return object.kind == SceneObjectKind::vehicle; };
    const auto other = std::find_if_not(objects.begin(), objects.end(), is_vehicle);
    const SceneObject first = other != objects.end() ? *other : objects.empty() ? SceneObject{} : objects.front();
    select(space, first);
    const Snapshot& now = space.document.session.snapshot();
    for (const SceneObject& object : objects) {
        if (object == first || !place_of(now, object)) continue;
        space.view.selection.more.push_back(object);
        space.more_names.push_back(name_of(*now.scene, object));
    }
}

void select_neighbour(Workspace& space, int step) {
    const VehicleId selected = space.view.selection.vehicle;
    std::vector<VehicleId> order;
    for (const VehicleView& vehicle : space.document.session.snapshot().vehicles)
        if (vehicle.id == selected || !space.document.lesson || !is_secret(space, vehicle.kind))
            order.push_back(vehicle.id);
    if (order.empty()) return;
    const auto here = std::find(order.begin(), order.end(), selected);
    const auto count = static_cast<int>(order.size());
    const int index = here == order.end() ? 0 : static_cast<int>(here - order.begin()) + step + count;
    select(space, vehicle_object(order[static_cast<std::size_t>(index % count)]));
}

void select_next_object(Workspace& space, int step) {
    const std::vector<SceneObject> all = objects_beside_vehicles(*space.document.session.snapshot().scene);
    if (all.empty()) return;
    const auto here = std::find(all.begin(), all.end(), space.view.selection.object);
    const auto count = static_cast<int>(all.size());
    const int index = here == all.end() ? (step > 0 ? 0 : count - 1) : static_cast<int>(here - all.begin()) + step;
    select_object(space, all[static_cast<std::size_t>((index + count) % count)]);
}

void keep_selection(Workspace& space) {
    const auto& vehicles = space.document.session.snapshot().vehicles;
    const bool begins = space.document.session.snapshot().tick == 0 && space.deselected == Deselected::by_death;
    if (selected_vehicle(space) || vehicles.empty() || begins) space.deselected = Deselected::no;
    const bool selects = !vehicles.empty() && space.deselected == Deselected::no;
    if (!selected_vehicle(space)) space.view.selection.vehicle = selects ? substitute(space) : no_vehicle;
    if (const VehicleView* now = selected_vehicle(space))
        space.selected_kind = kind_of(space.document.session.snapshot(), *now).name;
    keep_object(space);  // last: the chosen vehicle is in no other place of the selection
}

void reselect_after_death(Workspace& space, const VehicleView& selected) {
    const Snapshot& now = space.document.session.snapshot();
    if (now.vehicles.empty() || find_vehicle(now, selected.id)) return;
    const VehicleView* next = space.dragging ? nullptr : nearest_of_kind(now, selected);
    space.deselected = next ? Deselected::no : Deselected::by_death;
    space.view.selection.vehicle = next ? next->id : no_vehicle;
    keep_object(space);
    if (space.notice.kind == NoticeKind::failure && !space.notice.empty()) return;  // more important
    const DeathKeys keys = cause_of_death(*now.scene, selected);
    say(space, {NoticeKind::notice, std::string(next ? keys.selected : keys.alone), std::to_string(selected.id + 1),
                next ? std::to_string(next->id + 1) : ""});
}

void tell_fall(Workspace& space, VehicleId selected) {
    const std::vector<VehicleId>& fallen = space.document.session.snapshot().fallen;
    if (!std::binary_search(fallen.begin(), fallen.end(), selected)) return;
    if (space.notice.kind == NoticeKind::failure && !space.notice.empty()) return;  // more important
    say(space, {NoticeKind::notice, "notice.fell", std::to_string(selected + 1)});
}

void forget_vehicle_notice(Workspace& space) {
    const std::string& key = space.notice.key;
    if (key.starts_with("notice.starved") || key.starts_with("notice.eaten") || key == "notice.fell") space.notice = {};
}

VehicleId id_at_start(const Scene& scene, std::uint64_t seed, const Snapshot& now, const VehicleView& vehicle) {
    const auto world = World::create(scene, seed);
    if (!world) return no_vehicle;
    const Snapshot start = snapshot_of(*world);
    const int number = vehicle.start < 0 ? number_in_population(now, vehicle.id) : -1;
    for (const VehicleView& each : start.vehicles) {
        if (each.start != vehicle.start) continue;
        if (vehicle.start >= 0 || number_in_population(start, each.id) == number) return each.id;
    }
    return no_vehicle;
}

void renumber_selection(Selection& selection, const std::map<VehicleId, VehicleId>& new_ids) {
    const auto renumber = [&](int& id) {
        if (const auto found = new_ids.find(id); found != new_ids.end()) id = found->second;
    };
    renumber(selection.vehicle);
    for (SceneObject& object : selection.more)
        if (object.kind == SceneObjectKind::vehicle) renumber(object.index);
}

}  // namespace braitenlab
