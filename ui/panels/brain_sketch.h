// The strokes of the small picture of a brain: eyes, wheels and wires of a vehicle seen from above, nose up, hurt or
// not.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <imgui.h>

#include "ui/widgets/ui.h"

namespace braitenlab::sketch {

using WirePath = std::array<ImVec2, 4>;  // a cubic Bézier curve, window pixels

WirePath path(ImVec2 from, ImVec2 to);

// How near a point comes to the wire, window pixels.
float distance(const WirePath&, ImVec2);

// As wide as its weight, dashed where it has none, glowing with what it carries; ▶ excites, ● inhibits. A cut one has a
// gap with the knife's two strokes.
struct WireLook {
    float weight = 0, carried = 0;
    bool cut = false, warm = false;  // under the pointer
};
void wire(const Ui&, const WirePath&, const WireLook&);

// A covered eye wears a patch.
void eye(const Ui&, ImVec2 middle, float reading, bool covered, float warmth);

// The tread runs as the wheel turns; an arrow on the side of `outward` (−1 or 1) says how hard and which way. A stopped
// one is barred.
void wheel(const Ui&, ImVec2 middle, float outward, float motor, float angle, bool stopped, float warmth);

// Letters over a number, to the left or right of `at`.
void number(const Ui&, ImVec2 at, bool left, std::string_view letters, const std::string& value);

}  // namespace braitenlab::sketch
