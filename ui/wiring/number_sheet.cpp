#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/widgets/button.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/inspector.h"
#include "ui/wiring/menu.h"
#include "ui/words/strings.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

// A plot's rectangle and axes.
struct CurvePlot {
    Rect rect;  // window pixels
    float low_x = -1, high_x = 1;
    float low_y = -1, high_y = 1;
    // Window pixels; clamped to the rectangle.
    maths::vec2 at(float x, float y) const;
};

void draw_curve_line(ImDrawList& list, const CurvePlot& plot, const Curve& curve, Colour colour, float thickness) {
    constexpr int pieces = 64;
    std::array<ImVec2, pieces + 1> points;
    for (int i = 0; i <= pieces; ++i) {
        const float x = plot.low_x + (plot.high_x - plot.low_x) * static_cast<float>(i) / pieces;
        const vec2 at = plot.at(x, respond(curve, x));
        points[static_cast<std::size_t>(i)] = {at.x, at.y};
    }
    compat::polyline(list, points.data(), pieces + 1, paint(colour), false, thickness);
}

vec2 CurvePlot::at(float x, float y) const {
    const float across = (x - low_x) / (high_x - low_x), up = (y - low_y) / (high_y - low_y);
    return {rect.x + rect.w * std::clamp(across, 0.0f, 1.0f), rect.y + rect.h * (1 - std::clamp(up, 0.0f, 1.0f))};
}

// Shows inputs −1..1 and 0.5 beyond the peak.
CurvePlot plot_of(const Curve& curve, Rect rect) {
    CurvePlot plot{rect};
    const ResponseTraits& response = traits(curve.response);
    if (response.has_peak) {
        plot.low_x = std::min(-1.0f, curve.peak - 0.5f);
        plot.high_x = std::max(1.0f, curve.peak + 0.5f);
    }
    plot.low_y = std::min(-1.0f, response.low);
    plot.high_y = std::max(1.0f, response.high);
    return plot;
}

// `now`: the input and the value that a dot marks.
void draw_plot(ImDrawList& list, const Ui& ui, const CurvePlot& plot, const Curve& curve, std::optional<vec2> now) {
    const Palette& p = ui.palette;
    fill_box(ui, plot.rect, mix(p.panel, p.ground, 0.6f));
    const auto axis = [&](vec2 a, vec2 b) { list.AddLine({a.x, a.y}, {b.x, b.y}, paint(p.line), ui.px(1)); };
    axis(plot.at(plot.low_x, 0), plot.at(plot.high_x, 0));
    axis(plot.at(0, plot.low_y), plot.at(0, plot.high_y));
    draw_curve_line(list, plot, curve, p.text, ui.px(2));
    line_box(ui, plot.rect, p.line);
    if (!now) return;
    const vec2 dot = plot.at(now->x, now->y), foot = plot.at(now->x, 0);
    const Colour colour = colour_of_weight(p, now->y);
    list.AddLine({foot.x, foot.y}, {dot.x, dot.y}, paint(colour.with_alpha(0.7f)), ui.px(1.5f));
    list.AddCircleFilled({dot.x, dot.y}, ui.px(5.5f), paint(p.panel));
    list.AddCircleFilled({dot.x, dot.y}, ui.px(4), paint(colour));
}

constexpr float least_track = 110;  // layout pixels, with the space of the knob at both ends
constexpr float plot_side = 104, kind_width = 44, kind_height = 30, column_space = spacing::large;  // layout pixels
constexpr float numbers_of_a_wire = 4;  // weight, threshold, learning, forgetting
constexpr std::size_t curve_columns = 3;
constexpr float curves_width = static_cast<float>(curve_columns) * kind_width + (curve_columns - 1) * spacing::tight,
                room_for_plot = 680;

bool curve_button(Ui& ui, std::size_t index, const Curve& curve) {
    const Item at =
        item(ui, "inspector.kind." + std::to_string(index + 1), {ui.px(kind_width), ui.px(ui.tall(kind_height))});
    const Palette& p = ui.palette;
    const Response response = responses[index].value;
    const bool on = curve.response == response;
    fill_box(ui, at.rect, on ? mix(p.panel, p.accent, 0.20f) : mix(p.raised, p.line, at.warmth * 0.6f));
    line_box(ui, at.rect, on ? p.accent : p.line);
    const float inset = ui.px(spacing::tight);
    draw_curve(*ImGui::GetWindowDrawList(), ui,
               {at.rect.x + inset, at.rect.y + inset, at.rect.w - 2 * inset, at.rect.h - 2 * inset}, {response},
               on ? p.text : p.second_text);
    tooltip(ui, at, ui.strings(kind_key(index)));
    return at.pressed && !on;
}

// The width of the longest word before a slider, layout pixels.
float widest_words(const Ui& ui) {
    float widest = 0;
    for (const char* key :
         {"inspector.weight", "inspector.threshold", "inspector.bias", "inspector.memory", "inspector.peak",
          "inspector.middle", "inspector.step_at", "inspector.width", "inspector.learning", "inspector.decay"})
        widest = std::max(widest, text_width(ui, Face::text, ui.strings(key)) / ui.scale + spacing::small);
    return widest;
}

// The name of a curve's peak: string keys of the word and its tooltip.
struct PeakWords {
    std::string_view words, tooltip;
};

PeakWords peak_words(Response response, bool has_threshold) {
    if (response == Response::step)
        return {has_threshold ? "inspector.step_at" : "inspector.threshold", "inspector.step_how"};
    if (response == Response::sigmoid) return {"inspector.middle", "inspector.middle_how"};
    return {"inspector.peak", "inspector.peak_how"};
}

// Widths below are in window pixels; `width` is that of the card's content.
bool has_room_for_plot(const Ui& ui, float width) { return width > ui.px(room_for_plot); }

float room_for_sliders(const Ui& ui, float width) {
    const float plot = has_room_for_plot(ui, width) ? plot_side + column_space : 0;
    return width - ui.px(plot + curves_width + column_space + spacing::medium);
}

float half_of(const Ui& ui, float room) { return (room - ui.px(column_space)) / 2; }

bool is_one_column(const Ui& ui, float room) {
    return half_of(ui, room) < ui.px(widest_words(ui) + SliderLook{}.number_width + least_track);
}

}  // namespace

std::string_view Inspected::words(std::string_view key) const { return ui.strings(key); }

const Node* Inspected::node() const {
    const CanvasSelection& chosen = state.selection;
    const bool one = chosen.nodes.size() == 1 && chosen.wires.empty();
    return one ? find_node(graph(), *chosen.nodes.begin()) : nullptr;
}

std::optional<WireEnds> Inspected::wire() const {
    const CanvasSelection& chosen = state.selection;
    const bool one = chosen.wires.size() == 1 && chosen.nodes.empty();
    return one ? std::optional(*chosen.wires.begin()) : std::nullopt;
}

float Inspected::value(NodeId id) const { return node_value(*view.now, vehicle, id); }

float Inspected::learned_by(const Wire& wire) const {
    return learns(wire) ? learned(*view.now, vehicle, wire.from, wire.to) : 0;
}

void Inspected::send(Command command, std::uint64_t gesture) {
    ui.outbox.push_back(EditRequest{std::move(command), gesture});
}

void Inspected::send(const Edit& edit, std::uint64_t gesture) {
    if (edit) send(SetBrain{target, keep_positions(*edit.graph, state.layout.get(brain, state.held))}, gesture);
}

void draw_curve(ImDrawList& list, const Ui& ui, Rect rect, const Curve& curve, Colour colour) {
    CurvePlot plot = plot_of(curve, rect);
    const vec2 left = plot.at(plot.low_x, 0), right = plot.at(plot.high_x, 0);
    list.AddLine({left.x, left.y}, {right.x, right.y}, paint(ui.palette.line), ui.px(1));
    draw_curve_line(list, plot, curve, colour, ui.px(1.8f));
}

NumberSheet::NumberSheet(Inspected& in, Curve& curve, const SheetHead& head)
    : in_(in), plots_(has_room_for_plot(in.ui, ImGui::GetContentRegionAvail().x)), words_width_(widest_words(in.ui)) {
    const float room = room_for_sliders(in.ui, ImGui::GetContentRegionAvail().x);
    in_one_column_ = is_one_column(in.ui, room);
    slider_width_ = in_one_column_ ? room : half_of(in.ui, room);
    if (plots_) plot(curve, head.input);
    choose_curve(curve, head);
    ImGui::BeginGroup();
    // Under each other the sliders are close, so that all of a wire fit.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {ImGui::GetStyle().ItemSpacing.x, in_one_column_ ? 0.0f : in.ui.px(spacing::small)});
}

NumberSheet::~NumberSheet() {
    if (sliders_ == 0) ImGui::Dummy({1, 1});
    ImGui::PopStyleVar();
    compat::end_group();
}

void NumberSheet::plot(const Curve& curve, float input) {
    Ui& ui = in_.ui;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Item area = item(ui, "inspector.plot", {ui.px(plot_side), ui.px(plot_side)}, false);
    draw_plot(*ImGui::GetWindowDrawList(), ui, plot_of(curve, {at.x, at.y, area.rect.w, area.rect.h}), curve,
              maths::vec2{input, respond(curve, input)});
    tooltip(ui, area, in_.words("inspector.plot_how"));
    ImGui::SameLine(0, ui.px(column_space));
}

void NumberSheet::choose_curve(Curve& curve, const SheetHead& head) {
    Ui& ui = in_.ui;
    ImGui::BeginGroup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::tight), ui.px(spacing::tight)});
    for (std::size_t i = 0; i < responses.size(); ++i) {
        if (i % curve_columns != 0) ImGui::SameLine();
        if (!curve_button(ui, i, curve)) continue;
        curve.response = responses[i].value;
        gesture_ = in_.state.next_gesture++;
    }
    lesion_button(in_, head.lesioned, head.lesion_words);
    ImGui::PopStyleVar();
    compat::end_group();
    ImGui::SameLine(0, ui.px(column_space));
}

void NumberSheet::number(const Number& n, float& value) {
    if (sliders_++ % 2 == 1 && !in_one_column_) ImGui::SameLine(0, in_.ui.px(column_space));
    const std::string id(n.id);
    SliderLook look;
    look.words = in_.words(n.words);
    look.tooltip = in_.words(n.tooltip);
    look.low = n.low;
    look.high = in_.sliders.typed == id ? n.typed_high : n.high;
    look.signed_number = look.meaning = n.is_signed;
    look.words_width = words_width_;
    const auto edit = slider(in_.ui, in_.sliders, id, value, slider_width_, in_.view.wall_seconds, look);
    if (edit) value = edit->value, gesture_ = edit->gesture;
}

void NumberSheet::curve_numbers(Curve& curve, bool has_threshold) {
    const PeakWords words = peak_words(curve.response, has_threshold);
    if (traits(curve.response).has_peak)
        number({"inspector.peak", words.words, words.tooltip, -2, 2, 2, true}, curve.peak);
    if (traits(curve.response).has_width)
        number({"inspector.width", "inspector.width", "inspector.width_how", 0.01f, 2, 10}, curve.width);
}

float sheet_height(const Ui& ui, float width) {
    constexpr float below_heading = 12;  // layout pixels
    constexpr auto rows = static_cast<float>((responses.size() + curve_columns - 1) / curve_columns);
    const float curves = 44 + rows * (ui.tall(kind_height) + spacing::tight);
    const float row = ui.tall(slider_height);
    const bool stands = is_one_column(ui, room_for_sliders(ui, width));
    const float numbers = stands ? numbers_of_a_wire * row : 2 * row + spacing::small;
    return folded_height(ui) + ui.px(below_heading + std::max(curves, numbers));
}

void lesion_button(Inspected& in, bool lesioned, std::string_view lesion_words) {
    ButtonLook look{{}, in.words(lesioned ? "wiring.do.heal" : lesion_words)};
    look.on = lesioned;
    look.min_width = curves_width;
    const Item at = button(in.ui, "inspector.lesion", look);
    tooltip(in.ui, at, in.words("inspector.lesion_how"));
    if (!at.pressed) return;
    in.state.hovered = {};  // the lesion is for the selection, not for the part under the pointer
    in.state.actions.push_back(Action::lesion);
}

}  // namespace braitenlab::wiring
