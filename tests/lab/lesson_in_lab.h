// What tests of an open exercise share.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/lab_requests.h"
#include "core/lesson/submission.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests {

inline BrainGraph solution(const Lab& lab) { return lab.document.lesson->exercise->solution.submission.brain; }

inline Lab aggressor() { return opened_lab("05-aggressor"); }

// Exercise 5 with other offers; without any it offers all controls.
inline Lab exercise_that_offers(std::vector<std::string> offers, int changes = 0) {
    Lab lab = aggressor();
    auto exercise = std::make_shared<Exercise>(*lab.document.lesson->exercise);
    exercise->offers = std::move(offers);
    exercise->changes = changes;
    lab.document.lesson->exercise = exercise;
    return lab;
}

inline LessonView lesson_of(const Lab& lab) { return lesson_view_of(lab); }

inline void run(Lab& lab, int ticks) {
    for (int i = 0; i < ticks; ++i) tick(lab);
}

inline void run_until_every_step_is_done(Lab& lab) {
    for (int i = 0; i < 60 * 20 && !referee_of(lab.document).passed(); ++i) tick(lab);
    ASSERT_TRUE(referee_of(lab.document).passed());
}

// The part of App::turn that grades.
inline void turn(Lab& lab, Jobs& jobs) {
    jobs.deliver(std::chrono::nanoseconds(0));
    update_grading(lab, jobs);
}

// Returns how many turns that took.
inline int grade_to_the_end(Lab& lab, Jobs& jobs) {
    int turns = 0;
    for (; !lesson_of(lab).grade && turns < 100'000; ++turns) {
        turn(lab, jobs);
        if (jobs.threads() > 0) std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    return turns;
}

}  // namespace braitenlab::tests
