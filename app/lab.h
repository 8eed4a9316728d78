// The lab without its window: a workspace, and the features on it. Panels and keys send a Request, which
// app/lab_requests.h executes. It uses no graphics and no clock; tests call it directly. A feature does not include
// this header.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/features/behaviour_map.h"
#include "app/features/breeding.h"
#include "app/features/explanation.h"
#include "app/features/last_run.h"
#include "app/features/mystery_runs.h"
#include "app/features/predictions.h"
#include "app/features/robot_trial.h"
#include "app/features/slots.h"
#include "app/features/study_runs.h"
#include "app/workspace.h"
#include "core/lesson/progress.h"
#include "ui/lab_view.h"
#include "ui/request.h"

namespace braitenlab {

struct ExerciseCheck;  // app/course/exercise_check.h
struct AuthoredScene;  // app/course/authored_scene.h

// What is kept of lectures (app/course/lab_lecture.h).
struct LectureMemory {
    Theme theme = Theme::light;          // of the next lecture: that of the last one since the start
    std::optional<LectureView> left{};   // the lecture that was left last
    std::uint64_t left_run = 0;          // Document::run_id when it was left; F9 then goes back to it
    Slots slots_before{};                // restored when lecture mode ends; each page begins without stored brains
    std::optional<LectureView> tally{};  // of a question that is asked without pages; nullopt: hands are not counted
    std::size_t tally_options = 4;       // of the present tally and the next one
    double began = 0;                    // wall seconds
    std::string notes_written{};  // the page of notes as written last; empty: none is open. See app/course/notes_page.h
};

// Requests that the window executes and clears.
struct ForWindow {
    std::string to_copy{};  // text for the clipboard
    bool exit = false, screenshot = false, full_screen = false;
    std::optional<TakeAway> take_away{};  // a picture or a clip
    bool cancels_clip = false;
    bool begins = false;                         // leaves the title page
    bool opens_notes = false;                    // the notes of the lecture, in a browser
    bool uploads = false;                        // the user chooses files of the computer
    std::vector<Request> files{};                // to open, to save, to export, to list a folder
    std::vector<Request> reports{};              // hand-ins, lab records and figures to write
    std::vector<std::filesystem::path> saved{};  // scene files written: leftovers of earlier work on them are removed
};

// A workspace, and the state of each feature.
struct Lab : Workspace {
    std::shared_ptr<ExerciseCheck> check{};     // of the open exercise for its author; null: none
    std::vector<Finding> findings{};            // of that check, or the errors of its file
    std::shared_ptr<AuthoredScene> authored{};  // from which an exercise was made last; null: none
    StudentBook students{};                     // see app/course/lab_progress.h
    std::optional<std::pair<std::uint64_t, std::size_t>> progress_of{};  // run_id and student of the notes in the view
    LectureMemory lectures{};
    Predictions predictions{};  // of the selected vehicle's path
    LastRun last_run{};         // of the open document, before the last reset
    Explanation explanation{};  // of the selected vehicle's turn
    Slots slots{};
    MysteryRuns mystery{};
    BehaviourMap map{};       // of the selected vehicle's brains
    StudyRuns study{};        // on its sheet
    BreedingRuns breeding{};  // on its sheet
    RobotTrial robots{};      // of the selected vehicle's brain
    std::string link_base{};  // address before the '#' of a copied link; empty: unknown
    ForWindow window{};
};

// A lab with this document, paused.
Lab make_lab(Document);

// open_document() and make_lab().
Result<Lab> open_lab(const std::filesystem::path&, std::optional<std::uint64_t> seed,
                     const std::vector<Setting>& settings);

// Replaces the open document and resets the playback. Preferences, and the view settings that do not depend on the
// scene, stay unchanged.
void replace_document(Lab&, Document);

// Starts and takes what the features compute in the background. Call once per turn, after Jobs::deliver.
void update_features(Lab&, Jobs&);

// A page with a question of so many options without words, without hands.
LectureView empty_tally(std::size_t options);

// The camera that Home restores: that of the lecture's page, else the default.
Camera home_camera(const Workspace&);

// The view of the lab for the panels. Points into the lab: valid until the lab changes.
LabView view_of(const Lab&);

}  // namespace braitenlab
