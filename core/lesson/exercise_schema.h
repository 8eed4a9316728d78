// The schema of exercise files: every value, described once as core/scene/schema.h does for scenes. The scene of an
// exercise is not part of it.
#pragma once

#include "core/lesson/exercise.h"

namespace braitenlab {

namespace limits {
inline constexpr std::size_t hints = 32, options = 8, offers = 16, wrong_answers = 16;
}

void describe(auto& v, Of<Check>) {
    v.variant("goal", &Check::goal, "what the vehicle must do; each goal has keys of its own, listed under Goals");
    v.text("vehicle", &Check::vehicle, limits::name_length,
           "NAME of the [vehicle.NAME] that must do it; without it, the scene's first");
    v.number("hold", &Check::hold, "s", {0, 600}, "the goal must stay met for so long without a break");
    v.number("earliest", &Check::earliest, "s", {0, 600}, "it is not judged before this time");
    v.number("latest", &Check::latest, "s", {0, 600}, "it is not judged after this time; 0: no limit");
    v.number("after", &Check::after, "", {0, limits::steps}, "number of a step that must be done first; 0: none");
}

void describe(auto& v, Of<ShownCheck>) {
    v.text("option", &ShownCheck::option, limits::text_length,
           "the text of the option that the check belongs to; without it, `answer`, whichever that is");
    v.part(&ShownCheck::check);
}

void describe(auto& v, Of<Prediction>) {
    v.text("question", &Prediction::question, limits::text_length, "asked before the outcome is visible, never graded");
    v.texts("options", &Prediction::options, limits::options, limits::text_length, "two or more to choose from");
    v.choice("answer", &Prediction::answer, &Prediction::options, "the option that the run shows");
    v.text("outcome", &Prediction::outcome, limits::text_length,
           "shown once a run has shown it, beside the student's choice");
    v.number("after", &Prediction::after, "s", {0, 600},
             "of a run with the shipped brain, after which the outcome is visible");
    v.flag("hides_brain", &Prediction::hides_brain,
           "until the prediction is made, the brain's picture and the wires on the deck are not shown");
    v.text(
        "path", &Prediction::path_of, limits::name_length,
        "NAME of a [vehicle.NAME]: the student may draw its path of the first `after` seconds on the floor, instead of "
        "choosing an option; the mean distance to the real path is shown beside the outcome");
    v.list("shows", &Prediction::shows, limits::checks,
           "what a run shows by then if one of the options is true. `check` tests that the run with the shipped brain "
           "meets the checks of the answer, and not all of another option's");
}

void describe(auto& v, Of<Step>) {
    v.text("text", &Step::text, limits::text_length, "what is to be seen");
    v.part(&Step::check);
}

void describe(auto& v, Of<Hint>) {
    v.text("text", &Hint::text, limits::text_length, "from a nudge to the whole solution, one after the other");
    v.text("anchor", &Hint::anchor, limits::title_length, "id of the widget that pulses, like slider.LR");
}

void describe(auto& v, Of<Answer>) {
    v.text("name", &Answer::name, limits::title_length, "of a wrong answer: what it is");
    v.text("text", &Answer::text, limits::text_length, "of a wrong answer: what to tell a student who gives it");
    v.brain_keys(&Answer::brain, "a brain in place of the shipped one");
    v.settings("set", &Answer::settings, "values of the scene, by their paths, that differ from those as shipped");
}

void describe(auto& v, Of<Mutation>) {
    v.number("strength", &Mutation::strength, "", {0, 2}, "standard deviation of the error of a copied weight");
    v.flag("weights", &Mutation::weights, "the copy's weights have errors");
    v.flag("thresholds", &Mutation::thresholds, "the copy's thresholds have errors, a quarter as large");
    v.flag("biases", &Mutation::biases, "the copy's biases have errors, half as large");
    v.number("rewiring", &Mutation::rewiring, "", {0, 1}, "probability that the copy loses a wire or gets a new one");
}

void describe(auto& v, Of<SelectionRules>) {
    v.number("children", &SelectionRules::children, "", {2, 9}, "number of copies from which the student chooses");
    v.number("generations", &SelectionRules::generations, "", {1, 99}, "most choices");
    v.part(&SelectionRules::mutation);
    v.number("first_strength", &SelectionRules::first, "", {0, 2},
             "strength for the children of the shipped brain, so that the first ones differ visibly; 0: as the others");
}

void describe(auto& v, Of<MedianRule>) {
    v.number("step", &MedianRule::step, "", {1, limits::steps}, "number of the step whose measured value is compared");
    v.number("factor", &MedianRule::factor, "", {0.01f, 100},
             "what the step needs is this many times the median as shipped; `check` warns if it is not");
}

void describe(auto& v, Of<Exercise>) {
    v.text(
        "id", &Exercise::id, limits::title_length,
        "names the exercise in hand-ins, whatever its file is called; without it, the file's name without its ending "
        "and without what a copy adds, like ` (1)`");
    v.number("number", &Exercise::number, "", {0, 999}, "its position in the course");
    v.number("chapter", &Exercise::chapter, "", {0, 99}, "its chapter in the course, from 1; 0: none");
    v.text("title", &Exercise::title, limits::title_length, "must be given");
    v.text("goal", &Exercise::goal, limits::text_length, "must be given");
    v.text("why", &Exercise::why, limits::text_length, "the mechanism, shown on request");
    v.text("question", &Exercise::question, limits::text_length, "asked afterwards, never graded");
    v.texts("offers", &Exercise::offers, limits::offers, limits::name_length,
            "the controls that are shown: dials like \"LR\", dials that move together like \"LL=RR\", \"curves\", "
            "\"sensors\", \"wiring\", \"selection\", a shipped breeding like \"breeding:chase-ten\"; default: all");
    v.texts("hides", &Exercise::hides, limits::kinds, limits::name_length,
            "names of kinds of the scene whose brains are never shown; not the first vehicle's");
    v.number("changes", &Exercise::changes, "", {0, 16}, "most offered controls that may be changed; 0: any number");
    v.number("seed", &Exercise::seed, "", {0, 1e15}, "of the run that the student sees");
    v.number("seconds", &Exercise::seconds, "s", {1, 600}, "duration of a graded run");
    v.number("starts", &Exercise::starts, "", {1, 100}, "number of seeds, from 1 on, that are graded");
    v.number("needed", &Exercise::needed, "", {1, 100}, "number of them that must pass every step");
    v.table("median", &Exercise::median,
            "after grading, the values of a step are shown beside those of the shipped brain from the same seeds");
    v.table("predict", &Exercise::prediction, "a prediction, to be made before the outcome is visible");
    v.table("selection", &Exercise::selection,
            "how the copies of a brain differ, in an exercise that offers \"selection\"");
    v.list("step", &Exercise::steps, limits::steps, "what must happen; at least one");
    v.list("hint", &Exercise::hints, limits::hints, "help, in stages");
    v.table("solution", &Exercise::solution,
            "an answer that passes: a brain in place of the shipped one, or values that differ; must be given");
    v.list("wrong", &Exercise::wrong, limits::wrong_answers, "a plausible answer that must fail");
}

}  // namespace braitenlab
