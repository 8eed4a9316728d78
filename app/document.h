// An open document (scene, exercise or saved run): its session, its file and which edits are saved.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/asked.h"
#include "app/jobs/jobs.h"
#include "app/jobs/reference_path.h"
#include "core/lesson/attempt.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"
#include "core/lesson/referee.h"
#include "core/lesson/selection.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"
#include "core/session/session.h"

namespace braitenlab {

// Time and size of a file. Marks taken at two times differ if the file has been written in between.
struct FileMark {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;
    friend bool operator==(const FileMark&, const FileMark&) = default;
};
FileMark mark_of(const std::filesystem::path&);  // FileMark{} if there is no such file

// The hash of a file's bytes; nullopt if there is none that can be read.
std::optional<std::uint64_t> content_of(const std::filesystem::path&);

// A submission that is being graded in the background. It ends with the document.
struct Grading {
    Submission submission;
    Job<Grade> job;              // one part per start
    bool run_was_reset = false;  // since grading began
};

// What the gain of the offered controls depends on.
struct GainQuestion {
    std::int64_t edits = 0;                     // Document::edits
    std::shared_ptr<const BrainGraph> brain{};  // of the subject's kind: another one where the run goes back
    SensorPair pair{};                          // whose wires the sliders set
    friend bool operator==(const GainQuestion&, const GainQuestion&) = default;
};

// A grade belongs to the submission that got it.
struct GradedSubmission {
    Submission submission;
    Grade grade;
};

// Selection by hand (core/lesson/selection.h): the parents chosen so far, and the runs of the last one's children.
struct Selecting {
    std::vector<Parent> parents;   // at least the exercise's own brain
    std::vector<Parent> undone{};  // parents that undo has taken away, for redo
    std::uint64_t start = 0;       // seed of the runs
    Job<std::vector<StartResult>> job{};
    std::optional<StartResult> parent_run{};  // of the last parent; nullopt while it is computed
    std::vector<StartResult> child_runs{};    // of its children; empty while they are computed
    std::vector<int> child_stays{};           // SelectionView::stays
};

// A place of the first vehicle, m, at a tick.
struct RunPlace {
    std::uint64_t tick = 0;
    maths::vec2 at;
};

// An open exercise: its text and the student's progress. Its referee observes the session.
struct Lesson {
    std::shared_ptr<const Exercise> exercise;  // never null
    std::string key;                           // in StudentProgress: Exercise::id if it ships, else its file's path
    Attempt attempt{};
    Standing standing{};
    double last_hint_at = 0;  // wall seconds
    std::optional<Grading> grading{};
    std::optional<Job<Grade>> shipped_grading{};  // for Exercise::median; begins with the first grade
    std::optional<Grade> shipped_grade{};         // of the starts as shipped, once the submission has a grade
    std::optional<GradedSubmission> graded{};
    Asked<GainQuestion, std::vector<float>> gains{};  // LessonView::gains; asked once it has run
    std::optional<Selecting> selecting{};             // nullopt: not begun
    std::optional<Submission> done_with{};            // when every step of this run was done; nullopt: they are not
    bool was_shown = false;        // the solution, since the exercise was opened; it may come back by undo
    std::uint64_t selections = 0;  // begun since the exercise was opened
    BackgroundPath solution_path{}, shipped_path{};  // of the first vehicle with the solution, of the one in question
    // One per path_ticks from the start of the run, by ascending tick: the session records only the last minute. Valid
    // before Session::earliest(); an edit in the past leaves later ones until the next tick.
    std::vector<RunPlace> path{};
};

// The grade of the present submission, or null; and whether it has passed.
inline const Grade* grade_of(const Lesson& l) { return l.standing.is_graded && l.graded ? &l.graded->grade : nullptr; }
inline bool has_passed(const Lesson& lesson) { return grade_of(lesson) && grade_of(lesson)->good; }

struct Document {
    Session session;
    std::string name{};                       // of the file, without folder and extension
    std::filesystem::path path{};             // absolute; empty: not saved yet
    bool is_scene_named_by_file = false;      // the file that was opened states no name, or its own: nor does a copy
    std::shared_ptr<const Scene> file{};      // the scene as it was read or saved last
    FileMark on_disk{}, noticed{};            // the file as follow_file() knows it; and at its last check
    std::optional<std::uint64_t> content{};   // content_of() the file as it was read or written; nullopt: never
    std::optional<Error> broken{};            // why the file, changed by another program, cannot be read any more
    std::vector<Setting> settings{};          // values of the scene that were set when it was opened (--set)
    std::optional<Lesson> lesson{};           // nullopt: no exercise
    std::int64_t edits = 0, saved_edits = 0;  // edits so far, and their number when the user saved last
    std::uint64_t saved_tick = 0;             // the run up to this tick is in its file
    std::uint64_t run_id = 0;                 // unique among the documents opened since the program started
};

// The referee of the open exercise, as it has watched the run up to the present tick. Precondition: an exercise is
// open.
const Referee& referee_of(const Document&);

// The title of the exercise, else of the scene with all edits; the name of the file if there is no title.
std::string title_of(const Document&);

// The scene with all edits, and the run, as a file or a link keeps them: the brains that the exercise hides are hidden.
Scene scene_to_keep(const Document&);
SavedRun run_to_keep(const Document&);

// The absolute path without "." and "..". An empty path stays empty.
std::filesystem::path absolute_path(const std::filesystem::path&);

// A file that has been read once.
struct FileText {
    std::filesystem::path path;
    FileKind kind = FileKind::scene;
    std::string text;  // empty for a saved run, which load_run reads
    FileMark mark;
};

// Fails as read_text does.
Result<FileText> read_file(const std::filesystem::path&);

// Opens a scene, an exercise or a saved run. A saved run continues from its tick. `settings` apply to scenes and, after
// the exercise's own settings, to exercises. `seed` replaces the seed of the exercise, or 1 for a scene.
// Fails with file and line as load_scene, load_exercise and load_run do.
Result<Document> open_document(const FileText&, std::optional<std::uint64_t> seed,
                               const std::vector<Setting>& settings);
Result<Document> open_document(const std::filesystem::path&, std::optional<std::uint64_t> seed,
                               const std::vector<Setting>& settings);

// Continues a run; the document has no file.
Document resume_document(SavedRun, Edits = {});

}  // namespace braitenlab
