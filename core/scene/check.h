// Validation of a scene or brain beyond its syntax: ranges, names, references between parts, brains that compile.
#pragma once

#include <optional>
#include <string_view>

#include "core/scene/brain_text.h"
#include "core/scene/scene.h"
#include "core/scene/schema.h"

namespace braitenlab {

// The first fault in the order of the schema, with its path ("vehicle.one.facing"), or nullopt.
std::optional<Fault> find_fault(const Scene&);
std::optional<Fault> find_fault(const BrainGraph&);

// "'LL' is 3, outside -2 .. 2".
Message outside(std::string_view key, double value, Range);

// Why the text is no valid name, or nullopt. Names are bare TOML keys, so paths need no quotes.
std::optional<Message> name_fault(std::string_view name);

}  // namespace braitenlab
