// The arena of an exercise and the path of a run, from above, as SVG.
#pragma once

#include <string>

#include "core/lesson/exercise.h"
#include "core/lesson/grade.h"

namespace braitenlab {

struct PathPicture {
    float width = 96;         // px, of the picture; its height follows from the arena
    bool names = false;       // sources have their names
    bool has_sign = false;    // ✓ or ✕ in the corner
    std::size_t points = 60;  // most points of the path
};

// An <svg> element. Paths of starts that passed are solid, of others dashed, so that the colour does not tell alone.
// `label`: what the picture shows, for screen readers.
std::string path_picture(const Exercise&, const StartResult&, const std::string& label, const PathPicture& = {});

}  // namespace braitenlab
