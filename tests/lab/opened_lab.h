// A lab with a shipped scene or exercise, for tests.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "app/course/lesson_view.h"
#include "app/files/data.h"
#include "app/lab.h"
#include "app/lab_requests.h"
#include "app/playback.h"

namespace braitenlab::tests {

inline Lab opened_lab(const std::string& name) {
    const auto path = find_shipped(name);
    EXPECT_TRUE(path) << name;
    auto lab = open_lab(*path, std::nullopt, {});
    EXPECT_TRUE(lab) << lab.error().text();
    return std::move(*lab);
}

// Exercise 5 with its solution.
inline Lab solved_exercise() {
    Lab lab = opened_lab("05-aggressor");
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
    return lab;
}

}  // namespace braitenlab::tests
