// A picture of numbers over time, or of one number each: axes with round numbers and units, lines, and a read-out under
// the pointer. Drawn by hand on the draw list.
#pragma once

#include <optional>
#include <string_view>

#include <imgui.h>

#include "ui/widgets/ui.h"

namespace braitenlab {

// 1, 2 or 5 times a power of ten: the smallest such step that cuts `span` into at most `most` pieces. span > 0.
float round_step(float span, int most);

// What an axis spans, and the unit of its numbers (" s", "" …).
struct Axis {
    float low = 0, high = 1;
    std::string_view unit{};
    int decimals = 0;
    bool numbers = true;  // else the axis is bare
};

// The picture's ground with grid, numbers and units; returns where the lines go. The numbers stand outside of it.
Rect plot_ground(const Ui&, Rect outer, const Axis& x, const Axis& y);

// Where a point lies in the picture, held within it upwards and downwards.
ImVec2 plot_point(Rect inner, const Axis& x, const Axis& y, float at_x, float at_y);

// A line through `count` points: point(i) gives x and y as an ImVec2. NaN in y breaks it.
template <class Point>
void plot_line(const Ui&, Rect inner, const Axis& x, const Axis& y, std::size_t count, Colour, float layout_thickness,
               Point point);

// The x under the pointer, with a line drawn through it; nothing where the pointer is elsewhere.
std::optional<float> plot_cursor(const Ui&, Rect inner, const Axis& x);

// A quiet box of words beside the pointer, inside the picture: the read-out.
void plot_words(const Ui&, Rect inner, float pixel_x, const std::string_view* lines, const Colour* colours, int count);

// ------------------------------------------------------------------------------------------------------------------

namespace detail {
void stroke(const Ui&, Colour, float layout_thickness);  // what has been put into the draw list's path
void path_to(ImVec2);
}  // namespace detail

template <class Point>
void plot_line(const Ui& ui, Rect inner, const Axis& x, const Axis& y, std::size_t count, Colour colour,
               float thickness, Point point) {
    for (std::size_t i = 0; i < count; ++i) {
        const ImVec2 p = point(i);
        if (p.y != p.y)
            detail::stroke(ui, colour, thickness);
        else
            detail::path_to(plot_point(inner, x, y, p.x, p.y));
    }
    detail::stroke(ui, colour, thickness);
}

}  // namespace braitenlab
