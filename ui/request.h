// What panels, shortcuts and the mouse ask of the lab. The app carries requests out in order, once a frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/world/command.h"
#include "render/view/pick.h"
#include "render/view/view_settings.h"
#include "ui/files.h"
#include "ui/preferences.h"

namespace braitenlab {

// Requests without a value: what buttons and shortcuts do.
enum class Action {
    play_pause,
    step,
    step_back,
    rewind,  // by a stretch, and forward again as far as the run is recorded
    fast_forward,
    set_bookmark,
    last_bookmark,
    reset,
    add,
    remove,
    follow,
    new_population,
    exit,
    sensors,
    outlines,
    trails,
    surfaces,
    memory,  // the places that vehicles remember
    labels,
    next_field,  // of those that can be shown as contours, and none
    view,        // the menu of all these
    wiring,
    undo,
    redo,
    slower,
    faster,
    drive,   // by hand, or no longer
    lesion,  // of what is under the pointer: covers, cuts, stops or heals it
    next_vehicle,
    previous_vehicle,
    home,
    birds_eye,
    drivers_eye,
    cancel,
    erase,      // the lamp or obstacle that is selected, else the vehicle; in the canvas what is selected there
    duplicate,  // the lamp, obstacle or vehicle
    screenshot,
    full_screen,
    theme,
    larger,
    smaller,
    settings,
    charts,
    keys,
    hint,
    exercise_reset,
    open,
    save,
    save_as,
    lecture,

    // Of widgets, canvas and scene input, never of the lab.
    slider_LL,
    slider_LR,
    slider_RL,
    slider_RR,
    next_card,
    next_widget,
    previous_widget,
    press,
    less,
    more,
    restore,  // what the file says
    turn_left,
    turn_right,
    raise,
    lower,
    fit,
    nudge,  // what is selected in the scene
    close_outline,
    take_back,
    scene_menu,
    copy,
    cut,
    paste,
    select_all,
    tidy,
    join,
    menu,
    step_left,
    step_right,
    step_up,
    step_down,
};
inline constexpr Action last_action = Action::step_down;

struct EditRequest {
    Command command;
    std::uint64_t gesture = 0;  // the same for all edits of one drag: one step of undo
};
struct SelectRequest {
    VehicleId vehicle = no_vehicle;
};
// A lamp or an obstacle is selected beside the vehicle, which keeps its brain in sight; SceneObject{}: none of them.
struct TakeRequest {
    SceneObject object;
};
struct ScopeRequest {
    bool whole_kind = true;
};
struct PredictRequest {
    int option = 0;  // 0-based
};
struct ExportRequest {  // numbers for a spreadsheet, to a new file where pictures go
    std::string name, text;
};
struct SpeedRequest {
    float time_scale = 1;
};
struct SeekRequest {
    std::uint64_t tick = 0;
    bool held = false;  // the playhead is still in a hand: time waits, and a rough answer will do
};
struct BookmarkRequest {  // one of TimelineView::bookmarks
    int index = 0;
    bool remove = false;  // else go there
};
struct OpenRequest {
    std::string path;      // of a scene, an exercise or a brain; as typed, so perhaps a folder or relative to one
    bool dropped = false;  // onto the window: nothing that lists folders is in sight
};
struct BrowseRequest {
    std::string path{};  // of the folder to list; empty: the one where a file was opened or saved last
};
struct SaveRequest {
    std::string path;  // as typed; its ending may be missing
    FileKind kind = FileKind::scene;
    std::optional<std::string> title{};  // of the scene, if another than it has
};
enum class Leave { save, discard, stay, saved };  // saved: under a name of its own, in between
struct LeaveRequest {                             // the answer to FilesView::leaving
    Leave answer = Leave::stay;
};
struct RecoverRequest {
    bool take = true;  // what was left behind; or throw it away
};
struct PreferencesRequest {
    Preferences preferences;
};
struct OverlaysRequest {
    Overlays overlays;
};

// Gestures are numbered by the part of the window that sees them, each from its own base upwards, so that the drags of
// two parts never become one step of undo.
namespace gestures {
inline constexpr std::uint64_t panels = std::uint64_t{1} << 32;
inline constexpr std::uint64_t canvas = std::uint64_t{1} << 40;
inline constexpr std::uint64_t viewport = std::uint64_t{1} << 48;
}  // namespace gestures

using Request = std::variant<Action, EditRequest, SelectRequest, TakeRequest, ScopeRequest, PredictRequest,
                             ExportRequest, SpeedRequest, OpenRequest, PreferencesRequest, OverlaysRequest, SeekRequest,
                             BookmarkRequest, BrowseRequest, SaveRequest, RecoverRequest, LeaveRequest>;
using Outbox = std::vector<Request>;

}  // namespace braitenlab
