// The brain of a file that holds one or several: a brain file, a scene, a saved run or a hand-in.
#pragma once

#include <string>
#include <vector>

#include "core/brain/graph.h"
#include "core/lesson/submission.h"
#include "core/result.h"
#include "core/scene/scene.h"

namespace braitenlab {

// Which brain of a scene or a saved run; at most one of the two is given. A brain file and a hand-in have one brain,
// whatever they say.
struct BrainChoice {
    std::string kind;     // name of a kind
    std::string vehicle;  // name of a placed vehicle; in a saved run also the id of any vehicle
};

struct BrainOfFile {
    BrainGraph brain;
    std::string owner;              // "kind coward", "vehicle one", "hand-in of Ana"; empty for a brain file
    std::vector<Sensor> sensors{};  // of the kind, the vehicle or the hand-in; empty for a brain file
    float length = 0, width = 0;    // m, of the body; 0: of a hand-in or a brain file
    float ambient = 0, lux = 0;     // of the arena; 0: of a hand-in or a brain file
};

// Reads the brain of a file, which is a path or the name of a shipped scene. Without a choice: of a scene, the brain of
// the first vehicle's kind; of a saved run, the brain that the first vehicle has, or its kind's when it is gone.
// Without placed vehicles: the brain of the first kind. Fails for an exercise, a file that cannot be read, a
// hidden brain, and an unknown choice, with the nearest name.
Result<BrainOfFile> brain_of_file(const std::string& file, const BrainChoice&);

// The same for the text of a file that is no saved run. `file`: its name in errors.
Result<BrainOfFile> brain_of_text(const std::string& text, const std::string& file, const BrainChoice&);

// The brain as an answer to the exercise; with the file's sensors, if it has some and the exercise offers sensors.
Submission submission_with(const Exercise&, BrainOfFile);

}  // namespace braitenlab
