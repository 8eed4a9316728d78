// The whole window, once a frame: toolbar, cards, hint bar and, in Mode::wiring, the wiring canvas.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"
#include "ui/window_layout.h"

namespace braitenlab {

// Call between ImGui::NewFrame() and ImGui::Render(). Records anchors and fills ui.outbox; changes nothing else but the
// panels' own state. Sets ui.keyboard and ui.still.
void draw_window(const LabView&, PanelState&, Ui&, const WindowLayout&);

// What a key does, in the window's order: text being typed, the focused widget, the wiring canvas, then the shortcuts.
// Call for every press and repeat (GLFW's, in order), never for releases. False when the key means nothing here: arrows
// are then the camera's. Dear ImGui's own keyboard navigation must be off (no ImGuiConfigFlags_NavEnableKeyboard).
bool press_key(const LabView&, PanelState&, KeyPress, Outbox&);

}  // namespace braitenlab
