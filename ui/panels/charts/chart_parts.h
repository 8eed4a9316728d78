// Parts that the charts and strips of the chart card share.
#pragma once

#include <algorithm>

#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

// The time axis: at least `least` seconds long, up to the newest sample.
inline Axis time_axis(double first, double last, double least) {
    return {first, std::max(last, first + least), " s", 0};
}

// The sample nearest to a moment.
template <class Samples>
const auto& nearest_sample(const Samples& samples, double seconds) {
    const auto later = std::lower_bound(samples.begin(), samples.end(), seconds,
                                        [](const auto& s, double at) { return s.seconds < at; });
    if (later == samples.end()) return samples.back();
    if (later == samples.begin()) return *later;
    const auto& before = *(later - 1);
    return seconds - before.seconds < later->seconds - seconds ? before : *later;
}

// Instead of a chart without samples.
inline void no_samples(const Ui& ui, Rect r) {
    const auto lines = even_lines(ui, ui.strings("charts.nothing"), Face::small, r.w);
    const float line = line_height(ui, Face::small);
    float y = r.y + r.h / 2 - line * static_cast<float>(lines.size());
    for (const std::string& each : lines) {
        put_centred(ui, {r.x + r.w / 2, y}, each, ui.palette.second_text, Face::small);
        y += line;
    }
}

}  // namespace braitenlab::ui
