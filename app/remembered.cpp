#include "app/remembered.h"

#include <algorithm>
#include <utility>

#include "app/lab_selection.h"
#include "ui/panels/cards.h"

namespace braitenlab {

void restore_view(Lab& lab, ui::PanelState& panels, const StoredView& stored) {
    ViewSettings view = stored.settings;
    view.camera = lab.view.camera, view.selection = lab.view.selection;
    view.selection.whole_kind = stored.settings.selection.whole_kind;
    const CameraMode mode = stored.settings.camera.mode;
    if (!rides(mode) || selected_vehicle(lab)) view.camera.mode = mode;
    lab.view = std::move(view);
    panels.prompts.followed = stored.followed;
    panels.charts.strips = stored.strips;
    panels.sheets.breeding.may = stored.may_change;
    if (!stored.folded) return;
    for (const ui::CardTraits& row : ui::cards())
        panels.card(row.card).folded =
            std::find(stored.folded->begin(), stored.folded->end(), row.anchor) != stored.folded->end();
}

std::vector<Action> switched_off(const ViewSettings& view) {
    const ViewSettings usual;
    std::vector<Action> off;
#define LAB_ACTION(id, ...)
#define UI_ACTION(id, ...)
#define VIEW_SWITCH(id, keys, flag, ...) \
    if (usual.flag && !view.flag) off.push_back(Action::id);
#include "ui/actions.def"
    return off;
}

StoredView view_to_store(const Lab& lab, const ui::PanelState& panels) {
    const ViewSettings& shown = lab.before_lecture ? lab.before_lecture->view : lab.view;
    StoredView stored{.settings = for_another_scene(shown)};
    stored.settings.camera.mode = shown.camera.mode;
    stored.settings.selection.whole_kind = lab.view.selection.whole_kind;
    stored.followed = panels.prompts.followed;
    stored.strips = panels.charts.strips;
    stored.may_change = panels.sheets.breeding.may;
    stored.folded.emplace();
    for (const ui::CardTraits& row : ui::cards()) {
        const auto index = static_cast<std::size_t>(row.card);
        const bool is_folded = row.card == ui::Card::inspector ? panels.canvas.inspector.folded
                               : panels.lecture.before         ? panels.lecture.before->cards[index].folded
                                                               : panels.cards[index].folded;
        if (is_folded) stored.folded->emplace_back(row.anchor);
    }
    return stored;
}

}  // namespace braitenlab
