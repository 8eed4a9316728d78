// The canvas's picture: a pen in canvas units, the state to draw, and the parts of the picture from the lowest to the
// uppermost. One source each for wires (draw_wires.cpp), nodes (draw_nodes.cpp) and what is above them
// (draw_cursor.cpp).
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include <imgui.h>

#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/canvas_state.h"

namespace braitenlab::wiring {

inline constexpr float too_small = 6;  // letters' heights, layout pixels
// Of a neuron's card: what is left of its words, for the curve, and beside them on both sides; units.
inline constexpr float before_neuron_text = 66, beside_neuron_text = 80;
inline constexpr float map_name_margin = 8;  // beside the letters in a neuron's card on the map of a lecture, units

// Draws in canvas units on Dear ImGui's draw list.
struct Pen {
    ImDrawList& list;
    const ui::Ui& ui;
    View view;

    const Palette& palette() const { return ui.palette; }
    float size(float units) const { return units * view.scale; }
    ImVec2 at(maths::vec2 unit) const {
        const maths::vec2 pixel = view.to_window(unit);
        return {pixel.x, pixel.y};
    }

    // A line's thickness in window pixels: `units`, at least 0.75 layout pixels.
    float stroke(float units) const;

    // The least height of a line, window pixels: letters of 11 layout pixels. More in a lecture.
    float least_type() const { return std::max(ui.px(11 * ui::line_height_em), ui.least_type); }

    // Text about `height` units high, at least least_type(), its point `anchor` (0..1 of its width, middle of its
    // height) at `unit`. Text wider than `room` units (0: no limit) is made smaller, down to least_type(), then cut;
    // captions (ui::Face::small) are left out instead, and so is text below too_small. Returns the rectangle of the
    // letters, window pixels; empty for text that is left out.
    Rect text(maths::vec2 unit, float height, float anchor, std::string_view, Colour, ui::Face = ui::Face::text,
              float room = 0) const;
    // True if text() cuts this text in a room of this width.
    bool cuts(std::string_view, ui::Face, float room) const;

    void box(maths::vec2 centre, maths::vec2 size, float rounding, Colour) const;
    void frame(maths::vec2 centre, maths::vec2 size, float rounding, float thickness, Colour) const;

    // Light or shadow around a box, brightest at its rim and fading over `reach` units. One small mesh, because a large
    // brain has many.
    void halo(maths::vec2 centre, maths::vec2 size, float rounding, float reach, Colour) const;

    // A small disc with few vertices, window pixels.
    void dot(ImVec2 middle, float radius, ImU32 colour) const;
};

// The level of detail at the pen's zoom.
enum class Detail { map, sketch, full };  // boxes and lines; with text as large as it fits; everything
Detail detail_of(const Pen&);

// The room that the pen's letters need in the layout of a brain, the labels of free places left out between
// neurons where labels are large.
LetterRoom letter_room(const Pen&, const LabView&, const VehicleView&, const BrainGraph&);

// The height of a label's letters at this level of detail, units, where they are not enlarged.
inline float label_letters(Detail detail) { return detail == Detail::full ? 17.0f : 20.0f; }

// The state to draw.
struct Picture {
    const LabView& view;
    const VehicleView& vehicle;
    const BrainGraph& graph;
    const Layout& layout;
    const Readings& readings;
    const CanvasState& state;
    maths::vec2 low, high;  // corners of the visible canvas, canvas units

    // True when part of a box between two corners, with the margin of a card's glow around it, is visible.
    bool is_visible(maths::vec2 from, maths::vec2 to) const {
        constexpr float glow = 24;
        return to.x + glow > low.x && from.x - glow < high.x && to.y + glow > low.y && from.y - glow < high.y;
    }
};

// The canvas's background with a grid of dots.
void draw_ground(const Pen&, Rect area);

// Records the anchors of all visible nodes, pins and wires and of the selection, and draws the highlighted one.
void record_anchors(ui::Ui&, const Pen&, const Picture&, Rect area);

// Curves, signals and end signs of the wires; the labels with the weights.
void draw_wires(const Pen&, const Picture&);
void draw_labels(const Pen&, const Picture&);

// The sign at a wire's end, pointing right at `tip`: ▶ excites, ● inhibits.
void draw_end_sign(const Pen&, maths::vec2 tip, float size, bool excites, Colour);

// The signal's dots move along a wire with every tick: distance of the first one from the start of the wire; the others
// follow at `dot_gap`.
inline constexpr float dot_gap = 44;  // units
float first_dot(std::uint64_t tick);

// The input at the right end of a neuron's curve glyph, at least 1: the glyph always contains the step or the peak.
float glyph_reach(const Curve&);

// The name of a node on its card: in a lecture a neuron of a shipped brain has one in words.
std::string shown_name(const ui::Ui&, const LabView&, const VehicleView&, const Node&);

// Cards with name, value and icon, and their pins.
void draw_nodes(const Pen&, const Picture&);

// True if the card of the node cannot show its whole name.
bool cuts_name(const Pen&, const Picture&, const NodeShape&);

void draw_minimap(const Pen&, const Picture&, Rect area);

// The selected node's sum or description, the wire or box being dragged, and the reason of a refusal.
void draw_cursor(const Pen&, const Picture&, const CanvasFrame&);

}  // namespace braitenlab::wiring
