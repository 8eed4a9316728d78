// A lecture's large picture of the brain at work: bars of the eyes, wires with their weights, bars of the wheels. A
// brain of more than two eyes or with hidden neurons is shown whole, without numbers on its wires. Beside the diagram,
// where the picture is low, its eyes have the place of the wires.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "core/insight/why.h"
#include "core/scene/sensor_pairs.h"
#include "ui/panels/brain/brain_layout.h"
#include "ui/panels/brain/brain_sketch.h"
#include "ui/panels/panels.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr std::size_t most_labelled = 2;  // eyes; the labels of more wires do not fit
constexpr std::size_t most_eyes = 14;     // of a brain that is shown whole
constexpr float words_share = 0.20f, eyes_share = 0.19f, wheels_share = 0.26f;  // of the width; the rest are wires
constexpr float live_inset = spacing::large, live_bar = 10, low_picture = 110;  // layout pixels
constexpr float least_live_bar = 16;  // layout pixels, of a row that is one line

// A node of the brain in its row.
struct LiveRow {
    const Node* node = nullptr;
    std::string name;
    Rect place;
    float value = 0;
    float middle() const { return place.y + place.h / 2; }
};

// The left and the right eye of each pair, one after the other, then the eyes without a counterpart.
std::vector<std::string> in_pairs(const std::vector<std::string>& read, const Kind& kind) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        const bool is_read = std::find(read.begin(), read.end(), name) != read.end();
        if (is_read && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const KindPair& pair : sensor_pairs(kind)) add(pair.sensors.left), add(pair.sensors.right);
    for (const std::string& name : read) add(name);
    return names;
}

// No pair is in two columns.
std::size_t most_rows(std::size_t room) { return room > 1 ? room - room % 2 : 1; }

class LiveBrain {
public:
    LiveBrain(const LabView& view, Ui& ui, const VehicleView& vehicle, Rect bar)
        : view_(view), ui_(ui), vehicle_(vehicle), brain_(*brain_of(*view.now, vehicle)), bar_(bar) {
        const float inset = ui.px(live_inset), from = bar.x + words_share * bar.w;
        const float top = bar.y + ui.px(spacing::small), height = bar.h - 2 * ui.px(spacing::small);
        const Rect eyes{from, top, eyes_share * bar.w, height};
        std::vector<std::string> read;
        for (const Sensor& sensor : sketch::read_sensors(brain_, kind_of(*view.now, vehicle)))
            read.push_back(sensor.name);
        const bool is_simple = read.size() <= most_labelled && !insight::has_hidden_neurons(brain_);
        const bool is_whole = !is_simple && !read.empty() && read.size() <= most_eyes;
        is_graph_ = is_whole && !is_low();
        has_eyes_only_ = is_whole && is_low() && read.size() > most_labelled && !hides_brain(view, vehicle.kind);
        const float wheels = wheels_share * bar.w, of_wheels = bar.x + bar.w - inset - wheels;
        if (has_eyes_only_)
            lay_out_in_columns(in_pairs(read, kind_of(*view.now, vehicle)),
                               {from, top, of_wheels - inset - from, height});
        else if (is_graph_ || (is_simple && !read.empty()))
            lay_out(read, eyes_, eyes);
        else
            lay_out({pair_.left, pair_.right}, eyes_, eyes);
        lay_out({"ML", "MR"}, wheels_, {of_wheels, top, wheels, height});
    }

    void draw() {
        for (const LiveRow& eye : eyes_) {
            eyes_.size() > most_labelled ? draw_line(eye) : draw_row(eye, false);
            mark(ui_, "lecture.eye." + eye.name, eye.place);
        }
        for (std::size_t i = 0; i < wheels_.size(); ++i) {
            LiveRow wheel = wheels_[i];
            wheel.value = asks_first() ? 0 : vehicle_.motor[i];
            draw_row(wheel, true);
            mark(ui_, i == 0 ? "lecture.left" : "lecture.right", wheel.place);
        }
        if (has_eyes_only_) return;
        const float from =
            eyes_.empty() ? bar_.x + words_share * bar_.w : eyes_.front().place.x + eyes_.front().place.w;
        const Rect between{from, bar_.y, wheels_.front().place.x - from, bar_.h};
        mark(ui_, "lecture.wires", between);
        if (hides_brain(view_, vehicle_.kind))
            say_hidden(between);
        else if (is_graph_)
            draw_graph(between);
        else
            draw_wires(between);
    }

private:
    // True while the audience is asked what a hidden brain does, which its wheels would tell.
    bool asks_first() const { return view_.settings.revealed.asks_first && hides_brain(view_, vehicle_.kind); }

    // In place of the wires of a hidden brain.
    void say_hidden(Rect between) {
        const std::string_view words = ui_.strings("wiring.hidden");
        const float width = between.w - 2 * ui_.px(spacing::large), line = line_height(ui_, Face::text);
        const auto lines = lines_of_words(ui_, words, Face::text, width);
        float y = between.y + (between.h - static_cast<float>(lines.size()) * line) / 2;
        for (const std::string& each : lines) {
            put_centred(ui_, {between.x + between.w / 2, y}, each, ui_.palette.second_text, Face::text);
            y += line;
        }
    }

    void lay_out(const std::vector<std::string>& names, std::vector<LiveRow>& rows, Rect area) {
        const float each = area.h / static_cast<float>(std::max<std::size_t>(1, names.size()));
        for (std::size_t i = 0; i < names.size(); ++i) {
            LiveRow row{find_node(brain_, names[i]), names[i], {}, 0};
            row.place = {area.x, area.y + each * static_cast<float>(i), area.w, each};
            if (row.node && !row.node->silenced) row.value = node_value(*view_.now, vehicle_, row.node->id);
            rows.push_back(std::move(row));
        }
    }

    // The eyes in as many rows as are legible, column by column.
    void lay_out_in_columns(const std::vector<std::string>& names, Rect area) {
        const std::size_t most =
            most_rows(static_cast<std::size_t>(std::max(1.0f, area.h / line_height(ui_, Face::small))));
        const std::size_t columns = (names.size() + most - 1) / most, rows = (names.size() + columns - 1) / columns;
        const float gap = ui_.px(spacing::large);
        const float each = (area.w - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
        const float height = area.h / static_cast<float>(rows);
        for (std::size_t first = 0, column = 0; first < names.size(); first += rows, ++column) {
            const auto from = names.begin() + static_cast<std::ptrdiff_t>(first);
            const auto count = static_cast<std::ptrdiff_t>(std::min(rows, names.size() - first));
            lay_out(
                {from, from + count}, eyes_,
                {area.x + (each + gap) * static_cast<float>(column), area.y, each, height * static_cast<float>(count)});
        }
    }

    // The bias of a wheel, between its name and its number: a part of the sum beside the products of the wires. Both
    // wheels have it in the same form, in little room with the name of the slider.
    void write_bias(const LiveRow& wheel, float y) {
        if (!wheel.node || wheel.node->bias == 0 || wheel.node->silenced || hides_brain(view_, vehicle_.kind)) return;
        const std::string widest = with_sign(ui_, 1, 2);
        const float space = ui_.px(spacing::small), widest_name = text_width(ui_, Face::title, "MR") + space;
        const float room = wheel.place.w - widest_name - text_width(ui_, Face::title, widest) - space;
        const std::string number = with_sign(ui_, wheel.node->bias, 2);
        const std::string_view pattern = ui_.strings("lecture.bias");
        const bool has_room = text_width(ui_, Face::text, fill(pattern, {widest})) <= room;
        const std::string words = has_room ? fill(pattern, {number})
                                           : std::string(name(wheel.name == "ML" ? Dial::LM : Dial::RM)) + " " + number;
        const float width = text_width(ui_, Face::text, words);
        if (width > room) return;
        const Rect place{wheel.place.x + widest_name + (room - width) / 2,
                         y + line_height(ui_, Face::title) - line_height(ui_, Face::text), width,
                         line_height(ui_, Face::text)};
        put(ui_, {place.x, place.y}, words, ui_.palette.second_text, Face::text);
        mark(ui_, "lecture.bias." + wheel.name, place);
    }

    // Name and number above a bar. The bar of a wheel begins in its middle.
    void draw_row(const LiveRow& row, bool is_wheel) {
        const Palette& p = ui_.palette;
        const float line = line_height(ui_, Face::title), gap = ui_.px(spacing::hair), h = ui_.px(live_bar);
        const float y = row.middle() - (line + gap + h) / 2;
        put(ui_, {row.place.x, y}, name_of(row), p.second_text, Face::title);
        const std::string number = !is_wheel      ? fixed(ui_, row.value, 2)
                                   : asks_first() ? std::string("?")
                                                  : with_sign(ui_, row.value, 2);
        put_right(ui_, {row.place.x + row.place.w, y}, number, p.text, Face::title);
        if (is_wheel) write_bias(row, y);
        const Rect track{row.place.x, y + line + gap, row.place.w, h};
        fill_box(ui_, track, p.line.with_alpha(0.6f), Corner::round);
        const float reach = std::clamp(row.value, -1.0f, 1.0f) * track.w * (is_wheel ? 0.5f : 1.0f);
        const float zero = is_wheel ? track.x + track.w / 2 : track.x;
        const Colour colour = is_wheel ? colour_of_weight(p, row.value) : colour_of(p, channel_of(row.name));
        if (std::fabs(reach) >= 1)
            fill_box(ui_, {std::min(zero, zero + reach), track.y, std::fabs(reach), track.h}, colour, Corner::round);
        if (is_wheel)
            fill_box(ui_, {zero - ui_.px(1), track.y - ui_.px(3), ui_.px(2), track.h + ui_.px(6)}, p.text,
                     Corner::square);
    }

    // The widest name of an eye, window pixels.
    float names_width() const {
        float widest = 0;
        for (const LiveRow& eye : eyes_) widest = std::max(widest, text_width(ui_, Face::small, name_of(eye)));
        return widest;
    }

    std::string name_of(const LiveRow& row) const {
        return wiring::short_name(kind_of(*view_.now, vehicle_).sensors, row.name);
    }

    // Name, bar and number in one line; only the bar where lines are too close for text, none where the text leaves it
    // no room.
    void draw_line(const LiveRow& row) {
        const Palette& p = ui_.palette;
        const bool has_text = row.place.h >= line_height(ui_, Face::small);
        const float h = std::min(ui_.px(live_bar), 0.7f * row.place.h);
        Rect track{row.place.x, row.middle() - h / 2, row.place.w, h};
        if (has_text) {
            const float y = row.middle() - line_height(ui_, Face::small) / 2;
            const float space = ui_.px(spacing::small), name = names_width() + space;
            put(ui_, {row.place.x, y}, name_of(row), p.second_text, Face::small);
            put_right(ui_, {row.place.x + row.place.w, y}, fixed(ui_, row.value, 2), p.text, Face::small);
            track.x += name, track.w -= name + text_width(ui_, Face::small, fixed(ui_, 0, 2)) + space;
            if (track.w < ui_.px(least_live_bar)) return;
            mark(ui_, "lecture.bar." + row.name, track);
        }
        fill_box(ui_, track, p.line.with_alpha(0.6f), Corner::round);
        const float reach = std::clamp(row.value, 0.0f, 1.0f) * track.w;
        if (reach >= 1) fill_box(ui_, {track.x, track.y, reach, h}, colour_of(p, channel_of(row.name)), Corner::round);
    }

    // Beside the watched diagram, which shows all wires.
    bool is_low() const { return bar_.h < ui_.px(low_picture); }

    Channel channel_of(const std::string& sensor) const {
        for (const Sensor& each : kind_of(*view_.now, vehicle_).sensors)
            if (each.name == sensor) return each.channel;
        return Channel::light;
    }

    const LiveRow* row_of(const std::vector<LiveRow>& rows, NodeId id) const {
        for (const LiveRow& row : rows)
            if (row.node && row.node->id == id) return &row;
        return nullptr;
    }

    void draw_graph(Rect between) {
        const float top = eyes_.front().place.y;
        const Rect area{between.x, top, between.w, eyes_.back().place.y + eyes_.back().place.h - top};
        const sketch::BrainLayout parts =
            sketch::lay_out_sideways(brain_, kind_of(*view_.now, vehicle_), pair_, area, ui_.px(1));
        ImGui::PushClipRect({between.x, between.y}, {between.x + between.w, between.y + between.h}, true);
        for (const sketch::WireMark& mark : parts.wires) {
            const Wire& wire = brain_.wires[static_cast<std::size_t>(mark.wire)];
            const float plus = learns(wire) ? learned(*view_.now, vehicle_, wire.from, wire.to) : 0;
            const Node* from = find_node(brain_, wire.from);
            const float input = from->silenced ? 0 : node_value(*view_.now, vehicle_, from->id);
            sketch::wire(ui_, mark.path,
                         {.weight = wire.weight + plus,
                          .carried = wire.cut ? 0 : signal(wire, input, plus),
                          .cut = wire.cut,
                          .thin = parts.wires.size() > 8});
        }
        const float r = parts.neuron_radius;
        for (const sketch::NodeMark& neuron : parts.neurons) {
            sketch::neuron(ui_, neuron.at, r, node_value(*view_.now, vehicle_, neuron.node->id), neuron.node->silenced,
                           0);
            mark(ui_, "lecture.neuron." + neuron.name, {neuron.at.x - r, neuron.at.y - r, 2 * r, 2 * r});
        }
        ImGui::PopClipRect();
    }

    void draw_wires(Rect between) {
        ImGui::PushClipRect({between.x, between.y}, {between.x + between.w, between.y + between.h}, true);
        int others = 0;
        struct Label {
            ImVec2 at;
            const Wire* wire;
        };
        std::vector<Label> labels;
        const float side = ui_.px(10);
        for (const Wire& wire : brain_.wires) {
            if (wire.weight == 0 && !learns(wire)) continue;
            const LiveRow *from = row_of(eyes_, wire.from), *to = row_of(wheels_, wire.to);
            if (!from || !to) {
                ++others;
                continue;
            }
            const ImVec2 a{between.x + side, from->middle()}, b{between.x + between.w - side, to->middle()};
            const float bend = (b.x - a.x) * 0.45f;
            const float input = from->value, carried = wire.cut ? 0 : wire.weight * let_through(wire, input);
            sketch::wire(ui_, {a, {a.x + bend, a.y}, {b.x - bend, b.y}, b},
                         {.weight = wire.weight, .carried = carried, .cut = wire.cut});
            labels.push_back({place_of_label(a, b), &wire});
        }
        for (const Label& label : labels) draw_weight(label.at, *label.wire);
        ImGui::PopClipRect();
        if (others == 0 || is_low()) return;
        const bool is_network = labels.empty();  // too large for a picture of the whole
        const float y = is_network ? between.y + (between.h - line_height(ui_, Face::small)) / 2
                                   : between.y + between.h - line_height(ui_, Face::small) - ui_.px(2);
        put_centred(ui_, {between.x + between.w / 2, y},
                    fill(ui_.strings(is_network ? "lecture.network" : "lecture.more_wires"), {std::to_string(others)}),
                    ui_.palette.second_text, Face::small);
    }

    // Near the eye on a wire to the other side, so that the labels of crossed wires are apart; else in the middle.
    ImVec2 place_of_label(ImVec2 a, ImVec2 b) const {
        const bool is_level = std::fabs(b.y - a.y) < 0.25f * bar_.h;
        const float t = is_level ? 0.70f : 0.25f, u = 1 - t;
        const float rise = 3 * u * t * t + t * t * t;  // of a curve that begins and ends level
        const float along = 3 * u * u * t * 0.45f + 3 * u * t * t * 0.55f + t * t * t;
        return {a.x + (b.x - a.x) * along, a.y + (b.y - a.y) * rise};
    }

    void draw_weight(ImVec2 at, const Wire& wire) {
        const Face face = is_low() ? Face::strong : Face::title;
        // What the wire does to the reading before the weight: without it the sum is not that of the numbers shown.
        std::string words = with_sign(ui_, wire.weight, 2);
        if (wire.threshold > 0) words += " > " + fixed(ui_, wire.threshold, 2);
        if (wire.curve.response != Response::linear) words += " f";
        const float w = text_width(ui_, face, words) + ui_.px(14), h = line_height(ui_, face) + ui_.px(2);
        const Rect pill{at.x - w / 2, at.y - h / 2, w, h};
        fill_box(ui_, pill, ui_.palette.raised);
        line_box(ui_, pill, colour_of_weight(ui_.palette, wire.weight), Corner::box, 1.5f);
        put_centred(ui_, {at.x, at.y - line_height(ui_, face) / 2}, words, ui_.palette.text, face);
        const Node *from = find_node(brain_, wire.from), *to = find_node(brain_, wire.to);
        mark(ui_, "lecture.weight." + from->name + "." + to->name, pill);
    }

    const LabView& view_;
    Ui& ui_;
    const VehicleView& vehicle_;
    const BrainGraph& brain_;
    SensorPair pair_;
    Rect bar_;
    bool has_eyes_only_ = false;  // no wires, but all eyes
    bool is_graph_ = false;       // the whole brain is shown, not only the wires between two eyes and the wheels
    std::vector<LiveRow> eyes_, wheels_;
};

// What its neurons hold decides what such a brain does; one word for all of its states would be wrong in most of them.
bool has_neurons(const Snapshot& now, const VehicleView& vehicle) {
    const std::vector<Node>& nodes = brain_of(now, vehicle)->nodes;
    return std::any_of(nodes.begin(), nodes.end(), [](const Node& node) { return node.kind == NodeKind::neuron; });
}

// Character and speed, at the left end; of a brain with neurons the speed.
void live_words(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, Rect bar) {
    const Palette& p = ui.palette;
    const float x = bar.x + ui.px(live_inset), width = words_share * bar.w - 2 * ui.px(live_inset);
    const Recognised& known = recognised(state.brain.recognised, *view.now, vehicle, view.wall_seconds);
    const bool is_unknown = hides_outcome(view) || is_brain_secret(view, vehicle.kind);
    const bool is_told = view.settings.revealed.character && !is_unknown;
    const std::string word =
        is_told ? std::string(ui.strings(
                      "character." + std::string(character_key(known, *view.now, vehicle, shown_pair(view, vehicle)))))
                : "?";
    const std::string speed = fill(ui.strings("info.metres_a_second"), {fixed(ui, vehicle.speed, 2)});
    const float small = line_height(ui, Face::small), large = line_height(ui, Face::title);
    const bool has_word = is_unknown || !has_neurons(*view.now, vehicle);
    const float gap = ui.px(spacing::small), both = 2 * (small + large) + gap;
    const float caption = both <= bar.h ? small : 0;  // a low bar has no room for captions
    float y = bar.y + (bar.h - (has_word ? 2 * (caption + large) + gap : caption + large)) / 2;
    const auto figure = [&](std::string_view anchor, const std::string& words) {
        if (caption > 0) put(ui, {x, y}, ui.strings(anchor), p.second_text, Face::small);
        const Face face = text_width(ui, Face::title, words) <= width ? Face::title : Face::strong;
        put(ui, {x, y + caption}, shortened(ui, words, face, width), p.text, face);
        mark(ui, anchor, {x, y, width, caption + large});
        y += caption + large + gap;
    };
    if (has_word) figure("lecture.character", word);
    figure("lecture.speed", speed);
}

}  // namespace

void live_brain(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, Rect bar) {
    live_words(view, state, ui, vehicle, bar);
    LiveBrain(view, ui, vehicle, bar).draw();
}

}  // namespace braitenlab::ui
