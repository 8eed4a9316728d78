// An exercise that an author makes from the open scene: what the window asks for, and the exercise made of it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/result.h"

namespace braitenlab {

// The brain that the student gets; the solution is the brain in the window. Without wires, it has the solution's
// drives.
enum class ShippedBrain { of_file, without_wires };

// A brain that must fail.
struct WrongDraft {
    std::string name;  // what it is, for reports
    BrainGraph brain;
};

// What the author decides. The scene is the open one.
struct ExerciseDraft {
    std::string title, goal;
    std::vector<std::string> hints;  // from a nudge to the solution
    std::string vehicle;             // name of the start that the exercise is about; empty: the first
    ShippedBrain ships = ShippedBrain::of_file;
    std::vector<std::string> offers;  // empty: all controls
    std::vector<Step> steps;
    Prediction prediction;  // without a question: none
    std::vector<WrongDraft> wrong;
    float seconds = 20;
    int starts = 10;
    float heading_spread = 15;  // °, 0..180; the heading of the vehicle's start varies with the seed by up to ± this
};

// The goals that a step of the scene can have, each with values that suit the scene: the nearest lamp, half a metre.
// Without those that combine checks, and without those whose objects the scene lacks.
std::vector<Goal> goals_for(const Scene&, std::string_view vehicle);

// The word of a goal in files: "touches".
std::string_view word_of(const Goal&);

// One parameter of a goal. Exactly one of the pointers is set; they are valid while the goal is.
struct GoalValue {
    std::string_view key, unit;
    Range range{0, 0};
    float* number = nullptr;
    int* count = nullptr;
    std::string* name = nullptr;
};
std::vector<GoalValue> values_of(Goal&);

// The objects of the scene that a parameter of this key can name. Sensors: those of the vehicle.
std::vector<std::string> names_for(std::string_view key, const Scene&, std::string_view vehicle);

// Index of the start that the draft is about. Precondition: the scene has a start.
std::size_t subject_start(const ExerciseDraft&, const Scene&);

// The exercise. `now`: the scene in the window at its start, with all edits; `file`: as it was read. The vehicle of the
// draft becomes the first one, and its own brain and sensors those of its kind. `id`: exercise_id_of() its file.
// Error: the scene has no start; the brain in the window is the one that ships, or one of the wrong ones.
Result<Exercise> make_exercise(const ExerciseDraft&, const std::string& id, const Scene& now, const Scene& file);

}  // namespace braitenlab
