// Brains in a form that an editor does not show plainly: a scene file holds the brain of a kind with Kind::hidden so.
// This is no protection: the program contains all that is needed to read it, and so does a saved run.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/brain/graph.h"

namespace braitenlab {

// Letters a–p, two a byte: the brain file of core/scene/scene_file.h mixed with a fixed stream of random numbers, and a
// checksum of it.
std::string seal(const BrainGraph&);

// nullopt for a text that seal() did not make.
std::optional<BrainGraph> unseal(std::string_view);

}  // namespace braitenlab
