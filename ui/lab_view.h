// What the panels may see of the lab: the moment, the mode and what is selected. They change nothing; see ui/request.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"
#include "core/lesson/referee.h"
#include "core/world/snapshot.h"
#include "render/view/camera.h"
#include "render/view/palette.h"
#include "render/view/view_settings.h"
#include "ui/files.h"
#include "ui/notice.h"
#include "ui/preferences.h"
#include "ui/strings.h"

namespace braitenlab {

enum class Mode { playing, paused, wiring };  // wiring is a paused mode with a display of its own

// The exercise that is open and how far the student has got.
struct LessonView {
    const Exercise* exercise = nullptr;  // never null
    std::vector<Verdict> verdicts;       // one per step of the exercise
    int prediction = -1;                 // the option chosen, 0-based; −1: none yet
    bool has_run = false;                // played at least once since it was opened
    int hints_shown = 0;                 // of exercise->hints
    bool hint_ready = true;              // the next hint may be opened now
    std::optional<Grade> grade;          // of the starts, once every step has been done in a run
    bool by_hand = false;                // something was moved: this run does not count
};

// A shipped scene or exercise, as the menu of what can be opened lists it.
struct CatalogueEntry {
    std::string name, path;  // "2a-coward", and where its file is
    std::string title, story;
    int number = 0;  // of an exercise; 0: a scene
};

// The part of the run that can be gone to, in ticks. The moment shown is somewhere in it.
struct TimelineView {
    std::uint64_t earliest = 0, latest = 0;
    std::vector<std::uint64_t> bookmarks;  // in the order of setting them; some may lie outside
};

struct LabView {
    const Snapshot* now = nullptr;  // never null
    const Scene* file = nullptr;    // the scene as its file has it, before all edits; null: unknown
    Mode mode = Mode::paused;
    TimelineView timeline;
    float time_scale = 1;       // simulated seconds per second, 1/8 … 16
    std::optional<float> pace;  // the same, as it is reached, where that is clearly less
    ViewSettings settings;
    const Sight* sight = nullptr;  // where the scene is seen from; null: it cannot be pointed at
    int undo_depth = 0, redo_depth = 0;
    const LessonView* lesson = nullptr;                      // null outside exercises
    const std::vector<CatalogueEntry>* catalogue = nullptr;  // null: nothing to open
    const std::vector<std::string>* recent = nullptr;        // paths opened before, the newest first; null: none
    const FilesView* files = nullptr;                        // null: no disk to look at
    std::string opened;                                      // the name of what is open, as in the catalogue
    std::uint64_t run_id = 0;  // another number for every document opened since the program started
    Notice notice;             // empty when there is nothing to say
    Theme theme = Theme::dark;
    Preferences preferences;                           // as chosen; theme and reduce_motion are as shown now
    const std::vector<Language>* languages = nullptr;  // null: no choice
    bool reduce_motion = false;
    bool lecture = false;                     // large type, a clean screen
    const RecoveryOffer* recovery = nullptr;  // null: nothing was left behind
    double wall_seconds = 0;                  // for easing and pulsing alone
};

}  // namespace braitenlab
