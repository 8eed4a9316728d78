#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "ui/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/draw.h"
#include "ui/wiring/edits.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

constexpr vec2 note_padding{spacing::medium, spacing::small};

// The size of a note, window pixels.
ImVec2 note_size(const Ui& ui, std::string_view words) {
    ImFont* face = font(ui, Face::text);
    const char* end = words.data() + words.size();
    const ImVec2 extent = face->CalcTextSizeA(compat::size_of(face), 1e9f, 0, words.data(), end);
    return {extent.x + ui.px(2 * note_padding.x), extent.y + ui.px(2 * note_padding.y)};
}

// The position inside the area that is nearest to `at`, for a note of this size.
ImVec2 kept_inside(const Ui& ui, ImVec2 at, ImVec2 size, Rect area) {
    const float rim = ui.px(spacing::tight);
    const auto within = [rim](float wanted, float length, float low, float extent) {
        return std::floor(std::clamp(wanted, low + rim, std::max(low + rim, low + extent - length - rim)));
    };
    return {within(at.x, size.x, area.x, area.w), within(at.y, size.y, area.y, area.h)};
}

// A note with its upper left corner at `at` (window pixels), moved inside the area.
void draw_note(const Pen& pen, ImVec2 at, std::string_view words, Rect area, Colour edge) {
    const Ui& ui = pen.ui;
    const auto [w, h] = note_size(ui, words);
    at = kept_inside(ui, at, {w, h}, area);
    const ImVec2 far{at.x + w, at.y + h};
    const Palette& p = ui.palette;
    shadow_box(ui, pen.list, {at.x, at.y, w, h}, Corner::box, {6, 1.5f, 0.09f});
    pen.list.AddRectFilled(at, far, paint(p.raised), ui.px(radius::box));
    compat::outline(pen.list, at, far, paint(edge), ui.px(radius::box), ui.px(1.5f));
    put_on(pen.list, ui, {at.x + ui.px(note_padding.x), at.y + ui.px(note_padding.y)}, words, p.text, Face::text);
}

struct NoteBox {
    ImVec2 low, high;
    bool contains(ImVec2 p) const { return p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y; }
    bool overlaps(ImVec2 a, ImVec2 b) const { return a.x < high.x && b.x > low.x && a.y < high.y && b.y > low.y; }
};

constexpr int own_card_cover = 10000, card_cover = 100;  // by a note; a wire: 1

// What a note there would cover: its own card counts most, then other cards, weights and buttons, then wires.
int cards_covered_by(const Pen& pen, const Layout& layout, const NodeShape& own, const NoteBox& note) {
    int sum = 0;
    for (const NodeShape& other : layout.nodes)
        if (note.overlaps(pen.at(other.centre - other.size / 2), pen.at(other.centre + other.size / 2)))
            sum += other.id == own.id ? own_card_cover : card_cover;
    for (const WireShape& wire : layout.wires)
        if (wire.label_size.x > 0 &&
            note.overlaps(pen.at(wire.label - wire.label_size / 2), pen.at(wire.label + wire.label_size / 2)))
            sum += card_cover;
    for (const char* button : {"canvas.fit", "canvas.arrange"})
        if (const Rect* at = pen.ui.anchors.find(button))
            if (note.overlaps({at->x, at->y}, {at->x + at->w, at->y + at->h})) sum += card_cover;
    return sum;
}

int covered_by(const Pen& pen, const Layout& layout, const NodeShape& own, const NoteBox& note) {
    constexpr int pieces = 24;
    int sum = cards_covered_by(pen, layout, own, note);
    for (const WireShape& wire : layout.wires) {
        if (wire.wire < 0) continue;
        bool covers = false;
        for (int i = 0; i <= pieces && !covers; ++i)
            covers = note.contains(pen.at(bezier_point(wire.bezier, static_cast<float>(i) / pieces)));
        sum += covers ? 1 : 0;
    }
    return sum;
}

struct NotePlace {
    ImVec2 at;  // its upper left corner, window pixels
    int covered = -1;
};

// Below the card, above it, beside it or at its corners, also farther away: the first place where the note covers
// least.
NotePlace beside_card(const Pen& pen, const Layout& layout, const NodeShape& shape, ImVec2 note, Rect area) {
    const ImVec2 low = pen.at(shape.centre - shape.size / 2), high = pen.at(shape.centre + shape.size / 2);
    NotePlace best;
    for (const float layout_gap : {spacing::medium, 36.0f, 72.0f, 120.0f}) {
        const float gap = pen.ui.px(layout_gap), middle = (low.y + high.y - note.y) / 2;
        const float left = low.x - gap - note.x, right = high.x + gap, above = low.y - gap - note.y,
                    below = high.y + gap;
        const ImVec2 places[]{{low.x, below}, {low.x, above}, {right, middle}, {left, middle},
                              {right, below}, {right, above}, {left, below},   {left, above}};
        for (const ImVec2 wanted : places) {
            const ImVec2 at = kept_inside(pen.ui, wanted, note, area);
            const int covered = covered_by(pen, layout, shape, {at, {at.x + note.x, at.y + note.y}});
            if (best.covered < 0 || covered < best.covered) best = {at, covered};
            if (covered == 0) return best;
        }
    }
    return best;
}

// The place in the area that is nearest to the card and covers no card.
std::optional<ImVec2> free_of_cards(const Pen& pen, const Layout& layout, const NodeShape& shape, ImVec2 note,
                                    Rect area) {
    const ImVec2 middle = pen.at(shape.centre);
    const float step = pen.ui.px(spacing::medium);
    std::optional<ImVec2> best;
    float least = 0;
    for (float y = area.y; y <= area.y + area.h - note.y; y += step)
        for (float x = area.x; x <= area.x + area.w - note.x; x += step) {
            const ImVec2 at = kept_inside(pen.ui, {x, y}, note, area);
            const float away = std::hypot(at.x + note.x / 2 - middle.x, at.y + note.y / 2 - middle.y);
            if (best && away >= least) continue;
            if (cards_covered_by(pen, layout, shape, {at, {at.x + note.x, at.y + note.y}}) == 0)
                best = at, least = away;
        }
    return best;
}

float learned_now(const Picture& picture, const Wire& wire) {
    return learns(wire) ? learned(*picture.view.now, picture.vehicle, wire.from, wire.to) : 0;
}

// The text of a refusal; that of a full brain contains the limit.
std::string refusal_text(const Ui& ui, std::string_view key) {
    const int most = key == "wiring.refused.neurons" ? limits::neurons : limits::wires;
    return fill(ui.strings(key), {std::to_string(most)});
}

// At the selected node.
void draw_sum(const Pen& pen, const Picture& picture, Rect area) {
    const CanvasSelection& selection = picture.state.selection;
    if (selection.nodes.size() != 1 || !selection.wires.empty()) return;
    const NodeShape* shape = find_shape(picture.layout, *selection.nodes.begin());
    if (shape == nullptr) return;
    const Snapshot& now = *picture.view.now;
    std::function<std::string(NodeId)> named;  // in a lecture, where the audience does not follow each wire
    if (picture.view.lecture)
        named = [&](NodeId id) {
            const Node* from = find_node(picture.graph, id);
            return from ? shown_name(pen.ui, picture.view, picture.vehicle, *from) : std::string();
        };
    const std::string sum = sum_text(
        picture.graph, shape->id, [&](NodeId id) { return node_value(now, picture.vehicle, id); },
        [&](const Wire& wire) { return learned_now(picture, wire); }, pen.ui.decimal_mark, named);
    if (sum.empty()) return;
    // In one line where the area is as wide, else in several shorter ones. Where no place is left between the cards the
    // inspector shows it alone.
    const float width = note_size(pen.ui, sum).x - 2 * pen.ui.px(note_padding.x);
    const float widest = area.w - 2 * pen.ui.px(note_padding.x + spacing::tight);
    for (const float share : {1.0f, 0.55f, 0.4f}) {
        const float most = std::min(share * width, widest);
        const std::string words = most < width ? wrapped_at_spaces(pen.ui, Face::text, sum, most) : sum;
        const ImVec2 size = note_size(pen.ui, words);
        NotePlace place = beside_card(pen, picture.layout, *shape, size, area);
        if (place.covered >= card_cover) {
            const auto free = free_of_cards(pen, picture.layout, *shape, size, area);
            if (!free) continue;
            place.at = *free;
        }
        draw_note(pen, place.at, words, area, pen.palette().second_text);
        return pen.ui.anchors.record("canvas.sum", {place.at.x, place.at.y, size.x, size.y});
    }
}

void draw_box(const Pen& pen, vec2 a, vec2 b) {
    const ImVec2 low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
    pen.list.AddRectFilled(low, high, paint(pen.palette().accent.with_alpha(0.14f)), pen.ui.px(radius::box));
    compat::outline(pen.list, low, high, paint(pen.palette().accent), pen.ui.px(radius::box), pen.ui.px(1.5f));
}

struct LooseWire {
    NodeId fixed;
    bool outwards;  // it starts at the fixed node
    vec2 end;       // its other end, canvas units
};

void draw_loose(const Pen& pen, const Picture& picture, const LooseWire& loose, Colour colour) {
    const NodeShape* start = find_shape(picture.layout, loose.fixed);
    if (start == nullptr) return;
    const auto b = loose.outwards ? wire_curve(start->out_pin(), loose.end) : wire_curve(loose.end, start->in_pin());
    pen.list.AddBezierCubic(pen.at(b[0]), pen.at(b[1]), pen.at(b[2]), pen.at(b[3]), paint(colour), pen.stroke(4),
                            wire_segments * 2);
    draw_end_sign(pen, b[3] - vec2{8, 0}, 15, true, colour);
}

ImVec2 beside(const Pen& pen, vec2 pixel) {
    return {pixel.x + pen.ui.px(spacing::large), pixel.y + pen.ui.px(spacing::medium)};
}

// From the pin to the pointer, or to the pin that it would be joined to.
void draw_dragged_wire(const Pen& pen, const Picture& picture, const CanvasFrame& frame) {
    const Drag& drag = picture.state.drag;
    const Palette& p = pen.palette();
    const WireDrop drop = drop_of(picture.state, frame);
    vec2 end = pen.view.to_canvas(frame.pointer.at);
    if (drop.what == WireDrop::What::connect) {
        const NodeShape* goal = find_shape(picture.layout, drag.outwards ? drop.ends.to : drop.ends.from);
        end = drag.outwards ? goal->in_pin() : goal->out_pin();
    }
    const bool refused = drop.what == WireDrop::What::refused, off = drop.what == WireDrop::What::take_off;
    const Colour colour = refused || off ? p.warning : drop.what == WireDrop::What::connect ? p.excites : p.accent;
    draw_loose(pen, picture, {drag.fixed, drag.outwards, end}, colour);
    const ImVec2 note = beside(pen, frame.pointer.at);
    if (refused) draw_note(pen, note, refusal_text(pen.ui, drop.reason), frame.area, p.warning);
    if (off) draw_note(pen, note, pen.ui.strings("wiring.take_off"), frame.area, p.warning);
    if (drop.what == WireDrop::What::new_neuron)
        draw_note(pen, note, pen.ui.strings("wiring.new_neuron"), frame.area, p.accent);
}

// A wire that is drawn with keys: to the node in focus.
void draw_joining(const Pen& pen, const Picture& picture, const CanvasFrame& frame) {
    const CanvasState& state = picture.state;
    const NodeShape *from = find_shape(picture.layout, *state.joining),
                    *to = find_shape(picture.layout, state.focus.node);
    if (from == nullptr || to == nullptr) return;
    const vec2 end = to == from ? from->out_pin() + vec2{90, 0} : to->in_pin();
    draw_loose(pen, picture, {from->id, true, end}, pen.palette().accent);
    pen.frame(to->centre, to->size + vec2{10, 10}, 18, 3, pen.palette().accent);
    draw_note(pen, pen.at(to->centre + vec2{-to->size.x / 2, to->size.y / 2 + 12}), pen.ui.strings("wiring.joining"),
              frame.area, pen.palette().accent);
}

// The name of a node under a resting pointer, when its card cuts it; of a sensor or motor also its description, when
// its card is too small to show that.
void draw_description(const Pen& pen, const Picture& picture, const CanvasFrame& frame) {
    constexpr double rest_seconds = 0.5;
    const CanvasState& state = picture.state;
    const bool rests = !pen.ui.quiet && frame.wall_seconds - state.rest.since >= rest_seconds;
    if (!rests || state.hovered.part != Part::node) return;
    const Node* node = find_node(picture.graph, state.hovered.node);
    const NodeShape* shape = find_shape(picture.layout, state.hovered.node);
    if (node == nullptr || shape == nullptr) return;
    const bool has_description = node->kind != NodeKind::neuron && detail_of(pen) != Detail::full;
    if (!has_description && !cuts_name(pen, picture, *shape)) return;
    std::string words = node->name;
    if (has_description)
        words += ": " + std::string(pen.ui.strings(description_key(*picture.view.now, picture.vehicle, *node)));
    const ImVec2 at = beside_card(pen, picture.layout, *shape, note_size(pen.ui, words), frame.area).at;
    draw_note(pen, at, words, frame.area, pen.palette().second_text);
    pen.ui.anchors.record("says." + node->name, {frame.pointer.at.x, frame.pointer.at.y, 1, 1});
}

// The wire that the dragged neuron would be inserted into.
void draw_insertion(const Pen& pen, const Picture& picture, const CanvasFrame& frame) {
    const auto into = insertion_of(picture.state, frame);
    const WireShape* wire = into ? find_shape(picture.layout, *into) : nullptr;
    if (wire == nullptr) return;
    const auto& b = wire->bezier;
    const Palette& p = pen.palette();
    pen.list.AddBezierCubic(pen.at(b[0]), pen.at(b[1]), pen.at(b[2]), pen.at(b[3]), paint(p.accent.with_alpha(0.5f)),
                            pen.stroke(12), wire_segments * 2);
    draw_note(pen, beside(pen, frame.pointer.at), pen.ui.strings("wiring.insert_here"), frame.area, p.accent);
}

}  // namespace

void draw_cursor(const Pen& pen, const Picture& picture, const CanvasFrame& frame) {
    const CanvasState& state = picture.state;
    const DragPhase phase = state.drag.phase;
    if (!state.menu.open() && phase == DragPhase::idle && !state.joining) draw_sum(pen, picture, frame.area);
    if (!state.menu.open() && phase == DragPhase::idle && !state.joining) draw_description(pen, picture, frame);
    if (phase == DragPhase::drag_wire) draw_dragged_wire(pen, picture, frame);
    if (phase == DragPhase::box) draw_box(pen, state.drag.press, frame.pointer.at);
    if (phase == DragPhase::move_nodes) draw_insertion(pen, picture, frame);
    if (state.joining) draw_joining(pen, picture, frame);
    const Hit& loose = state.menu.loose;
    if (state.menu.open() && loose.part != Part::nothing)
        draw_loose(pen, picture, {loose.node, loose.part == Part::out_pin, state.menu.canvas_at}, pen.palette().accent);
    if (state.refusal.key.empty() || frame.wall_seconds >= state.refusal.until) return;
    draw_note(pen, beside(pen, state.refusal.at), refusal_text(pen.ui, state.refusal.key), frame.area,
              pen.palette().warning);
    pen.ui.anchors.record("refused." + state.refusal.key.substr(state.refusal.key.rfind('.') + 1),
                          {state.refusal.at.x, state.refusal.at.y, 1, 1});
}

void draw_minimap(const Pen& pen, const Picture& picture, Rect area) {
    const auto map = minimap_of(picture.layout, pen.view, area, pen.ui.scale);
    if (!map) return;
    const Palette& p = pen.palette();
    const Rect& r = map->rect;
    fill_box(pen.ui, r, p.panel.with_alpha(0.92f));
    pen.list.PushClipRect({r.x, r.y}, {r.x + r.w, r.y + r.h}, true);
    for (const NodeShape& node : picture.layout.nodes) {
        const bool selected = picture.state.selection.nodes.count(node.id) > 0;
        const vec2 low = map->view.to_window(node.centre - node.size / 2);
        const vec2 high = map->view.to_window(node.centre + node.size / 2);
        const Colour colour = selected ? p.selected : node.kind == NodeKind::neuron ? p.second_text : p.accent;
        pen.list.AddRectFilled({low.x, low.y}, {std::max(high.x, low.x + 1.5f), std::max(high.y, low.y + 1.5f)},
                               paint(colour));
    }
    const vec2 low = map->view.to_window(picture.low), high = map->view.to_window(picture.high);
    pen.list.AddRectFilled({low.x, low.y}, {high.x, high.y}, paint(p.text.with_alpha(0.07f)));
    compat::outline(pen.list, {low.x, low.y}, {high.x, high.y}, paint(p.text), 0, pen.ui.px(1.5f));
    pen.list.PopClipRect();
    line_box(pen.ui, r, p.line);
    pen.ui.anchors.record("canvas.minimap", r);
}

}  // namespace braitenlab::wiring
