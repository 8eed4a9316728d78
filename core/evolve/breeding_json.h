// The state of a breeding as the text of a file.
#pragma once

#include <string>
#include <string_view>

#include "core/evolve/breeding.h"

namespace braitenlab::evolve {

// read_state(write_state(s)) == s. Reading fails, with the file's name, for a text that write_state() has not written,
// and for the state of a breeding with other trials.
std::string write_state(const BreedingBase&, const BreedingState&);
Result<BreedingState> read_state(const BreedingBase&, std::string_view text, const std::string& file_name);

}  // namespace braitenlab::evolve
