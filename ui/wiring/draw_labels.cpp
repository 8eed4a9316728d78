// The weights' labels on the wires.
#include <algorithm>
#include <string>

#include "ui/theme.h"
#include "ui/widgets/number.h"
#include "ui/wiring/draw.h"

namespace braitenlab {
namespace {

using maths::vec2;

// A cut wire's ends, bent apart across the label's left end.
void draw_cut(const Pen& pen, vec2 at, float size) {
    const Palette& p = pen.palette();
    for (const float side : {-1.0f, 1.0f})
        pen.list.AddLine(pen.at(at + vec2{side * size * 0.45f - size * 0.25f, size}),
                         pen.at(at + vec2{side * size * 0.45f + size * 0.25f, -size}), paint(p.warning),
                         pen.stroke(2.4f));
}

void draw_label(const Pen& pen, const CanvasPicture& picture, std::size_t index) {
    const Palette& p = pen.palette();
    const WireShape& shape = picture.layout.wires[index];
    const Wire* wire = shape.wire < 0 ? nullptr : &picture.graph.wires[static_cast<std::size_t>(shape.wire)];
    const bool cut = wire != nullptr && wire->cut, selected = picture.state.selection.wires.count(shape.ends) > 0;
    const Hit& over = picture.state.hovered;
    const bool hovered = (over.part == Part::wire || over.part == Part::label) && over.wire == shape.ends;
    const bool sketch = detail_of(pen) != Detail::full;  // letters larger there, or they cannot be read
    const float letters = sketch ? 20 : 17, grow = std::max(1.0f, pen.ui.px(least_type) / pen.size(letters));
    const vec2 extent = shape.label_size * grow, at = shape.label;
    const float value = wire == nullptr ? 0 : wire->weight;
    if (!shape.ghost) pen.halo(at + vec2{0, 1}, extent, extent.y / 2, 4, p.shadow.with_alpha(p.shadow.a * 0.3f));
    pen.box(at, extent, extent.y / 2, shape.ghost || cut ? p.panel : p.raised);
    if (selected) pen.frame(at, extent + vec2{6, 6}, extent.y / 2 + 3, 3, p.selected);
    const Colour rim = cut ? p.warning : shape.ghost ? p.line : colour_of_weight(p, value);
    pen.frame(at, extent, extent.y / 2, hovered || !shape.ghost ? 2 : 1.2f, hovered ? p.text : rim);
    if (cut) draw_cut(pen, at + vec2{extent.x / 2, 0}, extent.y * 0.42f);
    const std::string weight = shape.ghost ? fixed(0, 2) : with_sign(value, 2);
    const Colour ink = shape.ghost || cut ? p.second_text : p.text;
    if (!shape.direct) return pen.text(at, letters + 2, 0.5f, weight, ink);
    const float pad = (sketch ? 9.0f : 13.0f) * grow;
    pen.text(at - vec2{extent.x / 2 - pad, 0}, letters, 0, name_of(picture.graph, picture.layout, shape), p.second_text,
             Face::strong);
    pen.text(at + vec2{extent.x / 2 - pad, 0}, letters + 2, 1, weight, ink);
}

bool is_marked(const CanvasPicture& picture, const WireShape& shape) {
    return picture.state.hovered.wire == shape.ends || picture.state.selection.wires.count(shape.ends) > 0;
}

}  // namespace

void draw_labels(const Pen& pen, const CanvasPicture& picture) {
    const bool all = detail_of(pen) != Detail::map;
    for (std::size_t i = 0; i < picture.layout.wires.size(); ++i) {
        const WireShape& shape = picture.layout.wires[i];
        const vec2 half = shape.label_size / 2;
        if ((all || is_marked(picture, shape)) && picture.sees(shape.label - half, shape.label + half))
            draw_label(pen, picture, i);
    }
}

}  // namespace braitenlab
