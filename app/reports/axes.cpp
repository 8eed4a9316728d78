#include "app/reports/axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/utf8.h"
#include "core/xml_text.h"
#include "ui/words/number_text.h"

namespace braitenlab {

float tick_step(float range) {
    const float wanted = range / 6, power = std::pow(10.0f, std::floor(std::log10(wanted))), share = wanted / power;
    return power * (share > 5 ? 10.0f : share > 2 ? 5.0f : share > 1 ? 2.0f : 1.0f);
}

std::vector<float> axis_ticks(float a, float b, float step) {
    const float low = std::min(a, b), high = std::max(a, b);
    std::vector<float> ticks;
    for (float k = std::ceil(low / step - 1e-3f); k * step <= high + step * 1e-3f; k += 1) ticks.push_back(k * step);
    return ticks;
}

std::string tick_text(float value, float step, const Strings& strings) {
    const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-4f)), 0, 6);
    return ui::fixed(value == 0 ? 0 : value, decimals, decimal_mark(strings));
}

std::string placed(float x, float y, std::string_view content) {
    return fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", x, y, content);
}

std::string words_at(float x, float y, std::string_view words, std::string_view more) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" fill=\"{}\"{}>{}</text>\n", x, y, axis_ink,
                       more, xml_text(words));
}

float PlotFrame::Axis::share(double value) const {
    if (cells.empty()) return static_cast<float>((value - from) / (to - from));
    const auto place = std::lower_bound(cells.begin(), cells.end(), value) - cells.begin();
    return static_cast<float>(place) / static_cast<float>(std::max<std::size_t>(1, cells.size() - 1));
}

std::string frame_svg(const PlotFrame& frame, std::string_view x_label, std::string_view y_label,
                      const Strings& strings) {
    std::string out = fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\"/>\n", frame.width,
                                  frame.height, axis_ink);
    std::string marks;
    const auto for_each_tick = [&](const PlotFrame::Axis& axis, const auto& each) {
        const auto from = static_cast<float>(axis.from), to = static_cast<float>(axis.to);
        const float step = std::max(axis.least_step, tick_step(std::fabs(to - from)));
        const auto is_place = [&](float value) {
            return axis.cells.empty() ||
                   std::binary_search(axis.cells.begin(), axis.cells.end(), static_cast<double>(value));
        };
        for (const float value : axis_ticks(from, to, step))
            if (is_place(value)) each(static_cast<double>(value), tick_text(value, step, strings));
    };
    for_each_tick(frame.x, [&](double value, const std::string& number) {
        marks += fmt::format("M{:.1f} {}v6", frame.x_of(value), frame.height);
        out += words_at(frame.x_of(value), frame.height + 22, number, " text-anchor=\"middle\"");
    });
    for_each_tick(frame.y, [&](double value, const std::string& number) {
        marks += fmt::format("M0 {:.1f}h-6", frame.y_of(value));
        out += words_at(-11, frame.y_of(value) + 5, number, " text-anchor=\"end\"");
    });
    out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\"/>\n", marks, axis_ink);
    out += words_at(frame.width / 2, frame.height + 46, x_label, " text-anchor=\"middle\" font-weight=\"bold\"");
    return out + words_at(-frame.height / 2, -62, y_label,
                          " transform=\"rotate(-90)\" text-anchor=\"middle\" font-weight=\"bold\"");
}

std::string colour_text(const ui::MapColour& colour) {
    const auto part = [](float share) { return static_cast<int>(std::lround(share * 255)); };
    return fmt::format("#{:02x}{:02x}{:02x}", part(colour.r), part(colour.g), part(colour.b));
}

std::string square_data(float x, float y, float size) {
    return fmt::format("M{:.2f} {:.2f}h{:.2f}v{:.2f}h-{:.2f}z", x, y, size, size, size);
}

std::string scale_svg(const ui::MapScale& scale, const Strings& strings) {
    constexpr int steps = 40;
    constexpr float above = 24, height = scale_bottom - above, width = 16;
    std::string out;
    for (int i = 0; i < steps; ++i)
        out += fmt::format("<rect y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
                           above + height * static_cast<float>(steps - 1 - i) / steps, width, height / steps + 0.5f,
                           colour_text(ui::scale_colour((static_cast<float>(i) + 0.5f) / steps)));
    const float step = tick_step(scale.high - scale.low);
    for (const float value : axis_ticks(scale.low, scale.high, step)) {
        const float y = above + height * (1 - scale.share(value));
        out += fmt::format("<path d=\"M{} {:.1f}h6\" stroke=\"{}\"/>\n", width, y, axis_ink) +
               words_at(width + 12, y + 5, tick_text(value, step, strings));
    }
    return out;
}

std::string outlined_text(float x, float y, std::string_view anchor, std::string_view fill, std::string_view words) {
    const std::string place =
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" text-anchor=\"{}\"", x, y, anchor);
    const std::string text = xml_text(words);
    return fmt::format(
        "{0} fill=\"#fff\" stroke=\"#fff\" stroke-width=\"3\" "
        "aria-hidden=\"true\">{1}</text>\n"
        "{0} fill=\"{2}\">{1}</text>\n",
        place, text, fill);
}

LabelBox label_box(float x, float y, std::string_view anchor, std::string_view words) {
    const float width = 7.7f * static_cast<float>(count_characters(words));
    const float left = anchor == "middle" ? x - width / 2 : anchor == "end" ? x - width : x;
    return {left, left + width, y - 10, y + 3};
}

bool is_free(const LabelBox& box, const std::vector<LabelBox>& taken) {
    return std::none_of(taken.begin(), taken.end(), [&](const LabelBox& other) {
        return box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom;
    });
}

}  // namespace braitenlab
