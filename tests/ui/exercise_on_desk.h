// What tests of the exercise card share.
#pragma once

#include <vector>

#include "desk.h"

namespace braitenlab::tests {

inline bool inside(Rect inner, Rect outer) {
    return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.w <= outer.x + outer.w + 0.5f &&
           inner.y + inner.h <= outer.y + outer.h + 0.5f;
}

inline void begin_run(Desk& desk) { desk.lesson.attempt.work.has_run = true, desk.lesson.at_start = false; }

inline void predict_and_run(Desk& desk, int option) {
    desk.lesson.attempt.answers.prediction = option;
    begin_run(desk);
}

// Unfolds the buttons for which the foot of the card has no room; no effect where it has.
inline void unfold_foot(Desk& desk) { desk.panels.exercise.more_open = true; }

// Opens an exercise that is passed: every step is done, and every start passes.
inline void pass(Desk& desk) {
    desk.open_exercise();
    predict_and_run(desk, 1);
    for (Verdict& verdict : desk.lesson.verdicts) verdict.done = true;
    desk.lesson.grade = graded(std::vector<bool>(10, true), true);
}

}  // namespace braitenlab::tests
