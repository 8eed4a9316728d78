// Signals on their way to the chart card: dragged there, or sent by the menu of a node of the diagram.
#pragma once

#include <string_view>

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Begins the drag of the signal `name`, and follows it, while the part that shows it is `held` by the mouse.
void drag_signal(PanelState&, const Ui&, bool held, std::string_view name);

// Esc: the signal that is dragged is dropped nowhere. False if none is dragged.
bool give_up_drag(PanelState&);

// Nodes of the diagram that are dropped on the chart card stay where they were and are shown there. Call it before the
// canvas. `card`: of the charts; empty while it is closed.
void drop_nodes_on_chart(const LabView&, PanelState&, Rect card);

// Puts dropped signals, and those chosen in the menu of a node, on the tab "Chosen"; draws the name at the pointer.
// A drag that began on the card itself ends on the tab or, of a chosen strip, on another one, whose place it takes; one
// that began elsewhere ends on the card, or on the button that opens it. Call it after canvas and cards.
void drop_signals(const LabView&, PanelState&, Ui&, Rect card);

}  // namespace braitenlab::ui
