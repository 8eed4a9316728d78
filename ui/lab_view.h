// Read-only view of the lab for the panels: snapshot, mode, selection. Changes go through ui/request.h.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/insight/compare.h"
#include "core/insight/map.h"
#include "core/insight/mystery.h"
#include "core/insight/robustness.h"
#include "core/insight/study.h"
#include "core/insight/why.h"
#include "core/lesson/attempt.h"
#include "core/lesson/disclosure.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"
#include "core/lesson/lecture.h"
#include "core/lesson/progress.h"
#include "core/lesson/referee.h"
#include "core/lesson/selection.h"
#include "core/lesson/submission.h"
#include "core/scene/sensor_pairs.h"
#include "core/world/character.h"
#include "core/world/snapshot.h"
#include "render/view/camera.h"
#include "render/view/palette.h"
#include "render/view/view_settings.h"
#include "ui/breeding_view.h"
#include "ui/files.h"
#include "ui/request.h"
#include "ui/words/strings.h"

namespace braitenlab {

enum class Mode { playing, paused, wiring };  // wiring: paused, with the wiring canvas in place of the scene
inline constexpr std::array<std::string_view, 3> mode_words{"playing", "paused", "wiring"};
static_assert(has_enumerators<Mode, mode_words.size()>());
constexpr std::string_view word(Mode mode) { return mode_words[static_cast<std::size_t>(mode)]; }

// The children of a brain, in an exercise that offers selection (core/lesson/selection.h).
struct SelectionView {
    int generation = 0;                 // number of choices so far
    std::optional<StartResult> parent;  // its run from the start that Play shows; nullopt while it is computed
    std::vector<StartResult> children;  // theirs; empty while they are computed
    std::vector<int> stays;             // of each child, at how many of other_starts; empty while not known
};
inline constexpr int other_starts = 3;  // at which children are run whose runs at the shown start do not differ

// The open exercise and its progress.
struct LessonView {
    const Exercise* exercise = nullptr;  // never null
    std::string key{};                   // in StudentProgress: Exercise::id if it ships, else its file's path
    Attempt attempt{};
    Standing standing{};
    std::vector<Verdict> verdicts;           // one per step of the exercise
    bool at_start = true;                    // of a run; in a selection by hand also before the first choice
    bool as_given = true;                    // every brain, sensor and body was that of the file since the start
    bool by_hand = false;                    // the user has moved an object: this run is not judged
    int hint_in = 0;                         // seconds until the next hint without a run, while it may not be shown now
    std::optional<Grade> grade;              // of the starts, once every step has been done in a run
    std::optional<Grade> shipped_grade;      // of the starts as shipped, for Exercise::median
    std::optional<SelectionView> selection;  // nullopt: the exercise does not offer it
    bool together = false;                   // the graded starts run at once in place of the exercise's own run
    // Of each of offered_dials() what it can gain, see core/lesson/gain.h; empty: not asked, nullopt: being computed.
    std::optional<std::vector<float>> gains = std::vector<float>{};
};

// True while a question waits for a run of the scene as given, which the student has changed: only Start over leads
// there. A question about a selection or a breeding is about its end.
inline bool needs_start_over(const LessonView& lesson) {
    const bool passed = lesson.grade && lesson.grade->good;
    return is_asked(lesson.exercise->prediction) && !lesson.as_given && !lesson.attempt.work.outcome_known && !passed &&
           !offers_selection(*lesson.exercise) && offered_breeding(*lesson.exercise).empty();
}

// True while the prediction is asked for: before the first run, and until it is made.
inline bool awaits_prediction(const LessonView& lesson) {
    return !lesson.attempt.work.has_run && !has_predicted(lesson.attempt.answers) &&
           is_asked(lesson.exercise->prediction);
}

// A vehicle of another run at the displayed time: of the run with the exercise's solution, or of the last run before
// the reset. It is not in the snapshot.
struct GhostView {
    Pose pose;
    float length = 1, width = 0.7f;       // m, of its chassis
    const ReferencePath* path = nullptr;  // from tick 0 on; never null
    std::size_t count = 0;                // of its poses, those up to the displayed time
};

// A slot, and the run of its brain in the last comparison.
struct SlotView {
    const insight::Design* design = nullptr;           // null: empty
    std::string kind{};                                // name of the kind of the vehicle that it is from
    Character character{};                             // when it was stored
    bool is_in_vehicle = false;                        // the selected vehicle has this brain and these sensors
    const insight::CompareNumbers* numbers = nullptr;  // null: not compared, or not known yet
};

// Slots A and B. The runs are shown while the vehicle drives as A from the same start.
struct SlotsView {
    std::array<SlotView, 2> slots{};
    float seconds = 0;          // of each run; 0: not compared
    bool is_computing = false;  // the runs are not known yet
    std::optional<GhostView> a{}, b{};

    bool has_any() const { return slots[0].design || slots[1].design; }
};

// The coming path of the selected vehicle. Paths have one pose per tick.
struct PredictionView {
    const std::vector<Pose>* path = nullptr;              // never null, never empty
    const std::vector<std::vector<Pose>>* fan = nullptr;  // with other random numbers; never null, may be empty
    std::uint64_t tick = 0;                               // of the first pose; at most the displayed tick
    const std::vector<Pose>* before = nullptr;            // without the change that is tried; null: not known
    std::uint64_t before_tick = 0;
    bool is_outdated = false;  // a newer path takes long to compute
};

// The map of behaviour of the selected vehicle, see core/insight/map.h.
struct MapView {
    const insight::MapCells* cells = nullptr;  // never null; those computed so far
    insight::MapAxis x{}, y{};                 // path: insight::AxisValue::id
    insight::MapMeasure measure = insight::MapMeasure::behaviour;
    int seeds = 1;
    float progress = 0;                        // 0..1; 1: every cell is known
    std::optional<insight::MapPlace> hovered;  // the cell whose path is shown
    const std::vector<Pose>* path = nullptr;   // of that cell; null: not known yet
};

// The study on its sheet.
struct StudyView {
    const std::vector<insight::Study>* shipped = nullptr;  // null: none
    std::shared_ptr<const insight::StudyBase> base{};      // null: none is open
    const std::vector<insight::StudyRow>* rows = nullptr;  // complete runs, in order; null with `base`
    bool runs = false;
    bool is_built = false;         // of the open scene, and not in a file
    bool has_file = false;         // of the user: its table is beside it once it is saved
    std::string table{};           // file of its table; empty: it is in memory only
    std::optional<Error> error{};  // why it could not be opened or continued
    int shown = 0;                 // increases with each study that is opened from a file: its sheet is shown then
    std::string last{};            // name or path of the one opened last, also by an earlier start; empty: none
};

// A hidden brain, the vehicle whose brain is to drive alike, and the score.
struct MysteryView {
    VehicleId hidden = no_vehicle, rebuilt = no_vehicle;  // no_vehicle: there is none
    bool is_computing = false;
    float progress = 0;                            // 0..1
    const insight::MysteryScore* score = nullptr;  // of the last comparison; null: none
    const Scene* scene = nullptr;                  // of that comparison; null without a score
    std::optional<Error> error{};                  // why there is none
};

// The selected vehicle's brain on robots whose parts differ, see core/insight/robustness.h.
struct RobotsView {
    float reality = 1;
    int count = 40;
    insight::Reality figures{};                     // of the robots
    bool is_typical = false;                        // the kind states no figures of its own
    bool is_on = false;                             // a trial has been asked for
    float progress = 1;                             // 0..1 of the trial that is computed; 1: none is
    const insight::RobotsReport* report = nullptr;  // null: none yet; of earlier values while one is computed
    bool judged = false;                            // robots pass or fail an exercise
    std::optional<int> hovered{};                   // robot under the pointer
    std::optional<int> replayed{};                  // shown in the scene: its index, or every_robot
};

// The open lecture and where it stands.
struct LectureView {
    std::shared_ptr<const Lecture> lecture;  // never null
    int page = 0, step = 0;                  // of Lecture::pages; number of the page's steps that have been shown
    std::vector<std::vector<int>> hands;     // counted, by page and option of its question
    bool notes = false;                      // the lecturer's notes are shown
    double seconds = 0;                      // wall time since the lecture was opened

    const LecturePage& current() const { return lecture->pages[static_cast<std::size_t>(page)]; }
    bool shows(PagePart part) const { return braitenlab::shows(current(), part, step); }
    bool awaits_answer() const { return !current().question.options.empty() && !shows(PagePart::answer); }
};

// A shipped scene, exercise or lecture in menus and the file browser.
struct CatalogueEntry {
    std::string name, path;  // "2a-coward", and its file
    std::string title, story;
    int number = 0;                              // of an exercise; 0: a scene
    int chapter = 0;                             // of an exercise of the course, from 1; 0: none
    std::shared_ptr<const Exercise> exercise{};  // null: a scene
};

// The recorded part of the run, in ticks. The tick shown is in it.
struct TimelineView {
    std::uint64_t earliest = 0, latest = 0;
    std::vector<std::uint64_t> bookmarks;  // in the order of creation; some may be outside
};

// Textures of rendered pictures of scenes at their start, by path of the file; 0: there is none.
using ScenePictures = std::map<std::string, std::uint64_t>;

// A message in the hint bar. Each kind has a different sign and colour.
enum class NoticeKind { done, notice, failure };

struct Notice {
    NoticeKind kind = NoticeKind::notice;
    std::string key{};             // string key; empty: show `words` as they are
    std::string words{};           // value of the first {}
    std::string more{};            // value of the second {}
    bool number = false;           // `words` is a number, shown with the decimal mark of the language
    std::optional<Error> error{};  // with an empty key: `words` is its text in English

    bool empty() const { return key.empty() && words.empty(); }
    friend bool operator==(const Notice&, const Notice&) = default;
};

// A value that is the title of a shipped scene is translated.
inline std::string text_of(const Notice& notice, const Strings& strings) {
    if (notice.error) return text_of(*notice.error, strings);
    if (notice.key.empty()) return notice.words;
    std::string words(strings.find(notice.words, notice.words));
    if (notice.number) std::replace(words.begin(), words.end(), '.', decimal_mark(strings));
    return fill(strings(notice.key), {words, notice.more});
}

// What the check of an exercise has found, for its author.
struct Finding {
    Notice said;
    std::vector<Measure> measures{};  // of the step that failed
};

// What the features of the lab show.
struct FeatureViews {
    std::optional<GhostView> ghost;            // while Attempt::Work::compares and it is known
    std::optional<GhostView> last_run;         // the selected vehicle in the run before the reset
    const std::vector<Pose>* path = nullptr;   // of the selected vehicle, a pose per tick of the run; null: not known
    std::optional<PredictionView> prediction;  // while something is tried, and until it is driven
    bool has_left_run = false;                 // the run before the reset can be returned to
    SlotsView slots{};
    MysteryView mystery{};
    StudyView study{};
    BreedingView breeding{};
    std::optional<MapView> map{};        // nullopt: not shown, or it may not be shown now
    std::optional<RobotsView> robots{};  // the same
    const insight::Why* why = nullptr;   // of the selected vehicle's turn; null: not asked
};

// What can be opened, and whose work is kept.
struct DocumentsView {
    const std::vector<CatalogueEntry>* catalogue = nullptr;  // scenes and exercises; null: nothing to open
    const std::vector<CatalogueEntry>* lectures = nullptr;   // that ship; null: none
    const ScenePictures* pictures = nullptr;                 // null: none are rendered
    const FilesView* files = nullptr;                        // null: no file access
    bool has_draft = false;       // the open exercise was saved by the sheet of its author, which can go on with it
    std::uint64_t draft_run = 0;  // run_id of the scene that was restored for this; 0: none
    std::string opened;           // name of the open file, as in the catalogue
    const std::vector<RecentFile>* recent = nullptr;  // recently opened files, newest first; null: none
    const LectureView* left_pages = nullptr;          // the lecture that was left last; null: none
    const RecoveryOffer* recovery = nullptr;          // null: nothing to recover
    std::string student;                              // name of the student; empty: none is named
    const StudentBook* students = nullptr;            // null: no progress is kept
};

// The program and its window.
struct ProgramView {
    Preferences preferences;  // as stored; theme, type_size, quality and reduce_motion below are those in effect
    Theme theme = Theme::dark;
    float type_size = 0;  // in effect where the window is too small for preferences.type_size; 0: as preferred
    float largest_type_size = 100;      // for which the window has room
    Quality quality = Quality::medium;  // of the last picture
    bool reduce_motion = false;
    const std::vector<Language>* languages = nullptr;  // null: no choice
    std::string native_language = "en";                // of the first start; Reset All chooses it
    bool title_page = false;                           // first start: the name of the program over a moving scene
    bool has_ffmpeg = false;                           // clips can be MP4 and WebM
    std::optional<float> clip_progress;                // 0..1, of the clip that is being written; nullopt: none is
    bool uploads = false;                              // in a browser: files of the computer come by upload
    std::string_view version;                          // of the program: "0.1.0"
    bool touch = false;                                // the last pointer was a finger
    float finger = 0;                                  // height of a row for a finger, window pixels; 0: not known
};

struct LabView {
    const Snapshot* now = nullptr;  // never null
    const Scene* file = nullptr;    // the scene as in its file, before all edits; null: unknown
    Mode mode = Mode::paused;
    TimelineView timeline;
    float time_scale = 1;       // simulated seconds per second, 1/8 … 16
    std::optional<float> pace;  // the speed reached, when clearly less than time_scale
    ViewSettings settings;
    const CameraView* camera_view = nullptr;  // the camera of the scene; null: no mouse input to the scene
    bool has_moved_camera = false;            // by the user: neither the camera that Home restores nor a slow orbit
    int undo_depth = 0, redo_depth = 0;
    std::size_t copied_objects = 0;                  // that can be pasted into the scene
    std::shared_ptr<const LessonView> lesson;        // null outside exercises
    Disclosure may;                                  // what may be shown now
    std::uint64_t run_id = 0;                        // changes with every document opened since the program started
    Notice notice;                                   // empty: none
    const std::vector<Finding>* findings = nullptr;  // null or empty: none
    bool lecture = false;                            // large type, few controls
    const LectureView* pages = nullptr;              // the open lecture; null: none. With one, `lecture` is true
    const LectureView* tally = nullptr;  // of a question that a lecture asks without pages: a page of its own; or null
    double wall_seconds = 0;             // for easing and pulsing
    FeatureViews features{};
    DocumentsView documents{};
    ProgramView program{};
};

// The page whose question is asked, if it has one: of the open lecture, or of a tally; null: none.
inline const LectureView* asked(const LabView& view) { return view.pages ? view.pages : view.tally; }

// Factors on the reach and the drawn size of pins and handles: a finger covers about 40 layout pixels.
inline float finger_reach(const LabView& view) { return view.program.touch ? 1.75f : 1.0f; }
inline float finger_size(const LabView& view) { return view.program.touch ? 1.5f : 1.0f; }
// The height of a control that a finger needs, layout pixels; 0 while the mouse is used: Ui::finger.
inline float finger_height(const LabView& view, float scale) {
    return view.program.touch ? view.program.finger / scale : 0;
}

// Null when no vehicle is selected.
inline const VehicleView* selected_vehicle(const LabView& view) {
    return find_vehicle(*view.now, view.settings.selection.vehicle);
}

// The kind of this name as the file has it, before all edits; null when the file is unknown or has no such kind.
inline const Kind* filed_kind(const LabView& view, const std::string& name) {
    const int kind = view.file ? find_kind(*view.file, name) : -1;
    return kind < 0 ? nullptr : &view.file->kinds[static_cast<std::size_t>(kind)];
}
inline const Kind* filed_kind(const LabView& view, const VehicleView& vehicle) {
    return filed_kind(view, kind_of(*view.now, vehicle).name);
}

// Shorter names of what LabView::may says.
inline bool hides_outcome(const LabView& view) { return !view.may.outcome; }
inline bool may_show_future(const LabView& view) { return view.may.future; }
inline bool can_compare(const LabView& view) {
    if (!view.may.solution_run || !view.lesson) return false;
    const Attempt& attempt = view.lesson->attempt;
    return attempt.work.runs > 1 || attempt.work.compares || attempt.answers.hints_shown > 0 || view.lesson->grade;
}

// True for a kind whose brains are hidden by the scene or by the exercise.
inline bool is_brain_secret(const LabView& view, int kind) {
    return is_secret(view.lesson ? view.lesson->exercise : nullptr, *view.now->scene, kind);
}

// True if Tab selects this vehicle: an exercise that hides a brain is about the other vehicles.
inline bool is_in_tab_order(const LabView& view, const VehicleView& vehicle) {
    return !view.lesson || !is_brain_secret(view, vehicle.kind);
}

// True if the brains of this kind may not be shown now: they are secret, or their wires would tell the outcome.
inline bool hides_brain(const LabView& view, int kind) { return !view.may.brains || is_brain_secret(view, kind); }

// The key of what a person does before the brain that the question hides is shown.
inline std::string_view way_to_brain(const LabView& view) {
    if (view.lesson && needs_start_over(*view.lesson)) return "wiring.answer_after_start_over";
    return view.may.open_prediction ? "wiring.answer_first" : "wiring.answer_after_reset";
}

// True if this vehicle's brain drives it and is shown.
inline bool shows_driving_brain(const LabView& view, const VehicleView& vehicle) {
    return vehicle.driver == Driver::brain && !hides_brain(view, vehicle.kind);
}

// True if the cause of the selected vehicle's turns may be told.
inline bool can_tell_why(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    return vehicle && view.may.why && shows_driving_brain(view, *vehicle);
}

// The string key of the reason why the map of behaviour may not show what other brains of this vehicle would do; empty
// if it may. `vehicle`: null if none is selected. `is_secret`: its kind is. `page`: of the open lecture, or null.
inline std::string_view why_no_map(const VehicleView* vehicle, const Disclosure& may, bool is_secret,
                                   const Revealed& revealed, const LectureView* page) {
    if (!vehicle) return "unavailable.no_vehicle";
    if (vehicle->driver == Driver::manual) return "unavailable.map_by_hand";
    if (vehicle->driver != Driver::brain) return "unavailable.map_driver";
    if (is_secret) return "unavailable.map_secret";
    if (!may.every_brain) return page ? "unavailable.map_page" : "unavailable.map";
    if (!revealed.brain) return "unavailable.map_hidden";
    if (may.other_brains) return "";
    return page && page->awaits_answer() ? "unavailable.map_question" : "unavailable.before_answer";
}
inline std::string_view why_no_map(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    return why_no_map(vehicle, view.may, vehicle && is_brain_secret(view, vehicle->kind), view.settings.revealed,
                      view.pages);
}

// The string key of the reason why the selected vehicle's brain cannot be stored in a slot or replaced by one; empty if
// it can. `vehicle`: null if none is selected.
inline std::string_view why_no_slots(const VehicleView* vehicle, bool shows_driving_brain) {
    if (!vehicle) return "unavailable.no_vehicle";
    return shows_driving_brain ? "" : "unavailable.why";
}
inline std::string_view why_no_slots(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    return why_no_slots(vehicle, vehicle && shows_driving_brain(view, *vehicle));
}

// The same for running both slots, for a vehicle that can take them.
inline std::string_view why_no_comparison(bool has_both, const Disclosure& may) {
    if (!has_both) return "unavailable.slots_empty";
    return may.future ? "" : "unavailable.before_answer";
}
inline std::string_view why_no_comparison(const LabView& view) {
    if (const std::string_view why = why_no_slots(view); !why.empty()) return why;
    return why_no_comparison(view.features.slots.slots[0].design && view.features.slots.slots[1].design, view.may);
}

// hides_brain() of every kind of the scene.
inline std::vector<bool> hidden_brains(const LabView& view) {
    std::vector<bool> hidden;
    const auto& kinds = view.now->scene->kinds;
    const bool may_hide = view.lesson || view.lecture ||
                          std::any_of(kinds.begin(), kinds.end(), [](const Kind& kind) { return kind.hidden; });
    for (std::size_t kind = 0; may_hide && kind < view.now->scene->kinds.size(); ++kind)
        hidden.push_back(hides_brain(view, static_cast<int>(kind)));
    return hidden;
}

// True if the name of this vehicle's character may not be shown now.
inline bool hides_character(const LabView& view, const VehicleView& vehicle) {
    return !view.may.characters || is_brain_secret(view, vehicle.kind);
}

// The vehicle whose eyes, wires and wheels a lecture shows large below the scene; null in scenes of predators and prey,
// where the counts of both take this place.
inline const VehicleView* vehicle_of_live_picture(const LabView& view) {
    if (!view.lecture || view.now->predators + view.now->prey > 0) return nullptr;
    return selected_vehicle(view);
}

// The pair of sensors whose wires the sliders set.
inline SensorPair shown_pair(const LabView& view, const VehicleView& vehicle) {
    return chosen_pair(kind_of(*view.now, vehicle), view.settings.selection.pair);
}

// What an edit of this vehicle's brain or sensors applies to: its whole kind or this vehicle alone.
inline Target target_of(const Selection& selection, const VehicleView& vehicle) {
    return selection.whole_kind ? Target{no_vehicle, vehicle.kind} : Target{vehicle.id, -1};
}
inline Target target_of(const LabView& view, const VehicleView& vehicle) {
    return target_of(view.settings.selection, vehicle);
}

}  // namespace braitenlab
