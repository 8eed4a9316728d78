// The lab without its window: an open document, its playback and its view settings. Panels and keys send a Request,
// which app/lab_requests.h executes. It uses no graphics and no clock; tests call it directly.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/course/together.h"
#include "app/document.h"
#include "app/insight/behaviour_map.h"
#include "app/insight/explanation.h"
#include "app/insight/last_run.h"
#include "app/insight/mystery_runs.h"
#include "app/insight/predictions.h"
#include "app/insight/robot_trial.h"
#include "app/insight/slots.h"
#include "app/insight/study_runs.h"
#include "app/playback.h"
#include "core/lesson/progress.h"
#include "render/view/view_settings.h"
#include "ui/lab_view.h"
#include "ui/request.h"

namespace braitenlab {

// The values that lecture mode changes, saved when it starts.
struct SettingsBeforeLecture {
    Theme theme = Theme::dark;
    float type_size = 1;
    ViewSettings view;  // restored at the end, except for the selection, which belongs to the run
};

struct ExerciseCheck;  // app/course/exercise_check.h

struct Lab {
    Document document;
    Playback playback{};
    ViewSettings view{};
    std::string object_name{};  // of view.selection.object, whose index changes when objects are added or removed
    std::vector<std::string> more_names{};  // of view.selection.more; empty for a vehicle
    Scene clipboard{};                      // copied objects (ui/scene_input/clipboard.h), also of another scene
    std::uint64_t gesture = 0;              // of the last action that edited several objects
    bool dragging = false;      // the user drags the selected vehicle or one of its values; see reselect_after_death()
    bool sheet_open = false;    // a sheet covers the window: simulated time is paused, the mode stays unchanged
    bool deselected = false;    // no vehicle is selected, and none is selected in place of a dead one
    Steer steered{};            // last command given by the arrow keys
    Preferences preferences{};  // as shown now
    Theme lecture_theme = Theme::light;                     // of the next lecture: that of the last one since the start
    std::optional<SettingsBeforeLecture> before_lecture{};  // set in lecture mode
    std::shared_ptr<ExerciseCheck> check{};                 // of the open exercise for its author; null: none
    std::vector<Finding> findings{};                        // of that check, or the errors of its file
    StudentBook students{};                                 // see app/course/lab_progress.h
    std::optional<std::pair<std::uint64_t, std::size_t>> progress_of{};  // run_id and student of the notes in the view
    std::optional<Together> together{};                                  // set while the graded starts run at once
    std::optional<LectureView> pages{};                                  // the open lecture; only in lecture mode
    std::optional<LectureView> left_pages{};                             // the lecture that was left last
    Slots slots_before_pages{};   // restored when the open lecture is left; each page begins without stored brains
    std::uint64_t left_run = 0;   // Document::run_id when it was left; F9 then goes back to it
    double lecture_began = 0;     // wall seconds
    std::string notes_written{};  // the page of notes as written last; empty: none is open. See app/course/notes_page.h
    Predictions predictions{};    // of the selected vehicle's path
    LastRun last_run{};           // of the open document, before the last reset
    Explanation explanation{};    // of the selected vehicle's turn
    Slots slots{};
    MysteryRuns mystery{};
    BehaviourMap map{};   // of the selected vehicle's brains
    StudyRuns study{};    // on its sheet
    RobotTrial robots{};  // of the selected vehicle's brain
    Notice notice{};
    double notice_until = 0;  // wall seconds
    double wall_seconds = 0;

    std::string link_base{};  // address before the '#' of a copied link; empty: unknown

    // Requests that the window executes and clears.
    std::string to_copy{};  // text for the clipboard
    bool exit = false, screenshot = false, full_screen = false;
    std::optional<TakeAway> take_away{};  // a picture or a clip
    bool cancels_clip = false;
    bool begins = false;                         // leaves the title page
    bool opens_notes = false;                    // the notes of the lecture, in a browser
    bool uploads = false;                        // the user chooses files of the computer
    std::vector<Request> files{};                // to open, to save, to export, to list a folder
    std::vector<Request> reports{};              // hand-ins and lab records to write
    std::vector<std::filesystem::path> saved{};  // scene files written: leftovers of earlier work on them are removed
};

// A lab with this document, paused.
Lab make_lab(Document);

// open_document() and make_lab().
Result<Lab> open_lab(const std::filesystem::path&, std::optional<std::uint64_t> seed,
                     const std::vector<Setting>& settings);

// Replaces the open document and resets the playback. Preferences, and the view settings that do not depend on the
// scene, stay unchanged.
void replace_document(Lab&, Document);

// The preferences without the changes that lecture mode makes.
Preferences own_preferences(const Lab&);

// What the scene shows: the run of the document, or the graded starts at once.
const Snapshot& shown_snapshot(const Lab&);

// Shows a notice at the bottom of the window, at least so long. Its duration depends on the length of the text;
// failures are shown longest.
void say(Lab&, Notice, double least_seconds = 0);
void say(Lab&, const Error&);

// The view of the lab for the panels. Points into the lab: valid until the lab changes.
LabView view_of(const Lab&);

}  // namespace braitenlab
