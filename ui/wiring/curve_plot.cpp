#include "ui/wiring/curve_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/imgui_compat.h"
#include "ui/theme.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

using maths::vec2;

namespace {

void line_along(ImDrawList& list, const CurvePlot& plot, const Curve& curve, Colour colour, float thickness) {
    constexpr int pieces = 64;
    std::array<ImVec2, pieces + 1> points;
    for (int i = 0; i <= pieces; ++i) {
        const float x = plot.low_x + (plot.high_x - plot.low_x) * static_cast<float>(i) / pieces;
        const vec2 at = plot.at(x, respond(curve, x));
        points[static_cast<std::size_t>(i)] = {at.x, at.y};
    }
    compat::polyline(list, points.data(), pieces + 1, paint(colour), false, thickness);
}

}  // namespace

vec2 CurvePlot::at(float x, float y) const {
    const float across = (x - low_x) / (high_x - low_x), up = (y - low_y) / (high_y - low_y);
    return {rect.x + rect.w * std::clamp(across, 0.0f, 1.0f), rect.y + rect.h * (1 - std::clamp(up, 0.0f, 1.0f))};
}

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

void draw_plot(ImDrawList& list, const Ui& ui, const CurvePlot& plot, const Curve& curve, std::optional<vec2> now) {
    const Palette& p = ui.palette;
    fill_box(ui, plot.rect, mix(p.panel, p.ground, 0.6f));
    const auto axis = [&](vec2 a, vec2 b) { list.AddLine({a.x, a.y}, {b.x, b.y}, paint(p.line), ui.px(1)); };
    axis(plot.at(plot.low_x, 0), plot.at(plot.high_x, 0));
    axis(plot.at(0, plot.low_y), plot.at(0, plot.high_y));
    line_along(list, plot, curve, p.text, ui.px(2));
    line_box(ui, plot.rect, p.line);
    if (!now) return;
    const vec2 dot = plot.at(now->x, now->y), foot = plot.at(now->x, 0);
    const Colour colour = colour_of_weight(p, now->y);
    list.AddLine({foot.x, foot.y}, {dot.x, dot.y}, paint(colour.with_alpha(0.7f)), ui.px(1.5f));
    list.AddCircleFilled({dot.x, dot.y}, ui.px(5.5f), paint(p.panel));
    list.AddCircleFilled({dot.x, dot.y}, ui.px(4), paint(colour));
}

void draw_curve_sign(ImDrawList& list, const Ui& ui, Rect rect, const Curve& curve, Colour colour) {
    CurvePlot plot = plot_of(curve, rect);
    const vec2 left = plot.at(plot.low_x, 0), right = plot.at(plot.high_x, 0);
    list.AddLine({left.x, left.y}, {right.x, right.y}, paint(ui.palette.line), ui.px(1));
    line_along(list, plot, curve, colour, ui.px(1.8f));
}

}  // namespace braitenlab
