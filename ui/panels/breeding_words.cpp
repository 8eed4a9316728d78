// Of the sheet of the breeding: how far it is, and what the matrix shows in words.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/breeding_parts.h"
#include "ui/strings.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

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
            return fill(ui.strings(is_predator ? "breeding.predator_unclear" : "breeding.prey_unclear"), {late});
        case Course::too_early:
            break;
    }
    return {};
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

// "Generation 12 of 40".
std::string words_of_progress(const BreedingView& view, const Ui& ui) {
    const evolve::Breeding& breeding = view.base->breeding();
    const int of_panel = generations_of_panel(breeding), panel = bred_of_panel(view), last = last_generation(view);
    if (panel < of_panel && (panel > 0 || view.runs))
        return fill(ui.strings("breeding.panel"), {std::to_string(panel), std::to_string(of_panel)});
    return fill(ui.strings("breeding.progress"),
                {std::to_string(std::max(0, last)), std::to_string(breeding.generations),
                 std::to_string(breeding.trials), fixed(ui, breeding.seconds, 0)});
}

bool has_begun(const BreedingView& view) {
    return view.runs || last_generation(view) >= 0 ||
           (bred_of_panel(view) > 0 && bred_of_panel(view) < generations_of_panel(view.base->breeding()));
}

}  // namespace

std::string breeding_percent(const BreedingView& view, const Ui& ui) {
    if (!view.base) return {};
    const std::string left = time_left(view, ui);
    return fill(ui.strings("lecture.percent"), {std::to_string(std::lround(100 * share_of_breeding(view)))}) +
           (left.empty() ? "" : ", ") + left;
}

void breeding_progress(const BreedingView& view, Ui& ui) {
    if (has_begun(view)) {
        const std::string left = time_left(view, ui);
        paragraph(ui, words_of_progress(view, ui) + (left.empty() ? "" : " · ") + left, ui.palette.second_text,
                  Face::small);
    } else {
        paragraph(ui, ui.strings("breeding.not_begun"), ui.palette.second_text, Face::small);
    }
    progress_bar(ui, share_of_breeding(view), spacing::small);
}

void breeding_words(const BreedingView& view, Ui& ui) {
    bool is_early = false;
    for (const Side side : {Side::predator, Side::prey}) {
        if (!view.base->breed(side)) continue;
        const evolve::Verdict& verdict = at(view.verdicts, side);
        if (verdict.course == Course::too_early)
            is_early = true;
        else
            paragraph(ui, words_of_verdict(ui, verdict, side), ui.palette.text);
    }
    const std::string how = is_early ? fill(ui.strings("breeding.early"), {std::to_string(evolve::least_generations)})
                                     : fill(ui.strings("breeding.verdict_how"), {fixed(ui, evolve::least_gain, 1)});
    paragraph(ui, how, ui.palette.second_text, Face::small);
}

float breeding_words_height(const BreedingView& view, const Ui& ui) {
    const auto height_of = [&](std::string_view words, Face face) {
        const auto lines = lines_of_words(ui, words, face, card_width(ui)).size();
        return static_cast<float>(lines) * line_height(ui, face) + ui.px(spacing::small);
    };
    float height = 0;
    for (const Side side : evolve::both_sides) {
        if (!view.base->breed(side)) continue;
        float most = 0;
        for (const Course course : {Course::arms_race, Course::circles, Course::unclear})
            most = std::max(most, height_of(words_of_verdict(ui, {course, {100, 199}, {100, 199}}, side), Face::text));
        height += most;
    }
    return height + line_height(ui, Face::small);
}

}  // namespace braitenlab::ui
