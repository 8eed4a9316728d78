// Commands as a JSON text, for what is kept beside a run.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/world/command.h"

namespace braitenlab::io {

std::string write_commands(const std::vector<Command>&);

// nullopt for a text that write_commands() cannot have written. A world checks the values when it executes a command.
std::optional<std::vector<Command>> read_commands(std::string_view text);

}  // namespace braitenlab::io
