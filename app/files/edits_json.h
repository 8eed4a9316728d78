// The undo history as JSON, for a run that another start of the lab continues.
#pragma once

#include <cstddef>
#include <optional>

#include "core/io/checked_json.h"
#include "core/session/session.h"

namespace braitenlab {

// The last `most` steps that can be undone, and as many that can be redone.
nlohmann::json edits_json(const Edits&, std::size_t most);

// nullopt for a value that edits_json() cannot have made. The commands are checked when they are executed.
std::optional<Edits> read_edits(const nlohmann::json&);

}  // namespace braitenlab
