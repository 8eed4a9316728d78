#include "ui/wiring/draw.h"

#include <array>
#include <cmath>

#include "core/maths/portable.h"
#include "core/scene/sensor_edits.h"
#include "core/utf8.h"
#include "ui/imgui_compat.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/theme.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

struct Type {
    ImFont* font;
    float pixels;
};

// The loaded font nearest to the wanted size, at its own size when that is close: slightly scaled letters are blurred.
Type type_for(const Ui& ui, Face face, float pixels) {
    const bool bold = face == Face::strong || face == Face::title;
    const Face choices[2] = {bold ? Face::strong : Face::small, bold ? Face::title : Face::text};
    for (const Face choice : choices) {
        ImFont* loaded = font(ui, choice);
        const float own = compat::size_of(loaded);
        if (pixels < own * 0.9f) return {loaded, pixels};
        if (pixels < own * 1.13f) return {loaded, own};
    }
    return {font(ui, Face::title), pixels};
}

// As many characters as fit, then "…".
template <class Fits>
std::string fitted(std::string_view words, Fits fits) {
    std::string text(words);
    while (!fits(text) && !words.empty()) {
        words = words.substr(0, character_start(words, words.size() - 1));
        text = std::string(words) + "…";
    }
    return text;
}

constexpr int corner_steps = 6;  // of a quarter circle
constexpr int rim_points = 4 * (corner_steps + 1);

// Unit vectors from a rounded box's corner centres to its rim, clockwise from the right.
const std::array<ImVec2, rim_points>& rim() {
    static const std::array<ImVec2, rim_points> points = [] {
        std::array<ImVec2, rim_points> made;
        for (int i = 0; i < rim_points; ++i) {
            const int quarter = i / (corner_steps + 1), step = i % (corner_steps + 1);
            const float turn = (static_cast<float>(quarter) + static_cast<float>(step) / corner_steps) * maths::pi / 2;
            made[static_cast<std::size_t>(i)] = {maths::cosine(turn), maths::sine(turn)};
        }
        return made;
    }();
    return points;
}

// Fills the inner rim with one colour that fades out towards the outer rim. Both rims have `count` points in pairs:
// inner, outer, inner, outer …
void fade_out(ImDrawList& list, const ImVec2* pairs, int count, ImU32 colour) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    list.PrimReserve(3 * (count - 2) + 6 * count, 2 * count);
    const unsigned first = list._VtxCurrentIdx;
    const auto corner = [&](int i) { list.PrimWriteIdx(static_cast<ImDrawIdx>(first + static_cast<unsigned>(i))); };
    const auto triangle = [&](int a, int b, int c) { corner(a), corner(b), corner(c); };
    for (int i = 2; i < count; ++i) triangle(0, 2 * i - 2, 2 * i);
    for (int i = 0; i < count; ++i) {
        const int here = 2 * i, next = 2 * ((i + 1) % count);
        triangle(here, next, next + 1);
        triangle(here, next + 1, here + 1);
    }
    for (int i = 0; i < 2 * count; ++i)
        list.PrimWriteVtx(pairs[i], white, i % 2 == 0 ? colour : colour & ~IM_COL32_A_MASK);
}

// The least width of a neuron's card in which every neuron's name is whole, and beside its curve also the widest
// number, within the gap of two columns. On the map of many nodes a card is as wide as the wires beside it allow.
float neuron_width(const Pen& pen, const LabView& view, const VehicleView& vehicle, const BrainGraph& graph) {
    constexpr float on_large_map = 240;  // units
    const bool map = detail_of(pen) == Detail::map;
    const float usual = LetterRoom{}.neuron_width, most = 1.6f * usual;
    const float least = map && graph.nodes.size() > few_nodes ? on_large_map : usual;
    const float own = compat::size_of(font(pen.ui, Face::strong)), height = pen.least_type() / pen.view.scale;
    const float beside = map ? 2 * map_name_margin : beside_neuron_text;
    float widest = map ? 0 : text_width(pen.ui, Face::text, with_sign(pen.ui, 1, 2));
    for (const Node& node : graph.nodes)
        if (node.kind == NodeKind::neuron)
            widest = std::max(widest, text_width(pen.ui, Face::strong, shown_name(pen.ui, view, vehicle, node)));
    return std::clamp(std::ceil(widest * height / own) + beside, least, most);
}

// The obstacle sensors of a brain that a lecture watches, beside four numbers of another channel: they keep the vehicle
// away from walls and are not what the lecture is about.
std::vector<NodeId> sensors_aside(const LabView& view, const VehicleView& vehicle, const BrainGraph& graph) {
    const std::vector<Sensor>& sensors = kind_of(*view.now, vehicle).sensors;
    const auto reads_obstacles = [&](const Node& node) {
        const Sensor* sensor = find_sensor(sensors, node.name);
        return sensor != nullptr && sensor->channel == Channel::obstacle;
    };
    std::vector<NodeId> aside;
    bool has_subject = false;
    for (const Node& node : graph.nodes) {
        if (node.kind != NodeKind::sensor) continue;
        if (reads_obstacles(node))
            aside.push_back(node.id);
        else
            has_subject = true;
    }
    return has_subject ? aside : std::vector<NodeId>{};
}

// Records an anchor whose centre is in the area and draws the highlight around the highlighted one.
void record_anchor(Ui& ui, Rect area, const std::string& id, Rect rect) {
    if (!area.contains(rect.middle())) return;
    ui.anchors.record(id, rect);
    if (ui.highlight == id) point_out(ui, rect);
}

// Parameter of a point of the curve that the label does not cover.
float clear_of_label(const WireShape& wire) {
    const float t = 0.7f;
    const vec2 away = bezier_point(wire.bezier, t) - wire.label;
    const bool covered = std::abs(away.x) < wire.label_size.x / 2 + 6 && std::abs(away.y) < wire.label_size.y / 2 + 6;
    return covered ? 0.45f : t;
}

void record_selected(Ui& ui, const BrainGraph& graph, const Layout& layout, const View& view,
                     const CanvasSelection& selection) {
    for (const NodeId id : selection.nodes)
        if (const NodeShape* node = find_shape(layout, id))
            ui.anchors.record("selected." + graph.nodes[node->node].name, node_rect(view, *node));
    for (const WireEnds& ends : selection.wires)
        if (const WireShape* wire = find_shape(layout, ends))
            ui.anchors.record("selected." + name_of(graph, layout, *wire), label_rect(view, *wire));
}

}  // namespace

float Pen::stroke(float units) const { return std::max(size(units), ui.px(0.75f)); }

Rect Pen::text(vec2 unit, float height, float anchor, std::string_view words, Colour colour, Face face,
               float room) const {
    if (words.empty() || size(height) < ui.px(too_small)) return {};
    const float least = least_type();
    Type type = type_for(ui, face, std::max(size(height), least));
    const auto width_of = [&](std::string_view part) {
        return type.font->CalcTextSizeA(type.pixels, 1e9f, 0, part.data(), part.data() + part.size()).x;
    };
    float width = width_of(words);
    std::string shortened;
    if (room > 0 && width > size(room)) {
        const float fitting = type.pixels * size(room) / width;
        if (fitting < least && face == Face::small) return {};  // an unreadable caption is left out
        type.pixels = std::max(fitting, least);
        shortened = fitted(words, [&](std::string_view part) { return width_of(part) <= size(room) + 1; });
        if (ui.shortened && words != shortened) ++*ui.shortened;
        words = shortened;
        width = width_of(words);
    }
    const ImVec2 p = at(unit);
    const ImVec2 corner{std::round(p.x - width * anchor), std::round(p.y - type.pixels / 2)};
    list.AddText(type.font, type.pixels, corner, paint(colour), words.data(), words.data() + words.size());
    record_text(ui, list, {corner.x, corner.y, width, type.pixels}, words, type.pixels);
    return {corner.x, corner.y, width, type.pixels};
}

bool Pen::cuts(std::string_view words, Face face, float room) const {
    const Type type = type_for(ui, face, least_type());
    const char* end = words.data() + words.size();
    return type.font->CalcTextSizeA(least_type(), 1e9f, 0, words.data(), end).x > size(room) + 1;
}

void Pen::box(vec2 centre, vec2 extent, float rounding, Colour colour) const {
    list.AddRectFilled(at(centre - extent / 2), at(centre + extent / 2), paint(colour), size(rounding));
}

void Pen::frame(vec2 centre, vec2 extent, float rounding, float thickness, Colour colour) const {
    compat::outline(list, at(centre - extent / 2), at(centre + extent / 2), paint(colour), size(rounding),
                    stroke(thickness));
}

void Pen::halo(vec2 centre, vec2 extent, float rounding, float reach, Colour colour) const {
    const vec2 half = extent / 2 - vec2{rounding, rounding};
    const ImVec2 middle = at(centre);
    std::array<ImVec2, 2 * rim_points> pairs;
    for (int i = 0; i < rim_points; ++i) {
        const ImVec2 out = rim()[static_cast<std::size_t>(i)];
        const int quarter = i / (corner_steps + 1);
        const vec2 corner{quarter == 0 || quarter == 3 ? half.x : -half.x, quarter < 2 ? half.y : -half.y};
        for (const int outer : {0, 1}) {
            const float radius = size(rounding + (outer == 0 ? 0 : reach));
            pairs[static_cast<std::size_t>(2 * i + outer)] = {middle.x + size(corner.x) + out.x * radius,
                                                              middle.y + size(corner.y) + out.y * radius};
        }
    }
    fade_out(list, pairs.data(), rim_points, paint(colour.with_alpha(std::min(1.0f, colour.a * 1.35f))));
}

void Pen::dot(ImVec2 middle, float radius, ImU32 colour) const {
    constexpr int corners = 8;
    constexpr float slant = 0.70710678f;
    const ImVec2 out[corners] = {{1, 0},  {slant, slant},   {0, 1},  {-slant, slant},
                                 {-1, 0}, {-slant, -slant}, {0, -1}, {slant, -slant}};
    ImVec2 pairs[2 * corners];
    for (int i = 0; i < 2 * corners; ++i) {
        const float r = std::max(0.0f, radius + (i % 2 == 0 ? -0.5f : 0.5f));  // a rim of one pixel
        pairs[i] = {middle.x + out[i / 2].x * r, middle.y + out[i / 2].y * r};
    }
    fade_out(list, pairs, corners, colour);
}

Detail detail_of(const Pen& pen) {
    if (is_map(pen.view, pen.ui.scale, pen.ui.least_type)) return Detail::map;
    return pen.view.scale < 0.75f * pen.ui.scale ? Detail::sketch : Detail::full;
}

LetterRoom letter_room(const Pen& pen, const LabView& view, const VehicleView& vehicle, const BrainGraph& graph) {
    constexpr float steps = 20;  // so that few zooms need another layout
    LetterRoom room;
    const Detail detail = detail_of(pen);
    if (detail != Detail::map) {
        const float growth = pen.least_type() / pen.size(label_letters(detail));
        room.label_growth = std::max(1.0f, std::ceil(growth * steps) / steps);
    }
    if (view.lecture) room.neuron_width = neuron_width(pen, view, vehicle, graph);
    const bool has_neurons = std::any_of(graph.nodes.begin(), graph.nodes.end(),
                                         [](const Node& node) { return node.kind == NodeKind::neuron; });
    constexpr float much = 1.5f;  // labels of weights then need the room
    room.has_free_labels = !has_neurons || (!view.lecture && room.label_growth <= much);
    if (view.lecture && view.mode != Mode::wiring && !has_neurons) room.aside = sensors_aside(view, vehicle, graph);
    return room;
}

void draw_ground(const Pen& pen, Rect area) {
    const Palette& p = pen.palette();
    pen.list.AddRectFilled({area.x, area.y}, {area.x + area.w, area.y + area.h}, paint(p.ground),
                           pen.ui.px(radius::box));
    float gap = 32 * pen.view.scale;
    while (gap < pen.ui.px(18)) gap *= 2;
    const float radius = pen.ui.px(1.1f);
    const auto first = [gap](float origin, float low) {
        return low + std::fmod(std::fmod(origin - low, gap) + gap, gap);
    };
    for (float y = first(pen.view.origin.y, area.y); y < area.y + area.h; y += gap)
        for (float x = first(pen.view.origin.x, area.x); x < area.x + area.w; x += gap)
            pen.list.AddRectFilled({x - radius, y - radius}, {x + radius, y + radius}, paint(p.grid));
    compat::outline(pen.list, {area.x, area.y}, {area.x + area.w, area.y + area.h}, paint(p.line), pen.ui.px(8),
                    pen.ui.px(1));
}

void record_anchors(Ui& ui, const Pen& pen, const Picture& picture, Rect area) {
    const BrainGraph& graph = picture.graph;
    const Layout& layout = picture.layout;
    const View& view = pen.view;
    record_selected(ui, graph, layout, view, picture.state.selection);
    for (const NodeShape& node : layout.nodes) {
        const std::string& name = graph.nodes[node.node].name;
        if (!area.overlaps(node_rect(view, node))) continue;
        record_anchor(ui, area, "node." + name, node_rect(view, node));
        if (node.has_in) record_anchor(ui, area, "pin." + name + ".in", pin_rect(view, node.in_pin()));
        if (node.has_out) record_anchor(ui, area, "pin." + name + ".out", pin_rect(view, node.out_pin()));
    }
    if (detail_of(pen) == Detail::map) return;
    for (const WireShape& wire : layout.wires) {
        const Rect label = label_rect(view, wire);
        if (label.w > 0 && !area.overlaps(label)) continue;
        const std::string name = name_of(graph, layout, wire);
        if (label.w > 0) record_anchor(ui, area, "wire." + name, label);
        const vec2 beside = view.to_window(bezier_point(wire.bezier, clear_of_label(wire)));
        record_anchor(ui, area, "curve." + name, {beside.x - 1, beside.y - 1, 2, 2});
    }
}

}  // namespace braitenlab::wiring
