// An exercise as its author writes it: one TOML file of text, checks and a scene. The format: docs/exercise-format.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/result.h"
#include "core/scene/scene.h"

namespace braitenlab {

// What a step asks of the run. `who` is the scene's first vehicle, `what` a source.
enum class Goal {
    runs,        // the run has lasted `seconds`
    turns_to,    // the source came to lie within `degrees` of the heading, having begun or been outside
    touches,     // came within `metres` of the source
    speeds_up,   // at the first touch (within `metres`) moved at least `factor` times as fast as after its first second
};

// A check is data; core/lesson/referee.h judges it.
struct Check {
    Goal goal = Goal::runs;
    std::string source;   // for all but `runs`
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

// Asked before the first run, never graded.
struct Prediction {
    std::string question;
    std::vector<std::string> options;
    int answer = 0;       // 0-based: what the run will show
    std::string outcome;  // said after the run, next to the student's own choice
    friend bool operator==(const Prediction&, const Prediction&) = default;
};

struct Hint {
    std::string text;
    std::string anchor;  // the widget that pulses while the hint is the newest, e.g. "slider.LR"; may be empty
    friend bool operator==(const Hint&, const Hint&) = default;
};

struct Exercise {
    std::string id;     // the file's stem: "05-aggressor"
    int number = 0;
    std::string title, goal, why;
    Scene scene;        // with the exercise's own settings applied
    std::uint64_t seed = 1;
    Prediction prediction;
    std::vector<Step> steps;
    std::vector<Hint> hints;
    float seconds = 20;  // how long a graded run lasts
    int starts = 10;     // seeds 1..starts are graded
    int needed = 8;      // so many of them must pass every step
    FourNeurons solution;
};

// Mistakes come with file and line. The scene's path is relative to the exercise's file.
Result<Exercise> load_exercise(const std::filesystem::path&);

}  // namespace braitenlab
