#include "app/reports/brain_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/reports/axes.h"
#include "app/reports/html.h"
#include "app/reports/svg_file.h"
#include "ui/words/number_text.h"

namespace braitenlab {

namespace {

constexpr float usual_width = 360, width_of_a_node = 90, node_radius = 15;
constexpr std::size_t most_weights = 40;
// Orange and blue as in the window, dark enough on white.
constexpr const char* plus_colour = "#b06a00";
constexpr const char* minus_colour = "#0072b2";

// Crossed wires between two rows alone need more room.
float row_height(std::size_t rows) { return rows <= 2 ? 150.0f : 92.0f; }

bool is_drawn(const Wire& wire) { return wire.weight != 0 || learns(wire); }

// Row of each node: sensors 0, neurons by the fewest wires from a sensor, motors last.
std::map<NodeId, std::size_t> rows_of(const BrainGraph& brain) {
    std::map<NodeId, std::size_t> rows;
    for (const Node& node : brain.nodes)
        if (node.kind == NodeKind::sensor) rows[node.id] = 0;
    std::size_t last = 0;
    for (bool grows = true; grows;) {
        grows = false;
        for (const Wire& wire : brain.wires) {
            const Node* to = find_node(brain, wire.to);
            if (!to || to->kind != NodeKind::neuron || !rows.count(wire.from) || rows.count(wire.to)) continue;
            rows[wire.to] = rows[wire.from] + 1;
            grows = true;
        }
    }
    for (const Node& node : brain.nodes)  // a neuron that no sensor reaches
        if (node.kind == NodeKind::neuron && !rows.count(node.id)) rows[node.id] = 1;
    for (const auto& [id, row] : rows) last = std::max(last, row);
    for (const Node& node : brain.nodes)
        if (node.kind == NodeKind::motor) rows[node.id] = last + 1;
    return rows;
}

class Drawing {
public:
    // `fits`: the drawing becomes so wide that the weights of a row do not overlap.
    Drawing(const BrainGraph& brain, const std::vector<Sensor>& sensors, const Strings& strings, bool fits = false)
        : brain_(brain), strings_(strings) {
        std::map<std::size_t, std::vector<const Node*>> by_row;
        for (const auto& [id, row] : rows_of(brain)) by_row[row].push_back(find_node(brain, id));
        for (const auto& [row, nodes] : by_row)
            if (fits) wide_ = std::max(wide_, width_of_a_node * static_cast<float>(nodes.size()));
        for (auto& [row, nodes] : by_row) {
            std::stable_sort(nodes.begin(), nodes.end(), [&](const Node* a, const Node* b) {
                return left_to_right(*a, sensors) < left_to_right(*b, sensors);
            });
            for (std::size_t i = 0; i < nodes.size(); ++i)
                places_[nodes[i]->id] = {wide_ * (static_cast<float>(i) + 0.5f) / static_cast<float>(nodes.size()),
                                         34 + row_height(by_row.size()) * static_cast<float>(rows_)};
            ++rows_;
        }
        drawn_ = static_cast<std::size_t>(std::count_if(brain.wires.begin(), brain.wires.end(), is_drawn));
    }

    std::string svg() const {
        return fmt::format(
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{0}\" "
                   "viewBox=\"0 0 {1:.0f} {2:.0f}\" width=\"{1:.0f}\" height=\"{2:.0f}\" font-size=\"12\">",
                   xml_text(strings_("report.brain")), wide_, height()) +
               content() + "</svg>";
    }

    float width() const { return wide_; }
    float height() const {
        return 34 + row_height(rows_) * static_cast<float>(std::max<std::size_t>(rows_, 1) - 1) + 62;
    }

    std::string content() const {
        const float high = height();
        std::string out;
        for (const Wire& wire : brain_.wires)
            if (is_drawn(wire)) out += wire_svg(wire);
        std::vector<LabelBox> taken;
        for (const auto& [id, place] : places_)
            taken.push_back(
                {place.x - node_radius, place.x + node_radius, place.y - node_radius, place.y + node_radius});
        for (const Wire& wire : brain_.wires)
            if (is_drawn(wire) && drawn_ <= most_weights) out += weight_svg(wire, taken);
        for (const Node& node : brain_.nodes)
            if (places_.count(node.id)) out += node_svg(node);
        return out +
               fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\" fill=\"#5a5a55\">▶ {} · ● {}</text>",
                           wide_ / 2, high - 5, xml_text(strings_("report.excites")),
                           xml_text(strings_("report.inhibits")));
    }

private:
    struct Path {
        maths::vec2 from, bend_1, bend_2, to;
        maths::vec2 at(float t) const {
            const float u = 1 - t;
            const float a = u * u * u, b = 3 * u * u * t, c = 3 * u * t * t, d = t * t * t;
            return {a * from.x + b * bend_1.x + c * bend_2.x + d * to.x,
                    a * from.y + b * bend_1.y + c * bend_2.y + d * to.y};
        }
    };

    struct Label {
        maths::vec2 at;
        std::string_view anchor;
        LabelBox box;
    };

    // Sensors by their place on the body, others by name, so that ML is left of MR.
    static std::pair<float, std::string> left_to_right(const Node& node, const std::vector<Sensor>& sensors) {
        for (const Sensor& sensor : sensors)
            if (node.kind == NodeKind::sensor && sensor.name == node.name) return {-sensor.y, node.name};
        return {0.0f, node.name};
    }

    std::string number(float value) const { return ui::fixed(value, 2, decimal_mark(strings_)); }

    // The horizontal shift of the end of a wire, so that wires to one node end side by side.
    float shift(const Wire& wire) const {
        std::vector<std::pair<float, NodeId>> from;
        for (const Wire& each : brain_.wires)
            if (each.to == wire.to && is_drawn(each) && places_.count(each.from))
                from.emplace_back(places_.at(each.from).x, each.from);
        std::sort(from.begin(), from.end());
        const auto index = std::find_if(from.begin(), from.end(), [&](const auto& e) { return e.second == wire.from; });
        const float gap = std::min(14.0f, 40.0f / static_cast<float>(from.size()));
        return gap * (static_cast<float>(index - from.begin()) - static_cast<float>(from.size() - 1) / 2);
    }

    Path path_of(const Wire& wire) const {
        const maths::vec2 a = places_.at(wire.from), b = places_.at(wire.to);
        if (wire.from == wire.to)
            return {{a.x + 10, a.y + 11}, {a.x + 48, a.y + 34}, {a.x + 48, a.y - 34}, {a.x + 13, a.y - 12}};
        if (b.y > a.y) {
            const maths::vec2 to{b.x + shift(wire), b.y - node_radius - 7};
            const float bend = (to.y - a.y) * 0.45f;
            return {{a.x, a.y + node_radius}, {a.x, a.y + node_radius + bend}, {to.x, to.y - bend}, to};
        }
        const float out = b.x >= a.x ? 1.0f : -1.0f;  // back, or beside: around the outside
        return {{a.x + out * 12, a.y + 9},
                {a.x + out * 60, a.y + 40},
                {b.x - out * 20, b.y + 60},
                {b.x - out * 4, b.y + node_radius + 7}};
    }

    std::string wire_svg(const Wire& wire) const {
        if (!places_.count(wire.from) || !places_.count(wire.to)) return "";
        const Path p = path_of(wire);
        const char* colour = wire.cut ? "#8a8a84" : wire.weight < 0 ? minus_colour : plus_colour;
        std::string out = fmt::format(
            "<path d=\"M{:.1f} {:.1f}C{:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}\" fill=\"none\" stroke=\"{}\" "
            "stroke-width=\"{:.1f}\"{}/>",
            p.from.x, p.from.y, p.bend_1.x, p.bend_1.y, p.bend_2.x, p.bend_2.y, p.to.x, p.to.y, colour,
            1 + 1.2f * std::min(2.0f, std::fabs(wire.weight)), wire.cut ? " stroke-dasharray=\"5 4\"" : "");
        if (wire.weight < 0)
            return out +
                   fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\"/>", p.to.x, p.to.y, colour);
        const float along = std::atan2(p.to.y - p.bend_2.y, p.to.x - p.bend_2.x) * 57.29578f;
        return out +
               fmt::format(
                   "<path d=\"M7 0L-5 -6L-5 6Z\" transform=\"translate({:.1f} {:.1f}) rotate({:.0f})\" fill=\"{}\"/>",
                   p.to.x, p.to.y, along, colour);
    }

    // The weight stands near the wire's start, on the side to which the wire goes, or outside; where another label is,
    // further along the wire. Adds its room to `taken`.
    std::string weight_svg(const Wire& wire, std::vector<LabelBox>& taken) const {
        if (!places_.count(wire.from) || !places_.count(wire.to)) return "";
        const Path p = path_of(wire);
        const float towards = p.to.x - p.from.x;
        const bool is_slanted = std::fabs(towards) > 24;  // then it bends below the number: put that higher
        const bool is_right = is_slanted ? towards > 0 : p.from.x > wide_ / 2;
        const float beside = is_slanted ? 9 : 6, below = is_slanted ? -2 : 4;
        std::string text = number(wire.weight);
        if (wire.threshold > 0) text += " θ " + number(wire.threshold);
        if (learns(wire)) text += " + h";
        const auto label = [&](float along, bool right) {
            const maths::vec2 at = p.at(along) + maths::vec2{right ? beside : -beside, below};
            return Label{at, right ? "start" : "end", label_box(at.x, at.y, right ? "start" : "end", text)};
        };
        Label chosen = label(0.2f, is_right);  // also where all places are taken
        for (int place = 12; place >= 0; --place)
            for (const bool right : {!is_right, is_right}) {
                const Label tried = label(0.2f + 0.05f * static_cast<float>(place), right);
                const bool fits = tried.box.left >= 0 && tried.box.right <= wide_;
                if (fits && is_free(tried.box, taken)) chosen = tried;
            }
        taken.push_back(chosen.box);
        return outlined_text(chosen.at.x, chosen.at.y, chosen.anchor, axis_ink, text);
    }

    std::string node_svg(const Node& node) const {
        const maths::vec2 at = places_.at(node.id);
        const bool is_motor = node.kind == NodeKind::motor;
        std::string out =
            is_motor ? fmt::format(
                           "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"36\" height=\"28\" rx=\"5\" "
                           "fill=\"#e4e4e0\" stroke=\"#1c1c1a\"/>",
                           at.x - 18, at.y - 14)
                     : fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"#1c1c1a\"/>",
                                   at.x, at.y, node_radius, node.kind == NodeKind::sensor ? "#fff3c4" : "#fff");
        const bool is_short = node.name.size() <= 3;
        out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" fill=\"#1c1c1a\">{}</text>", at.x,
                           is_short ? at.y + 4 : at.y - node_radius - 4, xml_text(node.name));
        if (node.bias != 0)
            out +=
                fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" fill=\"#1c1c1a\">{}</text>", at.x,
                            at.y + node_radius + 15, xml_text(fill(strings_("report.bias"), {number(node.bias)})));
        if (node.silenced)
            out += fmt::format(
                "<path d=\"M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}M{0:.1f} {3:.1f}L{2:.1f} {1:.1f}\" "
                "stroke=\"#b3261e\" stroke-width=\"2.5\"/>",
                at.x - 14, at.y - 14, at.x + 14, at.y + 14);
        return out;
    }

    const BrainGraph& brain_;
    const Strings& strings_;
    std::map<NodeId, maths::vec2> places_;
    float wide_ = usual_width;
    std::size_t rows_ = 0, drawn_ = 0;
};

}  // namespace

std::string brain_drawing(const BrainGraph& brain, const std::vector<Sensor>& sensors, const Strings& strings) {
    return Drawing(brain, sensors, strings).svg();
}

std::string brain_heading(const Scene& scene, const Kind& kind) {
    return scene.kinds.size() > 1 ? scene.title + ": " + kind.name : scene.title;
}

std::string brain_file(const BrainGraph& brain, const std::vector<Sensor>& sensors, std::string_view heading,
                       const Strings& strings) {
    constexpr float margin = 20, heading_height = 40, scale = 1.5f;
    const Drawing drawing(brain, sensors, strings, true);
    const float width = scale * drawing.width() + 2 * margin;
    return svg_file(
        heading, width, heading_height + scale * drawing.height() + margin,
        fmt::format("<g transform=\"translate({} {}) scale({})\" font-size=\"12\">", margin, heading_height, scale) +
            drawing.content() + "</g>");
}

}  // namespace braitenlab
