// The canvas's picture: ground, wires, cards, and what goes on under the cursor.
#pragma once

#include "ui/wiring/interaction.h"
#include "ui/wiring/moment.h"
#include "ui/wiring/pen.h"

namespace braitenlab {

struct CanvasPicture {
    const LabView& view;
    const VehicleView& vehicle;
    const BrainGraph& graph;
    const Layout& layout;
    const CanvasMoment& moment;
    const CanvasState& state;
    maths::vec2 low, high;  // corners of what can be seen, canvas units

    // Whether anything between two corners can be seen, with room for a card's glow around it.
    bool sees(maths::vec2 from, maths::vec2 to) const {
        constexpr float glow = 24;
        return to.x + glow > low.x && from.x - glow < high.x && to.y + glow > low.y && from.y - glow < high.y;
    }
};

void draw_ground(const Pen&, Rect area);
void draw_wires(const Pen&, const CanvasPicture&);
void draw_labels(const Pen&, const CanvasPicture&);
void draw_nodes(const Pen&, const CanvasPicture&);

// The selected neuron's sum, the wire or box being drawn, and the reason of a refusal.
void draw_cursor(const Pen&, const CanvasPicture&, const CanvasFrame&);

// The open menu, at the place that it gets here, and the small picture of a large brain.
void draw_menu(const Pen&, CanvasMenu&, Rect area);
void draw_minimap(const Pen&, const CanvasPicture&, Rect area);

// The sign at a wire's end, pointing right at `tip`: ▶ excites, ● inhibits.
void draw_end_sign(const Pen&, maths::vec2 tip, float size, bool excites, Colour);

// What stands on a card: an almond with an iris that opens and lights up with what it sees, a wheel seen from its side
// (rad), a response curve with a dot where the neuron stands, a bar from 0 to the value.
void draw_eye(const Pen&, maths::vec2 centre, float value, bool covered);
void draw_wheel(const Pen&, maths::vec2 centre, float angle, float value, bool stopped);
void draw_response(const Pen&, maths::vec2 centre, const Curve&, float value);
void draw_bar(const Pen&, maths::vec2 left, float width, float value, bool both_sides);
void draw_pin(const Pen&, maths::vec2 at, float spread, bool hovered, bool inviting, bool out);

// Where the dots of a signal stand along every wire at this tick: the first one's distance from the start, then one
// every `dot_gap`. A tick moves them on.
inline constexpr float dot_gap = 44;  // units
float first_dot(std::uint64_t tick);

// How much of the picture is worth drawing at this size.
enum class Detail { map, sketch, full };  // boxes and lines; words as large as they fit; everything
Detail detail_of(const Pen&);

}  // namespace braitenlab
