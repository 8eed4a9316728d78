// View state of the panels: folds, drags, focus. It is not part of the simulation.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/evolve/scene_breeding.h"
#include "core/insight/axis_value.h"
#include "core/world/command.h"
#include "ui/panels/brain/brain_analysis.h"
#include "ui/panels/charts/chart_data.h"
#include "ui/panels/course/author_state.h"
#include "ui/panels/course/exercise_rows.h"
#include "ui/panels/course/glossary.h"
#include "ui/panels/course/marks.h"
#include "ui/panels/files/file_lists.h"
#include "ui/panels/prompt_state.h"
#include "ui/panels/robots/robot_state.h"
#include "ui/panels/study/study_draft.h"
#include "ui/scene_input/scene_input.h"
#include "ui/widgets/card.h"
#include "ui/widgets/finger_scroll.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/menu_bar.h"
#include "ui/widgets/record_fields.h"
#include "ui/widgets/sheet.h"
#include "ui/widgets/slider.h"
#include "ui/wiring/canvas.h"

namespace braitenlab::ui {

// The cards of the window: card_table.def has one row for each.
enum class Card {
#define CARD(id, ...) id,
#include "ui/panels/card_table.def"
};
inline constexpr std::size_t card_count = static_cast<std::size_t>(Card::inspector) + 1;

// Every card in its initial state.
std::array<CardState, card_count> initial_cards();

// The sheet that covers the window; at most one, and simulated time is paused. sheet_table.def has one row for each.
enum class Sheet {
#define SHEET(id, ...) id,
#include "ui/panels/sheet_table.def"
    none
};
inline constexpr std::size_t sheet_count = static_cast<std::size_t>(Sheet::none);

// The card of the arena and the kinds.
struct ValuesState {
    bool kinds = false;               // the part with the kinds is shown
    int kind = 0;                     // the kind whose values are shown
    VehicleId followed = no_vehicle;  // the kind is that of this selected vehicle until another is selected or chosen
    TextField seed;
    bool body_open = false, realism_open = false, memory_open = false, lamps_open = false, path_open = false;
};

// The sheet for pictures and clips.
enum class TakePage { picture, clip };
struct TakeAwayState {
    bool open = false;    // in the last frame
    bool writes = false;  // a clip was being written in the last frame
    TakePage page = TakePage::picture;
    std::size_t picture = 0;                      // in pictures_to_take
    std::size_t picture_size = 0, clip_size = 0;  // of those that the sheet lists
    std::size_t format = 0;                       // of a clip, of those that can be written
    float from = 0, to = 0;                       // s, of a clip
};

// The card of the map of behaviour.
enum class MapList { none, x, y, measure };
struct MapState {
    MapList open = MapList::none;                            // the list of axes or measures that is unfolded
    insight::ValueGroup group = insight::ValueGroup::brain;  // of the values that the list of an axis shows
    float added_height = 0;         // of an unfolded list and a range below its axis as drawn last, window pixels
    bool drags = false;             // the dot is dragged
    bool is_open = false;           // in the last frame
    bool folded_scene = false;      // the scene's card was folded to make room
    bool folded_brain = false;      // so was the brain's, in a lecture
    bool replaces_diagram = false;  // this card or one beside it has the room of the watched diagram, set each frame
    std::optional<insight::MapPlace> pressed{};  // the cell on which the button went down, beside the dot
    std::optional<insight::MapPlace> hovered{};  // under the pointer in this frame
};

// The card of the trial with real robots.
struct RealityState {
    std::optional<int> hovered{};  // robot under the pointer in this frame
};

// A signal that is dragged to the chart card; see signal_drag.h.
struct SignalDrag {
    std::string name;       // empty: none
    maths::vec2 press;      // window pixels
    bool moves = false;     // far enough from the press to be no click
    bool given_up = false;  // by Esc; the button is still down
    std::string onto;       // chosen strip under the pointer; empty: none
    Rect onto_row;          // its row, window pixels
};

// The card of the charts; one chart is shown at a time.
enum class Chart { signals, all, chosen, population, energy, bars };
struct ChartsState {
    bool open = false;
    Chart shown = Chart::signals;
    History history;
    std::vector<std::string> strips;  // names of the signals on the tab "Chosen"; kept for every vehicle
    SignalDrag drag;
    EnergyOrder energy_order;
    std::vector<std::size_t> energy_rows;  // indices into the snapshot's vehicles, in that order
};

// The card of the sensors.
struct SensorsState {
    std::string shown;          // name of the sensor that the card shows; the first if there is none of this name
    bool channel_open = false;  // the list of channels is unfolded
    bool adding = false;        // the list of channels of a new sensor is unfolded
    bool single = false;        // a new sensor is a single one, not a pair
    bool alone = false;         // edits do not apply to the sensor on the other side
    bool quality_open = false;  // noise and latency are unfolded
};

// The menu of presets.
struct PresetsState {
    bool open = false, closes = false;
    float width = 0, height = 0;  // as drawn last; window pixels
    std::string asked;            // the preset whose sensors the menu offers to use, too; empty: it lists the presets
    bool wanted = false;          // requested by a click on their button while another menu covered it
};

// The card of the brain.
struct BrainState {
    Recognised recognised;
    bool thresholds_open = false;      // the thresholds are shown also while all are 0
    std::string lesion_under_pointer;  // anchor of the part that a click or L would lesion or heal; empty: none
    std::string lesion_requested;      // the same, requested by key and not yet carried out
    // What the preset or the part of the brain picture under the pointer would change; empty: none is.
    std::vector<Command> what_if;
    Steer steered;  // last command of the on-screen stick
    bool stick_held = false;
    PresetsState presets;
    std::uint64_t shown_run = 0;           // LabView::run_id and
    VehicleId shown_vehicle = no_vehicle;  // vehicle of the last frame: with others the card is at its top again
};

// Handing in an exercise; see exercise_files.cpp.
struct HandInState {
    TextField name;       // the student's, typed where the view has none
    bool asks = false;    // the field for the name is shown
    bool begins = false;  // and gets the focus when it is drawn
};

// The heights of the cards below the open card of the exercise. They stay until what they depend on changes or a card
// unfolds, so that no row of these cards moves while the exercise's text grows.
struct CardsBelowExercise {
    std::size_t depends_on = 0;  // hash of column, shown and folded cards, run, selection, and what may be shown
    int settling = 0;            // frames for which the heights still follow the cards' contents
    std::array<float, card_count> heights{};  // window pixels, by place in the column
    std::array<float, card_count> wanted{};   // those that the contents had then
};

// What a person is told once, also by a card that opens for it.
struct ExerciseNews {
    bool outcome = false, grade = false;
    std::size_t hints = 0;
};

// The card of the exercise.
struct ExerciseState {
    std::string id;  // of the exercise that the values below belong to
    ExerciseRows rows;
    std::optional<std::uint64_t> play_held;  // LabView::run_id of the document whose question Play has pointed to
    bool shows_question = false;             // the card scrolls to the question
    bool outcome_seen = false;               // the outcome of the prediction has been scrolled to
    std::size_t hints_seen = 0;              // hints already scrolled to
    bool hints_first = false;                // they were above the steps in the last frame
    bool grade_seen = false;
    ExerciseNews told{};
    bool why_open = false;     // unfolded
    bool steps_open = true;    // can be folded once the exercise is passed
    bool goal_open = false;    // all of the goal is shown in a low card
    bool is_goal_cut = false;  // it was shown in fewer lines in the last frame
    int step_in_full = -1;     // index of the open step that was clicked in a low card; −1: none
    bool more_open = false;    // the buttons that the foot has no room for are unfolded
    bool reset_asked = false;  // Start over asks before it takes changes back
    bool note_open = false;    // the notes are unfolded
    bool note_begins = false;  // their field gets the focus when it is drawn
    TextField note;
    std::string noted;  // the notes that the field was drawn with last
    HandInState hand_in;
    CardsBelowExercise below;
};

// Cards and focus that a lecture changes and restores at its end.
struct BeforeLecture {
    std::array<CardState, card_count> cards;
    std::string focus;
};

// A key shown to the audience of a lecture.
struct PressedKey {
    KeyPress press;
    double at = 0;  // wall seconds
};

struct LectureState {
    std::optional<BeforeLecture> before;
    bool controls = false;            // the card of the brain has all of its buttons
    std::vector<PressedKey> pressed;  // the newest last
    Marks marks;
    bool blank = false;                   // the window is black until the next key or click
    CardState notes;                      // of the lecturer
    int notes_page = -1;                  // whose notes were drawn last
    float notes_height = 1;               // wanted, as drawn last; window pixels
    std::vector<TextField> hands;         // counts on the current page, by option
    CardState question;                   // of that page
    float question_height = 0;            // wanted, as drawn last; window pixels
    std::array<int, 3> step{-1, -1, -1};  // run, page and step whose cards are shown
    bool compares = false;                // both runs of slots A and B were shown last
    bool counts = false;                  // hands were counted without a page in the last frame
    bool asks_prediction = false;         // the exercise of the page waited for its prediction in the last frame
};

// The sheet of the studies.
struct StudyState {
    int shown = 0;            // StudyView::shown at the last frame
    std::size_t measure = 0;  // in Study::measures
    StudyDraft draft;
};

// The sheet of the breeding.
struct BreedingSheetState {
    std::vector<BreedingCell> watched;  // BreedingView::watched at the last frame
    double began = 0;                   // wall seconds when these matches began
    int shown = 0;                      // BreedingView::shown at the last frame
    evolve::MayChange may{};            // in a breeding of the open scene
};

// The sheets about unsaved edits.
struct UnsavedState {
    bool recovery_asked = false, leaving_asked = false;
    int leaving_done = 0;  // FilesView::done when the sheet for a name was opened; −1: the sheet is not open
};

// What the sheets keep.
struct SheetStates {
    std::array<SheetState, sheet_count> all;
    FilesState files;
    AuthorState author;
    RobotState robot;
    TakeAwayState take;
    StudyState study;
    BreedingSheetState breeding;
    UnsavedState unsaved;
    TextField student_name;
    std::optional<Preferences> before_reset;  // preferences before Reset All, until one is changed
};

struct PanelState {
    CardState& card(Card which) {
        return which == Card::inspector ? canvas.inspector : cards[static_cast<std::size_t>(which)];
    }
    SheetState& state_of(Sheet which) { return sheets.all[static_cast<std::size_t>(which)]; }  // not of Sheet::none

    std::array<CardState, card_count> cards = initial_cards();  // the inspector's is in `canvas`
    // Set by draw_window: a card or a sheet does not yet have the height of what it shows; the next frame corrects it.
    // See CardState::is_cut, SheetState::is_resized.
    bool is_unsettled = false;
    SliderState sliders;
    FieldsState fields;
    Keyboard keyboard;
    Tooltips tooltips;
    wiring::CanvasState canvas;
    SceneInputState scene_input;
    PromptMemory prompts;
    BrainState brain;
    SensorsState sensors;
    ValuesState values;
    MapState map;
    RealityState reality;
    ChartsState charts;
    ExerciseState exercise;
    LectureState lecture;
    GlossaryState glossary;
    Sheet sheet = Sheet::none;
    SheetStates sheets;
    MenuBarState menu_bar;
    FingerScroll finger_scroll;
    std::vector<Action> chosen;  // with toolbar and menus, executed at the end of the frame
    bool playhead_held = false;  // true while the playhead is dragged; the simulation is paused
};

}  // namespace braitenlab::ui
