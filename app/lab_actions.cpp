#include "app/lab_actions.h"

#include <algorithm>
#include <array>

#include "app/course/edit_again.h"
#include "app/course/lab_lecture.h"
#include "app/course/lab_lesson.h"
#include "app/files/links.h"
#include "app/lab_edits.h"
#include "app/lab_reset.h"
#include "app/lab_selection.h"
#include "app/playback.h"
#include "app/seeking.h"

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
        return say(lab, {NoticeKind::failure,
                         shown_snapshot(lab).vehicles.empty() ? "unavailable.no_vehicles" : "notice.no_vehicle"});
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

constexpr std::string_view hidden_notice = "notice.asks_first";

// Keys of what is said once a part of a lecture is hidden, and once it is revealed. An empty one: nothing is said.
struct PartNotices {
    std::string_view hidden, revealed;
};

// Hides or reveals a part of a lecture and says so, because a page may show nothing of it now. The bar shows a revealed
// title itself. A notice that says what is hidden ends.
void hide_or_reveal(Lab& lab, bool& part, PartNotices notices) {
    if (!lab.before_lecture) return;
    part = !part;
    if (part || lab.notice.key == hidden_notice) lab.notice = {};
    const std::string_view said = part ? notices.revealed : notices.hidden;
    if (!said.empty()) say(lab, {NoticeKind::notice, std::string(said)});
}

// Shows or hides the cause of the selected vehicle's turn.
void ask_why(Lab& lab) {
    lab.explanation.on = !lab.explanation.on;
    update_explanation(lab.explanation, lab);
    if (lab.explanation.on && !explanation_of(lab.explanation, lab)) {
        lab.explanation.on = false;
        say(lab, {NoticeKind::failure, selected_vehicle(lab) ? "unavailable.why" : "unavailable.no_vehicle"});
    }
}

// The card of real robots takes the place of the map.
void show_reality(Lab& lab) {
    lab.view.reality = !lab.view.reality;
    if (!lab.view.reality) return;
    lab.view.map = false;
    if (robots_of(lab.robots, lab)) return;
    lab.view.reality = false;
    say(lab, {NoticeKind::failure, selected_vehicle(lab) ? "unavailable.reality" : "unavailable.no_vehicle"});
}

void show_map(Lab& lab) {
    lab.view.map = !lab.view.map;
    if (lab.view.map && lab.playback.mode == Mode::wiring) {
        lab.view.map = false;
        return say(lab, {NoticeKind::failure, "unavailable.scene_only"});
    }
    if (lab.view.map) lab.view.reality = false;
    const std::string_view why_not = why_no_map(lab);
    if (!lab.view.map || why_not.empty()) return;
    lab.view.map = false;
    say(lab, {NoticeKind::failure, std::string(why_not)});
}

// Ends what Esc is for: the foremost of what covers the scene or takes its place. A lecture ends only after a notice
// that says so, because the start key of a clicker sends Esc, too.
void cancel(Lab& lab) {
    constexpr std::string_view asked = "notice.escape_again";
    if (lab.playback.mode == Mode::wiring) return set_mode(lab, Mode::paused);
    if (lab.explanation.on) return ask_why(lab);
    if (lab.view.reality) return show_reality(lab);
    if (lab.view.map) return show_map(lab);
    if (lab.slots.runs.question()) return end_comparison(lab.slots, lab);
    if (!lab.before_lecture) return;
    if (lab.notice.key != asked) return say(lab, {NoticeKind::notice, std::string(asked)});
    lab.notice = {};
    end_lecture(lab);
}

// Reveals this scene, or hides it again; the next scene is hidden. It ends with the lecture.
void ask_first(Lab& lab) {
    if (!lab.before_lecture) return;
    Revealed& revealed = lab.view.revealed;
    if (revealed == hidden_until_asked) {
        revealed = revealed_after_asking;
        return say(lab, {NoticeKind::notice, "notice.asks_again"});
    }
    revealed = hidden_until_asked;
    if (!lab.pages && !lab.lectures.tally) say(lab, {NoticeKind::notice, std::string(hidden_notice)});
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

// Play leaves the wiring editor and keeps its diagram beside the scene, where it shows the values of the run.
void play_or_pause(Lab& lab) {
    const bool left_wiring = lab.playback.mode == Mode::wiring;
    set_mode(lab, lab.playback.mode == Mode::playing ? Mode::paused : Mode::playing);
    if (!left_wiring) return;
    lab.view.watching = true;
    say(lab, {NoticeKind::notice, "notice.left_wiring"});
}

// The wiring editor stays open: its inset shows the vehicle at its start.
void reset_and_pause(Lab& lab) {
    if (lab.playback.mode != Mode::wiring) set_mode(lab, Mode::paused);
    reset(lab);
}

// The new vehicle is where there is room; selected, it is found.
void add_vehicle(Lab& lab) {
    if (!apply(lab, AddVehicle{})) return;
    select(lab, vehicle_object(lab.document.session.snapshot().vehicles.back().id));
}

struct LabAction {
    Action action;
    void (*act)(Lab&);
    bool on_own_run = false;  // acts_on_own_run()
};

constexpr bool own_run = true;

constexpr LabAction lab_actions[]{
    {Action::play_pause, [](Lab& lab) { play_or_pause(lab); }},
    {Action::step,
     [](Lab& lab) {
         if (lab.playback.mode == Mode::playing) set_mode(lab, Mode::paused);
         tick(lab);
     }},
    {Action::step_back,
     [](Lab& lab) {
         if (lab.playback.mode == Mode::playing) set_mode(lab, Mode::paused);
         seek_by(lab, -1);
     },
     own_run},
    {Action::rewind, [](Lab& lab) { seek_by(lab, -rewind_ticks); }, own_run},
    {Action::fast_forward, [](Lab& lab) { seek_by(lab, rewind_ticks); }, own_run},
    {Action::set_bookmark, [](Lab& lab) { set_bookmark(lab); }, own_run},
    {Action::last_bookmark, [](Lab& lab) { go_to_last_bookmark(lab); }, own_run},
    {Action::reset,
     [](Lab& lab) {
         if (lab.together && lab.together->robot)
             restart_replay(lab.robots, lab);
         else if (lab.together)
             show_starts_together(lab);
         else
             reset_and_pause(lab);
     }},
    {Action::add, [](Lab& lab) { add_vehicle(lab); }, own_run},
    {Action::remove, [](Lab& lab) { apply(lab, RemoveVehicle{}); }, own_run},
    {Action::new_population, [](Lab& lab) { apply(lab, NewPopulation{}); }, own_run},
    {Action::follow, [](Lab& lab) { switch_camera(lab, CameraMode::follow); }},
    {Action::birds_eye, [](Lab& lab) { switch_camera(lab, CameraMode::birds_eye); }},
    {Action::drivers_eye, [](Lab& lab) { switch_camera(lab, CameraMode::driver); }},
    {Action::home,
     [](Lab& lab) {
         lab.view.camera = home_camera(lab);
         lab.view.orbits = false;
     }},
    {Action::slow_orbit, [](Lab& lab) { switch_orbit(lab); }},
    {Action::hide_title,
     [](Lab& lab) {
         hide_or_reveal(lab, lab.view.revealed.title, {"notice.hidden_title", ""});
     }},
    {Action::hide_character,
     [](Lab& lab) {
         hide_or_reveal(lab, lab.view.revealed.character, {"notice.hidden_character", "notice.shown_character"});
     }},
    {Action::hide_brain,
     [](Lab& lab) {
         hide_or_reveal(lab, lab.view.revealed.brain, {"notice.hidden_brain", "notice.shown_brain"});
     }},
    {Action::ask_first, [](Lab& lab) { ask_first(lab); }},
    {Action::tally, [](Lab& lab) { switch_tally(lab); }},
    {Action::next_field, [](Lab& lab) { show_next_field(lab); }},
    {Action::why, [](Lab& lab) { ask_why(lab); }},
    {Action::map, [](Lab& lab) { show_map(lab); }},
    {Action::slot, [](Lab& lab) { store_or_swap(lab.slots, lab); }, own_run},
    {Action::compare,
     [](Lab& lab) {
         if (can_compare_slots(lab.slots, lab)) reset(lab), compare_slots(lab.slots, lab);
     },
     own_run},
    {Action::reality, [](Lab& lab) { show_reality(lab); }},
    {Action::watch,
     [](Lab& lab) {
         if (lab.playback.mode == Mode::wiring) set_mode(lab, Mode::paused), lab.view.watching = false;
         lab.view.watching = !lab.view.watching;
     }},
    {Action::another_start, [](Lab& lab) { reset(lab, lab.document.session.seed() + 1); }, own_run},
    {Action::wiring, [](Lab& lab) { set_mode(lab, lab.playback.mode == Mode::wiring ? Mode::paused : Mode::wiring); },
     own_run},
    {Action::cancel, [](Lab& lab) { cancel(lab); }, own_run},
    {Action::return_run, [](Lab& lab) { return_to_last_run(lab.last_run, lab); }, own_run},
    {Action::undo,
     [](Lab& lab) {
         if (can_undo_return(lab.last_run, lab)) return undo_return(lab.last_run, lab);
         undo(lab);
     },
     own_run},
    {Action::redo,
     [](Lab& lab) {
         if (can_redo_return(lab.last_run, lab)) return redo_return(lab.last_run, lab);
         redo(lab);
     },
     own_run},
    {Action::drive, [](Lab& lab) { drive(lab); }, own_run},
    {Action::slower, [](Lab& lab) { change_speed(lab, -1); }},
    {Action::faster, [](Lab& lab) { change_speed(lab, +1); }},
    {Action::next_vehicle, [](Lab& lab) { select_neighbour(lab, +1); }},
    {Action::previous_vehicle, [](Lab& lab) { select_neighbour(lab, -1); }},
    {Action::next_object, [](Lab& lab) { select_next_object(lab, +1); }},
    {Action::previous_object, [](Lab& lab) { select_next_object(lab, -1); }},
    {Action::hint, [](Lab& lab) { show_hint(lab); }},
    {Action::exercise_reset, [](Lab& lab) { start_over(lab); }, own_run},
    {Action::edit_again, [](Lab& lab) { edit_again(lab); }},
    {Action::exit, [](Lab& lab) { lab.window.exit = true; }},
    {Action::erase, [](Lab& lab) { act_on_objects(lab, Action::erase); }, own_run},
    {Action::duplicate, [](Lab& lab) { act_on_objects(lab, Action::duplicate); }, own_run},
    {Action::copy, [](Lab& lab) { act_on_objects(lab, Action::copy); }},
    {Action::cut, [](Lab& lab) { act_on_objects(lab, Action::cut); }, own_run},
    {Action::select_all, [](Lab& lab) { act_on_objects(lab, Action::select_all); }},
    {Action::save,
     [](Lab& lab) {
         lab.window.files.push_back(SaveRequest{lab.document.path.string(), FileKind::scene});
     }},
    {Action::copy_link, [](Lab& lab) { copy_link(lab); }},
    {Action::screenshot, [](Lab& lab) { lab.window.screenshot = true; }},
    {Action::full_screen, [](Lab& lab) { lab.window.full_screen = true; }},
    {Action::theme,
     [](Lab& lab) { lab.preferences.theme = lab.preferences.theme == Theme::dark ? Theme::light : Theme::dark; }},
    {Action::lecture,
     [](Lab& lab) {
         if (lab.before_lecture) {
             if (lab.notice.key == "notice.projector_view" || lab.notice.key == "notice.escape_again") lab.notice = {};
             end_lecture(lab);
         } else if (lab.lectures.left && lab.lectures.left_run == lab.document.run_id) {
             request_left_lecture(lab, true);
         } else {
             begin_lecture(lab);
             say(lab, {NoticeKind::notice, "notice.projector_view"});
         }
     }},
    {Action::first_page, [](Lab& lab) { lab.pages ? begin_pages_again(lab) : request_left_lecture(lab, false); }},
    {Action::next_page, [](Lab& lab) { next_page(lab); }},
    {Action::previous_page, [](Lab& lab) { previous_page(lab); }},
    {Action::notes,
     [](Lab& lab) {
         if (lab.pages) lab.pages->notes = !lab.pages->notes;
     }},
    {Action::notes_page, [](Lab& lab) { lab.window.opens_notes = lab.pages.has_value(); }},
    {Action::larger, [](Lab& lab) { change_type_size(lab, +type_step); }},
    {Action::smaller, [](Lab& lab) { change_type_size(lab, -type_step); }},
#define LAB_ACTION(id, ...)
#define UI_ACTION(id, ...)
#define VIEW_SWITCH(id, keys, flag, ...) {Action::id, [](Lab& lab) { lab.view.flag = !lab.view.flag; }},
#include "ui/actions.def"
};

// The actions that the lab executes.
constexpr Action of_lab[]{
#define LAB_ACTION(id, ...) Action::id,
#define UI_ACTION(id, ...)
#define VIEW_SWITCH(id, ...) Action::id,
#include "ui/actions.def"
};

constexpr const LabAction* find_row(Action action) {
    for (const LabAction& row : lab_actions)
        if (row.action == action) return &row;
    return nullptr;
}

constexpr bool has_a_row_for_each_action_of_the_lab() {
    for (const Action action : of_lab)
        if (!find_row(action)) return false;
    return std::size(lab_actions) == std::size(of_lab);
}
static_assert(has_a_row_for_each_action_of_the_lab());

}  // namespace

void act(Lab& lab, Action action) {
    if (const LabAction* row = find_row(action)) row->act(lab);
}

bool acts_on_own_run(Action action) {
    const LabAction* row = find_row(action);
    return row && row->on_own_run;
}

}  // namespace braitenlab
