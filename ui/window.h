// One frame of the whole window: toolbar, cards, hint bar, sheets and, in Mode::wiring, the wiring canvas.
#pragma once

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"
#include "ui/window_layout.h"

namespace braitenlab::ui {

// Call between ImGui::NewFrame() and ImGui::Render(). Records anchors, fills ui.outbox, changes the PanelState, and
// sets ui.keyboard and ui.still.
void draw_window(const LabView&, PanelState&, Ui&, const WindowLayout&);

// The open cards that lay_out() makes room for.
OpenCards open_cards(const LabView&, const PanelState&);

// True while the user drags the vehicle, one of its sliders or its stick. Precondition: it is the selected one.
bool drags_vehicle(const PanelState&, VehicleId);

// What the open text field takes. Precondition: one is open.
TextKind awaited_text(const PanelState&);

}  // namespace braitenlab::ui
