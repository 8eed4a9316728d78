#include "app/lab.h"

#include <array>

#include "app/course/authored_scene.h"
#include "app/course/lesson_view.h"
#include "app/course/reference_runs.h"
#include "app/lab_selection.h"
#include "ui/scene_input/clipboard.h"

namespace braitenlab {

Lab make_lab(Document document) {
    Lab lab{{.document = std::move(document)}};
    watch(lab);
    keep_selection(lab);
    return lab;
}

Result<Lab> open_lab(const std::filesystem::path& path, std::optional<std::uint64_t> seed,
                     const std::vector<Setting>& settings) {
    auto document = open_document(path, seed, settings);
    if (!document) return document.error();
    return make_lab(std::move(*document));
}

void replace_document(Lab& lab, Document next) {
    lab.together.reset();
    next.run_id = lab.document.run_id + 1;
    lab.document = std::move(next);
    lab.playback = {};
    lab.view = for_another_scene(lab.view);
    if (lab.before_lecture) lab.before_lecture->view = for_another_scene(lab.before_lecture->view);
    lab.object_name.clear();
    lab.selected_kind.clear();
    lab.dragging = false, lab.deselected = Deselected::no;
    lab.steered = {};
    if (lab.lectures.tally) lab.lectures.tally = empty_tally(lab.lectures.tally_options);
    lab.notice = {};
    lab.findings.clear();
    if (lab.document.lesson) lab.document.lesson->last_hint_at = lab.wall_seconds;
    if (lab.document.lesson && !lab.before_lecture) lab.view.watching = false;  // it was of another exercise
    watch(lab);
    keep_selection(lab);
}

void update_features(Lab& lab, Jobs& jobs) {
    update_predictions(lab.predictions, lab, jobs);
    update_slots(lab.slots, lab, jobs);
    update_mystery(lab.mystery, lab, jobs);
    update_explanation(lab.explanation, lab);
    update_map(lab.map, lab, jobs);
    update_study(lab.study, jobs);
    update_breeding(lab.breeding, jobs, lab.wall_seconds);
    update_robots(lab.robots, lab, jobs);
}

namespace {

Camera camera_of(const LecturePage& page) {
    constexpr std::array<CameraMode, page_camera_table.size()> modes{CameraMode::overview, CameraMode::follow,
                                                                     CameraMode::driver, CameraMode::birds_eye};
    return {modes[static_cast<std::size_t>(page.camera)], page.azimuth, page.elevation, page.zoom, {page.x, page.y}};
}

}  // namespace

LectureView empty_tally(std::size_t options) {
    Lecture lecture;
    lecture.pages.resize(1);
    lecture.pages.front().question.options.resize(options);
    return {.lecture = std::make_shared<const Lecture>(std::move(lecture)), .hands = {std::vector<int>(options)}};
}

Camera home_camera(const Workspace& space) { return space.pages ? camera_of(space.pages->current()) : Camera{}; }

LabView view_of(const Lab& lab) {
    const Document& document = lab.document;
    const Playback& playback = lab.playback;
    LabView view;
    view.now = &shown_snapshot(lab);
    view.file = document.file.get();
    view.mode = playback.mode;
    view.timeline = {document.session.earliest(), document.session.latest(), {}};
    if (lab.together) view.timeline = {view.now->tick, view.now->tick, {}};
    for (const TimeMark& mark : playback.bookmarks) view.timeline.bookmarks.push_back(mark.moment.tick());
    view.time_scale = playback.time_scale;
    view.pace = playback.pace.reached;
    view.settings = lab.view;
    view.copied_objects = ui::object_count(lab.clipboard);
    view.undo_depth = document.session.undo_depth() + can_undo_return(lab.last_run, lab);
    view.redo_depth = document.session.redo_depth() + can_redo_return(lab.last_run, lab);
    if (document.lesson) view.lesson = std::make_shared<const LessonView>(lesson_view_of(lab));
    view.may = disclosure_of(lab);
    if (view.may.solution_run) view.features.ghost = ghost_of(lab);
    view.pages = lab.pages ? &*lab.pages : nullptr;
    view.tally = lab.lectures.tally ? &*lab.lectures.tally : nullptr;
    if (view.may.future)
        view.features.last_run = last_run_of(lab.last_run, lab),
        view.features.prediction = prediction_of(lab.predictions, lab);
    view.features.path = path_of_selected(lab.last_run, lab);
    view.features.why = explanation_of(lab.explanation, lab);
    view.features.has_left_run = has_left_run(lab.last_run, lab);
    view.features.mystery = mystery_of(lab.mystery, lab);
    view.features.slots = slots_of(lab.slots, lab);
    if (view.features.slots.b) view.features.last_run.reset(), view.features.prediction.reset();
    view.features.map = map_of(lab.map, lab);
    view.features.study = study_of(lab.study);
    view.features.breeding = breeding_of(lab.breeding, lab.wall_seconds);
    view.features.robots = robots_of(lab.robots, lab);
    view.documents.students = &lab.students;
    view.documents.student = lab.students.student().name;
    view.documents.opened = document.name;
    view.documents.has_draft = has_draft(lab.authored.get(), document);
    view.documents.draft_run = lab.authored ? lab.authored->restored_run : 0;
    view.run_id = document.run_id;
    view.notice = lab.notice;
    view.findings = &lab.findings;
    view.program.preferences = lab.preferences;
    view.program.theme = lab.preferences.theme;
    view.lecture = lab.before_lecture.has_value();
    view.has_moved_camera = !lab.view.orbits && !(lab.view.camera == home_camera(lab));
    view.documents.left_pages = lab.lectures.left ? &*lab.lectures.left : nullptr;
    view.program.reduce_motion = lab.preferences.reduce_motion;
    view.wall_seconds = lab.wall_seconds;
    return view;
}

}  // namespace braitenlab
