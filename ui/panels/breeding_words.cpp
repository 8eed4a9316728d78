#include <array>
#include <string>

#include "ui/panels/breeding_parts.h"
#include "ui/strings.h"
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

}  // namespace

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

}  // namespace braitenlab::ui
