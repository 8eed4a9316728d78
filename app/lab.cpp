#include "app/lab.h"

#include <algorithm>
#include <array>
#include <chrono>

#include <fmt/format.h>

#include "app/data.h"
#include "app/lab_parts.h"
#include "app/safe_file.h"
#include "core/match.h"
#include "core/scene/scene_file.h"
#include "core/world/run_file.h"
#include "render/view/intensity.h"
#include "ui/stage/edits.h"
#include "ui/steering.h"

namespace braitenlab {

namespace {

constexpr std::array<float, 8> speeds{0.125f, 0.25f, 0.5f, 1, 2, 4, 8, 16};
constexpr double hint_patience = 30;  // s until the next hint opens without a run
constexpr double notice_seconds = 6;  // how long a refusal stays readable
constexpr float type_step = 0.125f;
constexpr float lecture_type = 1.6f;        // times what a person has at the desk
constexpr std::int64_t rewind_ticks = 300;  // five seconds
constexpr double tick_length = 1.0 / 60;    // s, as core/brain/brain.h has it
constexpr double stepping_budget = 0.012;   // s of a frame

void notify(Lab& lab, std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    lab.notice = std::move(text);
    lab.notice_until = lab.wall_seconds + notice_seconds;
}

void set_mode(Lab& lab, Mode mode) {
    const bool was_playing = lab.mode == Mode::playing, plays = mode == Mode::playing;
    if (was_playing != plays) ++lab.toggles;
    if (plays) lab.debt = 0;
    lab.mode = mode;
}

const VehicleView* selected_vehicle(const Lab& lab) { return find_vehicle(lab.session.snapshot(), lab.selected); }

template <class Named>
int index_of(const std::vector<Named>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

void take(Lab& lab, const Thing& thing) {
    lab.thing = {};
    const Snapshot& now = lab.session.snapshot();
    if (!place_of(now, thing) || thing.kind == ThingKind::vehicle) return;
    const auto index = static_cast<std::size_t>(thing.index);
    lab.thing = thing;
    lab.thing_name =
        thing.kind == ThingKind::source ? now.scene->sources[index].name : now.scene->obstacles[index].name;
}

// Numbers of sources and obstacles shift when others come and go; names do not.
void keep_thing(Lab& lab) {
    if (!lab.thing) return;
    const Scene& scene = *lab.session.snapshot().scene;
    lab.thing.index = lab.thing.kind == ThingKind::source ? index_of(scene.sources, lab.thing_name)
                                                          : index_of(scene.obstacles, lab.thing_name);
    if (lab.thing.index < 0) lab.thing = {};
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

void change_speed(Lab& lab, int step) {
    const auto here = std::lower_bound(speeds.begin(), speeds.end(), lab.time_scale - 1e-6f);
    const auto index =
        std::clamp(static_cast<int>(here - speeds.begin()) + step, 0, static_cast<int>(speeds.size()) - 1);
    lab.time_scale = speeds[static_cast<std::size_t>(index)];
}

void change_type_size(Lab& lab, float by) {
    float& size = lab.preferences.type_size;
    size = std::clamp(size + by, least_type_size,
                      lab.before_lecture ? lecture_type * largest_type_size : largest_type_size);
}

bool apply(Lab& lab, const Command& command, std::uint64_t gesture = 0) {
    const auto error = lab.session.apply(command, gesture);
    if (error)
        notify(lab, error->text());
    else
        ++lab.work;
    keep_selection(lab);
    return !error;
}

// As a person asked for it: what was added is what comes next under the hand.
void edit(Lab& lab, const Command& command, std::uint64_t gesture = 0) {
    if (!apply(lab, command, gesture)) return;
    if (const Thing added = added_by(lab.session.snapshot(), command)) select(lab, added);
}

void edit_if(Lab& lab, const std::optional<Command>& command) {
    if (command && lab.mode != Mode::wiring) edit(lab, *command);
}

void reset(Lab& lab) {
    lab.session.reset(lab.lesson ? Keep::brains : Keep::edits);
    lab.past.judged.clear();
    lab.before.clear();
    lab.debt = 0;
    if (lab.lesson && !(lab.lesson->view.grade && lab.lesson->view.grade->good)) lab.lesson->view.grade.reset();
    watch(lab);
    keep_selection(lab);
}

// The exercise as it was on opening; the brain comes back by an edit, so that it can be undone.
void restart_exercise(Lab& lab) {
    if (!lab.lesson) return reset(lab);
    Lesson& lesson = *lab.lesson;
    set_mode(lab, Mode::paused);
    for (std::size_t k = 0; k < lesson.exercise->scene.kinds.size(); ++k)
        if (*lab.session.snapshot().kind_brains[k] != lesson.exercise->scene.kinds[k].brain)
            apply(lab, SetBrain{{.kind = static_cast<int>(k)}, lesson.exercise->scene.kinds[k].brain});
    lesson.view = {.exercise = lesson.exercise.get()};
    lesson.last_hint_at = lab.wall_seconds;
    lesson.referee = Referee(*lesson.exercise);
    reset(lab);
}

void show_hint(Lab& lab) {
    if (!lab.lesson) return;
    LessonView& view = lab.lesson->view;
    if (!view.hint_ready || view.hints_shown >= static_cast<int>(view.exercise->hints.size())) return;
    ++view.hints_shown;
    view.hint_ready = false;
    lab.lesson->last_hint_at = lab.wall_seconds;
}

// Into a way of looking, or back to the overview when it is on already.
void look_through(Lab& lab, CameraMode mode) {
    lab.camera.mode = lab.camera.mode == mode ? CameraMode::overview : mode;
    if (!rides(lab.camera.mode)) return;
    lab.camera.zoom = 1;  // how near the overview was says nothing about how near to ride
}

// A person takes the wheel, or gives it back to who had it.
void drive(Lab& lab) {
    const VehicleView* vehicle = selected_vehicle(lab);
    if (!vehicle) return;
    const Driver kinds = lab.session.snapshot().scene->kinds[static_cast<std::size_t>(vehicle->kind)].driver;
    const Driver others = kinds == Driver::manual ? Driver::brain : kinds;
    apply(lab, ChooseDriver{vehicle->id, vehicle->driver == Driver::manual ? others : Driver::manual});
}

// To the next free name in the current folder.
void write_numbers(Lab& lab, const ExportRequest& wanted) {
    std::error_code none;
    std::filesystem::path path;
    for (int i = 1; path.empty() || std::filesystem::exists(path, none); ++i)
        path = std::filesystem::current_path(none) / fmt::format("braitenlab-{}-{:03}.csv", wanted.name, i);
    const auto error = write_whole(path, wanted.text);
    notify(lab, error ? error->text() : path.string());
}

// From none through the channels of which there is something to feel, and back to none.
void show_next_field(Lab& lab) {
    const auto channels = channels_with_field(lab.session.snapshot());
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
            lab.work += lab.session.undo(), keep_selection(lab);
            break;
        case Action::redo:
            lab.work += lab.session.redo(), keep_selection(lab);
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

void keep_selection(Lab& lab) {
    keep_thing(lab);
    const auto& vehicles = lab.session.snapshot().vehicles;
    if (!selected_vehicle(lab)) lab.selected = vehicles.empty() ? no_vehicle : vehicles.front().id;
}

void watch(Lab& lab) {
    if (!lab.lesson) return;
    Lesson& lesson = *lab.lesson;
    lesson.referee.watch(lab.session.snapshot());
    lesson.view.verdicts = lesson.referee.verdicts();
    if (!lesson.referee.passed() || lesson.view.grade) return;
    // Every step is done in this run: now it must hold from the other starts as well.
    const Snapshot& now = lab.session.snapshot();
    if (now.vehicles.empty()) return;
    lesson.view.grade = grade(*lesson.exercise, *now.brains[static_cast<std::size_t>(now.vehicles.front().brain)]);
}

Result<Lab> open_lab(const std::filesystem::path& path, std::optional<std::uint64_t> seed,
                     const std::vector<Setting>& settings) {
    if (path.extension() == run_ending) {
        auto run = load_run(path);
        if (!run) return run.error();
        Lab lab = resume(std::move(*run));
        lab.name = path.stem().string();
        lab.path = path;
        return lab;
    }
    std::optional<Exercise> exercise;
    std::optional<Scene> scene;
    if (is_exercise(path)) {
        auto loaded = load_exercise(path, settings);
        if (!loaded) return loaded.error();
        exercise = std::move(*loaded);
        scene = exercise->scene;
    } else {
        auto loaded = load_scene(path, settings);
        if (!loaded) return loaded.error();
        scene = std::move(*loaded);
    }
    auto session = Session::open(*scene, seed.value_or(exercise ? exercise->seed : 1));
    if (!session) return session.error();
    Lab lab{.session = std::move(*session),
            .name = path.stem().string(),
            .path = path,
            .file = std::make_shared<const Scene>(std::move(*scene))};
    if (exercise) {
        auto shared = std::make_shared<const Exercise>(std::move(*exercise));
        lab.lesson = Lesson{shared, Referee(*shared), {.exercise = shared.get()}};
        watch(lab);
    }
    keep_selection(lab);
    return lab;
}

Lab resume(SavedRun run) {
    Lab lab{.session = Session::resume(std::move(run))};
    lab.file = std::make_shared<const Scene>(lab.session.scene());
    keep_selection(lab);
    return lab;
}

Preferences desk_preferences(const Lab& lab) {
    Preferences p = lab.preferences;
    if (lab.before_lecture) p.theme = lab.before_lecture->theme, p.type_size = lab.before_lecture->type_size;
    return p;
}

void tick(Lab& lab) {
    lab.before = lab.session.snapshot().vehicles;
    lab.session.step();
    keep_selection(lab);
    if (lab.lesson) {
        lab.lesson->view.has_run = true;
        if (lab.session.snapshot().tick == 1) lab.lesson->view.hint_ready = true;  // each run opens a hint
    }
    watch(lab);
    remember_judge(lab);
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
              [&](const PreferencesRequest& r) { lab.preferences = r.preferences; },
              [&](const OverlaysRequest& r) { lab.overlays = r.overlays; },
              [&](const PredictRequest& r) {
                  if (lab.lesson && !lab.lesson->view.has_run) lab.lesson->view.prediction = r.option;
              },
              [&](const ExportRequest& r) { write_numbers(lab, r); },
              [&](const SpeedRequest& r) { lab.time_scale = std::clamp(r.time_scale, speeds.front(), speeds.back()); }},
        request);
}

bool steer_by_keys(Lab& lab, float right, float ahead) {
    const VehicleView* vehicle = selected_vehicle(lab);
    const bool drives = vehicle && vehicle->driver == Driver::manual;
    // Whoever was steered and is left to itself lets go of the wheel.
    if (lab.steered.vehicle != no_vehicle && (!drives || vehicle->id != lab.steered.vehicle)) {
        (void)lab.session.apply(steer(lab.steered.vehicle, 0, 0));
        lab.steered = {};
    }
    if (!drives) return false;
    const Steer wanted = steer(vehicle->id, right, ahead);
    const bool idle = right == 0 && ahead == 0;
    if (idle && lab.steered.vehicle == no_vehicle) return true;  // the stick may hold it
    if (wanted != lab.steered) (void)lab.session.apply(wanted);
    lab.steered = idle ? Steer{} : wanted;
    return true;
}

void advance(Lab& lab, double wall_seconds) {
    lab.wall_seconds += wall_seconds;
    if (lab.wall_seconds >= lab.notice_until) lab.notice.clear();
    if (lab.lesson && lab.wall_seconds - lab.lesson->last_hint_at >= hint_patience) lab.lesson->view.hint_ready = true;
    if (lab.mode != Mode::playing || lab.past.held) return;

    using Clock = std::chrono::steady_clock;
    const auto began = Clock::now();
    const auto spent = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
    lab.debt += wall_seconds * static_cast<double>(lab.time_scale);
    while (lab.debt >= tick_length && spent() < stepping_budget) {
        tick(lab);
        lab.debt -= tick_length;
    }
    if (lab.debt >= tick_length) lab.debt = 0;
}

float between_ticks(const Lab& lab) {
    if (lab.mode != Mode::playing || lab.past.held) return 1;
    return std::clamp(static_cast<float>(lab.debt / tick_length), 0.0f, 1.0f);
}

LabView view_of(const Lab& lab) {
    LabView view;
    view.now = &lab.session.snapshot();
    view.file = lab.file.get();
    view.mode = lab.mode;
    view.timeline = {lab.session.earliest(), lab.session.latest(), {}};
    for (const Past::Mark& mark : lab.past.bookmarks) view.timeline.bookmarks.push_back(mark.moment.tick());
    view.time_scale = lab.time_scale;
    view.selected = lab.selected;
    view.thing = lab.thing;
    view.whole_kind = lab.whole_kind;
    view.sensors = lab.sensors;
    view.outlines = lab.outlines;
    view.overlays = lab.overlays;
    view.camera = lab.camera.mode;
    view.undo_depth = lab.session.undo_depth();
    view.redo_depth = lab.session.redo_depth();
    view.lesson = lab.lesson ? &lab.lesson->view : nullptr;
    view.opened = lab.name;
    view.notice = lab.notice;
    view.preferences = lab.preferences;
    view.theme = lab.preferences.theme;
    view.lecture = lab.before_lecture.has_value();
    view.reduce_motion = lab.preferences.reduce_motion;
    view.wall_seconds = lab.wall_seconds;
    return view;
}

}  // namespace braitenlab
