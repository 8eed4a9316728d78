// Text in a form that an editor does not show plainly: a scene file holds the brain of a kind with Kind::hidden so, and
// a saved run with such a kind is sealed as a whole. This is no protection: the program contains all that is needed to
// read it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/brain/graph.h"

namespace braitenlab {

// Letters a–p, two a byte: the text mixed with a fixed stream of random numbers, and a checksum of it.
std::string seal_text(std::string_view);

// nullopt for a text that seal_text() did not make.
std::optional<std::string> unseal_text(std::string_view letters);

// The brain file of core/scene/scene_file.h, sealed.
std::string seal(const BrainGraph&);

// nullopt for a text that seal() did not make.
std::optional<BrainGraph> unseal(std::string_view letters);

}  // namespace braitenlab
