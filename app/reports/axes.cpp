#include "app/reports/axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/reports/html.h"
#include "core/utf8.h"
#include "ui/number_text.h"

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

std::string words_at(float x, float y, std::string_view words, std::string_view more) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" fill=\"{}\"{}>{}</text>\n", x, y, axis_ink,
                       more, xml_text(words));
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
