// Drawing in canvas units on Dear ImGui's draw list.
#pragma once

#include <string_view>

#include <imgui.h>

#include "ui/widgets/paint.h"
#include "ui/wiring/layout.h"

namespace braitenlab {

inline constexpr float least_type = 11, least_name = 8, too_small = 6;  // layout pixels

struct Pen {
    ImDrawList& list;
    const Ui& ui;
    View view;

    const Palette& palette() const { return ui.palette; }
    float size(float units) const { return units * view.scale; }
    ImVec2 at(maths::vec2 unit) const {
        const maths::vec2 pixel = view.to_window(unit);
        return {pixel.x, pixel.y};
    }
    // A line's thickness: `units`, but never so thin that it vanishes.
    float stroke(float units) const;

    // Words about `height` units tall, but never smaller than can be read, whose point `anchor` (0..1 of their width,
    // middle of their height) lies at `unit`. Where they would be wider than `room` units (0: any width) they are
    // smaller, then cut short (down to least_name), or left out if they are a caption (Face::small). Left out, too,
    // where they were to be tiny.
    void text(maths::vec2 unit, float height, float anchor, std::string_view, Colour, Face = Face::text,
              float room = 0) const;

    void box(maths::vec2 centre, maths::vec2 size, float rounding, Colour) const;
    void frame(maths::vec2 centre, maths::vec2 size, float rounding, float thickness, Colour) const;

    // Light or shadow around a box that fades over `reach` units, brightest at its rim and behind it. One small mesh,
    // since a large brain has many.
    void halo(maths::vec2 centre, maths::vec2 size, float rounding, float reach, Colour) const;

    // A small disc, of window pixels and as cheap as can be: signals are many.
    void dot(ImVec2 middle, float radius, ImU32 colour) const;
};

}  // namespace braitenlab
