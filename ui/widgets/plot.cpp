#include "ui/widgets/plot.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

std::string number(const Ui& ui, double value, const Axis& axis) {
    return fixed(ui, value, axis.decimals) + std::string(axis.unit);
}

// The distance between the numbers of an axis. The decimals of the axis show it, so that no two numbers are equal.
double step_of(const Axis& axis, int most) {
    return std::max(round_step(axis.high - axis.low, most), std::pow(10.0, -axis.decimals));
}

// The first multiple of the step that is not below the axis.
double first_on(const Axis& axis, double step) { return std::ceil(axis.low / step - 1e-4) * step; }

Colour grid(const Ui& ui, bool is_zero) { return is_zero ? ui.palette.second_text : ui.palette.line.with_alpha(0.6f); }

// True where the line turns by more than 60°.
bool is_sharp(ImVec2 before, ImVec2 corner, ImVec2 after) {
    const ImVec2 in{corner.x - before.x, corner.y - before.y}, out{after.x - corner.x, after.y - corner.y};
    const float lengths = std::hypot(in.x, in.y) * std::hypot(out.x, out.y);
    return in.x * out.x + in.y * out.y < 0.5f * lengths;
}

}  // namespace

double round_step(double span, int most) {
    const double rough = span / std::max(1, most), power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double times : {1.0, 2.0, 5.0})
        if (power * times >= rough * 0.9999) return power * times;
    return power * 10;
}

ImVec2 plot_point(Rect r, const Axis& x, const Axis& y, PlotPoint at) {
    const auto across = static_cast<float>((at.x - x.low) / (x.high - x.low));
    const auto up = static_cast<float>(std::clamp((at.y - y.low) / (y.high - y.low), 0.0, 1.0));
    return {r.x + r.w * across, r.y + r.h * (1 - up)};
}

Rect plot_ground(const Ui& ui, Rect outer, const Axis& x, const Axis& y) {
    const float line = line_height(ui, Face::label);
    const float numbers =
        std::max(text_width(ui, Face::label, number(ui, y.high, y)), text_width(ui, Face::label, number(ui, y.low, y)));
    const float aside = (y.numbers ? numbers : 0) + ui.px(6);
    const Rect inner{outer.x + aside, outer.y + line / 2, outer.w - aside - ui.px(6), outer.h - 1.5f * line - ui.px(3)};
    fill_box(ui, inner, ui.palette.ground.with_alpha(0.45f), Corner::box);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const double y_step = step_of(y, std::max(2, static_cast<int>(inner.h / (1.6f * line))));
    // A low plot has a number at its zero and its end only, whichever have room.
    const auto apart = static_cast<float>(y_step / (y.high - y.low)) * inner.h;
    const int every = std::max(1, static_cast<int>(std::ceil(0.8f * line / std::max(apart, 1.0f))));
    for (double v = first_on(y, y_step); y.numbers && v <= y.high + y_step * 1e-3; v += y_step) {
        const float at = plot_point(inner, x, y, {x.low, v}).y;
        draw.AddLine({inner.x, at}, {inner.x + inner.w, at}, paint(grid(ui, std::fabs(v) < y_step * 1e-3)), ui.px(1));
        if (std::lround(v / y_step) % every == 0)
            put_right(ui, {inner.x - ui.px(6), at - line / 2}, number(ui, v, y), ui.palette.second_text, Face::label);
    }
    if (!x.numbers) return inner;
    const float widest = text_width(ui, Face::label, number(ui, x.high, x)) + ui.px(44);
    const double x_step = step_of(x, std::max(1, static_cast<int>(inner.w / widest)));
    for (double v = first_on(x, x_step); v <= x.high + x_step * 1e-3; v += x_step) {
        const float at = plot_point(inner, x, y, {v, y.low}).x;
        draw.AddLine({at, inner.y}, {at, inner.y + inner.h}, paint(grid(ui, false)), ui.px(1));
        const std::string words = number(ui, v, x);
        const float half = text_width(ui, Face::label, words) / 2;
        const float middle = std::clamp(at, outer.x + half, outer.x + outer.w - half);
        put_centred(ui, {middle, inner.y + inner.h + ui.px(3)}, words, ui.palette.second_text, Face::label);
    }
    return inner;
}

std::optional<double> plot_cursor(const Ui& ui, Rect inner, const Axis& x) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!inner.contains(mouse.x, mouse.y) || !ImGui::IsWindowHovered()) return std::nullopt;
    ImGui::GetWindowDrawList()->AddLine({mouse.x, inner.y}, {mouse.x, inner.y + inner.h}, paint(ui.palette.text),
                                        ui.px(1));
    return x.low + static_cast<double>((mouse.x - inner.x) / inner.w) * (x.high - x.low);
}

void plot_words(const Ui& ui, Rect inner, float pixel_x, const std::string_view* lines, const Colour* colours,
                int count) {
    float widest = 0;
    for (int i = 0; i < count; ++i) widest = std::max(widest, text_width(ui, Face::label, lines[i]));
    const float line = line_height(ui, Face::label), pad = ui.px(spacing::small), away = ui.px(10);
    const float w = widest + 2 * pad, h = static_cast<float>(count) * line + 2 * ui.px(3);
    // On the side where there is room.
    const float x = pixel_x + away + w <= inner.x + inner.w ? pixel_x + away : std::max(inner.x, pixel_x - away - w);
    const Rect box{x, inner.y + ui.px(3), w, h};
    fill_box(ui, box, ui.palette.raised.with_alpha(0.94f));
    line_box(ui, box, ui.palette.line);
    for (int i = 0; i < count; ++i)
        put(ui, {box.x + pad, box.y + ui.px(3) + static_cast<float>(i) * line}, lines[i], colours[i], Face::label);
}

namespace detail {

void path_to(ImVec2 point) { ImGui::GetWindowDrawList()->PathLineToMergeDuplicate(point); }

// Dear ImGui's mitred joins extend up to five times the line's width beyond a sharp corner. The line is therefore drawn
// in pieces that end at sharp corners, with a disc over each of these corners.
void stroke(const Ui& ui, Colour colour, float layout_thickness) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float thickness = ui.px(layout_thickness);
    ImVector<ImVec2> path;
    path.swap(draw._Path);  // the discs use the path of the draw list
    for (int first = 0, i = 1; i < path.Size; ++i) {
        const bool is_last = i + 1 == path.Size;
        if (!is_last && !is_sharp(path[i - 1], path[i], path[i + 1])) continue;
        draw.AddPolyline(&path[first], i - first + 1, paint(colour), 0, thickness);
        if (!is_last) draw.AddCircleFilled(path[i], thickness / 2, paint(colour));
        first = i;
    }
    path.resize(0);
    path.swap(draw._Path);  // keeps its memory
}

}  // namespace detail

}  // namespace braitenlab::ui
