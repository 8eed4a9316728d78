// What the drawings with axes share: ticks, words, and labels with an outline.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ui/strings.h"

namespace braitenlab {

inline constexpr const char* axis_ink = "#1c1c1a";

// The step between ticks: 1, 2 or 5 times a power of ten, so that there are at most seven. `range` > 0.
float tick_step(float range);

// The multiples of the step from the smaller end to the larger one.
std::vector<float> axis_ticks(float a, float b, float step);

// The number at a tick, with the decimals that the step needs.
std::string tick_text(float value, float step, const Strings&);

// A text of 13 px. `more`: attributes, with a space before each.
std::string words_at(float x, float y, std::string_view words, std::string_view more = "");

// A text over lines, on an outline of 3 px of the ground's colour. The outline is a text of its own below: LibreOffice
// 7.4 and CairoSVG 2.5 ignore paint-order and draw it over the letters.
std::string outlined_text(float x, float y, std::string_view anchor, std::string_view fill, std::string_view words);

// The room of a label, for those that must not overlap. Width and height are those of DejaVu Sans of 12 px.
struct LabelBox {
    float left = 0, right = 0, top = 0, bottom = 0;
};
LabelBox label_box(float x, float y, std::string_view anchor, std::string_view words);
bool is_free(const LabelBox&, const std::vector<LabelBox>& taken);

}  // namespace braitenlab
