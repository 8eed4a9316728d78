// Every value of an exercise file, described once as core/scene/fields.h does for scenes.
//
// Beyond what is said there a visitor offers texts(key, vector<string> T::*, most, longest, meaning) and
// choice(key, int T::*, options, meaning): one of the texts that `options` names, kept as its index.
#pragma once

#include <array>

#include "core/lesson/exercise.h"
#include "core/scene/fields.h"
#include "core/scene/names.h"

namespace braitenlab {

inline constexpr std::array<Named<Goal>, 4> goal_words{
    {{Goal::runs, "runs"}, {Goal::turns_to, "turns_to"}, {Goal::touches, "touches"}, {Goal::speeds_up, "speeds_up"}}};
constexpr const auto& words(Goal) { return goal_words; }

namespace limits {
inline constexpr std::size_t steps = 32, hints = 32, options = 8;
}

template <class Visitor>
void describe(Visitor& v, Of<Prediction>) {
    v.text("question", &Prediction::question, limits::text_length, "asked before the first run, never graded");
    v.texts("options", &Prediction::options, limits::options, limits::text_length, "two or more to choose from");
    v.choice("answer", &Prediction::answer, &Prediction::options, "the option that the run will show");
    v.text("outcome", &Prediction::outcome, limits::text_length, "said after the run, beside the student's choice");
}

template <class Visitor>
void describe(Visitor& v, Of<Check>) {
    v.word("goal", &Check::goal, "what the first vehicle must do");
    v.text("source", &Check::source, limits::name_length, "to which source; for all goals but runs");
    v.number("metres", &Check::metres, "m", {0.01, 100}, "touches, speeds_up: so near counts as touching");
    v.number("seconds", &Check::seconds, "s", {0.1, 600}, "runs: for so long");
    v.number("degrees", &Check::degrees, "°", {0.5, 180}, "turns_to: the source lies so near to straight ahead");
    v.number("factor", &Check::factor, "×", {0.01, 100}, "speeds_up: so many times its speed after one second");
}

template <class Visitor>
void describe(Visitor& v, Of<Step>) {
    v.text("text", &Step::text, limits::text_length, "what is to be seen");
    v.part(&Step::check);
}

template <class Visitor>
void describe(Visitor& v, Of<Hint>) {
    v.text("text", &Hint::text, limits::text_length, "from a nudge to the whole way, one after the other");
    v.text("anchor", &Hint::anchor, limits::title_length, "the widget that pulses, like slider.LR");
}

template <class Visitor>
void describe(Visitor& v, Of<Exercise>) {
    v.number("number", &Exercise::number, "", {0, 999}, "its place in the course");
    v.text("title", &Exercise::title, limits::title_length, "must be given");
    v.text("goal", &Exercise::goal, limits::text_length, "must be given");
    v.text("why", &Exercise::why, limits::text_length, "the mechanism, shown on request");
    v.number("seed", &Exercise::seed, "", {0, 1e15}, "of the run that the student sees");
    v.number("seconds", &Exercise::seconds, "s", {1, 600}, "how long a graded run lasts");
    v.number("starts", &Exercise::starts, "", {1, 100}, "so many seeds, from 1 on, are graded");
    v.number("needed", &Exercise::needed, "", {1, 100}, "so many of them must pass every step");
    v.table("predict", &Exercise::prediction, "a prediction before the first run");
    v.list("step", &Exercise::steps, limits::steps, "what must come to pass; one at least");
    v.list("hint", &Exercise::hints, limits::hints, "help, in stages");
    v.table("solution", &Exercise::solution, "a brain that passes; must be given");
}

}  // namespace braitenlab
