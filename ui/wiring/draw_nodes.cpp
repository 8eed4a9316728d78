#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/maths/portable.h"
#include "core/scene/sensor_edits.h"
#include "core/utf8.h"
#include "ui/imgui_compat.h"
#include "ui/widgets/number.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/draw.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

// A sensor: an almond with an iris that opens and brightens with the reading.
void draw_eye(const Pen& pen, vec2 c, float value, bool covered) {
    const Palette& p = pen.palette();
    const auto almond = [&] {
        pen.list.PathLineTo(pen.at(c - vec2{21, 0}));
        pen.list.PathBezierQuadraticCurveTo(pen.at(c - vec2{0, 25}), pen.at(c + vec2{21, 0}), 20);
        pen.list.PathBezierQuadraticCurveTo(pen.at(c + vec2{0, 25}), pen.at(c - vec2{21, 0}), 20);
    };
    almond();
    pen.list.PathFillConvex(paint(mix(p.wheel, p.raised, 0.15f)));
    const float seen = std::clamp(value, 0.0f, 1.0f);
    pen.list.AddCircleFilled(pen.at(c), pen.size(11), paint(p.chassis.with_alpha(0.35f)));
    if (seen > 0.005f) pen.list.AddCircleFilled(pen.at(c), pen.size(3 + 8 * seen), paint(mix(p.excites, p.lamp, seen)));
    pen.list.AddCircleFilled(pen.at(c), pen.size(2.5f), paint(p.wheel));
    if (covered) {  // a closed lid
        almond();
        pen.list.PathFillConvex(paint(mix(p.wheel, p.raised, 0.6f)));
        pen.list.AddLine(pen.at(c - vec2{21, 0}), pen.at(c + vec2{21, 0}), paint(p.warning), pen.stroke(2.4f));
    }
    almond();
    pen.list.PathStroke(paint(p.second_text), 0, pen.stroke(1.8f));
}

// A motor: a wheel seen from its side at `angle` (rad).
void draw_wheel(const Pen& pen, vec2 c, float angle, float value, bool stopped) {
    const Palette& p = pen.palette();
    constexpr float radius = 20;
    pen.list.AddCircleFilled(pen.at(c), pen.size(radius), paint(p.wheel), 40);
    pen.list.AddCircleFilled(pen.at(c), pen.size(radius - 5), paint(mix(p.panel, p.chassis, 0.35f)), 40);
    for (int spoke = 0; spoke < 3; ++spoke) {
        const float turn = -angle + static_cast<float>(spoke) * maths::pi / 3;
        const vec2 out{maths::cosine(turn) * (radius - 5), maths::sine(turn) * (radius - 5)};
        pen.list.AddLine(pen.at(c - out), pen.at(c + out), paint(p.wheel), pen.stroke(2.2f));
    }
    pen.list.AddCircleFilled(pen.at(c), pen.size(5), paint(value == 0 ? p.second_text : colour_of_weight(p, value)));
    pen.list.AddCircle(pen.at(c), pen.size(radius), paint(p.second_text), 40, pen.stroke(1.5f));
    if (stopped)  // a brake block across it
        pen.list.AddLine(pen.at(c + vec2{-14, 14}), pen.at(c + vec2{14, -14}), paint(p.warning), pen.stroke(4));
}

// A neuron: its response curve as a gauge of its input sum. A mark is at the threshold or peak, a dot at the sum and
// the value.
void draw_response(const Pen& pen, vec2 c, const Curve& curve, float sum, float value) {
    const Palette& p = pen.palette();
    constexpr float half = 17;
    pen.box(c, {2 * half + 6, 2 * half + 6}, 8, mix(p.panel, p.ground, 0.6f));
    pen.list.AddLine(pen.at(c - vec2{half, 0}), pen.at(c + vec2{half, 0}), paint(p.line), pen.stroke(1));
    pen.list.AddLine(pen.at(c - vec2{0, half}), pen.at(c + vec2{0, half}), paint(p.line), pen.stroke(1));
    const float reach = glyph_reach(curve);
    if (row_of(curve.response).has_peak) {
        const float x = curve.peak / reach * half;
        pen.list.AddLine(pen.at(c + vec2{x, -half}), pen.at(c + vec2{x, half}), paint(p.accent.with_alpha(0.7f)),
                         pen.stroke(1.6f));
    }
    constexpr int pieces = 32;
    ImVec2 points[pieces + 1];
    for (int i = 0; i <= pieces; ++i) {
        const float x = 2 * static_cast<float>(i) / pieces - 1;
        points[i] = pen.at(c + vec2{x, -std::clamp(respond(curve, x * reach), -1.0f, 1.0f)} * half);
    }
    compat::polyline(pen.list, points, pieces + 1, paint(p.text), false, pen.stroke(2));
    const vec2 dot{std::clamp(sum / reach, -1.0f, 1.0f), -std::clamp(value, -1.0f, 1.0f)};
    pen.list.AddCircleFilled(pen.at(c + dot * half), pen.size(4), paint(colour_of_weight(p, value)));
}

// The input sum of a node: what its wires carry, and its bias.
float sum_into(const Picture& picture, std::size_t node) {
    float sum = picture.graph.nodes[picture.layout.nodes[node].node].bias;
    for (std::size_t i = 0; i < picture.layout.wires.size(); ++i)
        if (picture.layout.wires[i].to == node) sum += picture.readings.carried[i];
    return sum;
}

// A bar from 0 to the value: to the right for positive values. A sensor has no negative side.
void draw_bar(const Pen& pen, vec2 left, float width, float value, bool both_sides) {
    const Palette& p = pen.palette();
    const vec2 middle = left + vec2{width / 2, 0};
    pen.box(middle, {width, 7}, 3.5f, mix(p.ground, p.line, 0.7f));
    const float room = both_sides ? width / 2 : width;
    const float length = std::clamp(value, both_sides ? -1.0f : 0.0f, 1.0f) * room;
    const vec2 zero = both_sides ? middle : left;
    if (std::abs(length) > 0.5f)
        pen.box(zero + vec2{length / 2, 0}, {std::abs(length), 7}, 3.5f, colour_of_weight(p, value));
    if (both_sides)
        pen.list.AddLine(pen.at(middle - vec2{0, 6}), pen.at(middle + vec2{0, 6}), paint(p.second_text),
                         pen.stroke(1.5f));
}

void draw_pin(const Pen& pen, vec2 at, float size, float spread, bool hovered, bool inviting, bool out) {
    const Palette& p = pen.palette();
    const float radius = (hovered ? 9.5f : 7.5f) * size;
    const vec2 extent{2 * radius, 2 * radius + spread};
    if (hovered || inviting)
        pen.halo(at, extent, radius, hovered ? 8 : 5, p.accent.with_alpha(hovered ? 0.45f : 0.28f));
    pen.box(at, extent, radius, out ? p.text : p.panel);
    pen.frame(at, extent, radius, 2.2f, hovered || inviting ? p.accent : p.text);
    if (out) pen.box(at, {5, 5}, 2.5f, p.panel);
}

constexpr float card_rounding = 16;

float wheel_angle(const Picture& picture, const Node& node) {
    const auto& angle = picture.vehicle.wheel_angle;
    return node.name == "ML" ? angle[0] : node.name == "MR" ? angle[1] : 0;
}

// Beside the scene the names have anchors.
void record_name(const Pen& pen, const Picture& picture, const std::string& name, Rect rect) {
    if (picture.view.mode != Mode::wiring) pen.ui.anchors.record("name." + name, rect);
}

std::string name_of(const Pen& pen, const Picture& picture, const Node& node) {
    return shown_name(pen.ui, picture.view, picture.vehicle, node);
}

// The text of a card begins here, right of its icon; and ends here.
float text_left(const NodeShape& shape) {
    return shape.centre.x - shape.size.x / 2 + (shape.kind == NodeKind::neuron ? before_neuron_text : 78.0f);
}
float text_right(const NodeShape& shape) {
    return shape.centre.x + shape.size.x / 2 -
           (shape.kind == NodeKind::neuron ? beside_neuron_text - before_neuron_text : 18.0f);
}

// The width for the name in a card, beside the number in a sensor's or motor's card of full detail.
float name_room(const NodeShape& shape, Detail detail) {
    const bool beside_number = shape.kind != NodeKind::neuron && detail == Detail::full;
    return text_right(shape) - text_left(shape) - (beside_number ? 62 : 0);
}

// The width for the name on the map: between the pins. In a lecture, where the pins are not used, it is that of the
// card. A name of a few letters, of which nothing is left otherwise, may be wider, because there is space between the
// columns.
float map_room(const Pen& pen, const Picture& picture, const NodeShape& shape, std::string_view name) {
    constexpr float overhang = 1.5f;  // of the card's width
    constexpr std::size_t few = 4;
    const float inner = shape.size.x - 30, own = compat::size_of(font(pen.ui, Face::strong));
    const std::size_t letters = count_characters(name);
    if (picture.view.lecture && (shape.kind == NodeKind::neuron || letters > few))
        return shape.size.x - 2 * map_name_margin + 1;
    if (letters > few && !picture.view.lecture) return inner;
    const float readable = text_width(pen.ui, Face::strong, name) * pen.least_type() / own / pen.view.scale;
    return std::clamp(readable + 1, inner, overhang * shape.size.x);
}

// True if the cards of sensors and motors have two rows in place of three: in a lecture, and where a line is higher
// than a row.
bool has_two_rows(const Pen& pen, const Picture& picture) {
    constexpr float row = 28;  // units
    return detail_of(pen) != Detail::full && (picture.view.lecture || pen.least_type() > pen.size(row));
}

// In a lecture nothing is pale.
Colour caption_colour(const Pen& pen, const Picture& picture) {
    return picture.view.lecture ? pen.palette().text : pen.palette().second_text;
}

constexpr float large_words_inset = 12, beside_pin = 9;

// The width for the caption below an icon: a motor's begins right of its pin.
float caption_inset(const NodeShape& shape) { return large_words_inset + (shape.has_in ? beside_pin : 0); }

// "motor izquierdo"; in large letters, where one of the eyes' and motors' captions has no room, "izquierdo" in all.
std::string_view caption_of(const Pen& pen, const Picture& picture, const NodeShape& shape, const Node& node) {
    constexpr std::array<std::string_view, 4> sides{"SL", "SR", "ML", "MR"};
    const std::string_view whole = pen.ui.strings(description_key(*picture.view.now, picture.vehicle, node));
    const bool has_side = std::find(sides.begin(), sides.end(), node.name) != sides.end();
    if (!has_side || !picture.view.lecture || detail_of(pen) == Detail::full) return whole;
    const float room = shape.size.x - 2 * large_words_inset - beside_pin;
    const bool all_fit = std::none_of(sides.begin(), sides.end(), [&](std::string_view name) {
        return pen.cuts(pen.ui.strings("wiring.node." + std::string(name)), Face::small, room);
    });
    return all_fit ? whole : pen.ui.strings(node.name.back() == 'L' ? "wiring.side.left" : "wiring.side.right");
}

struct CardWords {
    const std::string &name, &number;
    std::string_view caption;
};

// Two lines in place of three, for large letters: the number is beside the name and the caption below both. Below a
// long name is the number.
void draw_large_words(const Pen& pen, const Picture& picture, const NodeShape& shape, const CardWords& words) {
    const Palette& p = pen.palette();
    const float height = pen.least_type() / pen.view.scale, own = compat::size_of(font(pen.ui, Face::strong));
    const auto width_of = [&](Face face, std::string_view text) {
        return text_width(pen.ui, face, text) * height / own;
    };
    constexpr float beside_icon = 18, at_edge = 6;
    const float inset = caption_inset(shape);
    const float left = text_left(shape) - beside_icon, right = shape.centre.x + shape.size.x / 2 - at_edge;
    const float room = right - left;
    const float first = shape.centre.y - shape.size.y / 4 + 2, second = shape.centre.y + shape.size.y / 4;
    const bool fits = width_of(Face::strong, words.name) + width_of(Face::text, words.number) + at_edge <= room;
    const std::string& id = picture.graph.nodes[shape.node].name;
    record_name(pen, picture, id,
                pen.text({left, first}, height, 0, words.name, p.text, Face::strong, fits ? 0 : room));
    const vec2 below{shape.centre.x - shape.size.x / 2 + inset, second};
    const float whole = shape.size.x - inset - large_words_inset;
    if (!fits) return void(pen.text(below, height, 0, words.number, p.text, Face::text, whole));
    pen.text({right, first}, height, 1, words.number, p.text);
    pen.text(below, height, 0, words.caption, p.text, Face::small, whole);
}

// Below full detail only name, number and a sensor's caption, as large as the card allows.
void draw_words(const Pen& pen, const Picture& picture, const NodeShape& shape, const Node& node, float value) {
    const Palette& p = pen.palette();
    const vec2 low{text_left(shape), shape.centre.y - shape.size.y / 2};
    const vec2 high{text_right(shape), shape.centre.y + shape.size.y / 2};
    const bool neuron = node.kind == NodeKind::neuron, far = detail_of(pen) != Detail::full;
    const float shown = shown_value(node, value);
    const std::string number = node.kind == NodeKind::sensor ? fixed(pen.ui, shown, 2) : with_sign(pen.ui, shown, 2);
    const float room = high.x - low.x, of_name = name_room(shape, detail_of(pen));
    const std::string_view caption = caption_of(pen, picture, shape, node);
    const Colour pale = caption_colour(pen, picture);
    const std::string name = name_of(pen, picture, node);
    const auto put_name = [&](float y, float height) {
        record_name(pen, picture, node.name, pen.text({low.x, y}, height, 0, name, p.text, Face::strong, of_name));
    };
    if (!neuron && has_two_rows(pen, picture)) {
        draw_large_words(pen, picture, shape, {name, number, caption});
    } else if (far && !neuron) {
        put_name(low.y + 24, 27);
        pen.text({low.x, low.y + 52}, 26, 0, number, p.text, Face::text, room);
        pen.text({low.x - 62, low.y + 81}, 20, 0, caption, pale, Face::small, room + 66);
    } else if (far || neuron) {
        const float height = far ? 29 : 21, above = far ? 25 : 22;
        const float apart = std::max(height + 2, pen.least_type() / pen.view.scale);
        const float first = low.y + above - (apart - height - 2) / 2;
        put_name(first, height);
        if (!pen.cuts(number, Face::text, room))
            pen.text({low.x, first + apart}, height, 0, number, p.text, Face::text, room);
    } else {
        put_name(low.y + 27, 24);
        pen.text({high.x, low.y + 27}, 20, 1, number, p.text);
        pen.text({low.x, low.y + 52}, 19, 0, caption, pale, Face::small, room);
    }
    const float bar = neuron ? low.x : low.x - 58;
    if (!far)
        draw_bar(pen, {bar, high.y - (neuron ? 14.0f : 18.0f)}, high.x - 2 - bar, value, node.kind != NodeKind::sensor);
}

void draw_contents(const Pen& pen, const Picture& picture, const NodeShape& shape, const Node& node, float value) {
    const bool neuron = node.kind == NodeKind::neuron;
    const bool far = detail_of(pen) != Detail::full;
    const vec2 half = shape.size / 2;
    const bool has_two = has_two_rows(pen, picture);
    const float above = neuron ? 0.0f : !far ? 9.0f : has_two ? 23.0f : 13.0f;
    const float right = neuron ? 38.0f : has_two ? 33.0f : 44.0f;
    const vec2 icon = shape.centre + vec2{-half.x + right, -above};
    if (node.kind == NodeKind::sensor) draw_eye(pen, icon, value, node.silenced);
    if (node.kind == NodeKind::motor) draw_wheel(pen, icon, wheel_angle(picture, node), value, node.silenced);
    if (neuron)
        draw_response(pen, icon, node.curve,
                      sum_into(picture, static_cast<std::size_t>(&shape - picture.layout.nodes.data())), value);
    draw_words(pen, picture, shape, node, value);
}

// A lesion: pale stripes across the card.
void draw_silence(const Pen& pen, const NodeShape& shape) {
    const Palette& p = pen.palette();
    const vec2 half = shape.size / 2;
    const ImVec2 low = pen.at(shape.centre - half), high = pen.at(shape.centre + half);
    pen.list.PushClipRect(low, high, true);
    const float gap = pen.size(15), height = high.y - low.y;
    for (float x = low.x - height; x < high.x; x += gap)
        pen.list.AddLine({x, high.y}, {x + height, low.y}, paint(p.warning.with_alpha(0.20f)), pen.stroke(3));
    pen.list.PopClipRect();
    pen.frame(shape.centre, shape.size, card_rounding, 2.2f, p.warning);
}

// The fill of a card on the map.
Colour map_colour(const Palette& p, float value) {
    return colour_of_weight(p, value).with_alpha(0.15f + 0.6f * std::min(std::abs(value), 1.0f));
}

// On the map of a lecture a sensor has a word in place of the icon of its channel, where the card has room for it.
std::string map_name_of(const Pen& pen, const Picture& picture, const NodeShape& shape, const Node& node) {
    std::string name = name_of(pen, picture, node);
    const Sensor* sensor = find_sensor(kind_of(*picture.view.now, picture.vehicle).sensors, node.name);
    if (!picture.view.lecture || !sensor || name == node.name) return name;
    std::string word(pen.ui.strings("wiring.word." + std::string(row_of(sensor->channel).word)));
    if (name.back() == 'L' || name.back() == 'R') word += std::string(" ") + name.back();
    return pen.cuts(word, Face::strong, shape.size.x - 2 * map_name_margin) ? name : word;
}

bool is_large_map(const Pen& pen, const Picture& picture) {
    return picture.view.lecture && detail_of(pen) == Detail::map && picture.layout.nodes.size() > few_nodes;
}

// The height of all names on a large map of a lecture, units: the largest at which each fits into its card.
std::optional<float> height_of_names(const Pen& pen, const Picture& picture) {
    constexpr float share = 0.85f;  // of the card's height, at most
    if (!is_large_map(pen, picture)) return std::nullopt;
    float height = share * card_size(NodeKind::neuron).y;
    const float own = compat::size_of(font(pen.ui, Face::strong));
    for (const NodeShape& shape : picture.layout.nodes) {
        const std::string name = map_name_of(pen, picture, shape, picture.graph.nodes[shape.node]);
        height = std::min(height, map_room(pen, picture, shape, name) * own / text_width(pen.ui, Face::strong, name));
    }
    return height;
}

// On the map: as large as the card allows, or `common` units high; at least least_type() high if the card is as high.
void draw_name(const Pen& pen, const Picture& picture, std::size_t index, std::optional<float> common) {
    constexpr float share = 0.6f;  // of the card's height
    const Palette& p = pen.palette();
    const NodeShape& shape = picture.layout.nodes[index];
    const Node& node = picture.graph.nodes[shape.node];
    const std::string name = map_name_of(pen, picture, shape, node);
    const float least = pen.least_type();
    if (pen.size(shape.size.y) < least) return;
    const float room = map_room(pen, picture, shape, name);
    if (room > shape.size.x - 30) {
        const vec2 extent{room + 8, shape.size.y - 24};
        pen.box(shape.centre, extent, 6, mix(p.panel, p.raised, 0.45f));
        pen.box(shape.centre, extent, 6, map_colour(p, picture.readings.nodes[index]));
    }
    const float height = std::max(common.value_or(share * shape.size.y), least / pen.view.scale);
    record_name(pen, picture, node.name, pen.text(shape.centre, height, 0.5f, name, p.text, Face::strong, room));
}

// The names of the three groups above the columns of a large map, where these are apart and there is room.
void draw_group_names(const Pen& pen, const Picture& picture) {
    if (!is_large_map(pen, picture)) return;
    constexpr std::array<std::string_view, 3> keys{"wiring.group.sensors", "wiring.group.neurons",
                                                   "wiring.group.motors"};
    struct Span {
        float low = 1e9f, high = -1e9f;
    };
    std::array<Span, 3> spans;
    for (const NodeShape& shape : picture.layout.nodes) {
        Span& span = spans[shape.kind == NodeKind::sensor ? 0 : shape.kind == NodeKind::neuron ? 1 : 2];
        span.low = std::min(span.low, shape.centre.x - shape.size.x / 2);
        span.high = std::max(span.high, shape.centre.x + shape.size.x / 2);
    }
    constexpr float growth = 1.25f, above = 24;  // of the least type; units between cards and letters
    const float height = growth * pen.least_type() / pen.view.scale, y = picture.layout.low.y - above - height / 2;
    const bool apart = spans[0].high < spans[1].low && spans[1].high < spans[2].low;
    if (!apart || y - height / 2 < picture.low.y) return;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const vec2 at{(spans[i].low + spans[i].high) / 2, y};
        pen.ui.anchors.record(keys[i], pen.text(at, height, 0.5f, pen.ui.strings(keys[i]), pen.palette().text,
                                                Face::strong, spans[i].high - spans[i].low));
    }
}

void draw_card(const Pen& pen, const Picture& picture, std::size_t index) {
    const Palette& p = pen.palette();
    const NodeShape& shape = picture.layout.nodes[index];
    const Node& node = picture.graph.nodes[shape.node];
    const float value = picture.readings.nodes[index], strength = std::min(std::abs(value), 1.0f);
    const bool selected = picture.state.selection.nodes.count(shape.id) > 0;
    const bool hovered = picture.state.hovered.part == Part::node && picture.state.hovered.node == shape.id;
    const bool plain = detail_of(pen) == Detail::map;
    if (!plain)
        pen.halo(shape.centre + vec2{0, 4}, shape.size, card_rounding, 14, p.shadow.with_alpha(p.shadow.a * 0.28f));
    if (strength > 0.01f && !plain)
        pen.halo(shape.centre, shape.size, card_rounding, 8 + 10 * strength,
                 colour_of_weight(p, value).with_alpha(0.34f * strength));
    pen.box(shape.centre, shape.size, card_rounding, mix(p.panel, p.raised, hovered ? 1.0f : 0.45f));
    const Colour edge = strength > 0.01f ? mix(p.line, colour_of_weight(p, value), 0.25f + 0.6f * strength) : p.line;
    if (selected) {
        pen.frame(shape.centre, shape.size + vec2{7, 7}, card_rounding + 4, 5, p.text.with_alpha(0.45f));
        pen.frame(shape.centre, shape.size + vec2{7, 7}, card_rounding + 4, 3, p.selected);
    }
    if (node.silenced)
        draw_silence(pen, shape);
    else
        pen.frame(shape.centre, shape.size, card_rounding, 1.6f, hovered ? p.second_text : edge);
    if (!plain) return draw_contents(pen, picture, shape, node, value);
    pen.box(shape.centre, shape.size - vec2{24, 24}, 6, map_colour(p, value));
}

// What a card of a lecture has no room for: the step of a neuron, as "≥ 0.50", and on the map the value of the node
// before it. Nothing on a large map.
std::string words_below(const Pen& pen, const Picture& picture, const NodeShape& shape, float value) {
    const Node& node = picture.graph.nodes[shape.node];
    if (!picture.view.lecture || is_large_map(pen, picture)) return {};
    std::string words;
    if (detail_of(pen) == Detail::map) words = fixed(pen.ui, shown_value(node, value), 2);
    if (node.kind == NodeKind::neuron && node.curve.response == Response::step)
        words += (words.empty() ? "≥ " : " (≥ ") + fixed(pen.ui, node.curve.peak, 2) + (words.empty() ? "" : ")");
    return words;
}

// Draws the words below the card, else above it, behind or before it, where they cover no card, no label and no other
// such words. False if there is no such place.
bool draw_beside(const Pen& pen, const Picture& picture, const NodeShape& shape, const std::string& words,
                 OccupiedBoxes& taken) {
    const float height = pen.least_type() / pen.view.scale, own = compat::size_of(font(pen.ui, Face::text));
    const vec2 extent{text_width(pen.ui, Face::text, words) * height / own + 6, height};
    constexpr float pin = 10;
    const vec2 away = shape.size / 2 + extent / 2 + vec2{pin, 2};
    for (const vec2 aside : {vec2{0, away.y}, vec2{0, -away.y}, vec2{away.x, 0}, vec2{-away.x, 0}}) {
        const vec2 at = shape.centre + aside;
        const bool is_inside = at.x - extent.x / 2 > picture.low.x && at.x + extent.x / 2 < picture.high.x &&
                               at.y - extent.y / 2 > picture.low.y && at.y + extent.y / 2 < picture.high.y;
        if (!is_inside || taken.overlaps(at, extent)) continue;
        taken.add(at, extent);
        pen.box(at, extent, 4, pen.palette().ground.with_alpha(0.85f));
        const Rect rect = pen.text(at, height, 0.5f, words, pen.palette().text);
        if (picture.view.mode != Mode::wiring)
            pen.ui.anchors.record("below." + picture.graph.nodes[shape.node].name, rect);
        return true;
    }
    return false;
}

// Of words without room only the value.
void draw_words_below(const Pen& pen, const Picture& picture, std::size_t index, OccupiedBoxes& taken) {
    const NodeShape& shape = picture.layout.nodes[index];
    const std::string words = words_below(pen, picture, shape, picture.readings.nodes[index]);
    if (words.empty() || draw_beside(pen, picture, shape, words, taken)) return;
    if (const std::size_t end = words.find(" ("); end != std::string::npos)
        draw_beside(pen, picture, shape, words.substr(0, end), taken);
}

// True for a pin that the dragged wire can be joined to.
bool invites(const Picture& picture, const NodeShape& shape, bool out) {
    const Drag& drag = picture.state.drag;
    if (drag.phase != DragPhase::drag_wire) return false;
    const bool outwards = drag.pressed.part == Part::out_pin;
    if (outwards == out) return false;
    const WireEnds ends = outwards ? WireEnds{drag.pressed.node, shape.id} : WireEnds{shape.id, drag.pressed.node};
    return weight_of(picture.graph, ends) == 0;
}

}  // namespace

std::string shown_name(const Ui& ui, const LabView& view, const VehicleView& vehicle, const Node& node) {
    if (view.lecture && node.kind == NodeKind::neuron)
        return std::string(ui.strings.find("neuron." + node.name, node.name));
    return short_name(kind_of(*view.now, vehicle).sensors, node.name);
}

float glyph_reach(const Curve& curve) {
    constexpr float beyond = 1.4f;  // of the peak
    return row_of(curve.response).has_peak ? std::max(1.0f, beyond * std::fabs(curve.peak)) : 1.0f;
}

bool cuts_name(const Pen& pen, const Picture& picture, const NodeShape& shape) {
    const Detail detail = detail_of(pen);
    const Node& node = picture.graph.nodes[shape.node];
    const std::string name =
        detail == Detail::map ? map_name_of(pen, picture, shape, node) : name_of(pen, picture, node);
    const float room = detail == Detail::map ? map_room(pen, picture, shape, name) : name_room(shape, detail);
    return pen.cuts(name, Face::strong, room);
}

void draw_nodes(const Pen& pen, const Picture& picture) {
    const Hit& over = picture.state.hovered;
    const float size = finger_size(picture.view);
    const std::optional<float> names = height_of_names(pen, picture);
    for (std::size_t i = 0; i < picture.layout.nodes.size(); ++i) {
        const NodeShape& shape = picture.layout.nodes[i];
        if (!picture.is_visible(shape.centre - shape.size / 2, shape.centre + shape.size / 2)) continue;
        draw_card(pen, picture, i);
        const bool in = over.part == Part::in_pin && over.node == shape.id;
        const bool out = over.part == Part::out_pin && over.node == shape.id;
        if (shape.has_in)
            draw_pin(pen, shape.in_pin(), size, shape.in_spread, in, invites(picture, shape, false), false);
        if (shape.has_out) draw_pin(pen, shape.out_pin(), size, 0, out, invites(picture, shape, true), true);
        if (detail_of(pen) == Detail::map) draw_name(pen, picture, i, names);
    }
    if (!picture.view.lecture) return;
    draw_group_names(pen, picture);
    OccupiedBoxes taken;
    for (const NodeShape& node : picture.layout.nodes) taken.add(node.centre, node.size);
    if (detail_of(pen) != Detail::map)
        for (const WireShape& wire : picture.layout.wires)
            if (wire.label_size.x > 0) taken.add(wire.label, wire.label_size);
    for (std::size_t i = 0; i < picture.layout.nodes.size(); ++i) draw_words_below(pen, picture, i, taken);
}

}  // namespace braitenlab::wiring
