// What a scene must be beyond well-formed: every value in its range, every name borne by something, every brain able to
// think.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/scene/brain_text.h"
#include "core/scene/scene.h"
#include "core/scene/schema.h"

namespace braitenlab {

// The first fault in the order of the description, with its path ("vehicle.one.facing"), or nothing.
std::optional<Fault> find_fault(const Scene&);
std::optional<Fault> find_fault(const BrainGraph&);

// "'LL' is 3, outside -2 .. 2".
std::string outside(std::string_view key, double value, Range);

// Why this cannot be a name, or nothing. Names are bare TOML keys, so that every path can be typed.
std::optional<std::string> name_fault(std::string_view name);

}  // namespace braitenlab
