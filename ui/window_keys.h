// Keys and chosen actions of the whole window: which panel, sheet or shortcut they are for.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"

namespace braitenlab::ui {

// Executes a key. Order: text being typed, the open sheet or menu, the focused widget, the wiring canvas, shortcuts.
// Call for every press and repeat in GLFW's order, not for releases. False when the key has no meaning here: arrow keys
// then move the camera. Precondition: Dear ImGui's keyboard navigation is off (no ImGuiConfigFlags_NavEnableKeyboard).
bool press_key(const LabView&, PanelState&, KeyPress, Outbox&);

// Passes the keys of the rows on, once the menu that they are for has been drawn. Call before begin_keyboard().
void pass_keys_to_rows(PanelState&);

// Executes the actions that were chosen with the pointer or in a menu since the last frame.
// The keyboard focus returns from the rows of a menu first: an action may move it.
void execute_chosen(const LabView&, PanelState&, Outbox&);

}  // namespace braitenlab::ui
