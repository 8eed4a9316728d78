// What is remembered between two starts: how the scene is shown, which cards are folded, what the person
// knows, what may change in a breeding.
#pragma once

#include <vector>

#include "app/files/settings.h"
#include "app/lab.h"
#include "ui/panels/panel_state.h"

namespace braitenlab {

// Call at the start, after a document was opened. A camera that rides with a vehicle needs a selected vehicle; without
// one the camera stays as it is.
void restore_view(Lab&, ui::PanelState&, const StoredView&);

// The switches of the view that are off, of those that are on at the first start: a person may miss what they show.
std::vector<Action> switched_off(const ViewSettings&);

// In a lecture, the values from before it.
StoredView view_to_store(const Lab&, const ui::PanelState&);

}  // namespace braitenlab
