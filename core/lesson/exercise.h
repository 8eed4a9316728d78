// An exercise as its author writes it: one TOML file of text, checks and a scene. The format: docs/exercise-format.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/brain/mutate.h"
#include "core/lesson/goals.h"
#include "core/result.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"
#include "core/scene/schema.h"
#include "core/scene/subject.h"
#include "core/scene/translatable.h"

namespace braitenlab {

struct Step {
    std::string text;
    Check check;
};

// What a run meets whose outcome is one of the options of a prediction.
struct ShownCheck {
    std::string option;  // its text; empty: the answer
    Check check;
};

// Asked before the outcome is visible, never graded. There is none when the question is empty.
struct Prediction {
    std::string question;
    std::vector<std::string> options;
    int answer = 0;       // index of the option that the run shows; in the file, the option's text
    std::string outcome;  // shown next to the student's own choice once a run has shown it
    float after = 3;      // simulated seconds of a run with the shipped brain after which the outcome is visible
    std::vector<ShownCheck> shows;  // tested in a run with the shipped brain and Exercise::seed of this duration
    bool hides_brain = false;       // until it is made, the brain's picture and the wires on the deck are not shown
    std::string path_of;  // name of the start whose path of the first `after` s can be drawn on the floor; empty: none
};
inline bool is_asked(const Prediction& prediction) { return !prediction.question.empty(); }

struct Hint {
    std::string text;
    std::string anchor;  // id of the widget that pulses while the hint is the newest, e.g. "slider.LR"; may be empty
};

// A submission stored in the file: the solution, or a plausible one that must fail.
struct Answer {
    std::string name, text;         // of a wrong answer: what it is, and feedback on it
    BrainText brain;                // replaces the shipped one if it has a dial or a node
    std::vector<Setting> settings;  // of the scene, applied before
    Submission submission;          // the result
};

// Selection by hand, for an exercise that offers "selection"; see core/lesson/selection.h.
struct SelectionRules {
    int children = 9;      // of each brain, 2..9
    int generations = 12;  // most choices
    Mutation mutation;     // how the children differ from their parent
    float first = 0;       // strength of the errors of the shipped brain's children, 0..2; 0: that of the others
};

// A comparison of medians over the starts: what a step measures in the student's runs, and in runs of the shipped brain
// from the same seeds.
struct MedianRule {
    int step = 0;      // from 1; 0: nothing is compared
    float factor = 2;  // what the step needs is this many times the median of the shipped brain
};

struct Exercise {
    std::string id;  // in the file, or exercise_id_of() it: "05-aggressor"
    int number = 0;
    int chapter = 0;  // of the course, from 1; 0: none
    std::string title, goal, why;
    std::string question;  // asked afterwards, never graded
    Scene scene;           // with the exercise's own settings applied
    std::uint64_t seed = 1;
    Prediction prediction;
    std::vector<Step> steps;
    std::vector<Hint> hints;
    std::vector<std::string> hides;   // kinds of the scene whose brains are never shown
    std::vector<std::string> offers;  // the controls that are shown, see parse_offer; empty: all
    SelectionRules selection;         // meaningful only if "selection" is offered
    int changes = 0;                  // most offered controls that may be changed; 0: any number
    float seconds = 20;               // duration of a graded run
    int starts = 10;                  // seeds 1..starts are graded
    int needed = 8;                   // number of starts that must pass every step
    MedianRule median;
    Answer solution;
    std::vector<Answer> wrong;
};

}  // namespace braitenlab
