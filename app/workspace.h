// The open document as a person works on it: its playback, what is selected, how it is shown, the notice. What all
// features of the lab read and change; a feature knows the workspace and its own state, never another feature.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/course/together.h"
#include "app/document.h"
#include "core/session/session.h"
#include "core/world/snapshot.h"
#include "render/view/view_settings.h"
#include "ui/lab_view.h"
#include "ui/request.h"

namespace braitenlab {

inline constexpr float least_time_scale = 0.125f, largest_time_scale = 16;  // simulated seconds per second
inline constexpr double tick_length = 1.0 / 60;                             // s, as in core/brain/brain.h

// Measured speed of simulated time while playing.
struct Pace {
    double wall = 0, simulated = 0;  // s, in the interval being measured
    std::optional<float> reached;    // simulated seconds per second in the last interval; nullopt: as requested
    double slow = 0;                 // s of processor time in ticks that are too long, of which the last one is one
};

// A moment of the run.
struct TimeMark {
    Bookmark moment;
    std::vector<RunPlace> path{};  // Lesson::path at that moment; empty: no exercise
};

struct Playback {
    Mode mode = Mode::paused;
    float time_scale = 1;               // simulated seconds per second
    std::vector<VehicleView> previous;  // vehicles one tick ago, to interpolate between two ticks
    double debt = 0;                    // simulated seconds that are due and not stepped yet
    Pace pace;
    std::int64_t toggles = 0;  // changes between playing and not playing
    std::vector<TimeMark> bookmarks;
    bool held = false;                   // true while the playhead is dragged; the simulation is paused
    std::optional<std::uint64_t> seeks;  // the recorded tick on the way to which the run is, a part of it a frame
};

// The values that lecture mode changes, saved when it starts.
struct SettingsBeforeLecture {
    Theme theme = Theme::dark;
    float type_size = 1;
    ViewSettings view;  // restored at the end, except for the selection, which belongs to the run
    std::optional<std::uint64_t> run_with_work{};  // Document::run_id of the document if it has unsaved edits
};

// Why no vehicle is selected, and none is to be selected instead: the user's choice stays until a vehicle is chosen,
// the death of the selected vehicle until the run begins anew.
enum class Deselected { no, by_user, by_death };

struct Workspace {
    Document document;
    Playback playback{};
    ViewSettings view{};
    std::string object_name{};  // of view.selection.object, whose index changes when objects are added or removed
    std::vector<std::string> more_names{};  // of view.selection.more; empty for a vehicle
    std::string selected_kind{};            // name of the kind of the vehicle that was selected last
    Scene clipboard{};                      // copied objects (ui/scene_input/clipboard.h), also of another scene
    std::uint64_t gesture = 0;              // of the last action that edited several objects
    bool dragging = false;    // the user drags the selected vehicle or one of its values; see reselect_after_death()
    bool sheet_open = false;  // a sheet covers the window: simulated time is paused, the mode stays unchanged
    Deselected deselected = Deselected::no;
    Steer steered{};                                        // last command given by the arrow keys
    Preferences preferences{};                              // as shown now
    std::optional<SettingsBeforeLecture> before_lecture{};  // set in lecture mode
    std::optional<LectureView> pages{};                     // the open lecture; only in lecture mode
    std::optional<Together> together{};                     // set while the graded starts run at once
    Notice notice{};
    double notice_until = 0;  // wall seconds
    double wall_seconds = 0;
};

// What the scene shows: the run of the document, or the graded starts at once.
const Snapshot& shown_snapshot(const Workspace&);

// The preferences without the changes that lecture mode makes.
Preferences own_preferences(const Workspace&);

// The number of a new action that edits several objects in one step of undo.
std::uint64_t new_gesture(Workspace&);

// Shows a notice at the bottom of the window, at least so long. Its duration depends on the length of the text;
// failures are shown longest.
void say(Workspace&, Notice, double least_seconds = 0);
void say(Workspace&, const Error&);
// Says where a download is; `key`: of the string with its name. A browser does not tell whether it downloads.
void say_downloaded(Workspace&, std::string_view key, const std::filesystem::path&);

// The error as the user is told it: a page shows the name of a file without its folder, which the user does not know.
Error for_user(Error);

void set_mode(Workspace&, Mode);

// The run goes on from another place: nothing is interpolated or due.
void forget_motion(Workspace&);

// Position of the picture between the previous tick (0) and the last one (1); 1 while the simulation is paused.
float between_ticks(const Workspace&);

// Shows these worlds, at least one, in place of the document's run; time plays.
void begin_together(Workspace&, Together);
// The document's run is shown again, paused, as it was left. Does nothing if it is shown.
void end_together(Workspace&);

// The vehicle of another run with this path and body at the displayed time; nullopt once the path has ended. It points
// to the path.
std::optional<GhostView> ghost_at(const Workspace&, const ReferencePath&, const Body&);

}  // namespace braitenlab
