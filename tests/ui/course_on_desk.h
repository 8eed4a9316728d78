// What tests of the shipped exercises share: the course, and an exercise of it in a window.
#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/lesson/exercise_file.h"
#include "core/lesson/gain.h"
#include "core/lesson/grade.h"
#include "core/lesson/selection.h"
#include "core/lesson/submission.h"
#include "core/scene/sensor_pairs.h"
#include "core/scene/subject.h"
#include "exercise_on_desk.h"
#include "render/view/camera.h"

namespace braitenlab::tests {

using namespace ui;

inline std::vector<Exercise> course() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(BRAITENLAB_SOURCE) + "/exercises/guided"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Exercise> all;
    for (const std::filesystem::path& file : files) {
        auto loaded = load_exercise(file);
        EXPECT_TRUE(loaded) << loaded.error().text();
        if (loaded) all.push_back(std::move(*loaded));
    }
    EXPECT_GT(all.size(), 20u);
    return all;
}

inline Exercise exercise_of(const std::string& id) {
    for (Exercise& each : course())
        if (each.id == id) return std::move(each);
    throw std::runtime_error("no exercise " + id);
}

inline Strings words_of_course(const std::string& language) {
    auto words = Strings::load(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "words" / (language + ".toml"));
    EXPECT_TRUE(words);
    return words ? *words : Strings{};
}

// The gain of each offered dial in the exercise as shipped; tried once for each exercise.
inline const std::vector<float>& gains_of_shipped(const Exercise& exercise) {
    static std::map<std::string, std::vector<float>> known;
    const auto [at, is_new] = known.try_emplace(exercise.id);
    if (!is_new) return at->second;
    std::vector<StartResult> runs;
    const auto pairs =
        sensor_pairs(exercise.scene.kinds[static_cast<std::size_t>(subject_kind(exercise.scene))].sensors);
    for (const Submission& tried :
         tries_of(exercise, as_shipped(exercise), pairs.empty() ? SensorPair{} : pairs.front().sensors))
        runs.push_back(try_start(exercise, tried, exercise.seed));
    return at->second = gains_of(runs);
}

// The exercise at the start of its run, with the subject selected.
struct Opened {
    Opened(Exercise exercise, float width = 1280, float height = 800, float scale = 1)
        : desk(width, height, scale, true), world(std::move(*World::create(exercise.scene, exercise.seed))) {
        desk.opened = std::move(exercise);
        desk.lesson.exercise = &desk.opened;
        if (offers_selection(desk.opened)) desk.lesson.selection.emplace();
        desk.lesson.verdicts.assign(desk.opened.steps.size(), Verdict{false, {{0.4f, 0.6f, "m", true, true}}});
        desk.view.file = &desk.opened.scene;
        desk.view.documents.opened = desk.opened.id;
        desk.show_lesson();
        show();
        desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    }
    void show() {
        world.capture(desk.now);
        desk.view.timeline.latest = std::max(desk.view.timeline.latest, desk.now.tick);
    }
    void look_at_scene() {
        desk.frame(2);
        Camera camera;
        camera.mode = CameraMode::birds_eye;
        sight = look(camera, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
        desk.view.camera_view = &sight;
    }
    void play_after_prediction() {
        desk.lesson.attempt.answers.prediction = desk.opened.prediction.answer;
        begin_run(desk);
        desk.view.mode = Mode::playing;
        desk.lesson.gains = gains_of_shipped(desk.opened);
    }
    const VehicleView* subject() const { return find_vehicle(desk.now, desk.view.settings.selection.vehicle); }

    Desk desk;
    World world;
    CameraView sight;
};

// The offered dials that the slider with this anchor sets; empty if there are none.
inline std::vector<Dial> dials_at(const Exercise& exercise, std::string_view anchor) {
    for (const Offer& offer : offered_dials(exercise))
        for (const Dial dial : offer.dials)
            if (anchor_of(dial) == anchor) return offer.dials;
    return {};
}

struct SmallWindow {
    float width, height, scale;
};
inline const SmallWindow small_windows[]{{800, 600, 1}, {1280, 800, fitting_scale(2, {0, 0, 1280, 800}, false)}};

// The part of the exercise's card that scrolls: between its heading and the buttons at its foot.
inline Rect body_of_exercise(const Desk& desk) {
    const Rect card = desk.where("card.exercise"), heading = desk.where("card.exercise.fold");
    const auto top_of = [&](const char* id) {
        const Rect* at = desk.anchors.find(id);
        return at ? at->y : card.y + card.h;
    };
    const float top = heading.y + heading.h;
    const float bottom = std::min({top_of("exercise.hint"), top_of("exercise.reset"), top_of("selection.open")});
    return {card.x, top, card.w, bottom - top};
}

inline bool is_in_body(const Desk& desk, const std::string& id) {
    const Rect body = body_of_exercise(desk), *at = desk.anchors.find(id);
    return at && at->y >= body.y - 1 && at->y + std::min(at->h, desk.layout.scale * 40) <= body.y + body.h + 1;
}

}  // namespace braitenlab::tests
