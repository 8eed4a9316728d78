// The wiring diagram of a brain as SVG, for print.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/brain/graph.h"
#include "core/scene/scene.h"
#include "ui/words/strings.h"

namespace braitenlab {

// Sensors above, from the vehicle's left to its right, then the neurons in rows, motors below. A wire has its weight
// beside it, and at its end ▶ where it excites and ● where it inhibits; its width is |weight|. A cut wire is dashed, a
// silenced node is crossed out. Wires of weight 0 that do not learn are left out. Above 40 wires there are no weights.
std::string brain_drawing(const BrainGraph&, const std::vector<Sensor>&, const Strings&);

// The heading of a kind's brain: the scene's title, and the kind's name where the scene has several kinds.
std::string brain_heading(const Scene&, const Kind&);

// The same drawing as the text of an SVG file, larger and with a heading.
std::string brain_file(const BrainGraph&, const std::vector<Sensor>&, std::string_view heading, const Strings&);

}  // namespace braitenlab
