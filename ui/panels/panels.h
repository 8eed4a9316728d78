// The panels, each a free function: it reads the view, keeps its own folds and drags in PanelState, and puts what the
// person wants into ui.outbox. ui/window.cpp calls them.
#pragma once

#include <string>

#include <imgui.h>

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"
#include "ui/window_layout.h"

namespace braitenlab {

void toolbar(const LabView&, PanelState&, Ui&, Rect);
void exercise_card(const LabView&, PanelState&, Ui&, Rect);  // precondition: view.lesson
void scene_card(const LabView&, PanelState&, Ui&, Rect);
void brain_card(const LabView&, PanelState&, Ui&, Rect, Rect column);  // `column`: all that it shares with others
void information_card(const LabView&, PanelState&, Ui&, Rect);
void strips(const LabView&, const History&, Ui&);  // the selected vehicle's last seconds, and the population's
void sensor_card(const LabView&, PanelState&, Ui&, Rect);
void chart_card(const LabView&, PanelState&, Ui&, Rect);          // while PanelState::charts_open; its fold closes it
void object_card(const LabView&, PanelState&, Ui&, Rect);          // precondition: view.settings.selection.object
void tool_palette(const LabView&, PanelState&, Ui&, Rect scene);  // the hand, and what draws into the scene
void scene_menu(const LabView&, PanelState&, Ui&, Rect window);   // of a thing or of the floor; closes itself
void timeline(const LabView&, PanelState&, Ui&, Rect);
void hint_bar(const LabView&, Ui&, Rect, std::string_view hint);  // `hint`: key of a prompt's words, or empty
void point_to_lamp(const LabView&, Ui&);                          // while it is what Ui::highlight names

void view_menu(const LabView&, PanelState&, Ui&, const WindowLayout&);  // the same for what the scene shows
bool for_view_menu(const LabView&, PanelState&, KeyPress);

// While the view is in a lecture: instead of the toolbar, instead of the hint bar, and what they fold away.
void lecture_bar(const LabView&, Ui&, Rect);
void lecture_figures(const LabView&, PanelState&, Ui&, const WindowLayout&);
void follow_lecture(const LabView&, PanelState&);  // call once a frame, before the cards

// Sheets over everything; each draws itself while PanelState::sheet says so, and closes itself.
void keys_card(const LabView&, PanelState&, Ui&, Rect window);       // all shortcuts
void recovery_sheet(const LabView&, PanelState&, Ui&, Rect window);  // after a crash, while the view offers something
void leaving_sheet(const LabView&, PanelState&, Ui&, Rect window);   // while the view asks about unsaved edits
void files_sheet(const LabView&, PanelState&, Ui&, Rect window);     // opening and saving
void settings_card(const LabView&, PanelState&, Ui&, Rect window);   // language, theme, size of type, motion

// The parts of the brain card. Precondition of all: the vehicle is in the snapshot.
void dial_sliders(const LabView&, PanelState&, Ui&, const VehicleView&);
void equations(const LabView&, Ui&, const VehicleView&);
void driver_panel(PanelState&, Ui&, const VehicleView&);  // instead of the equations: who drives it
void presets_menu(const LabView&, PanelState&, Ui&, const VehicleView&, bool wanted, ImVec2 corner);
void brain_picture(const LabView&, PanelState&, Ui&, const VehicleView&, float layout_height);

// "Predator", "Lamp seeker": the kind's name in the language of the strings, or as its author wrote it.
std::string kind_name(const Ui&, const Kind&);

// The same of a vehicle, but a plain "Vehicle" where there is one kind alone: its name then says nothing, or gives an
// exercise's answer away.
std::string kind_name(const LabView&, const Ui&, const VehicleView&);

}  // namespace braitenlab
