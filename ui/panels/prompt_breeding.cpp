#include "ui/panels/prompt_breeding.h"

#include <algorithm>

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

}  // namespace

Prompt of_breeding(const PromptMemory& memory, const LabView& view) {
    const LessonView& lesson = *view.lesson;
    const BreedingView& bred = view.features.breeding;
    const bool plays = view.mode == Mode::playing;
    if (has_changed_since_start(memory, view)) return {"button.reset", "hint.changed_since"};
    const bool has_champion = is_edited(*lesson.exercise, submission_of(*lesson.exercise, *view.now));
    if (has_champion && view.now->tick == 0 && !are_equal(memory.failed, tried_now(view)))
        return plays ? Prompt{} : Prompt{"button.play", "hint.press_play"};
    if (bred.runs) return {{}, "hint.breeding_runs"};
    const bool shows_outcome = is_asked(lesson.exercise->prediction) && !lesson.attempt.work.outcome_known;
    if (has_champion ? view.now->tick > 0 && !has_failed(view) : shows_outcome)
        return plays ? Prompt{} : Prompt{"button.play", "hint.press_play"};
    const bool has_hint = lesson.attempt.answers.hints_shown > 0;
    if ((has_hint || has_champion) && has_shipped_opponents(view))
        return {"breeding.against.random", "hint.breed_against"};
    const bool is_complete = bred.base && last_generation(bred) >= bred.base->breeding().generations;
    if (!is_complete) return {"breeding.start", has_shipped_opponents(view) ? "hint.breed_shipped" : "hint.breed"};
    const bool is_tried = memory.failed_base == bred.base && memory.failed_generation == last_generation(bred);
    return has_champion && is_tried ? Prompt{"breeding.matrix", "hint.breed_again"}
                                    : Prompt{"breeding.take", "hint.take_champion"};
}

}  // namespace braitenlab::ui
