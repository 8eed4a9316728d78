// Drawing of the brain picture: sensors, wheels and wires of a vehicle seen from above, with lesions.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <imgui.h>

#include "ui/widgets/ui.h"

namespace braitenlab::ui::sketch {

using WirePath = std::array<ImVec2, 4>;  // a cubic Bézier curve, window pixels

WirePath path(ImVec2 from, ImVec2 to);

// Distance of a point from the wire, window pixels.
float distance(const WirePath&, ImVec2);

// Width: |weight|; dashed for weight 0. Brightness: the signal. End sign: ▶ excites, ● inhibits. A cut wire has a gap
// with a cross.
struct WireLook {
    float weight = 0, carried = 0;
    bool cut = false, warm = false;  // warm: under the pointer
    bool thin = false;               // for a picture with many wires
};
void wire(const Ui&, const WirePath&, const WireLook&);

// A silenced sensor is dark with a cross. `radius`: layout pixels.
void eye(const Ui&, ImVec2 middle, float radius, float reading, bool silenced, float warmth);

// Filled in the colour of its sign, brighter with |value|. A silenced neuron has a cross. `radius`: window pixels.
void neuron(const Ui&, ImVec2 middle, float radius, float value, bool silenced, float warmth);

// The tread moves as the wheel turns. An arrow on the side `outward` (−1 or 1) shows the wheel command. A stopped wheel
// has a cross.
void wheel(const Ui&, ImVec2 middle, float outward, float motor, float angle, bool stopped, float warmth);

// A name above a number, to the left or right of `at`.
void number(const Ui&, ImVec2 at, bool left, std::string_view letters, const std::string& value);

}  // namespace braitenlab::ui::sketch
