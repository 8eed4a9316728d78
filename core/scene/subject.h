// The subject of an exercise: the kind of the scene's first start. A student may change its brain, its sensors and its
// body, and nothing else; these are the submission.
#pragma once

#include <vector>

#include "core/brain/graph.h"
#include "core/scene/scene.h"

namespace braitenlab {

// Index of the subject's kind, in a scene that passes check_scene; −1 if the scene has no start.
int subject_kind(const Scene&);

// Everything that the student may change.
struct Submission {
    BrainGraph brain;
    std::vector<Sensor> sensors;
    Body body;
    friend bool operator==(const Submission&, const Submission&) = default;
};

Submission submission_of(const Kind&);
Kind with_submission(Kind, Submission);

// True if the kinds are equal but for what a student may change.
bool differ_in_submission_only(const Kind&, const Kind&);

}  // namespace braitenlab
