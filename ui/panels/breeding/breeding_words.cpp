// Of the sheet of the breeding: how far it is, and what the matrix shows in words.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/evolve/tournament.h"
#include "ui/panels/breeding/breeding_parts.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using evolve::Course;
using evolve::Side;

std::string words_of_generations(evolve::Generations g) {
    return std::to_string(g.first) + "–" + std::to_string(g.last);
}

std::string words_of_verdict(const Ui& ui, const evolve::Verdict& verdict, Side side) {
    const bool is_predator = side == Side::predator;
    const std::string late = words_of_generations(verdict.late), earlier = words_of_generations(verdict.earlier);
    switch (verdict.course) {
        case Course::arms_race:
            return fill(ui.strings(is_predator ? "breeding.predator_race" : "breeding.prey_race"), {late});
        case Course::circles:
            return fill(ui.strings(is_predator ? "breeding.predator_circles" : "breeding.prey_circles"),
                        {late, earlier});
        case Course::unclear:
            return fill(ui.strings(is_predator ? "breeding.predator_unclear" : "breeding.prey_unclear"),
                        {late, with_sign(ui, verdict.gain, 2), earlier});
        case Course::too_early:
            break;
    }
    return {};
}

enum class ScoreCurve { opponents, panel };

// The mean of the last quarter of a curve less that of its first quarter.
float rise_of(const BreedingView& view, Side side, ScoreCurve which) {
    const std::vector<evolve::Generation>& all = at(view.state->main.generations, side);
    std::vector<float> scores;  // of the complete generations
    for (std::size_t i = 0; i < static_cast<std::size_t>(last_generation(view) + 1); ++i)
        scores.push_back(which == ScoreCurve::panel ? all[i].panel : all[i].best);
    const evolve::Trend trend = evolve::trend_of(scores);
    return trend.last - trend.first;
}

std::string words_of_rise(const Ui& ui, Side side, ScoreCurve which, float rise) {
    const std::string_view name = ui.strings(side == Side::predator ? "info.predators" : "info.prey");
    return fill(ui.strings(which == ScoreCurve::panel ? "breeding.rises_panel" : "breeding.rises_own"),
                {name, fixed(ui, rise, 2)});
}

// Why a curve rises although the matrix shows no clear change; empty where none does.
std::string why_it_rises(const BreedingView& view, const Ui& ui) {
    for (const Side side : evolve::both_sides) {
        if (!view.base->breed(side) || at(view.verdicts, side).course != Course::unclear) continue;
        for (const ScoreCurve which : {ScoreCurve::panel, ScoreCurve::opponents}) {
            if (which == ScoreCurve::panel && view.base->breeding().panel == 0) continue;
            const float rise = rise_of(view, side, which);
            if (rise >= evolve::least_gain) return words_of_rise(ui, side, which, rise);
        }
    }
    return {};
}

std::string words_of_rule(const Ui& ui) {
    return fill(ui.strings("breeding.verdict_how"), {fixed(ui, evolve::least_gain, 1)});
}

std::string words_of_beginning(const Ui& ui) {
    return fill(ui.strings("breeding.early"), {std::to_string(evolve::least_generations)});
}

std::size_t lines_in_card(const Ui& ui, std::string_view words, Face face) {
    return lines_of_words(ui, words, face, card_width(ui)).size();
}

float height_of_lines(const Ui& ui, std::size_t lines, Face face) {
    return static_cast<float>(lines) * line_height(ui, face);
}

// "about 40 s left"; empty while it is not known.
std::string time_left(const BreedingView& view, const Ui& ui) {
    if (!view.seconds_left) return {};
    const int seconds = std::max(5, static_cast<int>(std::ceil(*view.seconds_left / 5)) * 5);  // it does not flicker
    const bool minutes = seconds >= 120;
    return fill(ui.strings(minutes ? "breeding.minutes_left" : "breeding.seconds_left"),
                {std::to_string(minutes ? (seconds + 59) / 60 : seconds)});
}

int generations_of_panel(const evolve::Breeding& breeding) {
    return breeding.panel > 0 ? breeding.panel_generations + 1 : 0;
}

int bred_of_panel(const BreedingView& view) { return static_cast<int>(view.state->panel.generations.front().size()); }

// Of all generations, those of the panel included: 0 to 1.
float share_of_breeding(const BreedingView& view) {
    const evolve::Breeding& breeding = view.base->breeding();
    const int of_panel = generations_of_panel(breeding), all = breeding.generations + 1;
    const int done = std::min(bred_of_panel(view), of_panel) + std::min(last_generation(view) + 1, all);
    return std::clamp((static_cast<float>(done) + view.progress) / static_cast<float>(of_panel + all), 0.0f, 1.0f);
}

std::string words_of_panel(const evolve::Breeding& breeding, int bred, const Ui& ui) {
    return fill(ui.strings("breeding.panel"), {std::to_string(bred), std::to_string(generations_of_panel(breeding))});
}

std::string words_of_generation(const evolve::Breeding& breeding, int generation, const Ui& ui) {
    return fill(ui.strings("breeding.progress"),
                {std::to_string(generation), std::to_string(breeding.generations), std::to_string(breeding.trials),
                 fixed(ui, breeding.seconds, 0), std::to_string(evolve::tournament_trials)});
}

// "Generation 12 of 40".
std::string words_of_progress(const BreedingView& view, const Ui& ui) {
    const evolve::Breeding& breeding = view.base->breeding();
    if (breeds_panel(view)) return words_of_panel(breeding, bred_of_panel(view), ui);
    return words_of_generation(breeding, std::max(0, last_generation(view)), ui);
}

// Of the words about the progress with the time that is left, whatever they will be.
std::size_t lines_of_progress(const evolve::Breeding& breeding, const Ui& ui) {
    std::size_t most = lines_in_card(ui, ui.strings("breeding.not_begun"), Face::small);
    const std::string left = " · " + fill(ui.strings("breeding.seconds_left"), {"115"});
    for (const std::string& words : {words_of_panel(breeding, generations_of_panel(breeding), ui),
                                     words_of_generation(breeding, breeding.generations, ui)})
        most = std::max(most, lines_in_card(ui, words + left, Face::small));
    return most;
}

bool has_begun(const BreedingView& view) {
    return view.runs || last_generation(view) >= 0 ||
           (bred_of_panel(view) > 0 && bred_of_panel(view) < generations_of_panel(view.base->breeding()));
}

}  // namespace

bool breeds_panel(const BreedingView& view) {
    const int bred = bred_of_panel(view);
    return bred < generations_of_panel(view.base->breeding()) && (bred > 0 || view.runs);
}

std::string breeding_percent(const BreedingView& view, const Ui& ui) {
    if (!view.base) return {};
    const std::string left = time_left(view, ui);
    return fill(ui.strings("lecture.percent"), {std::to_string(std::lround(100 * share_of_breeding(view)))}) +
           (left.empty() ? "" : ", ") + left;
}

void paragraph_of_lines(Ui& ui, std::string_view words, std::size_t lines) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    paragraph(ui, words, ui.palette.second_text, Face::small);
    ImGui::SetCursorScreenPos(start);
    ImGui::Dummy({1, height_of_lines(ui, lines, Face::small)});
}

void breeding_progress(const BreedingView& view, Ui& ui) {
    std::string words(ui.strings("breeding.not_begun"));
    if (has_begun(view)) {
        const std::string left = time_left(view, ui);
        words = words_of_progress(view, ui) + (left.empty() ? "" : " · ") + left;
    }
    paragraph_of_lines(ui, words, lines_of_progress(view.base->breeding(), ui));
    progress_bar(ui, share_of_breeding(view), spacing::small);
}

void breeding_words(const BreedingView& view, Ui& ui) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    bool is_early = false;
    for (const Side side : evolve::both_sides) {
        if (!view.base->breed(side)) continue;
        const evolve::Verdict& verdict = at(view.verdicts, side);
        if (verdict.course == Course::too_early)
            is_early = true;
        else
            paragraph(ui, words_of_verdict(ui, verdict, side), ui.palette.text);
    }
    const std::string rises = why_it_rises(view, ui);
    const std::string words = is_early ? words_of_beginning(ui) : rises.empty() ? words_of_rule(ui) : rises;
    paragraph(ui, words, ui.palette.second_text, Face::small);
    const float height = breeding_words_height(view, ui) - ui.px(spacing::small);
    ImGui::SetCursorScreenPos(start);
    const Item area = item(ui, "breeding.words", {card_width(ui), height}, false);
    if (words != words_of_rule(ui)) tooltip(ui, area, words_of_rule(ui));
}

float breeding_words_height(const BreedingView& view, const Ui& ui) {
    const float space = ui.px(spacing::small);
    float height = 0;
    std::size_t last = std::max(lines_in_card(ui, words_of_beginning(ui), Face::small),
                                lines_in_card(ui, words_of_rule(ui), Face::small));
    for (const Side side : evolve::both_sides) {
        if (!view.base->breed(side)) continue;
        std::size_t most = 0;
        for (const Course course : {Course::arms_race, Course::circles, Course::unclear})
            most = std::max(
                most,
                lines_in_card(ui, words_of_verdict(ui, {course, {100, 199}, {100, 199}, -0.05f}, side), Face::text));
        height += height_of_lines(ui, most, Face::text) + space;
        for (const ScoreCurve which : {ScoreCurve::panel, ScoreCurve::opponents})
            last = std::max(last, lines_in_card(ui, words_of_rise(ui, side, which, 0.55f), Face::small));
    }
    return height + height_of_lines(ui, last, Face::small) + space;
}

}  // namespace braitenlab::ui
