// The button on the card of an exercise that is solved by breeding.
#include <string>

#include "ui/panels/breeding/breeding_parts.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Opens the breeding that the exercise offers, unless another one has begun.
void open_offered(const LabView& view, std::string_view offered, Ui& ui) {
    const BreedingView& bred = view.features.breeding;
    const bool has_begun = bred.base && (bred.runs || last_generation(bred) >= 0);
    if (!has_begun) ui.outbox.emplace_back(BreedingRequest{.edit = BreedingEdit::open, .path = std::string(offered)});
}

}  // namespace

void breeding_button(const LabView& view, PanelState& state, Ui& ui) {
    const std::string_view offered = offered_breeding(*view.lesson->exercise);
    if (offered.empty() || view.mode == Mode::wiring) return;
    const Item at = button(ui, "exercise.breeding", {{}, ui.strings("action.breeding")});
    tooltip(ui, at, ui.strings("exercise.breeding_how"));
    if (view.features.breeding.runs) {
        const float x = at.right() + ui.px(spacing::small), room = at.rect.x + card_width(ui) - x;
        const std::string words = shortened(ui, breeding_percent(view.features.breeding, ui), Face::small, room);
        put(ui, {x, at.middle_y() - line_height(ui, Face::small) / 2}, words, ui.palette.second_text, Face::small);
    }
    if (!at.pressed) return;
    open_offered(view, offered, ui);
    state.chosen.push_back(Action::breeding);  // at the end of the frame: the sheet then finds it open
}

}  // namespace braitenlab::ui
