// An exercise as its author writes it: one TOML file of text, checks and a scene. The format: docs/exercise-format.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/result.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

// What a step asks of the scene's first vehicle.
enum class Goal {
    runs,       // the run has lasted `seconds`
    turns_to,   // the source came to lie within `degrees` of the heading, having been outside
    touches,    // its origin came within `metres` of the source
    speeds_up,  // when it first came within `metres`, it moved at least `factor` times as fast as after its first
                // second
};

// A check is data; core/lesson/referee.h judges it.
struct Check {
    Goal goal = Goal::runs;
    std::string source;  // for all but `runs`
    float metres = 0;
    float seconds = 0;
    float degrees = 0;
    float factor = 0;
    friend bool operator==(const Check&, const Check&) = default;
};

struct Step {
    std::string text;
    Check check;
    friend bool operator==(const Step&, const Step&) = default;
};

// Asked before the first run, never graded. Without a question there is none.
struct Prediction {
    std::string question;
    std::vector<std::string> options;
    int answer = 0;       // 0-based: what the run will show; in the file, one of the options
    std::string outcome;  // said after the run, next to the student's own choice
    friend bool operator==(const Prediction&, const Prediction&) = default;
};

struct Hint {
    std::string text;
    std::string anchor;  // the widget that pulses while the hint is the newest, e.g. "slider.LR"; may be empty
    friend bool operator==(const Hint&, const Hint&) = default;
};

struct Exercise {
    std::string id;  // the file's stem: "05-aggressor"
    int number = 0;
    std::string title, goal, why;
    Scene scene;  // with the exercise's own settings applied
    std::uint64_t seed = 1;
    Prediction prediction;
    std::vector<Step> steps;
    std::vector<Hint> hints;
    float seconds = 20;  // how long a graded run lasts
    int starts = 10;     // seeds 1..starts are graded
    int needed = 8;      // so many of them must pass every step
    FourNeurons solution;
};

// Mistakes come with file and line, those in the scene with the scene's. The scene's path is relative to the exercise's
// file.
Result<Exercise> load_exercise(const std::filesystem::path&, const std::vector<Setting>& more = {});
Result<Exercise> parse_exercise(std::string_view toml, const std::filesystem::path& file,
                                const std::vector<Setting>& more = {});

// The tables of docs/exercise-format.md, in Markdown.
std::string describe_exercise_format();

// Where a scene's first vehicle's brain is: the kind that the exercise is about.
// Precondition: the scene has a start (load_exercise sees to it) and is sound.
int pupil_kind(const Scene&);

}  // namespace braitenlab
