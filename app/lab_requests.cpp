// What requests do: each action and each request that panels, keys and the mouse can make.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/lab_parts.h"
#include "core/match.h"
#include "ui/stage/edits.h"

namespace braitenlab {

namespace {

constexpr std::array<float, 8> speeds{0.125f, 0.25f, 0.5f, 1, 2, 4, 8, 16};
constexpr float type_step = 0.125f;
constexpr float lecture_type = 1.6f;        // times what a person has at the desk
constexpr std::int64_t rewind_ticks = 300;  // five seconds

// Says what became of the time that was recorded ahead.
void tell_of_time(Lab& lab, std::uint64_t latest_before) {
    constexpr std::uint64_t worth_a_word = 30;  // ticks
    const std::uint64_t now = lab.session.snapshot().tick, latest = lab.session.latest();
    const std::string seconds = fmt::format("{:.1f}", lab.session.snapshot().seconds);
    if (latest > latest_before && latest > now + worth_a_word)
        say(lab, {NoticeKind::done, "notice.time_back", seconds});
    if (latest_before <= latest + worth_a_word) return;
    const bool can_come_back = lab.session.undo_brings_time_back();
    say(lab, {NoticeKind::notice, can_come_back ? "notice.forgotten" : "notice.forgotten_for_good", seconds});
}

// Undo or redo.
template <class Change>
void change(Lab& lab, const Change& make) {
    const std::uint64_t latest = lab.session.latest();
    lab.work += make();
    keep_selection(lab);
    watch(lab);
    tell_of_time(lab, latest);
}

void change_speed(Lab& lab, int step) {
    const auto here = std::lower_bound(speeds.begin(), speeds.end(), lab.time_scale - 1e-6f);
    const auto index =
        std::clamp(static_cast<int>(here - speeds.begin()) + step, 0, static_cast<int>(speeds.size()) - 1);
    lab.time_scale = speeds[static_cast<std::size_t>(index)];
    lab.pace = {};
}

void change_type_size(Lab& lab, float by) {
    float& size = lab.preferences.type_size;
    size = std::clamp(size + by, least_type_size,
                      lab.before_lecture ? lecture_type * largest_type_size : largest_type_size);
}

// As a person asked for it: what was added is what comes next under the hand.
void edit(Lab& lab, const Command& command, std::uint64_t gesture = 0) {
    if (!apply(lab, command, gesture)) return;
    if (const Thing added = added_by(lab.session.snapshot(), command)) select(lab, added);
}

void edit_if(Lab& lab, const std::optional<Command>& command) {
    if (command && lab.mode != Mode::wiring) edit(lab, *command);
}

// Into a way of looking, or back to the overview when it is on already.
void look_through(Lab& lab, CameraMode mode) {
    lab.camera.mode = lab.camera.mode == mode ? CameraMode::overview : mode;
    if (!rides(lab.camera.mode)) return;
    lab.camera.zoom = 1;  // how near the overview was says nothing about how near to ride
}

// From none through the channels of which there is something to feel, and back to none.
void show_next_field(Lab& lab) {
    const auto channels = channels_with_intensity(lab.session.snapshot());
    auto next = channels.begin();
    if (lab.overlays.field) {
        next = std::find(channels.begin(), channels.end(), *lab.overlays.field);
        if (next != channels.end()) ++next;
    }
    lab.overlays.field = next == channels.end() ? std::nullopt : std::optional(*next);
}

void begin_lecture(Lab& lab) {
    lab.before_lecture =
        LectureBefore{lab.preferences.theme, lab.preferences.type_size, lab.camera, lab.sensors, lab.outlines};
    lab.preferences.theme = Theme::light;
    lab.preferences.type_size *= lecture_type;
}

void end_lecture(Lab& lab) {
    const LectureBefore before = *lab.before_lecture;
    lab.preferences = desk_preferences(lab);
    lab.camera = before.camera;
    lab.sensors = before.sensors;
    lab.outlines = before.outlines;
    lab.before_lecture.reset();
}

void act(Lab& lab, Action action) {
    switch (action) {
        case Action::play_pause:
            set_mode(lab, lab.mode == Mode::playing ? Mode::paused : Mode::playing);
            break;
        case Action::step:
            if (lab.mode == Mode::playing) set_mode(lab, Mode::paused);
            tick(lab);
            break;
        case Action::step_back:
            if (lab.mode == Mode::playing) set_mode(lab, Mode::paused);
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
            reset(lab);
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
            look_through(lab, CameraMode::follow);
            break;
        case Action::birds_eye:
            look_through(lab, CameraMode::birds_eye);
            break;
        case Action::drivers_eye:
            look_through(lab, CameraMode::driver);
            break;
        case Action::home:
            lab.camera = Camera{};
            break;
        case Action::sensors:
            lab.sensors = !lab.sensors;
            break;
        case Action::outlines:
            lab.outlines = !lab.outlines;
            break;
        case Action::trails:
            lab.overlays.trails = !lab.overlays.trails;
            break;
        case Action::surfaces:
            lab.overlays.surfaces = !lab.overlays.surfaces;
            break;
        case Action::memory:
            lab.overlays.memory = !lab.overlays.memory;
            break;
        case Action::labels:
            lab.overlays.labels = !lab.overlays.labels;
            break;
        case Action::next_field:
            show_next_field(lab);
            break;
        case Action::wiring:
            set_mode(lab, lab.mode == Mode::wiring ? Mode::paused : Mode::wiring);
            break;
        case Action::cancel:
            if (lab.mode == Mode::wiring) set_mode(lab, Mode::paused);
            break;
        case Action::undo:
            change(lab, [&] { return lab.session.undo(); });
            break;
        case Action::redo:
            change(lab, [&] { return lab.session.redo(); });
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
        case Action::hint:
            show_hint(lab);
            break;
        case Action::exercise_reset:
            restart_exercise(lab);
            break;
        case Action::exit:
            lab.exit = true;
            break;
        case Action::erase:
            edit_if(lab, removal_of(lab.session.snapshot(), chosen(lab)));
            break;
        case Action::duplicate:
            edit_if(lab, copy_of(lab.session.snapshot(), chosen(lab)));
            break;
        case Action::save:
            lab.files.push_back(SaveRequest{lab.path.string(), FileKind::scene});
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
            lab.before_lecture ? end_lecture(lab) : begin_lecture(lab);
            break;
        case Action::larger:
            change_type_size(lab, +type_step);
            break;
        case Action::smaller:
            change_type_size(lab, -type_step);
            break;
        default:
            break;  // the panels' own
    }
}

}  // namespace

void set_mode(Lab& lab, Mode mode) {
    const bool was_playing = lab.mode == Mode::playing, plays = mode == Mode::playing;
    if (was_playing != plays) ++lab.toggles;
    if (plays) lab.debt = 0;
    lab.pace = {};
    lab.mode = mode;
}

bool apply(Lab& lab, const Command& command, std::uint64_t gesture) {
    const std::uint64_t latest = lab.session.latest();
    const auto error = lab.session.apply(command, gesture);
    if (error)
        say(lab, {NoticeKind::failure, "", error->text()});
    else
        ++lab.work, tell_judge(lab, command), tell_of_time(lab, latest);
    keep_selection(lab);
    return !error;
}

Preferences desk_preferences(const Lab& lab) {
    Preferences p = lab.preferences;
    if (lab.before_lecture) p.theme = lab.before_lecture->theme, p.type_size = lab.before_lecture->type_size;
    return p;
}

void handle(Lab& lab, const Request& request) {
    std::visit(
        Match{[&](Action action) { act(lab, action); }, [&](const EditRequest& r) { edit(lab, r.command, r.gesture); },
              [&](const SelectRequest& r) { select(lab, vehicle_thing(r.vehicle)), keep_selection(lab); },
              [&](const TakeRequest& r) { take(lab, r.thing); },
              [&](const ScopeRequest& r) { lab.whole_kind = r.whole_kind; },
              [&](const SeekRequest& r) { seek(lab, r); }, [&](const BookmarkRequest& r) { handle_bookmark(lab, r); },
              [&](const OpenRequest& r) { lab.files.push_back(r); },
              [&](const BrowseRequest& r) { lab.files.push_back(r); },
              [&](const SaveRequest& r) { lab.files.push_back(r); },
              [&](const RecoverRequest& r) { lab.files.push_back(r); },
              [&](const LeaveRequest& r) { lab.files.push_back(r); },
              [&](const PreferencesRequest& r) { lab.preferences = r.preferences; },
              [&](const OverlaysRequest& r) { lab.overlays = r.overlays; },
              [&](const PredictRequest& r) {
                  if (lab.lesson && !lab.lesson->view.has_run) lab.lesson->view.prediction = r.option;
              },
              [&](const ExportRequest& r) { lab.files.push_back(r); },
              [&](const SpeedRequest& r) { lab.time_scale = std::clamp(r.time_scale, speeds.front(), speeds.back()); }},
        request);
}

}  // namespace braitenlab
