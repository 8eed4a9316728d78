// The lab without its window: a session with its clock, its exercise and what is selected. Panels and keys ask by
// Request; this carries the requests out. No graphics, no clock of its own: a test can drive it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/past.h"
#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"
#include "core/lesson/referee.h"
#include "core/scene/scene_file.h"
#include "core/session/session.h"
#include "render/view/camera.h"
#include "ui/lab_view.h"
#include "ui/preferences.h"
#include "ui/request.h"

namespace braitenlab {

// What tells whether a file has been written again.
struct FileMark {
    std::filesystem::file_time_type written{};
    std::uintmax_t size = 0;
    friend bool operator==(const FileMark&, const FileMark&) = default;
};
FileMark mark_of(const std::filesystem::path&);  // FileMark{} where there is no such file

// An open exercise: its text, its judge and how far the student has got.
struct Lesson {
    std::shared_ptr<const Exercise> exercise;  // never null
    Referee referee;
    LessonView view;
    double last_hint_at = 0;  // wall seconds
};

// What a lecture changes in the way of looking.
struct LectureBefore {
    Theme theme = Theme::dark;
    float type_size = 1;
    Camera camera;
    bool sensors = true, outlines = false;
};

// How fast simulated time passes, measured while playing.
struct Pace {
    double wall = 0, simulated = 0;  // seconds so far of the stretch that is measured now
    std::optional<float> reached;    // simulated seconds a second, of the last stretch; none: as fast as was asked for
};

struct Lab {
    Session session;
    std::string name;                   // of the file, without folder and ending
    std::filesystem::path path;         // of the file; empty: none yet
    std::shared_ptr<const Scene> file;  // the scene as it was read or saved
    FileMark on_disk, noticed;          // that file when it was read or saved; and as it was when last looked at
    std::vector<Setting> settings;      // that it was opened with
    std::optional<Lesson> lesson;

    Past past;

    Mode mode = Mode::paused;
    float time_scale = 1;
    std::vector<VehicleView> before;  // the vehicles a tick ago, so that a picture can stand between two ticks
    double debt = 0;                  // simulated seconds that are due but not yet stepped
    Pace pace;
    std::int64_t toggles = 0;  // changes between playing and not playing
    VehicleId selected = no_vehicle;
    Thing thing;             // a lamp or an obstacle, selected beside the vehicle
    std::string thing_name;  // by which it is known when others come or go
    bool whole_kind = true;
    Steer steered;  // by the arrow keys, last
    bool sensors = true, outlines = false;
    Overlays overlays;
    Camera camera;
    Preferences preferences;                      // as worn now
    std::optional<LectureBefore> before_lecture;  // in a lecture: what leaving it brings back
    std::int64_t work = 0, saved_work = 0;        // edits so far, and when a person saved last
    std::uint64_t saved_tick = 0;                 // up to which the run is in its file
    std::uint64_t sitting = 0;                    // which of the labs opened since the start this is
    Notice notice;                                // what there is to say
    double notice_until = 0;                      // wall seconds
    double wall_seconds = 0;

    // Asked of the window, which answers and clears them.
    bool exit = false, screenshot = false, full_screen = false;
    std::vector<Request> files;  // to open, to save, to export, to list a folder
};

// Opens a scene, an exercise or a saved run, which goes on as it is. Scenes take the settings; exercises bring their
// own and take them on top.
Result<Lab> open_lab(const std::filesystem::path&, std::optional<std::uint64_t> seed,
                     const std::vector<Setting>& settings);

// A lab that goes on with a run; it has no file.
Lab resume(SavedRun);

// What a person chose, without what a lecture puts over it.
Preferences desk_preferences(const Lab&);

void handle(Lab&, const Request&);

// Says it at the bottom of the window, for as long as it takes to read: what failed stays longest.
void say(Lab&, Notice);

// Lets wall time pass: steps as often as time and speed ask, for at most 12 ms, and forgets what it could not keep up
// with, so that a slow machine shows slow motion and never falls behind for good.
void advance(Lab&, double wall_seconds);

// One tick, whatever the mode.
void tick(Lab&);

// Arrow keys while the selected vehicle is driven by hand: `right` and `ahead` are −1, 0 or 1. False where nobody
// drives, and the keys are the camera's.
bool steer_by_keys(Lab&, float right, float ahead);

// How far wall time has gone from the last tick but one to the last, 0..1; 1 while time stands still.
float between_ticks(const Lab&);

// What panels see. Points into the lab: valid until it changes.
LabView view_of(const Lab&);

}  // namespace braitenlab
