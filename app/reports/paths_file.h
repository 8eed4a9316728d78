// The paths of all vehicles of a run over the floor of its scene, as an SVG file with scale bar and legend.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/session/recording.h"
#include "ui/words/strings.h"

namespace braitenlab {

// The text of the file: arena, zones, obstacles and sources as at tick `to`; the paths between the two ticks, each from
// a ring to an arrow. Up to eight vehicles have a colour and a name each, more of them those of their kinds.
std::string paths_file(const Recording&, std::uint64_t from, std::uint64_t to, std::string_view title, const Strings&);

}  // namespace braitenlab
