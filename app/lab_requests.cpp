#include "app/lab_requests.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/course/lab_children.h"
#include "app/course/lab_lecture.h"
#include "app/course/lab_lesson.h"
#include "app/course/lab_progress.h"
#include "app/files/links.h"
#include "app/files/pages.h"
#include "app/lab_selection.h"
#include "app/playback.h"
#include "core/lesson/utf8.h"
#include "core/match.h"
#include "ui/scene_input/clipboard.h"
#include "ui/scene_input/edits.h"

namespace braitenlab {

namespace {

constexpr std::array<float, 8> speeds{least_time_scale, 0.25f, 0.5f, 1, 2, 4, 8, largest_time_scale};
constexpr float type_step = 0.125f;
constexpr std::int64_t rewind_ticks = 300;  // five seconds

// Undo or redo.
template <class Change>
void change(Lab& lab, const Change& make) {
    const std::uint64_t latest = lab.document.session.latest();
    const UndoResult made = make();
    lab.document.edits += made.done;
    keep_selection(lab);
    follow_removed_ticks(lab.document, latest);
    recompute_referee(lab.document);
    record_referee(lab.document);
    watch(lab);
    report_time_change(lab, latest);
    if (made.error) say(lab, *made.error);
}

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

// Applies an edit and selects what it has added.
void edit(Lab& lab, const Command& command, std::uint64_t gesture = 0) {
    if (!apply(lab, command, gesture)) return;
    if (const SceneObject added = ui::added_by(lab.document.session.snapshot(), command)) select(lab, added);
}

// An edit in the wiring diagram pauses, so that the vehicle stays where it is while the brain is edited further.
void edit_by_request(Lab& lab, const EditRequest& r) {
    const bool from_diagram = r.gesture >= gestures::canvas && r.gesture < gestures::viewport;
    if (from_diagram && lab.playback.mode == Mode::playing) set_mode(lab, Mode::paused);
    edit(lab, r.command, r.gesture);
}

void erase(Lab& lab) {
    const std::uint64_t gesture = gestures::lab + ++lab.gesture;
    for (const Command& command :
         ui::removals_of(lab.document.session.snapshot(), selected_objects(lab.view.selection)))
        apply(lab, command, gesture);
}

// Adds copied objects as one step of undo and selects them.
void paste(Lab& lab, const Scene& copy, std::optional<maths::vec2> at) {
    const std::uint64_t gesture = gestures::lab + ++lab.gesture;
    std::vector<SceneObject> added;
    for (const Command& command : ui::pasted(lab.document.session.snapshot(), copy, at)) {
        const Command with_room = ui::with_room(lab.document.session.snapshot(), command);
        if (!apply(lab, with_room, gesture)) break;  // the notice says why
        if (const SceneObject one = ui::added_by(lab.document.session.snapshot(), with_room)) added.push_back(one);
    }
    select_objects(lab, added);
}

// Duplicates the selected objects. Edits of a single copied vehicle apply to it alone.
void duplicate(Lab& lab) {
    const Snapshot& now = lab.document.session.snapshot();
    const std::vector<SceneObject> objects = selected_objects(lab.view.selection);
    if (objects.size() > 1) return paste(lab, ui::copied(now, objects), std::nullopt);
    const auto copy = ui::copy_of(now, chosen_object(lab.view.selection));
    if (!copy || !apply(lab, *copy)) return;
    if (const SceneObject added = ui::added_by(lab.document.session.snapshot(), *copy)) select(lab, added);
    if (std::holds_alternative<AddVehicle>(*copy)) lab.view.selection.whole_kind = false;
}

void copy(Lab& lab) {
    Scene copy = ui::copied(lab.document.session.snapshot(), selected_objects(lab.view.selection));
    if (ui::object_count(copy) > 0) lab.clipboard = std::move(copy);
}

void select_all(Lab& lab) {
    const Snapshot& now = lab.document.session.snapshot();
    std::vector<SceneObject> all = objects_beside_vehicles(*now.scene);
    for (const VehicleView& v : now.vehicles) all.push_back(vehicle_object(v.id));
    select_objects(lab, all);
}

// Actions on the objects of the scene. The canvas has its own while it replaces the scene.
void act_on_objects(Lab& lab, Action action) {
    if (lab.playback.mode == Mode::wiring) return;
    if (action == Action::erase || action == Action::cut) {
        if (action == Action::cut) copy(lab);
        erase(lab);
    } else if (action == Action::duplicate) {
        duplicate(lab);
    } else if (action == Action::copy) {
        copy(lab);
    } else if (action == Action::select_all) {
        select_all(lab);
    }
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

// Actions on the exercise's own run: the graded starts that run at once end first.
bool acts_on_own_run(Action action) {
    switch (action) {
        case Action::step_back:
        case Action::rewind:
        case Action::fast_forward:
        case Action::set_bookmark:
        case Action::last_bookmark:
        case Action::add:
        case Action::remove:
        case Action::new_population:
        case Action::wiring:
        case Action::another_start:
        case Action::cancel:
        case Action::undo:
        case Action::redo:
        case Action::drive:
        case Action::slot:
        case Action::compare:
        case Action::return_run:
        case Action::exercise_reset:
        case Action::erase:
        case Action::duplicate:
        case Action::cut:
            return true;
        default:
            return false;
    }
}

bool acts_on_own_run(const Request& request) {
    if (const auto* action = std::get_if<Action>(&request)) return acts_on_own_run(*action);
    return std::holds_alternative<EditRequest>(request) || std::holds_alternative<PasteRequest>(request) ||
           std::holds_alternative<SeedRequest>(request) || std::holds_alternative<SeekRequest>(request) ||
           std::holds_alternative<BookmarkRequest>(request) || std::holds_alternative<ShowMeRequest>(request) ||
           std::holds_alternative<KeptRequest>(request) || std::holds_alternative<StudentRequest>(request) ||
           std::holds_alternative<ChooseChildRequest>(request) ||
           std::holds_alternative<EarlierGenerationRequest>(request) || std::holds_alternative<SlotRequest>(request);
}

// While the graded starts run at once, their vehicles cannot be selected.
bool selects(const Request& request) {
    return std::holds_alternative<SelectRequest>(request) || std::holds_alternative<TakeRequest>(request) ||
           std::holds_alternative<SelectObjectsRequest>(request);
}

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
            lab.view.camera = Camera{};
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
            else if (lab.before_lecture)
                end_lecture(lab);
            break;
        case Action::return_run:
            return_to_last_run(lab);
            break;
        case Action::undo:
            if (can_undo_return(lab)) return undo_return(lab);
            change(lab, [&] { return lab.document.session.undo(); });
            break;
        case Action::redo:
            if (can_redo_return(lab)) return redo_return(lab);
            change(lab, [&] { return lab.document.session.redo(); });
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

}  // namespace

void report_time_change(Lab& lab, std::uint64_t latest_before) {
    constexpr std::uint64_t reported = 30;  // ticks
    const std::uint64_t now = lab.document.session.snapshot().tick, latest = lab.document.session.latest();
    const std::string seconds = fmt::format("{:.1f}", lab.document.session.snapshot().seconds);
    if (latest > latest_before && latest > now + reported)
        say(lab, {NoticeKind::done, "notice.time_back", seconds, "", true});
    if (latest_before <= latest + reported) return;
    const bool can_come_back = lab.document.session.undo_brings_time_back();
    say(lab, {NoticeKind::notice, can_come_back ? "notice.forgotten" : "notice.forgotten_for_good", seconds, "", true});
}

bool apply(Lab& lab, const Command& command, std::uint64_t gesture) {
    const std::uint64_t latest = lab.document.session.latest();
    const auto error = lab.document.session.apply(command, gesture);
    if (error) {
        say(lab, *error);
    } else {
        ++lab.document.edits;
        follow_removed_ticks(lab.document, latest);
        tell_referee(lab, command);
        report_time_change(lab, latest);
    }
    keep_selection(lab);
    return !error;
}

void handle(Lab& lab, const Request& request) {
    if (lab.together && selects(request)) return;
    if (lab.together && acts_on_own_run(request)) {
        end_together(lab);
        if (const auto* action = std::get_if<Action>(&request); action && *action == Action::cancel) return;
    }
    std::visit(Match{[&](Action action) { act(lab, action); },
                     [&](const EditRequest& r) { edit_by_request(lab, r); },
                     [&](const SelectRequest& r) {
                         forget_death_notice(lab);
                         select(lab, vehicle_object(r.vehicle)), keep_selection(lab);
                     },
                     [&](const NoticeRequest& r) {
                         say(lab, {NoticeKind::notice, r.key, r.words, r.more});
                     },
                     [&](const TakeRequest& r) { select_object(lab, r.object); },
                     [&](const SelectObjectsRequest& r) { select_objects(lab, r.objects), keep_selection(lab); },
                     [&](const PasteRequest& r) {
                         if (lab.playback.mode != Mode::wiring) paste(lab, lab.clipboard, r.at);
                     },
                     [&](const CanvasShareRequest& r) {
                         lab.view.canvas_share = std::clamp(r.share, least_canvas_share, largest_canvas_share);
                     },
                     [&](const PairRequest& r) { lab.view.selection.pair = r.name; },
                     [&](const ScopeRequest& r) { lab.view.selection.whole_kind = r.whole_kind; },
                     [&](const SeedRequest& r) { reset(lab, r.seed); },
                     [&](const MapRequest& r) { choose_map(lab.map, r); },
                     [&](const StudyRequest& r) { handle_study(lab.study, r); },
                     [&](const RobotsRequest& r) { handle_robots(lab, r); },
                     [&](const SeekRequest& r) { seek(lab, r); },
                     [&](const WhyRequest& r) { explain_at(lab, r.tick); },
                     [&](const BookmarkRequest& r) { handle_bookmark(lab, r); },
                     [&](const OpenRequest& r) { lab.files.push_back(r); },
                     [&](const BrowseRequest& r) { lab.files.push_back(r); },
                     [&](const SaveRequest& r) { lab.files.push_back(r); },
                     [&](const SaveExerciseRequest& r) { lab.files.push_back(r); },
                     [&](const RecoverRequest& r) { lab.files.push_back(r); },
                     [&](const BeginRequest&) { lab.begins = true; },
                     [&](const UploadRequest&) { lab.uploads = true; },
                     [&](const LeaveRequest& r) { lab.files.push_back(r); },
                     [&](const PreferencesRequest& r) { lab.preferences = r.preferences; },
                     [&](const OverlaysRequest& r) { lab.view.overlays = r.overlays; },
                     [&](const PredictRequest& r) { predict(lab, r); },
                     [&](const PredictPathRequest& r) { predict(lab, r); },
                     [&](const CompareRequest& r) { compare(lab, r); },
                     [&](const FreePlayRequest& r) {
                         if (lab.document.lesson) lab.document.lesson->view.free_play = r.on;
                     },
                     [&](const ShowMeRequest&) { show_solution(lab); },
                     [&](const ChooseChildRequest& r) { choose_child(lab, r.child); },
                     [&](const EarlierGenerationRequest&) { take_choice_back(lab); },
                     [&](const KeptRequest&) { take_kept_submission(lab); },
                     [&](const TogetherRequest& r) { r.on ? begin_together(lab) : end_together(lab); },
                     [&](const NotesRequest& r) {
                         if (lab.document.lesson) lab.document.lesson->view.notes = utf8_cut(r.text, longest_notes);
                     },
                     [&](const StudentRequest& r) {
                         if (r.edit == StudentEdit::save) return lab.files.push_back(r);
                         edit_students(lab, r);
                     },
                     [&](const HandsRequest& r) { count_hands(lab, r); },
                     [&](const SlotRequest& r) { handle_slot(lab, r); },
                     [&](const MysteryRequest& r) { handle_mystery(lab, r); },
                     [&](const ExportRequest& r) { lab.files.push_back(r); },
                     [&](const WriteFilesRequest& r) { lab.files.push_back(r); },
                     [&](const HandInRequest& r) { lab.reports.push_back(r); },
                     [&](const LabRecordRequest& r) { lab.reports.push_back(r); },
                     [&](const TakeAwayRequest& r) { lab.take_away = r.what; },
                     [&](const PageRequest& r) { open_page(lab, r.page); },
                     [&](const CancelClipRequest&) { lab.cancels_clip = true; },
                     [&](const SpeedRequest& r) {
                         lab.playback.time_scale = std::clamp(r.time_scale, speeds.front(), speeds.back());
                     }},
               request);
}

namespace {

// Adds a request that only moves an object as a part of this gesture; false for any other request.
bool add_move(MoveObjects& all, const Request& request, std::uint64_t gesture) {
    const auto* edit = std::get_if<EditRequest>(&request);
    if (!edit || edit->gesture != gesture || gesture == 0) return false;
    return std::visit(
        Match{[&](const MoveVehicle& c) { return all.of_vehicles.push_back(c), true; },
              [&](const MoveSource& c) { return all.of_sources.push_back(c), true; },
              [&](const MoveObstacle& c) { return all.of_obstacles.push_back(c), true; },
              [&](const MoveZone& c) { return all.of_zones.push_back(c), true; }, [](const auto&) { return false; }},
        edit->command);
}

}  // namespace

void handle_all(Lab& lab, const Outbox& requests) {
    for (auto next = requests.begin(); next != requests.end();) {
        const auto* edit = std::get_if<EditRequest>(&*next);
        const std::uint64_t gesture = edit ? edit->gesture : 0;
        MoveObjects all;
        auto end = next;
        while (end != requests.end() && add_move(all, *end, gesture)) ++end;
        if (end - next > 1) {
            handle(lab, EditRequest{all, gesture});
            next = end;
        } else {
            handle(lab, *next++);
        }
    }
}

}  // namespace braitenlab
