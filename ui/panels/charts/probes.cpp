// Probes of the diagram: the last seconds of a sensor, neuron or motor beside its node.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/charts/chart_data.h"
#include "ui/panels/panels.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float least_probe = 84, largest_probe = 150, probe_gap = spacing::small,
                probe_pad = spacing::tight;                 // layout pixels
constexpr float probe_share = 1.15f, probe_height = 0.32f;  // width: of the node's width; height: of the probe's width

bool covers_one(const Rect& r, const std::vector<Rect>& others) {
    return std::any_of(others.begin(), others.end(), [&](const Rect& other) { return other.overlaps(r); });
}

// Below the node, above it, right or left of it, at its corners: the first place in the area that covers no node and no
// probe, else no node; else below.
Rect place_of_probe(const Ui& ui, Rect node, Rect area, const std::vector<Rect>& nodes,
                    const std::vector<Rect>& probes) {
    const float w = std::clamp(probe_share * node.w, ui.px(least_probe), ui.px(largest_probe)), h = probe_height * w;
    const float gap = ui.px(probe_gap), x = node.x + (node.w - w) / 2, y = node.y + (node.h - h) / 2;
    const float right = node.x + node.w + gap, left = node.x - gap - w, below = node.y + node.h + gap,
                above = node.y - gap - h;
    const Rect places[]{{x, below, w, h},     {x, above, w, h},     {right, y, w, h},    {left, y, w, h},
                        {right, below, w, h}, {right, above, w, h}, {left, below, w, h}, {left, above, w, h}};
    const auto first = [&](auto is_wanted) {
        return std::find_if(std::begin(places), std::end(places), [&](const Rect& r) {
            const bool is_inside =
                r.x >= area.x && r.y >= area.y && r.x + r.w <= area.x + area.w && r.y + r.h <= area.y + area.h;
            return is_inside && is_wanted(r);
        });
    };
    const auto free = first([&](const Rect& r) { return !covers_one(r, nodes) && !covers_one(r, probes); });
    if (free != std::end(places)) return *free;
    const auto beside_nodes = first([&](const Rect& r) { return !covers_one(r, nodes); });
    return beside_nodes != std::end(places) ? *beside_nodes : places[0];
}

void draw_probe(const Ui& ui, const History& history, const Signal& signal, Rect r) {
    const Palette& p = ui.palette;
    fill_box(ui, r, p.panel.with_alpha(0.94f));
    line_box(ui, r, p.accent.with_alpha(0.7f));
    if (history.signals.empty()) return;
    const float pad = ui.px(probe_pad), number = text_width(ui, Face::small, with_sign(ui, -1, 2)) + pad;
    const Rect plot{r.x + pad, r.y + pad, r.w - 2 * pad - number, r.h - 2 * pad};
    const double now = history.signals.back().seconds;
    const Axis time{now - strip_seconds, now};
    const SignalRange range = range_of(history, signal);
    const Axis values{range.low, range.high};
    const ImVec2 zero = plot_point(plot, time, values, {time.low, 0});
    ImGui::GetWindowDrawList()->AddLine(zero, {plot.x + plot.w, zero.y}, paint(p.line), ui.px(1));
    const std::size_t first = first_in_strip(history);
    plot_line(ui, plot, time, values, history.signals.size() - first, p.accent, 1.6f, [&](std::size_t i) {
        const History::Signals& sample = history.signals[first + i];
        return PlotPoint{sample.seconds, signal.value(sample)};
    });
    const float value = signal.value(history.signals.back()), h = line_height(ui, Face::small);
    const bool is_signed = signal.of != Signal::Of::sensor;
    const bool has_seconds = r.h >= 2 * h;
    put_right(ui, {r.x + r.w - pad, r.y + r.h / 2 - (has_seconds ? h : h / 2)},
              is_signed ? with_sign(ui, value, 2) : fixed(ui, value, 2), p.text, Face::small);
    if (has_seconds)
        put_right(ui, {r.x + r.w - pad, r.y + r.h / 2}, ui.strings("wiring.probe_seconds"), p.second_text, Face::small);
}

}  // namespace

void draw_probes(const LabView& view, const PanelState& state, const Ui& ui, Rect area) {
    const VehicleView* vehicle = find_vehicle(*view.now, state.charts.history.vehicle);
    if (state.canvas.probes.empty() || !vehicle || hides_brain(view, vehicle->kind)) return;
    std::vector<Rect> nodes, probes;
    for (const Node& node : brain_of(*view.now, *vehicle)->nodes)
        if (const Rect* rect = ui.anchors.find("node." + node.name)) nodes.push_back(*rect);
    ImGui::Begin("wiring canvas");  // again: over what the canvas has drawn
    ImGui::PushClipRect({area.x, area.y}, {area.x + area.w, area.y + area.h}, false);
    for (const std::string& name : state.canvas.probes) {
        const Rect* node = ui.anchors.find("node." + name);
        const std::optional<Signal> signal = signal_named(state.charts.history, name);
        if (!node || !signal) continue;
        const Rect place = place_of_probe(ui, *node, area, nodes, probes);
        draw_probe(ui, state.charts.history, *signal, place);
        probes.push_back(place);
        ui.anchors.record("probe." + name, place);
    }
    ImGui::PopClipRect();
    compat::end_window();
}

}  // namespace braitenlab::ui
