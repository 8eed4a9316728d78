// What the drawings with axes share: frames with ticks, words, the scale of colours, and labels with an outline.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ui/map_look.h"
#include "ui/words/strings.h"

namespace braitenlab {

inline constexpr const char* axis_ink = "#1c1c1a";

// The step between ticks: 1, 2 or 5 times a power of ten, so that there are at most seven. `range` > 0.
float tick_step(float range);

// The multiples of the step from the smaller end to the larger one.
std::vector<float> axis_ticks(float a, float b, float step);

// The number at a tick, with the decimals that the step needs.
std::string tick_text(float value, float step, const Strings&);

// Of M. Okabe and K. Ito's colours, those that are dark enough on white, and more of other lightness.
inline constexpr std::array<const char*, 8> series_colours{"#0072b2", "#d55e00", "#007a5a", "#a3477f",
                                                           "#4a4a46", "#8a6d00", "#5b3fa0", "#2f9ccc"};

// A group of elements, moved.
std::string placed(float x, float y, std::string_view content);

// A text of 13 px. `more`: attributes, with a space before each.
std::string words_at(float x, float y, std::string_view words, std::string_view more = "");

// The frame of a drawing from (0, 0) on. An axis has its ends in ascending or descending order, never equal.
struct PlotFrame {
    struct Axis {
        double from = 0, to = 1;
        float least_step = 0;         // between ticks: 1 for whole numbers
        std::vector<double> cells{};  // where not empty: the only values, ascending, at equal distances
        float share(double value) const;
    };
    float width = 0, height = 0;  // px
    Axis x, y;                    // from the left to the right, from the bottom to the top
    float inset = 0;              // px, between the frame and the ends of the axes, as for cells: half a cell

    float x_of(double value) const { return inset + x.share(value) * (width - 2 * inset); }
    float y_of(double value) const { return height - inset - y.share(value) * (height - 2 * inset); }
};

// The frame with ticks, their numbers, and bold labels. It needs 92 px on the left and 50 px below.
std::string frame_svg(const PlotFrame&, std::string_view x_label, std::string_view y_label, const Strings&);

// "#0072b2".
std::string colour_text(const ui::MapColour&);

// The data of a path that is a square with its upper left corner at (x, y).
std::string square_data(float x, float y, float size);

// The scale of ui::scale_colour() with ticks: 264 px high, the colours 24 px below its top.
inline constexpr float scale_bottom = 264;
std::string scale_svg(const ui::MapScale&, const Strings&);

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
