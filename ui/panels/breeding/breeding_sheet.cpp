// The sheet of the breeding: what is bred, which can be folded, the scores by generation, the matrix of the champions,
// two matches to watch, and what the matrix shows in words. In an exercise that is solved by breeding it has the step
// that is next, the opponents, the matrix and the matches; "More" unfolds the rest.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <imgui.h>

#include "core/evolve/champions.h"
#include "ui/panels/breeding/breeding_parts.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using evolve::Breeding;

// Layout pixels, of the curves, the matrix and the matches.
constexpr float column_gap_of_breeding = spacing::wide, least_height = 280, most_height = 460;
// On a narrower sheet the figures, or the numbers, are below each other.
constexpr float least_of_figures = 600, least_of_numbers = 720;
constexpr float title_inset = 24;  // of the words of a row that folds

void choose(const Breeding& choice, Ui& ui) {
    ui.outbox.emplace_back(
        BreedingRequest{.edit = BreedingEdit::choose, .choice = std::make_shared<const Breeding>(choice)});
}

void shipped_choice(const BreedingView& view, Ui& ui, float right) {
    for (const Breeding& each : *view.shipped) {
        const bool on = view.base && view.base->breeding().title == each.title;  // also read from a folder of results
        const std::string id = "breeding.open." + each.id;
        const SmallButton which{id, {}, translated(ui, each.title), on};
        if (&each != &view.shipped->front()) beside_or_below(ui, small_button_width(ui, which, true), right);
        if (small_button(ui, which).pressed && !on)
            ui.outbox.emplace_back(BreedingRequest{.edit = BreedingEdit::open, .path = each.id});
    }
}

// Title of the breeding of the open scene.
std::string title_of_open(const LabView& lab, const Ui& ui) {
    const std::string& title = lab.now->scene->title;
    return std::string(title.empty() ? ui.strings("breeding.open_scene") : translated(ui, title));
}

void breed_scene(const LabView& lab, const evolve::MayChange& may, Ui& ui) {
    ui.outbox.emplace_back(BreedingRequest{.edit = BreedingEdit::scene,
                                           .title = title_of_open(lab, ui),
                                           .may = std::make_shared<const evolve::MayChange>(may)});
}

// The open scene, and what may change in it once it is chosen.
void scene_choice(const LabView& lab, evolve::MayChange& may, Ui& ui, float right) {
    const BreedingView& view = lab.features.breeding;
    const bool on =
        view.base && view.base->breeding().from_scene && view.base->breeding().title == title_of_open(lab, ui);
    const SmallButton scene{"breeding.open_scene", {}, ui.strings("breeding.open_scene"), on};
    if (view.shipped && !view.shipped->empty()) beside_or_below(ui, small_button_width(ui, scene, true), right);
    const Item open = small_button(ui, scene);
    tooltip(ui, open, ui.strings("breeding.open_scene_how"));
    if (open.pressed) breed_scene(lab, may, ui);
    if (!on) return;
    struct Part {
        const char* id;
        bool evolve::MayChange::*part;
    };
    constexpr Part parts[]{{"breeding.may_weights", &evolve::MayChange::weights},
                           {"breeding.may_biases", &evolve::MayChange::biases},
                           {"breeding.may_thresholds", &evolve::MayChange::thresholds},
                           {"breeding.may_eyes", &evolve::MayChange::eyes}};
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string_view words = ui.strings("breeding.may");
    const float height = ui.px(ui.tall(small_button_height)), width = text_width(ui, Face::small, words);
    put(ui, {at.x, at.y + (height - line_height(ui, Face::small)) / 2}, words, ui.palette.second_text, Face::small);
    ImGui::Dummy({width, height});
    for (const Part& each : parts) {
        const SmallButton which{each.id, {}, ui.strings(each.id), may.*each.part};
        beside_or_below(ui, small_button_width(ui, which, true), right);
        const Item item = small_button(ui, which);
        tooltip(ui, item, ui.strings("breeding.may_how"));
        if (item.pressed) may.*each.part = !(may.*each.part), breed_scene(lab, may, ui);
    }
}

std::string_view how_of(evolve::Opponents which, const Ui& ui) {
    return ui.strings("breeding.opponents_" + std::string(row_of(which).word) + "_how");
}

// Those between which the steps of an exercise lead: those of its breeding, those that pulse, and the present ones.
bool is_of_steps(evolve::Opponents which, const Breeding& now) {
    return which == evolve::Opponents::best_of_last || which == evolve::Opponents::random || which == now.opponents;
}

// What is bred against. `all`: every row of the table is a choice.
void opponents_choice(const Breeding& now, Ui& ui, float right, bool all) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string_view words = ui.strings("breeding.opponents");
    const float height = ui.px(ui.tall(small_button_height)), width = text_width(ui, Face::small, words);
    put(ui, {at.x, at.y + (height - line_height(ui, Face::small)) / 2}, words, ui.palette.second_text, Face::small);
    ImGui::Dummy({width, height});
    for (const evolve::OpponentsTraits& row : evolve::opponents_table) {
        if (!all && !is_of_steps(row.value, now)) continue;
        const std::string stem = "breeding.opponents_" + std::string(row.word),
                          id = "breeding.against." + std::string(row.word);
        const SmallButton which{id, {}, ui.strings(stem), row.value == now.opponents};
        beside_or_below(ui, small_button_width(ui, which, true), right);
        const Item item = small_button(ui, which);
        tooltip(ui, item, how_of(row.value, ui));
        if (!item.pressed || row.value == now.opponents) continue;
        Breeding choice = now;
        choice.opponents = row.value;
        choose(choice, ui);
    }
}

// What the chosen opponents are, in the lines of the longest explanation: another choice moves nothing.
void words_of_opponents(const Breeding& now, Ui& ui, bool all) {
    std::size_t lines = 1;
    for (const evolve::OpponentsTraits& row : evolve::opponents_table)
        if (all || is_of_steps(row.value, now))
            lines = std::max(lines, lines_of_words(ui, how_of(row.value, ui), Face::small, card_width(ui)).size());
    paragraph_of_lines(ui, how_of(now.opponents, ui), lines);
}

// Three numbers side by side; below each other on a narrow sheet.
void numbers_of_breeding(const LabView& lab, const Breeding& now, SliderState& sliders, Ui& ui) {
    struct Number {
        const char* id;
        float low, high;
    };
    const Number numbers[]{{"generations", 5, 200}, {"population", 6, 60}, {"seed", 1, 20}};
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float all = card_width(ui), space = ui.px(column_gap_of_breeding);
    const bool is_wide = all >= ui.px(least_of_numbers);
    const float width = is_wide ? (all - 2 * space) / 3 : all;
    Breeding choice = now;
    for (std::size_t i = 0; i < std::size(numbers); ++i) {
        const Number& number = numbers[i];
        const std::string id = "breeding." + std::string(number.id);
        const auto step = static_cast<float>(i);
        ImGui::SetCursorScreenPos(is_wide ? ImVec2{at.x + step * (width + space), at.y}
                                          : ImVec2{at.x, at.y + step * ui.px(ui.tall(slider_height))});
        const std::string_view words = ui.strings(id);
        SliderLook look{.words = words,
                        .tooltip = ui.strings(id + "_how"),
                        .low = number.low,
                        .high = number.high,
                        .home = number.low,
                        .step = 1,
                        .mouse = 1,
                        .nudge = 1,
                        .decimals = 0,
                        .whole = true,
                        .signed_number = false,
                        .meaning = false,
                        .words_width = text_width(ui, Face::text, words) / ui.px(1) + 12};
        const float known = i == 0   ? static_cast<float>(now.generations)
                            : i == 1 ? static_cast<float>(now.population)
                                     : static_cast<float>(now.seed);
        // Each choice begins a breeding, so a dragged number is one when the mouse is released.
        const bool was_dragged = sliders.dragged == id;
        const auto edit = slider(ui, sliders, id, was_dragged ? sliders.asked : known, width, lab.wall_seconds, look);
        if (sliders.dragged == id || (!edit && !was_dragged)) continue;
        const float asked = edit ? edit->value : sliders.asked;
        const int wanted = std::max(1, static_cast<int>(std::lround(asked)));
        if (i == 0) choice.generations = wanted;
        if (i == 1) choice.population = std::max(wanted, now.parents);
        if (i == 2) choice.seed = static_cast<std::uint64_t>(wanted);
    }
    ImGui::SetCursorScreenPos({at.x, at.y + (is_wide ? 1 : 3) * ui.px(ui.tall(slider_height)) + ui.px(spacing::tight)});
    ImGui::Dummy({1, 1});
    if (choice.generations != now.generations || choice.population != now.population || choice.seed != now.seed)
        choose(choice, ui);
}

// "Chase · Opponents: anyone".
std::string words_of_choice(const Breeding& breeding, const Ui& ui) {
    const std::string opponents =
        " · " + std::string(ui.strings("breeding.opponents")) + ": " +
        std::string(ui.strings("breeding.opponents_" + std::string(row_of(breeding.opponents).word)));
    const float room = card_width(ui) - ui.px(title_inset) - text_width(ui, Face::text, opponents);
    return shortened(ui, translated(ui, breeding.title), Face::text, room) + opponents;
}

// Whether the choices are unfolded, at first unless `leads`: kept by Dear ImGui with the body of the sheet, as that of
// a tree node. Create it in the body.
class OpenChoices {
public:
    explicit OpenChoices(bool leads) : leads_(leads), id_(ImGui::GetID(leads ? "more choices" : "choices")) {}

    bool are_open() const { return kept_.GetBool(id_, !leads_); }

    // The row with the title, which folds and unfolds them. True if they are unfolded.
    bool row(const Breeding& breeding, Ui& ui) {
        bool open = are_open();
        const std::string how =
            std::string(ui.strings("breeding.choices_how")) + "\n" + std::string(how_of(breeding.opponents, ui));
        if (!open && ui.highlight.starts_with("breeding.against.")) ui.highlight = "breeding.choices";
        fold_row(ui, "breeding.choices", words_of_choice(breeding, ui), open, how);
        kept_.SetBool(id_, open);
        return open;
    }
    // In an exercise: the opponents, and a button beside them that unfolds the rest. True if it is unfolded.
    bool row_of_steps(const Breeding& breeding, Ui& ui, float right) {
        bool open = are_open();
        opponents_choice(breeding, ui, right, open);
        const SmallButton more{"breeding.choices", open ? icon::unfolded : icon::folded, ui.strings("breeding.more"),
                               open};
        beside_or_below(ui, small_button_width(ui, more, true), right);
        if (small_push_button(ui, more, ui.strings("breeding.more_how"))) open = !open;
        kept_.SetBool(id_, open);
        words_of_opponents(breeding, ui, open);
        return open;
    }
    void fold() { kept_.SetBool(id_, false); }
    // Height of all rows above the figures while they are unfolded; window pixels.
    float& height_unfolded() { return *kept_.GetFloatRef(id_ + 1); }

private:
    ImGuiStorage& kept_ = *ImGui::GetStateStorage();
    bool leads_;
    ImGuiID id_;
};

// What is bred and how. `leads`: the opponents are above.
void choices_of_breeding(const LabView& lab, PanelState& state, Ui& ui, bool leads) {
    const BreedingView& view = lab.features.breeding;
    const float right = ImGui::GetCursorScreenPos().x + card_width(ui);
    if (view.shipped) shipped_choice(view, ui, right);
    scene_choice(lab, state.sheets.breeding.may, ui, right);
    if (!view.base) return;
    const Breeding& breeding = view.base->breeding();
    if (!breeding.story.empty()) paragraph(ui, translated(ui, breeding.story), ui.palette.text);
    if (!leads) opponents_choice(breeding, ui, right, true), words_of_opponents(breeding, ui, true);
    numbers_of_breeding(lab, breeding, state.sliders, ui);
}

// Curves, if they are shown, matrix and matches side by side; below each other on a narrow sheet.
void figures_of_breeding(const LabView& lab, PanelState& state, Ui& ui, float height, bool has_curves) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float all = card_width(ui), space = ui.px(column_gap_of_breeding);
    const bool is_wide = all >= ui.px(least_of_figures);
    const float most = has_curves ? 0.38f * all : 0.5f * all;
    const float matrix = is_wide ? std::min(most, breeding_matrix_width(ui, height)) : all;
    const float curves = !is_wide ? all : has_curves ? (all - matrix - 2 * space) * 0.48f : 0;
    const float x = is_wide && has_curves ? curves + space : 0, down = is_wide ? 0 : height + space;
    const float duels = is_wide ? all - matrix - x - space : all;
    const float first = has_curves ? down : 0;
    if (has_curves) breeding_curves(lab.features.breeding, ui, {at.x, at.y, curves, height});
    breeding_matrix(lab.features.breeding, ui, {at.x + x, at.y + first, matrix, height});
    const Rect place{is_wide ? at.x + x + matrix + space : at.x, at.y + first + down, duels, height};
    breeding_duels(lab, state.sheets.breeding, ui, place);
    ImGui::SetCursorScreenPos({at.x, at.y});
    ImGui::Dummy({all, first + down + height});
}

// "Take predator 30 and prey 12": the champions that a press takes. Their numbers come with the first generation.
std::string words_of_taking(const LabView& lab, const std::string& predator, const std::string& prey, const Ui& ui) {
    const auto kinds = evolve::kinds_for_champions(*lab.features.breeding.base, *lab.now->scene, lab.lesson != nullptr);
    if (kinds && at(*kinds, evolve::Side::prey) < 0) return fill(ui.strings("breeding.take_predator"), {predator});
    if (kinds && at(*kinds, evolve::Side::predator) < 0) return fill(ui.strings("breeding.take_prey"), {prey});
    return fill(ui.strings("breeding.take"), {predator, prey});
}

bool match_button(const LabView& lab, BreedingEdit edit, const char* id, Ui& ui) {
    const BreedingView& view = lab.features.breeding;
    const bool takes = edit == BreedingEdit::take;
    const bool has_match = !view.watched.empty() && !view.watches_panel;
    const BreedingCell cell = takes || !has_match ? chosen_cell(view) : view.watched.front();
    const bool has_champions = cell.predator >= 0;
    const auto number = [&](int generation) { return has_champions ? std::to_string(generation) : std::string("…"); };
    const std::string predator = number(cell.predator), prey = number(cell.prey);
    const std::string words = takes ? words_of_taking(lab, predator, prey, ui) : std::string(ui.strings(id));
    ButtonLook look{takes ? icon::load : icon::open, words};
    look.enabled = has_champions;
    if (takes) {  // another match moves no button
        const std::string widest = words_of_taking(lab, "000", "000", ui);
        look.words = widest, look.min_width = button_width(ui, look) / ui.px(1), look.words = words;
    }
    const Item item = button(ui, id, look);
    if (wants_tooltip(ui, item)) {
        tooltip(ui, item,
                look.enabled ? fill(ui.strings(takes ? "breeding.take_how" : "breeding.match_how"), {predator, prey})
                             : std::string(ui.strings("breeding.no_champion")));
    }
    ImGui::SameLine();
    if (!item.pressed || !look.enabled) return false;
    BreedingRequest request{.edit = edit, .cell = cell};
    request.title =
        fill(ui.strings("breeding.match_title"), {translated(ui, view.base->breeding().title), predator, prey});
    request.story = ui.strings("breeding.match_story");
    ui.outbox.emplace_back(std::move(request));
    return true;
}

// True if the sheet closes. In a low window Start folds the choices, so that what is bred is seen. `has_match`: the
// watched match can be opened.
bool breeding_buttons(const LabView& lab, OpenChoices& choices, bool folds, bool has_match, Ui& ui) {
    const BreedingView& view = lab.features.breeding;
    const bool is_complete = view.base && last_generation(view) >= view.base->breeding().generations &&
                             std::none_of(view.matrix->scores.begin(), view.matrix->scores.end(),
                                          [](float score) { return std::isnan(score); });
    ButtonLook first{icon::pause, ui.strings("breeding.stop"), Emphasis::primary};
    first.min_width =
        least_width_for(ui, first, {"breeding.start", "breeding.go_on", "breeding.stop", "breeding.complete"});
    if (view.base && view.runs) {
        const Item stop = button(ui, "breeding.stop", first);
        tooltip(ui, stop, ui.strings("breeding.stop_how"));
        if (stop.pressed) ui.outbox.emplace_back(BreedingRequest{.edit = BreedingEdit::stop});
        ImGui::SameLine();
    } else if (view.base && !is_complete) {
        const bool has_begun = !view.state->panel.generations.front().empty() || last_generation(view) >= 0;
        first.icon = icon::play, first.words = ui.strings(has_begun ? "breeding.go_on" : "breeding.start");
        const Item start = button(ui, "breeding.start", first);
        tooltip(ui, start, ui.strings("breeding.start_how"));
        if (start.pressed) {
            ui.outbox.emplace_back(BreedingRequest{.edit = BreedingEdit::run});
            if (folds) choices.fold();
        }
        ImGui::SameLine();
    } else if (view.base) {  // keeps the place of Stop
        first.icon = icon::check, first.words = ui.strings("breeding.complete"), first.enabled = false;
        const Item item = button(ui, "breeding.complete", first);
        tooltip(ui, item, ui.strings("breeding.complete_how"));
        ImGui::SameLine();
    }
    bool closes = false;
    if (view.base) {
        if (has_match) closes |= match_button(lab, BreedingEdit::match, "breeding.match", ui);
        closes |= match_button(lab, BreedingEdit::take, "breeding.take", ui);
    }
    const Item close = button(ui, "breeding.close", {{}, ui.strings("keys.close")});
    tooltip(ui, close, ui.strings("keys.close_how"), key_name({key::escape}, ui.strings));
    return closes || close.pressed;
}

// The words of the prompt: the sheet covers the hint bar.
void prompt_on_sheet(const LabView& lab, std::string_view hint, Ui& ui) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    paragraph(ui, words_of_hint(lab, ui, hint), ui.palette.text, Face::small);
    mark(ui, "breeding.hint", {start.x, start.y, card_width(ui), ImGui::GetCursorScreenPos().y - start.y});
}

// The step of the exercise that is next, in as many lines as the longest one: what is below stays in its place. While
// nothing is to be pressed it says how to read the matrix.
void step_on_sheet(const LabView& lab, std::string_view hint, Ui& ui) {
    constexpr std::string_view steps[]{"hint.breed_shipped", "hint.breed_others",  "hint.look_at_ancestor",
                                       "hint.look_at_last",  "hint.take_champion", "hint.take_worse",
                                       "hint.breed_against", "hint.breed_again",   "breeding.while_it_runs"};
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float width = card_width(ui);
    std::size_t lines = 1;
    for (const std::string_view step : steps)
        lines = std::max(lines, lines_of_words(ui, words_of_hint(lab, ui, step), Face::text, width).size());
    const bool is_told = ui.highlight.starts_with("breeding.");
    put_lines(ui, start, words_of_hint(lab, ui, is_told ? hint : "breeding.while_it_runs"), ui.palette.text, Face::text,
              width, lines);
    const float height = static_cast<float>(lines) * line_height(ui, Face::text);
    ImGui::Dummy({1, height});
    mark(ui, "breeding.hint", {start.x, start.y, width, height});
}

}  // namespace

void follow_breeding(const LabView& lab, PanelState& state, Ui&) {
    if (std::exchange(state.sheets.breeding.shown, lab.features.breeding.shown) != lab.features.breeding.shown)
        state.sheet = Sheet::breeding;
}

void breeding_sheet(const LabView& lab, PanelState& state, Ui& ui, Rect window) {
    const BreedingView& view = lab.features.breeding;
    if (!view.base && !view.error && view.shipped && !view.shipped->empty())
        ui.outbox.emplace_back(BreedingRequest{.edit = BreedingEdit::open,
                                               .path = view.last.empty() ? view.shipped->front().id : view.last});
    SheetState& sheet = open_sheet(state, ui, Sheet::breeding, window);
    const float most = window.h - 2 * ui.px(spacing::medium) - (sheet.rect.h - ImGui::GetWindowHeight());
    const float top = ImGui::GetCursorScreenPos().y;
    bool is_low = false;
    const bool leads = is_bred(lab) && view.base;
    OpenChoices choices(leads);
    bool is_open = true;
    if (leads) {
        const float right = ImGui::GetCursorScreenPos().x + card_width(ui);
        step_on_sheet(lab, state.prompts.highlight.hint, ui);
        is_open = choices.row_of_steps(view.base->breeding(), ui, right);
    } else {
        if (ui.highlight.starts_with("breeding.")) prompt_on_sheet(lab, state.prompts.highlight.hint, ui);
        if (view.base) is_open = choices.row(view.base->breeding(), ui);
    }
    const bool has_all = is_open || !leads;
    if (is_open) choices_of_breeding(lab, state, ui, leads);
    if (view.error) paragraph(ui, text_of(*view.error, ui.strings), ui.palette.warning);
    if (view.base) {
        breeding_progress(view, ui);
        const float above = ImGui::GetCursorScreenPos().y - top;
        const float below = has_all ? breeding_words_height(view, ui) : 0;
        // The figures take the room of folded choices, so that the sheet keeps its height.
        float& unfolded = choices.height_unfolded();
        if (is_open) unfolded = above;
        const float body = std::min(most, std::max(above, unfolded) + ui.px(most_height) + below);
        const float height = std::floor(std::max(ui.px(least_height), body - above - below));
        is_low = is_open && height < ui.px(most_height);
        figures_of_breeding(lab, state, ui, height, has_all);
        if (has_all) breeding_words(view, ui);
    }
    sheet_buttons(ui, sheet);
    const bool closed = breeding_buttons(lab, choices, is_low, has_all, ui);
    if (end_sheet(sheet) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
