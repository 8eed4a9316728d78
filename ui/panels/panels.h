// The panels. Each is a free function that reads the view, stores its view state in PanelState and adds requests to
// ui.outbox. ui/window.cpp and cards.cpp call them. A panel is defined in the file of its name, unless a comment names
// another file.
#pragma once

#include <string>
#include <string_view>

#include <imgui.h>

#include "ui/lab_view.h"
#include "ui/panels/actions.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// The cards of the columns; cards.h says when and where they are shown. `rest`: the column from the top of the card
// down.
#define CARD(id, function, ...) void function(const LabView&, PanelState&, Ui&, Rect place, Rect rest);
#define WINDOW_CARD(id, ...)
#include "ui/panels/card_table.def"

// Parts of cards, and the card of the charts.
std::string exercise_heading(const LabView&,
                             const Ui&);                 // "EXERCISE 5", "EXERCISE 14a", or "EXERCISE" without a number
void start_pictures(const LabView&, Ui&);                // precondition: view.lesson has a grade
void median_rows(const LessonView&, Ui&);                // nothing without LessonView::shipped_grade and a grade
void note_field(const LabView&, PanelState&, Ui&);       // the student's notes, while they are unfolded
void note_button(const LabView&, PanelState&, Ui&);      // unfolds them
float note_button_width(const LabView&, const Ui&);      // window pixels
void breeding_button(const LabView&, PanelState&, Ui&);  // nothing unless the exercise offers a breeding
void chart_card(const LabView&, PanelState&, Ui&, Rect);      // while ChartsState::open; folding closes it
void export_csv(const LabView&, const PanelState&, Outbox&);  // the chart that the chart card shows; chart_card.cpp

// Whether edits of the brain or the sensors apply to the vehicle or to all of its kind; nothing for the only vehicle of
// its kind. Anchors: `id`.1, `id`.2. brain_card.cpp
void scope_choice(const LabView&, Ui&, const VehicleView&, std::string_view id, std::string_view how);

void start_row(const LabView&, PanelState&, Ui&);  // the seed, and buttons that reset the run; in values_card.cpp
void follow_map(const LabView&, PanelState&);      // call once a frame, before the cards; map_card.cpp

// Bars and menus.
void toolbar(const LabView&, PanelState&, Ui&, Rect);
void timeline(const LabView&, PanelState&, Ui&, Rect);
void hint_bar(const LabView&, Ui&, Rect, std::string_view hint);  // `hint`: key of a prompt's words, or empty
// In the upper left corner of the area: all tools, or for a finger on an upright page the chosen one, anchor `tools`,
// which opens the row of all until one is chosen.
void tool_palette(const LabView&, PanelState&, Ui&, Rect area);
// A small window that is higher than wide, as of a telephone or a tablet. `width`, `height`: layout pixels.
inline bool is_upright(float width, float height) { return width < 900 && height > 1.2f * width; }

// The height of its rows in an area of this width, and the size of a tool for the mouse; layout pixels. `finger`: see
// Ui.
float tool_palette_height(float width, float finger);
inline constexpr float tool_size = 32, tool_pad = 4;
// Where it is drawn; width 0 where it is not.
Rect place_of_tool_palette(const LabView&, const PanelState&, const Ui&, Rect area);
void scene_menu(const LabView&, PanelState&, Ui&, Rect window);  // menu of an object or of the floor

// menu_bar.cpp: the menu bar. A chosen action is added to PanelState::chosen.
void menu_bar(PanelState&, Ui&, Rect bar);                              // the titles
void lab_menu(const LabView&, PanelState&, Ui&, Rect bar, Rect above);  // the open menu
std::string_view menu_title_at(const Ui&, float x, float y);            // name of its menu, or empty; window pixels
void toggle_menu(MenuBarState&, std::string_view menu);                 // opens it, or closes it if it is open
void switch_menu(MenuBarState&, int step);  // opens the menu `step` titles to the right of the open one, or the first

// Opens the lecture that was left at the page where it was left. Precondition: DocumentsView::left_pages.
OpenRequest back_to_page(const LabView&);

// lecture.cpp: shown during a lecture in place of toolbar and hint bar.
void lecture_bar(const LabView&, PanelState&, Ui&, Rect);
void live_brain(const LabView&, PanelState&, Ui&, const VehicleView&, Rect);  // eyes, wires and wheels, live_brain.cpp
void title_page(const LabView&, Ui&, Rect window);                            // ProgramView::title_page
void lecture_figures(const LabView&, PanelState&, Ui&, Rect bar);
bool shows_lecture_figures(const LabView&);                        // false: that bar is empty
void blank_window(const LabView&, PanelState&, Ui&, Rect window);  // black, while LectureState::blank
void follow_lecture(const LabView&, PanelState&);  // saves and restores the cards; call once a frame, before them

// lecture_page.cpp: the parts of a page of a lecture file. Precondition: view.pages.
void lecture_caption(const LabView&, Ui&, Rect);
void lecture_question(const LabView&, PanelState&, Ui&, Rect);
void lecture_notes(const LabView&, PanelState&, Ui&, Rect);

// Sheets over the whole window; sheets.h says when they are drawn.
#define SHEET(id, function, ...) void function(const LabView&, PanelState&, Ui&, Rect window);
#define FOLLOWED_SHEET(id, function, follow, ...)                 \
    void function(const LabView&, PanelState&, Ui&, Rect window); \
    void follow(const LabView&, PanelState&, Ui&);
#include "ui/panels/sheet_table.def"

// unsaved_sheets.cpp
// "today at 14:05" for the time `when`, "2026-03-01 14:05:12", on the day `today`, "2026-03-01".
std::string time_words(const Ui&, const std::string& when, const std::string& today);

// Parts of the brain card. Precondition of all: the vehicle is in the snapshot.
void dial_sliders(const LabView&, PanelState&, Ui&, const VehicleView&);

// True in the lowest windows, in which the rows of the brain are close to each other.
bool has_close_rows(const LabView&, const Ui&);

// Whether the card of the brain has its buttons. In a lecture only after a click on the button in its heading, so that
// the audience sees weights and sums.
inline bool shows_controls(const LabView& view, const PanelState& state) {
    return !view.lecture || state.lecture.controls;
}
// Anchors of the sliders that the keys 1 to 6 focus: LL, LR, RL, RR, LM and RM, or those that the exercise offers, from
// top to bottom. In dial_sliders.cpp.
std::vector<std::string_view> numbered_sliders(const LabView&);
// Which of them has this anchor, which may be that of any dial of a slider of several; their count: none.
std::size_t number_of_slider(const LabView&, std::string_view anchor);
std::string_view anchor_of(Dial);    // of its slider, in dial_sliders.cpp
std::string words_of(const Offer&);  // of its slider: "LL = RR"
// A hint of the bar with what fills its gaps, and keys in brackets. In hint_bar.cpp.
std::string words_of_hint(const LabView&, const Ui&, std::string_view hint);
// The sums of both motors.
void equations(const LabView&, Ui&, const VehicleView&);
// The cause of a turn, with the buttons of further explanations; `column` is the height that the card has at most.
void cause_in_words(const LabView&, Ui&, const VehicleView&, float bottom, bool has_buttons);
// True if the vehicle does not move. Not known in the first half second.
bool stands_still(const LabView&, const VehicleView&);
// The key of the sentence about two wheels that turn alike, at this command; `stuck`: the vehicle does not move.
std::string_view alike_key(float wheels, bool stuck);
// True if these wheel commands move a vehicle, forwards or backwards, unless something is in the way.
bool wheels_push(float left, float right);
// True if it does not move although its wheels push. Not known in the first half second, and after an edit in a pause.
bool is_stuck(const LabView&, const VehicleView&);
void presets_menu(const LabView&, PanelState&, Ui&, const VehicleView&, bool wanted, ImVec2 corner);
void brain_picture(const LabView&, PanelState&, Ui&, const VehicleView&, float layout_height);
// The height of the picture whose height for a pair of sensors is `of_pair`: the whole brain needs more. Layout pixels.
float brain_picture_height(const LabView&, const VehicleView&, float of_pair);

// FeatureViews::why beside the vehicle, over the scene and below the cards, within `area`. Anchor: why.
void why_callout(const LabView&, const Ui&, Rect area);

// Lesions outside the brain picture: sets state.brain.lesion_under_pointer to the sensor or motor under the pointer in
// the scene, or to the wire of the slider under the pointer, and executes state.brain.lesion_requested. Call after the
// cards.
void lesions(const LabView&, PanelState&, Ui&);

// The last seconds of the nodes with a probe, over the canvas in `area`. Anchors: probe.NAME. Call it after the canvas.
void draw_probes(const LabView&, const PanelState&, const Ui&, Rect area);

// BrainState::what_if for the wire under the pointer on the selected vehicle's deck or on the canvas: cut, or
// healed. In the wiring editor words in the scene's inset say so (anchor what_if). Notes are within `area`, the scene.
// Call it after what else sets what_if.
void try_without_wire(const LabView&, PanelState&, const Ui&, Rect area);

// Sign and colour of a notice; readable on the panel colour. In hint_bar.cpp.
std::string_view sign_of(NoticeKind);
Colour colour_of(NoticeKind, const Palette&);

// True if keys have brought the focus to a slider of the brain. In hint_bar.cpp.
bool has_slider_focus(const Keyboard&);

// brain_card.cpp: "Predator", "Lamp seeker": the kind's name in the language of the strings, or as its file has it.
std::string kind_name(const Ui&, const Kind&);

// children_sheet.cpp: the generation, and the button that opens the sheet of children; nothing in an exercise without
// selection by hand. Precondition: an exercise is open.
void generation_of_selection(const LabView&, Ui&);
void selection_button(const LabView&, PanelState&, Ui&);

// sensor_card.cpp: "Obstacles left" for a sensor with letters as its name, else its name.
std::string sensor_label(const Ui&, const std::vector<Sensor>& all, const Sensor&);

// The name of the vehicle's kind; "Vehicle" if the scene has one kind only, because its name could reveal the
// behaviour.
std::string kind_name(const LabView&, const Ui&, const VehicleView&);

}  // namespace braitenlab::ui
