// The button on the card of an exercise that is solved by breeding, and how far the breeding is.
#include <algorithm>
#include <cmath>
#include <string>

#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompts.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

// Opens the breeding that the exercise offers, unless another one has begun.
void open_offered(const LabView& view, std::string_view offered, Ui& ui) {
    const BreedingView& bred = view.features.breeding;
    const bool has_begun = bred.base && (bred.runs || last_generation(bred) >= 0);
    if (!has_begun) ui.outbox.emplace_back(BreedingRequest{.edit = BreedingEdit::open, .path = std::string(offered)});
}

}  // namespace

std::string breeding_progress(const BreedingView& bred, const Ui& ui) {
    if (!bred.base) return {};
    const evolve::Breeding& breeding = bred.base->breeding();
    const int of_panel = breeding.panel > 0 ? breeding.panel_generations + 1 : 0;
    const auto panel = static_cast<int>(bred.state->panel.generations.front().size());
    const int done = std::min(panel, of_panel) + last_generation(bred) + 1, all = of_panel + breeding.generations + 1;
    const float share = std::clamp((static_cast<float>(done) + bred.progress) / static_cast<float>(all), 0.0f, 1.0f);
    std::string words = fill(ui.strings("lecture.percent"), {std::to_string(std::lround(100 * share))});
    if (!bred.seconds_left) return words;
    const int seconds = std::max(5, static_cast<int>(std::ceil(*bred.seconds_left / 5)) * 5);  // it does not flicker
    const bool minutes = seconds >= 120;
    return words + ", " +
           fill(ui.strings(minutes ? "breeding.minutes_left" : "breeding.seconds_left"),
                {std::to_string(minutes ? (seconds + 59) / 60 : seconds)});
}

void breeding_button(const LabView& view, PanelState& state, Ui& ui) {
    const std::string_view offered = offered_breeding(*view.lesson->exercise);
    if (offered.empty() || view.mode == Mode::wiring) return;
    const Item at = button(ui, "exercise.breeding", {{}, ui.strings("action.breeding")});
    tooltip(ui, at, ui.strings("exercise.breeding_how"));
    if (view.features.breeding.runs) {
        const float x = at.right() + ui.px(spacing::small), room = at.rect.x + card_width(ui) - x;
        const std::string words = shortened(ui, breeding_progress(view.features.breeding, ui), Face::small, room);
        put(ui, {x, at.middle_y() - line_height(ui, Face::small) / 2}, words, ui.palette.second_text, Face::small);
    }
    if (!at.pressed) return;
    open_offered(view, offered, ui);
    state.chosen.push_back(Action::breeding);  // at the end of the frame: the sheet then finds it open
}

}  // namespace braitenlab::ui
