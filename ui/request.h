// Requests of panels, shortcuts and the mouse. The app executes them in order, once a frame.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/insight/behaviour.h"
#include "core/insight/study_file.h"
#include "core/world/command.h"
#include "render/view/palette.h"
#include "render/view/pick.h"
#include "render/view/view_settings.h"
#include "ui/files.h"
#include "ui/take_away.h"

namespace braitenlab::evolve {
struct Breeding;   // core/evolve/breeding_file.h
struct MayChange;  // core/evolve/scene_breeding.h
}  // namespace braitenlab::evolve

namespace braitenlab::robots {
struct ExportedFile;  // core/export/export.h
}  // namespace braitenlab::robots

namespace braitenlab {

// Requests without a value: what keys, menus and buttons do. ui/actions.def has one row for each.
enum class Action {
#define ACTION(id, ...) id,
#include "ui/actions.def"
};
inline constexpr Action last_action = Action::blank;

// User settings that do not depend on the scene.
struct Preferences {
    Theme theme = Theme::dark;
    std::string language = "en";       // code of the strings file
    float type_size = 1;               // factor on the display's scale; least_type_size .. largest_type_size
    bool reduce_motion = false;        // no easing, no pulsing
    std::optional<Quality> quality{};  // nullopt: chosen by measured frame time
    std::string link_base{};           // address of the lab on the web, for links; only in the file of the settings
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

inline constexpr float least_type_size = 1, largest_type_size = 2;

struct EditRequest {
    Command command;
    std::uint64_t gesture = 0;  // the same for all edits of one drag: one step of undo
};
// Shows a notice: the text of the key with its values.
struct NoticeRequest {
    std::string key, words, more;
};
struct SelectRequest {
    VehicleId vehicle = no_vehicle;
};
// Selects a lamp, an obstacle or a zone in addition to the vehicle; SceneObject{}: none.
struct TakeRequest {
    SceneObject object;
};
// Selects these objects and no others: the first source, obstacle or zone as the chosen object, else the first vehicle.
struct SelectObjectsRequest {
    std::vector<SceneObject> objects;
};
// Adds the copied objects.
struct PasteRequest {
    std::optional<maths::vec2> at{};  // m, of their middle; nullopt: beside the original
};
struct ScopeRequest {
    bool whole_kind = true;
};
struct PairRequest {
    std::string name;  // KindPair::name
};
struct CanvasShareRequest {
    float share = 0.45f;  // ViewSettings::canvas_share
};
struct PredictRequest {
    int option = 0;  // 0-based
};
struct PredictPathRequest {
    std::vector<maths::vec2> path;  // m, from the vehicle on
};
struct CompareRequest {
    bool on = true;  // shows the run with the exercise's solution beside the student's
};
struct FreePlayRequest {
    bool on = true;  // shows all controls of the exercise; false: only the offered ones
};
struct HandsRequest {  // the count of raised hands of an option on the current page of the lecture
    int option = 0, hands = 0;
};
inline constexpr std::size_t least_tally_options = 2, most_tally_options = 6;
struct TallyRequest {  // the number of options of the question that a lecture asks without a page
    std::size_t options = most_tally_options;
};
struct ShowMeRequest {};     // gives the vehicle the exercise's solution
struct ChooseChildRequest {  // the vehicle gets the brain of this child, which then has children itself
    int child = 0;           // 0-based; −1: the parent again, for other children
};
struct EarlierGenerationRequest {};  // takes the last choice back
struct KeptRequest {};               // gives the vehicle the submission kept in the student's progress
struct TogetherRequest {             // runs the graded starts at once in the scene; false: returns to the exercise
    bool on = true;
};
struct NotesRequest {
    std::string text;  // replaces Attempt::notes
};
// choose: the student `index` works now. add, rename: `name`; refused unless is_free_name(). reset: forgets the
// progress of the current student; restore: takes the last reset back. save: writes the progress of all as a CSV file.
enum class StudentEdit { choose, add, rename, reset, restore, save, save_progress };
struct StudentRequest {
    StudentEdit edit = StudentEdit::choose;
    std::size_t index = 0;  // in StudentBook::all
    std::string name{};
};
struct ExportRequest {  // writes a new CSV file to the folder of pictures
    std::string name, text;
};
struct WriteFilesRequest {                                           // writes these files
    std::string folder;                                              // as typed; its last part is created
    std::shared_ptr<const std::vector<robots::ExportedFile>> files;  // never null
    bool replace = false;                                            // else nothing is written where a file exists
};
enum class EarlierHandIn { ask, replace, keep };  // what happens to an earlier one with a better result
struct HandInRequest {                            // writes a hand-in file to the folder of documents
    std::string student;
    EarlierHandIn earlier = EarlierHandIn::ask;
};
struct LabRecordRequest {  // writes a lab record to the folder of documents
    std::string student;   // may be empty
};
struct OpenFolderRequest {  // opens the folder of exported files with the system's program
    std::string folder;     // FilesView::exported_to
};
struct OpenWrittenRequest {};  // opens the lab record written last with the system's program
struct MapRange {
    float from = 0, to = 1;
};
struct MapRequest {                       // what the map of behaviour shows; nullopt: as before
    std::optional<std::string> x{}, y{};  // insight::AxisValue::id, with its usual range
    std::optional<MapRange> x_range{}, y_range{};
    std::optional<insight::MapMeasure> measure{};
    std::optional<int> seeds{};
};
// hide, reveal: the brain of the selected vehicle's kind. rebuild: adds a vehicle with the body of the hidden brain.
// score: how nearly the selected vehicle's brain drives as the hidden one.
enum class MysteryEdit { hide, reveal, rebuild, score };
struct MysteryRequest {
    MysteryEdit edit = MysteryEdit::score;
};
struct SlotRequest {
    std::size_t slot = 0;  // 0: A, 1: B
    bool store = false;    // stores the vehicle's brain; else puts the slot's brain into the vehicle
};
struct EmptySlotsRequest {};  // forgets both brains, which closes their card
// Closes the card of what the check of an exercise has found.
struct HideFindingsRequest {};
// open: a file or the name of a shipped study. build: `study` of the open scene. run: goes on with the runs that are
// missing. stop: keeps complete runs. save: writes a built study with its scene to the folder of documents, and the
// table of a study with a file beside it. figure: writes a new SVG file to the folder of documents.
enum class StudyEdit { open, build, run, stop, save, figure };
struct StudyRequest {
    StudyEdit edit = StudyEdit::open;
    std::string path{};
    std::shared_ptr<const insight::Study> study{};  // its id, scene and first seed are set by the lab
};
// Two generations whose champions meet.
struct BreedingCell {
    int predator = 0, prey = 0;
    friend bool operator==(const BreedingCell&, const BreedingCell&) = default;
};
// open: a file or the name of a shipped breeding. scene: the open scene, of which `may` change. choose: `choice`, the
// open one with other numbers or opponents; what was bred with an earlier choice is kept. run: goes on to the last
// generation. stop: keeps complete generations. watch: the match of the cell, beside the one watched before. match:
// opens its scene, at its first start. take: its champions replace predator and prey of the open scene, else as match.
enum class BreedingEdit { open, scene, choose, run, stop, watch, match, take };
struct BreedingRequest {
    BreedingEdit edit = BreedingEdit::open;
    std::string path{};
    std::shared_ptr<const evolve::Breeding> choice{};
    BreedingCell cell{};
    std::string title{}, story{};  // of the scene of a match; the title also of a breeding of the open scene
    std::shared_ptr<const evolve::MayChange> may{};
};
struct RobotsRequest {               // of the trial with real robots; nullopt: as before
    std::optional<float> reality{};  // insight::RobotsQuestion
    std::optional<bool> tries{};     // begins the trial; false: ends it
    // Replays this robot, or every_robot, from the start in the place of the run; nullopt inside: the run is shown
    // again.
    std::optional<std::optional<int>> replays{};
};
inline constexpr int every_robot = -1;
struct TakeAwayRequest {  // writes a new picture or clip to the folder of pictures
    TakeAway what;
};
struct PageRequest {  // opens a page of the manual, "docs/robots.md"
    std::string page;
};
struct CancelClipRequest {};  // ends the clip that is being written; there is no file then
struct SpeedRequest {
    float time_scale = 1;
};
struct SeedRequest {  // resets the run with this seed
    std::uint64_t seed = 1;
};
struct SeekRequest {
    std::uint64_t tick = 0;
    bool held = false;  // true while the playhead is dragged: the simulation stays paused
};
struct WhyRequest {  // goes to this tick, pauses, and shows the cause of the selected vehicle's turn there
    std::uint64_t tick = 0;
};
struct BookmarkRequest {
    int index = 0;        // in TimelineView::bookmarks
    bool remove = false;  // else go to it
};
struct OpenRequest {
    std::string path;            // a scene, exercise, brain, run or folder, as typed, may be relative; or a link
    bool dropped = false;        // dropped onto the window, not chosen in the file browser
    bool next_exercise = false;  // requested by the button of a passed exercise, whose edited brain may be lost
    bool resume = false;         // a lecture that was left: at the page where it was left
    std::uint64_t seed = 1;      // of the run of a link
};
struct UploadRequest {};  // in a browser: the user chooses files of the computer
struct BrowseRequest {
    std::string path{};  // the folder to list; empty: the folder of the last opened or saved file
};
struct SaveRequest {
    std::string path;  // as typed; the extension may be missing
    FileKind kind = FileKind::scene;
    std::optional<std::string> title{};  // new title of the scene
    bool create_folder = false;          // else saving into a folder that does not exist is refused
    std::optional<std::string> story{};  // new story of the scene
};
struct ExerciseDraft;                            // core/lesson/author.h
struct SaveExerciseRequest {                     // writes an exercise file, opens it and checks it
    std::string path;                            // as typed; the extension may be missing
    std::shared_ptr<const ExerciseDraft> draft;  // never null
    bool replace = false;                        // else a path at which there is a file is refused
};
enum class Leave { save, discard, stay, saved };  // saved: already saved under a new name
struct LeaveRequest {                             // the answer to FilesView::leaving
    Leave answer = Leave::stay;
};
struct BeginRequest {};  // leaves the title page
struct RecoverRequest {
    bool take = true;  // recover the unsaved work; false: discard it
};
struct PreferencesRequest {
    Preferences preferences;
};
struct OverlaysRequest {
    Overlays overlays;
};

// Base numbers of gestures, one per part of the window, so that drags in two parts are separate steps of undo.
namespace gestures {
inline constexpr std::uint64_t panels = std::uint64_t{1} << 32;
inline constexpr std::uint64_t canvas = std::uint64_t{1} << 40;
inline constexpr std::uint64_t viewport = std::uint64_t{1} << 48;
inline constexpr std::uint64_t lab = std::uint64_t{1} << 56;  // one action that edits several objects
}  // namespace gestures

// Wheel commands for a stick or for four arrow keys; `right` and `ahead` are −1..1. Full ahead with full right gives a
// curve forwards.
inline Steer steer(VehicleId vehicle, float right, float ahead) {
    constexpr float turning = 0.5f;  // of full wheel speed, at full right or left
    return {vehicle, std::clamp(ahead + turning * right, -1.0f, 1.0f),
            std::clamp(ahead - turning * right, -1.0f, 1.0f)};
}

// A variant whose special members are defined once, in request.cpp: a compiler spends seconds on them in each source.
struct Request
    : std::variant<Action, EditRequest, SelectRequest, TakeRequest, SelectObjectsRequest, PasteRequest, ScopeRequest,
                   PairRequest, CanvasShareRequest, PredictRequest, FreePlayRequest, ShowMeRequest, ExportRequest,
                   SpeedRequest, OpenRequest, PreferencesRequest, OverlaysRequest, SeekRequest, WhyRequest,
                   BookmarkRequest, BrowseRequest, SaveRequest, RecoverRequest, LeaveRequest, SeedRequest,
                   NoticeRequest, SaveExerciseRequest, PredictPathRequest, CompareRequest, ChooseChildRequest,
                   EarlierGenerationRequest, KeptRequest, TogetherRequest, NotesRequest, StudentRequest, HandsRequest,
                   TallyRequest, HandInRequest, LabRecordRequest, BeginRequest, MapRequest, SlotRequest, StudyRequest,
                   UploadRequest, MysteryRequest, WriteFilesRequest, RobotsRequest, TakeAwayRequest, PageRequest,
                   CancelClipRequest, HideFindingsRequest, BreedingRequest, EmptySlotsRequest, OpenWrittenRequest,
                   OpenFolderRequest> {
    using variant::variant;
    Request() = default;
    Request(const Request&);
    Request(Request&&) noexcept;
    Request& operator=(const Request&);
    Request& operator=(Request&&) noexcept;
    ~Request();
};
using Outbox = std::vector<Request>;

}  // namespace braitenlab
