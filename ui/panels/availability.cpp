// Whether a switch is on, and why an action cannot be chosen now.
#include <algorithm>
#include <optional>
#include <string_view>

#include "ui/panels/panels.h"
#include "ui/scene_input/edits.h"

namespace braitenlab::ui {

std::optional<bool> switched_on(const LabView& view, const PanelState& state, Action action) {
    const Overlays& shown = view.settings.overlays;
    switch (action) {
        case Action::sensors:
            return view.settings.sensors;
        case Action::outlines:
            return view.settings.outlines;
        case Action::trails:
            return shown.trails;
        case Action::surfaces:
            return shown.surfaces;
        case Action::memory:
            return shown.memory;
        case Action::labels:
            return shown.labels;
        case Action::slow_orbit:
            return view.settings.orbits;
        case Action::last_run:
            return shown.last_run;
        case Action::why:
            return view.why != nullptr;
        case Action::follow:
            return view.settings.camera.mode == CameraMode::follow;
        case Action::birds_eye:
            return view.settings.camera.mode == CameraMode::birds_eye;
        case Action::drivers_eye:
            return view.settings.camera.mode == CameraMode::driver;
        case Action::wiring:
            return view.mode == Mode::wiring;
        case Action::watch:
            return view.settings.watching;
        case Action::values:
            return view.settings.values;
        case Action::charts:
            return state.charts.open;
        case Action::map:
            return view.settings.map;
        case Action::reality:
            return view.settings.reality;
        default:
            return std::nullopt;
    }
}

namespace {

// Cut, copy, paste and select all in the scene.
std::string_view why_not_in_scene(const LabView& view, Action action) {
    const Snapshot& now = *view.now;
    if (action == Action::paste) return view.copied_objects > 0 ? "" : "wiring.refused.nothing_copied";
    if (action == Action::select_all)
        return now.vehicles.empty() && objects_beside_vehicles(*now.scene).empty() ? "unavailable.no_objects" : "";
    return place_of(now, chosen(view)) ? "" : "unavailable.nothing_selected";
}

std::string_view why_not_on_canvas(const LabView& view, const PanelState& state, Action action) {
    if (view.mode != Mode::wiring) return "unavailable.wiring_only";
    const wiring::CanvasState& canvas = state.canvas;
    if (action == Action::paste) return canvas.clipboard.neurons.empty() ? "wiring.refused.nothing_copied" : "";
    if (action == Action::cut || action == Action::copy)
        return canvas.selection.nodes.empty() ? "wiring.refused.nothing_to_copy" : "";
    if (action == Action::probe) return canvas.selection.nodes.empty() ? "unavailable.no_node" : "";
    if (action == Action::join) return canvas.selection.nodes.size() == 1 ? "" : "wiring.refused.join_one";
    return "";
}

// Duplicate, delete, lesion and the context menu: of the canvas's selection while wiring, else of the scene's.
std::string_view why_not_on_selection(const LabView& view, const PanelState& state, Action action) {
    constexpr std::string_view nothing = "unavailable.nothing_selected";
    if (view.mode == Mode::wiring) {
        if (action == Action::scene_menu) return "unavailable.scene_only";
        return state.canvas.selection.empty() ? nothing : "";
    }
    if (action == Action::lesion) return "unavailable.lesion";
    if (action == Action::duplicate) return copy_of(*view.now, chosen(view)) ? "" : nothing;
    return removal_of(*view.now, chosen(view)) ? "" : nothing;
}

std::string_view why_not_in_time(const LabView& view, Action action) {
    const TimelineView& time = view.timeline;
    if (action == Action::last_bookmark) return time.bookmarks.empty() ? "unavailable.no_bookmark" : "";
    if (action == Action::fast_forward) return time.latest > view.now->tick ? "" : "unavailable.latest";
    return time.earliest < view.now->tick ? "" : "unavailable.earliest";
}

std::string_view why_not_in_exercise(const LabView& view, Action action) {
    if (!view.lesson) return "unavailable.no_exercise";
    if (action == Action::exercise_reset) return "";
    if (view.lesson->hints_shown >= static_cast<int>(view.lesson->exercise->hints.size())) return "exercise.hint_none";
    return view.lesson->hint_ready ? "" : "exercise.hint_wait";
}

std::string_view why_not_with_vehicle(const LabView& view, const PanelState& state, Action action) {
    const VehicleId selected = view.settings.selection.vehicle;
    if (selected != no_vehicle && find_vehicle(*view.now, selected)) return "";
    return switched_on(view, state, action).value_or(false) ? "" : "unavailable.no_vehicle";
}

// The brain must drive, and it must not be hidden.
std::string_view why_no_cause(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (!vehicle) return why_not_with_vehicle(view, state, Action::why);
    return can_tell_why(view) ? "" : "unavailable.why";
}

std::string_view why_no_map(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (!vehicle) return why_not_with_vehicle(view, state, Action::map);
    if (view.mode == Mode::wiring) return "unavailable.scene_only";
    return can_show_map(view, *vehicle) ? "" : "unavailable.map";
}

std::string_view why_no_brain_file(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (vehicle && is_brain_secret(view, vehicle->kind)) return "unavailable.hidden_brain";
    return why_not_with_vehicle(view, state, Action::save_brain);
}

std::string_view why_no_robots(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (!vehicle) return why_not_with_vehicle(view, state, Action::reality);
    if (view.mode == Mode::wiring) return "unavailable.scene_only";
    const bool is_free = vehicle->driver == Driver::brain && may_show_future(view) && !hides_outcome(view);
    return is_free ? "" : "unavailable.reality";
}

std::string_view why_no_robot(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (!vehicle) return why_not_with_vehicle(view, state, Action::export_robot);
    return hides_brain(view, vehicle->kind) ? "wiring.hidden" : "";
}

std::string_view why_no_csv(const LabView& view, const PanelState& state) {
    const bool of_vehicle =
        state.charts.shown == Chart::signals || state.charts.shown == Chart::all || state.charts.shown == Chart::chosen;
    const bool empty = of_vehicle                          ? state.charts.history.signals.empty()
                       : state.charts.shown == Chart::bars ? view.now->vehicles.empty()
                                                           : state.charts.history.population.empty();
    return empty ? "charts.nothing" : "";
}

}  // namespace

const CatalogueEntry* empty_scene(const LabView& view) {
    if (!view.catalogue) return nullptr;
    const auto is_empty_scene = [](const CatalogueEntry& entry) { return entry.name == "empty"; };
    const auto found = std::find_if(view.catalogue->begin(), view.catalogue->end(), is_empty_scene);
    return found == view.catalogue->end() ? nullptr : &*found;
}

std::string_view why_unavailable(const LabView& view, const PanelState& state, Action action) {
    switch (action) {
        case Action::undo:
            return view.undo_depth > 0 ? "" : "unavailable.undo";
        case Action::redo:
            return view.redo_depth > 0 ? "" : "unavailable.redo";
        case Action::cut:
        case Action::copy:
        case Action::paste:
        case Action::select_all:
            return view.mode == Mode::wiring ? why_not_on_canvas(view, state, action) : why_not_in_scene(view, action);
        case Action::menu:
        case Action::probe:
        case Action::join:
        case Action::tidy:
        case Action::fit:
            return why_not_on_canvas(view, state, action);
        case Action::duplicate:
        case Action::erase:
        case Action::lesion:
        case Action::scene_menu:
            return why_not_on_selection(view, state, action);
        case Action::close_outline:
        case Action::take_back:
            return view.mode != Mode::wiring && !state.scene_input.corners.empty() ? "" : "unavailable.no_polygon";
        case Action::next_vehicle:
        case Action::previous_vehicle:
        case Action::remove:
            return view.now->vehicles.empty() ? "unavailable.no_vehicles" : "";
        case Action::next_object:
        case Action::previous_object:
            return objects_beside_vehicles(*view.now->scene).empty() ? "unavailable.no_objects" : "";
        case Action::add_here:
            return view.mode == Mode::wiring ? "unavailable.scene_only" : "";
        case Action::follow:
        case Action::drivers_eye:
        case Action::drive:
            return why_not_with_vehicle(view, state, action);
        case Action::save_brain:
            return why_no_brain_file(view, state);
        case Action::why:
            return why_no_cause(view, state);
        case Action::map:
            return view.settings.map ? "" : why_no_map(view, state);
        case Action::return_run:
            return view.has_left_run ? "" : "unavailable.no_last_run";
        case Action::slot:
            return why_no_slots(view);
        case Action::compare:
            return why_no_comparison(view);
        case Action::reality:
            return view.settings.reality ? "" : why_no_robots(view, state);
        case Action::charts:
            return view.mode == Mode::wiring ? "unavailable.scene_only" : "";
        case Action::larger:
            return view.preferences.type_size < largest_type_size ? "" : "unavailable.largest";
        case Action::smaller:
            return view.preferences.type_size > least_type_size ? "" : "unavailable.smallest";
        case Action::step_back:
        case Action::rewind:
        case Action::fast_forward:
        case Action::last_bookmark:
            return why_not_in_time(view, action);
        case Action::slower:
            return view.time_scale > 0.126f ? "" : "unavailable.slowest";
        case Action::faster:
            return view.time_scale < 15.9f ? "" : "unavailable.fastest";
        case Action::hint:
        case Action::exercise_reset:
            return why_not_in_exercise(view, action);
        case Action::new_scene:
            return empty_scene(view) ? "" : "unavailable.no_empty_scene";
        case Action::save_exercise:
            return view.now->scene->starts.empty() ? "author.no_vehicle" : "";
        case Action::export_robot:
            return why_no_robot(view, state);
        case Action::export_csv:
            return why_no_csv(view, state);
        case Action::first_page:
            return view.pages || view.left_pages ? "" : "unavailable.no_lecture";
        case Action::next_page:
        case Action::previous_page:
        case Action::notes:
        case Action::notes_page:
        case Action::blank:
            return view.pages ? "" : "unavailable.no_lecture";
        case Action::slow_orbit:
            return view.reduce_motion ? "unavailable.motion_reduced" : "";
        case Action::draw_marks:
        case Action::clear_marks:
        case Action::hide_title:
        case Action::hide_character:
        case Action::hide_brain:
            return view.lecture ? "" : "unavailable.no_lecture_view";
        default:
            return "";
    }
}

}  // namespace braitenlab::ui
