// Probes of the diagram: the last seconds of a sensor, neuron or motor beside its node.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/chart_data.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

constexpr double probed_seconds = 10;
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

void draw_probe(const Ui& ui, const History& history, const Signal& signal, Rect r, double now) {
    const Palette& p = ui.palette;
    fill_box(ui, r, p.panel.with_alpha(0.94f), 5);
    line_box(ui, r, p.accent.with_alpha(0.7f), 5);
    const float pad = ui.px(probe_pad), number = text_width(ui, Face::small, with_sign(ui, -1, 2)) + pad;
    const Rect plot{r.x + pad, r.y + pad, r.w - 2 * pad - number, r.h - 2 * pad};
    const SignalRange range = range_of(history, signal);
    const auto height = [&](float value) {
        return plot.y + plot.h * (1 - (value - range.low) / (range.high - range.low));
    };
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddLine({plot.x, height(0)}, {plot.x + plot.w, height(0)}, paint(p.line), ui.px(1));
    std::vector<ImVec2> line;
    for (const History::Signals& sample : history.signals) {
        const double ago = now - sample.seconds;
        if (ago < 0 || ago > probed_seconds) continue;
        line.push_back({plot.x + plot.w * static_cast<float>(1 - ago / probed_seconds), height(signal.value(sample))});
    }
    if (line.size() > 1) draw.AddPolyline(line.data(), static_cast<int>(line.size()), paint(p.accent), 0, ui.px(1.6f));
    const float value = history.signals.empty() ? 0 : signal.value(history.signals.back()),
                h = line_height(ui, Face::small);
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
        draw_probe(ui, state.history, *signal, place, view.now->seconds);
        taken.push_back(place);
        ui.anchors.record("probe." + name, place);
    }
    ImGui::PopClipRect();
    ImGui::End();
}

}  // namespace braitenlab::ui
