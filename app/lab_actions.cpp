#include "app/lab_actions.h"

#include <algorithm>
#include <array>

#include "app/course/lab_lecture.h"
#include "app/course/lab_lesson.h"
#include "app/files/links.h"
#include "app/lab_edits.h"
#include "app/lab_selection.h"
#include "app/playback.h"

namespace braitenlab {

namespace {

constexpr std::array<float, 8> speeds{least_time_scale, 0.25f, 0.5f, 1, 2, 4, 8, largest_time_scale};
constexpr float type_step = 0.125f;
constexpr std::int64_t rewind_ticks = 300;  // five seconds

void change_speed(Lab& lab, int step) {
    const auto here = std::lower_bound(speeds.begin(), speeds.end(), lab.playback.time_scale - 1e-6f);
    const auto index =
        std::clamp(static_cast<int>(here - speeds.begin()) + step, 0, static_cast<int>(speeds.size()) - 1);
    lab.playback.time_scale = speeds[static_cast<std::size_t>(index)];
    lab.playback.pace = {};
}

void change_type_size(Lab& lab, float by) {
    float& size = lab.preferences.type_size;
    size = std::clamp(size + by, least_type_size,
                      lab.before_lecture ? lecture_type * largest_type_size : largest_type_size);
}

// Switches to a camera mode, or back to the overview if that mode is on already.
// A mode that rides with a vehicle is refused without a selected vehicle.
void switch_camera(Lab& lab, CameraMode mode) {
    lab.view.orbits = false;
    if (rides(mode) && lab.view.camera.mode != mode && !selected_vehicle(lab))
        return say(lab, {NoticeKind::failure, "notice.no_vehicle"});
    lab.view.camera.mode = lab.view.camera.mode == mode ? CameraMode::overview : mode;
    if (!rides(lab.view.camera.mode)) return;
    lab.view.camera.zoom = 1;  // the overview's zoom is wrong for a camera that moves with a vehicle
}

// Starts or stops the slow orbit, which is about the framed part of the floor: it leaves the other camera modes.
void switch_orbit(Lab& lab) {
    if (lab.preferences.reduce_motion) return say(lab, {NoticeKind::notice, "unavailable.motion_reduced"});
    const bool orbits = !lab.view.orbits;
    if (orbits && lab.view.camera.mode != CameraMode::overview) switch_camera(lab, lab.view.camera.mode);
    lab.view.orbits = orbits;
}

// Hides or reveals a part of a lecture.
void hide_or_reveal(Lab& lab, bool& part) {
    if (lab.before_lecture) part = !part;
}

// Shows or hides the cause of the selected vehicle's turn.
void ask_why(Lab& lab) {
    lab.explanation.on = !lab.explanation.on;
    update_explanation(lab);
    if (lab.explanation.on && !explanation_of(lab, view_of(lab))) {
        lab.explanation.on = false;
        say(lab, {NoticeKind::failure, selected_vehicle(lab) ? "unavailable.why" : "unavailable.no_vehicle"});
    }
}

// The card of real robots takes the place of the map.
void show_reality(Lab& lab) {
    lab.view.reality = !lab.view.reality;
    if (!lab.view.reality) return;
    lab.view.map = false;
    if (robots_of(lab, view_of(lab))) return;
    lab.view.reality = false;
    say(lab, {NoticeKind::failure, selected_vehicle(lab) ? "unavailable.reality" : "unavailable.no_vehicle"});
}

void show_map(Lab& lab) {
    lab.view.map = !lab.view.map;
    if (lab.view.map) lab.view.reality = false;
    const VehicleView* vehicle = selected_vehicle(lab);
    if (!lab.view.map || (vehicle && can_show_map(view_of(lab), *vehicle))) return;
    lab.view.map = false;
    say(lab, {NoticeKind::failure, vehicle ? "unavailable.map" : "unavailable.no_vehicle"});
}

// Shows the intensity of the next channel that has one in this scene; after the last, none.
void show_next_field(Lab& lab) {
    const auto channels = channels_with_intensity(lab.document.session.snapshot());
    auto next = channels.begin();
    if (lab.view.overlays.field) {
        next = std::find(channels.begin(), channels.end(), *lab.view.overlays.field);
        if (next != channels.end()) ++next;
    }
    lab.view.overlays.field = next == channels.end() ? std::nullopt : std::optional(*next);
}

}  // namespace

void act(Lab& lab, Action action) {
    switch (action) {
        case Action::play_pause:
            set_mode(lab, lab.playback.mode == Mode::playing ? Mode::paused : Mode::playing);
            break;
        case Action::step:
            if (lab.playback.mode == Mode::playing) set_mode(lab, Mode::paused);
            tick(lab);
            break;
        case Action::step_back:
            if (lab.playback.mode == Mode::playing) set_mode(lab, Mode::paused);
            seek_by(lab, -1);
            break;
        case Action::rewind:
            seek_by(lab, -rewind_ticks);
            break;
        case Action::fast_forward:
            seek_by(lab, rewind_ticks);
            break;
        case Action::set_bookmark:
            set_bookmark(lab);
            break;
        case Action::last_bookmark:
            go_to_last_bookmark(lab);
            break;
        case Action::reset:
            if (lab.together && lab.together->robot)
                restart_replay(lab);
            else if (lab.together)
                begin_together(lab);
            else
                set_mode(lab, Mode::paused), reset(lab);
            break;
        case Action::add:
            apply(lab, AddVehicle{});
            break;
        case Action::remove:
            apply(lab, RemoveVehicle{});
            break;
        case Action::new_population:
            apply(lab, NewPopulation{});
            break;
        case Action::follow:
            switch_camera(lab, CameraMode::follow);
            break;
        case Action::birds_eye:
            switch_camera(lab, CameraMode::birds_eye);
            break;
        case Action::drivers_eye:
            switch_camera(lab, CameraMode::driver);
            break;
        case Action::home:
            lab.view.camera = home_camera(lab);
            lab.view.orbits = false;
            break;
        case Action::slow_orbit:
            switch_orbit(lab);
            break;
        case Action::hide_title:
            hide_or_reveal(lab, lab.view.revealed.title);
            break;
        case Action::hide_character:
            hide_or_reveal(lab, lab.view.revealed.character);
            break;
        case Action::hide_brain:
            hide_or_reveal(lab, lab.view.revealed.brain);
            break;
        case Action::sensors:
            lab.view.sensors = !lab.view.sensors;
            break;
        case Action::outlines:
            lab.view.outlines = !lab.view.outlines;
            break;
        case Action::trails:
            lab.view.overlays.trails = !lab.view.overlays.trails;
            break;
        case Action::surfaces:
            lab.view.overlays.surfaces = !lab.view.overlays.surfaces;
            break;
        case Action::memory:
            lab.view.overlays.memory = !lab.view.overlays.memory;
            break;
        case Action::labels:
            lab.view.overlays.labels = !lab.view.overlays.labels;
            break;
        case Action::next_field:
            show_next_field(lab);
            break;
        case Action::last_run:
            lab.view.overlays.last_run = !lab.view.overlays.last_run;
            break;
        case Action::why:
            ask_why(lab);
            break;
        case Action::map:
            show_map(lab);
            break;
        case Action::slot:
            store_or_swap(lab);
            break;
        case Action::compare:
            compare_slots(lab);
            break;
        case Action::reality:
            show_reality(lab);
            break;
        case Action::watch:
            if (lab.playback.mode == Mode::wiring) set_mode(lab, Mode::paused), lab.view.watching = false;
            lab.view.watching = !lab.view.watching;
            break;
        case Action::values:
            lab.view.values = !lab.view.values;
            break;
        case Action::another_start:
            reset(lab, lab.document.session.seed() + 1);
            break;
        case Action::wiring:
            set_mode(lab, lab.playback.mode == Mode::wiring ? Mode::paused : Mode::wiring);
            break;
        case Action::cancel:
            if (lab.playback.mode == Mode::wiring)
                set_mode(lab, Mode::paused);
            else if (lab.explanation.on)
                ask_why(lab);
            else if (lab.before_lecture)
                end_lecture(lab);
            break;
        case Action::return_run:
            return_to_last_run(lab);
            break;
        case Action::undo:
            if (can_undo_return(lab)) return undo_return(lab);
            undo(lab);
            break;
        case Action::redo:
            if (can_redo_return(lab)) return redo_return(lab);
            redo(lab);
            break;
        case Action::drive:
            drive(lab);
            break;
        case Action::slower:
            change_speed(lab, -1);
            break;
        case Action::faster:
            change_speed(lab, +1);
            break;
        case Action::next_vehicle:
            select_neighbour(lab, +1);
            break;
        case Action::previous_vehicle:
            select_neighbour(lab, -1);
            break;
        case Action::next_object:
            select_next_object(lab, +1);
            break;
        case Action::previous_object:
            select_next_object(lab, -1);
            break;
        case Action::hint:
            show_hint(lab);
            break;
        case Action::exercise_reset:
            start_over(lab);
            break;
        case Action::exit:
            lab.exit = true;
            break;
        case Action::erase:
        case Action::duplicate:
        case Action::copy:
        case Action::cut:
        case Action::select_all:
            act_on_objects(lab, action);
            break;
        case Action::save:
            lab.files.push_back(SaveRequest{lab.document.path.string(), FileKind::scene});
            break;
        case Action::copy_link:
            copy_link(lab);
            break;
        case Action::screenshot:
            lab.screenshot = true;
            break;
        case Action::full_screen:
            lab.full_screen = true;
            break;
        case Action::theme:
            lab.preferences.theme = lab.preferences.theme == Theme::dark ? Theme::light : Theme::dark;
            break;
        case Action::lecture:
            if (lab.before_lecture) {
                if (lab.notice.key == "notice.projector_view") lab.notice = {};
                end_lecture(lab);
            } else if (lab.left_pages && lab.left_run == lab.document.run_id) {
                request_left_lecture(lab, true);
            } else {
                begin_lecture(lab);
                say(lab, {NoticeKind::notice, "notice.projector_view"});
            }
            break;
        case Action::first_page:
            lab.pages ? show_page(lab, 0) : request_left_lecture(lab, false);
            break;
        case Action::next_page:
            next_page(lab);
            break;
        case Action::previous_page:
            previous_page(lab);
            break;
        case Action::notes:
            if (lab.pages) lab.pages->notes = !lab.pages->notes;
            break;
        case Action::notes_page:
            lab.opens_notes = lab.pages.has_value();
            break;
        case Action::larger:
            change_type_size(lab, +type_step);
            break;
        case Action::smaller:
            change_type_size(lab, -type_step);
            break;
        default:
            break;  // handled by the panels
    }
}

}  // namespace braitenlab
