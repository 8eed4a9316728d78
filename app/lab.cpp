#include "app/lab.h"

#include <algorithm>
#include <chrono>

#include "app/data.h"
#include "app/lab_parts.h"
#include "core/io/run_file.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

namespace {

constexpr double hint_patience = 30;       // s until the next hint opens without a run
constexpr double tick_length = 1.0 / 60;   // s, as core/brain/brain.h has it
constexpr double stepping_budget = 0.012;  // s of a frame

// Once a second. A person hardly sees a twentieth less.
void measure(Lab& lab, double wall_seconds, double simulated) {
    constexpr double stretch = 1, falls_behind = 0.95;
    Pace& pace = lab.pace;
    pace.wall += wall_seconds, pace.simulated += simulated;
    if (pace.wall < stretch) return;
    const double reached = pace.simulated / pace.wall;
    pace.reached.reset();
    if (reached < falls_behind * static_cast<double>(lab.time_scale)) pace.reached = static_cast<float>(reached);
    pace.wall = pace.simulated = 0;
}

}  // namespace

FileMark mark_of(const std::filesystem::path& path) {
    std::error_code problem, other;
    const FileMark mark{std::filesystem::last_write_time(path, problem), std::filesystem::file_size(path, other)};
    return problem || other ? FileMark{} : mark;
}

Result<Lab> open_lab(const std::filesystem::path& path, std::optional<std::uint64_t> seed,
                     const std::vector<Setting>& settings) {
    const FileMark mark = mark_of(path);  // before reading: what is written meanwhile is news
    if (path.extension() == io::run_ending) {
        auto run = io::load_run(path);
        if (!run) return run.error();
        Lab lab = resume(std::move(*run));
        lab.name = path.stem().string();
        lab.path = path;
        lab.saved_tick = lab.session.snapshot().tick;
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
            .file = std::make_shared<const Scene>(std::move(*scene)),
            .on_disk = mark,
            .settings = settings};
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

void tick(Lab& lab) {
    lab.before = lab.session.snapshot().vehicles;
    const VehicleView* selected = selected_vehicle(lab);
    const std::optional<VehicleView> before = selected ? std::optional(*selected) : std::nullopt;
    lab.session.step();
    if (before) mourn(lab, *before);
    keep_selection(lab);
    if (lab.lesson) {
        lab.lesson->view.has_run = true;
        if (lab.session.snapshot().tick == 1) lab.lesson->view.hint_ready = true;  // each run opens a hint
    }
    watch(lab);
    remember_judge(lab);
}

void advance(Lab& lab, double wall_seconds) {
    lab.wall_seconds += wall_seconds;
    if (lab.wall_seconds >= lab.notice_until) lab.notice = {};
    if (lab.lesson && lab.wall_seconds - lab.lesson->last_hint_at >= hint_patience) lab.lesson->view.hint_ready = true;
    if (lab.mode != Mode::playing || lab.past.held) return;

    using Clock = std::chrono::steady_clock;
    const auto began = Clock::now();
    const auto spent = [&] { return std::chrono::duration<double>(Clock::now() - began).count(); };
    lab.debt += wall_seconds * static_cast<double>(lab.time_scale);
    const double before = lab.session.snapshot().seconds;
    while (lab.debt >= tick_length && spent() < stepping_budget) {
        tick(lab);
        lab.debt -= tick_length;
    }
    measure(lab, wall_seconds, lab.session.snapshot().seconds - before);
    if (lab.debt >= tick_length) lab.debt = 0;
}

void say(Lab& lab, Notice notice) {
    constexpr double letters_a_second = 15;  // read by somebody who was looking elsewhere
    const double least = notice.kind == NoticeKind::failure ? 10 : notice.kind == NoticeKind::notice ? 8 : 6;
    const double seconds = std::max(least, static_cast<double>(notice.words.size()) / letters_a_second);
    std::string& words = notice.words;
    if (notice.key.empty() && !words.empty() && words[0] >= 'a' && words[0] <= 'z')
        words[0] = static_cast<char>(words[0] - 'a' + 'A');
    lab.notice = std::move(notice);
    lab.notice_until = lab.wall_seconds + seconds;
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
    view.pace = lab.pace.reached;
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
    view.sitting = lab.sitting;
    view.notice = lab.notice;
    view.preferences = lab.preferences;
    view.theme = lab.preferences.theme;
    view.lecture = lab.before_lecture.has_value();
    view.reduce_motion = lab.preferences.reduce_motion;
    view.wall_seconds = lab.wall_seconds;
    return view;
}

}  // namespace braitenlab
