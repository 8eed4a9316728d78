#include "ui/panels/prompt_breeding.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ui/panels/offered.h"
#include "ui/panels/prompt_run.h"

namespace braitenlab::ui {

namespace {

// True while the breeding of the exercise has the opponents of its file: with them hardly a champion passes.
bool has_shipped_opponents(const LabView& view) {
    const BreedingView& bred = view.features.breeding;
    const std::string_view offered = offered_breeding(*view.lesson->exercise);
    if (!bred.base || !bred.shipped) return false;
    return std::any_of(bred.shipped->begin(), bred.shipped->end(), [&](const evolve::Breeding& each) {
        return each.id == offered && each.opponents == bred.base->breeding().opponents;
    });
}

// True until the run as given is over for the first time: it shows what the prey do before they are bred.
bool awaits_first_run(const PromptMemory& memory, const LabView& view, bool has_champion) {
    const BreedingView& bred = view.features.breeding;
    const bool has_begun = bred.base && (bred.runs || last_generation(bred) >= 0);
    return !has_champion && !has_begun && !has_failed(view) && !are_equal(memory.failed, tried_now(view));
}

// The match that a person has chosen last; nullopt: none.
std::optional<BreedingCell> chosen_by_person(const BreedingView& bred) {
    if (bred.watched.empty() || bred.watches_by_itself) return std::nullopt;
    return bred.watched.front();
}

// True if the predator has a higher score against the last prey than against the ancestor.
bool is_worse(const BreedingView& bred, const TellingMatches& matches) {
    const std::vector<int>& all = bred.matrix->generations;
    const auto index_of = [&](int generation) {
        return static_cast<std::size_t>(std::find(all.begin(), all.end(), generation) - all.begin());
    };
    const std::size_t predator = index_of(matches.last.predator);
    return bred.matrix->score(evolve::Side::predator, predator, index_of(matches.last.prey)) >
           bred.matrix->score(evolve::Side::predator, predator, index_of(matches.ancestor.prey));
}

}  // namespace

Prompt of_breeding(PromptMemory& memory, const LabView& view) {
    const BreedingView& bred = view.features.breeding;
    const bool plays = view.mode == Mode::playing;
    if (has_changed_since_start(memory, view)) return {"button.reset", "hint.changed_since"};
    const Exercise& exercise = *view.lesson->exercise;
    const bool has_champion = is_edited(exercise, submission_of(exercise, *view.now));
    if (has_champion && view.now->tick == 0 && !are_equal(memory.failed, tried_now(view)))
        return plays ? Prompt{} : Prompt{"button.play", "hint.play_bred"};
    if (bred.runs) return {{}, "hint.breeding_runs"};
    if (has_champion ? view.now->tick > 0 && !has_failed(view) : awaits_first_run(memory, view, has_champion))
        return plays ? Prompt{} : Prompt{"button.play", "hint.press_play"};
    if (has_champion && has_shipped_opponents(view)) return {"breeding.against.random", "hint.breed_against"};
    const bool is_complete = bred.base && last_generation(bred) >= bred.base->breeding().generations;
    if (!is_complete)
        return {"breeding.start", !bred.base                    ? "hint.breed"
                                  : has_shipped_opponents(view) ? "hint.breed_shipped"
                                                                : "hint.breed_others"};
    const bool is_tried = memory.failed_base == bred.base && memory.failed_generation == last_generation(bred);
    if (has_champion && is_tried) return {"breeding.matrix", "hint.breed_again"};
    const auto matches = has_champion ? std::nullopt : telling_matches(bred);
    if (!matches || chosen_by_person(bred) == matches->last)
        return {"breeding.take", matches && is_worse(bred, *matches) ? "hint.take_worse" : "hint.take_champion"};
    const bool has_seen_ancestor = chosen_by_person(bred) == matches->ancestor;
    const BreedingCell& cell = has_seen_ancestor ? matches->last : matches->ancestor;
    memory.cell = "breeding.cell." + std::to_string(cell.predator) + "." + std::to_string(cell.prey);
    return {memory.cell, has_seen_ancestor ? "hint.look_at_last" : "hint.look_at_ancestor"};
}

}  // namespace braitenlab::ui
