// Charts: axes with round numbers and units, lines, and a read-out under the pointer.
#pragma once

#include <optional>
#include <string_view>

#include <imgui.h>

#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// The smallest of 1, 2 or 5 times a power of ten that divides `span` into at most `most` pieces. span > 0.
double round_step(double span, int most);

// Range of an axis, and the unit of its numbers (" s", "" …). Doubles: steps of a float are as long as half a second
// after 50 days.
struct Axis {
    double low = 0, high = 1;
    std::string_view unit{};
    int decimals = 0;
    bool numbers = true;  // false: neither grid lines nor numbers
};

struct PlotPoint {
    double x = 0, y = 0;
};

// Background, grid, numbers and units. Returns the rectangle of the lines; the numbers are outside of it.
Rect plot_ground(const Ui&, Rect outer, const Axis& x, const Axis& y);

// The pixel of a point, clamped vertically to the chart.
ImVec2 plot_point(Rect inner, const Axis& x, const Axis& y, PlotPoint);

// A line through `count` points: point(i) gives a PlotPoint. NaN in y breaks it.
template <class Point>
void plot_line(const Ui&, Rect inner, const Axis& x, const Axis& y, std::size_t count, Colour, float layout_thickness,
               Point point);

// The x under the pointer, with a vertical line; nullopt when the pointer is outside.
std::optional<double> plot_cursor(const Ui&, Rect inner, const Axis& x);

// The read-out: a box of lines beside the pointer, inside the chart.
void plot_words(const Ui&, Rect inner, float pixel_x, const std::string_view* lines, const Colour* colours, int count);

// ------------------------------------------------------------------------------------------------------------------

namespace detail {
void stroke(const Ui&, Colour, float layout_thickness);  // draws the path of the draw list
void path_to(ImVec2);
}  // namespace detail

template <class Point>
void plot_line(const Ui& ui, Rect inner, const Axis& x, const Axis& y, std::size_t count, Colour colour,
               float thickness, Point point) {
    for (std::size_t i = 0; i < count; ++i) {
        const PlotPoint p = point(i);
        if (p.y != p.y)
            detail::stroke(ui, colour, thickness);
        else
            detail::path_to(plot_point(inner, x, y, p));
    }
    detail::stroke(ui, colour, thickness);
}

}  // namespace braitenlab::ui
