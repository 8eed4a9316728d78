// The values of one kind on the card of the arena and the kinds, and the rows that its parts share.
#pragma once

#include <optional>
#include <string>

#include "ui/widgets/record_fields.h"

namespace braitenlab {
struct LabView;
}

namespace braitenlab::ui {

struct PanelState;

FieldRows rows_for(const LabView&, PanelState&, Ui&);

// The body colours side by side, none first. The colour that was pressed, unless it is the present one.
std::optional<std::string> colour_row(const FieldRows&, const std::string& anchor, const std::string& now, Role);

// Draws the values at the cursor and requests their edits. `kind`: index in Scene::kinds.
void kind_editor(const LabView&, PanelState&, Ui&, int kind);

}  // namespace braitenlab::ui
