// Fixture: a page of a shipped lecture in a small window.
#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/lesson/exercise_file.h"
#include "desk.h"

namespace braitenlab::tests {

inline std::filesystem::path shipped_exercises() { return std::filesystem::path(BRAITENLAB_SOURCE) / "exercises"; }

inline LectureView opened_lecture(const std::string& name) {
    auto lecture = load_lecture(shipped_exercises() / "lectures" / (name + ".toml"), shipped_exercises());
    if (!lecture) throw std::runtime_error(lecture.error().text());
    LectureView view{.lecture = std::make_shared<const Lecture>(std::move(*lecture))};
    for (const LecturePage& page : view.lecture->pages) view.hands.emplace_back(page.question.options.size(), 0);
    return view;
}

// The scene of a page at its start.
inline Snapshot first_moment(const LecturePage& page) {
    Scene scene;
    if (page.exercise.empty()) {
        if (auto loaded = load_scene(page.file)) scene = std::move(*loaded);
    } else if (auto exercise = load_exercise(page.file)) {
        scene = exercise->scene;
    }
    Snapshot now;
    World::create(scene, 1)->capture(now);
    return now;
}

inline Snapshot first_moment_of(const Scene& scene) {
    Snapshot now;
    World::create(scene, 1)->capture(now);
    return now;
}

// The strings with the words of the shipped lectures.
inline Strings speaking_in_lectures(const std::string& code) {
    Strings strings = speaking(code);
    const auto words = Strings::load(shipped_exercises() / "words" / (code + ".toml"));
    EXPECT_TRUE(words);
    for (const char* name : {"four-numbers", "wheels-to-neurons"})
        add_translations(strings, texts_of(*opened_lecture(name).lecture), *words);
    return strings;
}

struct LectureOnDesk : testing::Test {
    Desk desk{1024, 768, 1.4f, true};
    LectureView pages = opened_lecture("four-numbers");

    LectureOnDesk() {
        desk.now = snapshot(0);
        desk.view.lecture = true;
        desk.view.pages = &pages;
    }
    void show(int page, int step) {
        pages.page = page, pages.step = step;
        ++desk.view.run_id;
        desk.frame(4);
    }
};

inline bool is_inside(Rect a, Rect b) {
    return a.x >= b.x - 0.5f && a.y >= b.y - 0.5f && a.x + a.w <= b.x + b.w + 0.5f && a.y + a.h <= b.y + b.h + 0.5f;
}
inline bool overlap(Rect a, Rect b) {
    return a.x < b.x + b.w - 0.5f && b.x < a.x + a.w - 0.5f && a.y < b.y + b.h - 0.5f && b.y < a.y + a.h - 0.5f;
}

}  // namespace braitenlab::tests
