#include "core/lesson/disclosure.h"

#include <algorithm>

#include "core/lesson/submission.h"

namespace braitenlab {

Disclosure disclosure_of(const Exercise* exercise, const Known& known) {
    const bool asks = exercise && is_asked(exercise->prediction);
    const bool page_hides = known.page_asks && !known.page_answers;
    Disclosure may;
    // An answer alone tells nothing: it can still be changed until the exercise has been run.
    const bool has_shown = known.predicted && known.has_run;
    may.outcome = !asks || known.page_answers || has_shown || known.outcome || known.passed;
    may.open_prediction = exercise && known.at_start && !known.outcome;
    // Not at a start at which the prediction can be changed: the coming run would be the one it asks for.
    const bool is_bound = known.predicted && known.has_run && !(may.open_prediction && known.as_given);
    may.future = !page_hides && (!asks || known.outcome || is_bound);
    may.solution_run = exercise && known.has_run && !known.together && may.outcome;
    may.brains = known.brain_revealed && (may.outcome || !exercise->prediction.hides_brain);
    may.characters = known.character_revealed && known.brain_revealed && may.outcome;
    may.why = may.outcome && may.brains;
    may.robots = may.future && may.outcome;
    // An exercise asks for one of the other brains, unless it offers all controls.
    may.every_brain = !exercise || known.free_play || offers_all(*exercise);
    may.other_brains = may.future && may.why && may.every_brain;
    return may;
}

bool is_secret(const Exercise* exercise, const Scene& now, int kind) {
    const Kind& of = now.kinds[static_cast<std::size_t>(kind)];
    if (of.hidden) return true;
    return exercise && std::find(exercise->hides.begin(), exercise->hides.end(), of.name) != exercise->hides.end();
}

}  // namespace braitenlab
