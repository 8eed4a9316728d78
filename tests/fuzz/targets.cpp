#include "tests/fuzz/targets.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "app/files/settings.h"
#include "core/evolve/breeding_file.h"
#include "core/insight/study_file.h"
#include "core/io/link.h"
#include "core/io/run_file.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/hand_in.h"
#include "core/lesson/lecture.h"
#include "core/scene/scene_file.h"
#include "tests/fuzz/commands.h"
#include "tests/fuzz/promise.h"
#include "ui/words/strings.h"

namespace braitenlab::fuzz {

namespace {

const std::filesystem::path exercises = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises";
constexpr std::size_t few = 60;  // vehicles; a world of more takes the time of many inputs

// An error has words.
template <class T>
void is_explained(const Result<T>& read) {
    if (!read) promise(!read.error().text().empty() && read.error().line >= 0, "an error without words");
}

// A scene that is read can be written, read again and run.
void scene_is_sound(const Scene& scene) {
    const auto again = parse_scene(write_scene(scene), "again.toml");
    promise(again && write_scene(*again) == write_scene(scene), "a scene that is not read as it was written");
    if (scene.starts.size() + static_cast<std::size_t>(scene.ecology.population) > few) return;
    auto session = Session::open(scene, 3);
    promise(static_cast<bool>(session), "a valid scene without a world");
    for (int i = 0; i < 20; ++i) session->step(), is_sound(*session);
}

void read_scene_text(std::string_view text) {
    const auto scene = parse_scene(text, "f.toml");
    is_explained(scene);
    if (scene) scene_is_sound(*scene);
}

void read_brain_text(std::string_view text) {
    const auto brain = parse_brain(text, "f.toml");
    is_explained(brain);
    if (brain) promise(static_cast<bool>(parse_brain(write_brain(*brain), "again.toml")), "a brain");
}

void read_exercise_text(std::string_view text) {
    const auto file = exercises / "guided" / "f.toml";
    const auto exercise = parse_exercise(text, file);
    is_explained(exercise);
    promise(errors_of_exercise(text, file).empty() == static_cast<bool>(exercise), "all errors, and the first one");
}

void read_lecture_text(std::string_view text) {
    is_explained(parse_lecture(text, exercises / "lectures" / "f.toml", exercises));
    (void)errors_of_lecture(text, exercises / "lectures" / "f.toml", exercises);
}

void read_study_text(std::string_view text) { is_explained(insight::parse_study(text, "f.toml")); }

void read_breeding_text(std::string_view text) { is_explained(evolve::parse_breeding(text, "f.toml")); }

void read_run_text(std::string_view text) {
    auto run = io::read_run(text, "f.run");
    is_explained(run);
    if (!run || run->checkpoint.tick - run->checkpoint.keyframe_tick > 300) return;
    Session session = Session::resume(std::move(*run));
    if (session.snapshot().vehicles.size() > few) return;
    is_sound(session), is_restored(session);
}

void read_hand_in_text(std::string_view text) {
    const auto hand_in = parse_hand_in(text, "f.toml");
    is_explained(hand_in);
    if (hand_in) promise(static_cast<bool>(parse_hand_in(write_hand_in(*hand_in), "again.toml")), "a hand-in");
}

void read_settings_text(std::string_view text) {
    const auto preferences = parse_preferences(text, "f.toml");
    const auto state = parse_state(text, "f.toml");
    is_explained(preferences), is_explained(state);
    if (preferences)
        promise(static_cast<bool>(parse_preferences(write_preferences(*preferences), "again")), "settings");
    if (state) promise(static_cast<bool>(parse_state(write_state(*state), "again")), "a state");
}

void read_words_text(std::string_view text) { is_explained(Strings::parse(text, "f.toml")); }

void read_link(std::string_view text) {
    const auto linked = io::decode_link(text);
    is_explained(linked);
    if (linked && linked->exercise.empty()) scene_is_sound(linked->scene);
}

}  // namespace

std::span<const Target> targets() {
    static constexpr std::array all{Target{"scene", "exercises/scenes", true, read_scene_text},
                                    Target{"exercise", "exercises/guided", true, read_exercise_text},
                                    Target{"lecture", "exercises/lectures", true, read_lecture_text},
                                    Target{"study", "exercises/studies", true, read_study_text},
                                    Target{"breeding", "exercises/breeding", true, read_breeding_text},
                                    Target{"brain", "", true, read_brain_text},
                                    Target{"run", "", true, read_run_text},
                                    Target{"hand-in", "", true, read_hand_in_text},
                                    Target{"settings", "", true, read_settings_text},
                                    Target{"words", "exercises/words", true, read_words_text},
                                    Target{"link", "", false, read_link},
                                    Target{"commands", "", false, run_commands}};
    return all;
}

const Target* find_target(std::string_view name) {
    for (const Target& target : targets())
        if (target.name == name) return &target;
    return nullptr;
}

}  // namespace braitenlab::fuzz
