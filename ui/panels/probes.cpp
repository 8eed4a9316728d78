// Probes of the diagram: the last seconds of a sensor, neuron or motor beside its node.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/chart_data.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

constexpr float probe_width = 150, probe_height = 46, probe_gap = 6, probe_pad = 5;  // layout pixels

// Below the node, or above it, or beside it: the first place in the area that covers no other node and no probe; else
// below.
Rect place_of_probe(const Ui& ui, Rect node, Rect area, const std::vector<Rect>& taken) {
    const float w = ui.px(probe_width), h = ui.px(probe_height), gap = ui.px(probe_gap);
    const float x = node.x + (node.w - w) / 2, y = node.y + (node.h - h) / 2;
    const Rect places[]{{x, node.y + node.h + gap, w, h},
                        {x, node.y - gap - h, w, h},
                        {node.x + node.w + gap, y, w, h},
                        {node.x - gap - w, y, w, h}};
    const auto is_free = [&](const Rect& r) {
        const bool is_inside =
            r.x >= area.x && r.y >= area.y && r.x + r.w <= area.x + area.w && r.y + r.h <= area.y + area.h;
        return is_inside && std::none_of(taken.begin(), taken.end(), [&](const Rect& t) {
                   return r.x < t.x + t.w && t.x < r.x + r.w && r.y < t.y + t.h && t.y < r.y + r.h;
               });
    };
    const auto free = std::find_if(std::begin(places), std::end(places), is_free);
    return free == std::end(places) ? places[0] : *free;
}

void draw_probe(const Ui& ui, const History& history, const Signal& signal, Rect r) {
    const Palette& p = ui.palette;
    fill_box(ui, r, p.panel.with_alpha(0.94f), 5);
    line_box(ui, r, p.accent.with_alpha(0.7f), 5);
    if (history.signals.empty()) return;
    const float pad = ui.px(probe_pad), number = text_width(ui, Face::small, with_sign(ui, -1, 2)) + pad;
    const Rect plot{r.x + pad, r.y + pad, r.w - 2 * pad - number, r.h - 2 * pad};
    const double now = history.signals.back().seconds;
    const Axis time{static_cast<float>(now - strip_seconds), static_cast<float>(now)};
    const SignalRange range = range_of(history, signal);
    const Axis values{range.low, range.high};
    const ImVec2 zero = plot_point(plot, time, values, time.low, 0);
    ImGui::GetWindowDrawList()->AddLine(zero, {plot.x + plot.w, zero.y}, paint(p.line), ui.px(1));
    const std::size_t first = first_in_strip(history);
    plot_line(ui, plot, time, values, history.signals.size() - first, p.accent, 1.6f, [&](std::size_t i) {
        const History::Signals& sample = history.signals[first + i];
        return ImVec2{static_cast<float>(sample.seconds), signal.value(sample)};
    });
    const float value = signal.value(history.signals.back()), h = line_height(ui, Face::small);
    const bool is_signed = signal.of != Signal::Of::sensor;
    put_right(ui, {r.x + r.w - pad, r.y + r.h / 2 - h}, is_signed ? with_sign(ui, value, 2) : fixed(ui, value, 2),
              p.text, Face::small);
    put_right(ui, {r.x + r.w - pad, r.y + r.h / 2}, ui.strings("wiring.probe_seconds"), p.second_text, Face::small);
}

}  // namespace

void draw_probes(const LabView& view, const PanelState& state, const Ui& ui, Rect area) {
    const VehicleView* vehicle = find_vehicle(*view.now, state.history.vehicle);
    if (state.canvas.probes.empty() || !vehicle || hides_brain(view, vehicle->kind)) return;
    std::vector<Rect> taken;
    for (const Node& node : brain_of(*view.now, *vehicle)->nodes)
        if (const Rect* rect = ui.anchors.find("node." + node.name)) taken.push_back(*rect);
    ImGui::Begin("wiring canvas");  // again: over what the canvas has drawn
    ImGui::PushClipRect({area.x, area.y}, {area.x + area.w, area.y + area.h}, false);
    for (const std::string& name : state.canvas.probes) {
        const Rect* node = ui.anchors.find("node." + name);
        const std::optional<Signal> signal = signal_named(state.history, name);
        if (!node || !signal) continue;
        const Rect place = place_of_probe(ui, *node, area, taken);
        draw_probe(ui, state.history, *signal, place);
        taken.push_back(place);
        ui.anchors.record("probe." + name, place);
    }
    ImGui::PopClipRect();
    ImGui::End();
}

}  // namespace braitenlab::ui
