// Pictures over time: the selected vehicle's eyes and motors, and the numbers of predators and prey.
#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

// A line through the samples, the newest at the right edge.
template <class Samples, class Value>
void line(const Ui& ui, Rect r, const Samples& samples, std::size_t most, float low, float high, Colour colour,
          Value value) {
    std::vector<ImVec2> points;
    points.reserve(samples.size());
    const float stride = r.w / static_cast<float>(most - 1);
    const float first = r.x + r.w - stride * (static_cast<float>(samples.size()) - 1);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const float share = std::clamp((value(samples[i]) - low) / (high - low), 0.0f, 1.0f);
        points.push_back({first + stride * static_cast<float>(i), r.y + r.h * (1 - share)});
    }
    if (points.size() > 1)
        compat::polyline(*ImGui::GetWindowDrawList(), points.data(), static_cast<int>(points.size()), paint(colour),
                         false, ui.px(1.5f));
}

void ground(const Ui& ui, Rect r) {
    fill_box(ui, {r.x, r.y - ui.px(2), r.w, r.h + ui.px(4)}, ui.palette.ground.with_alpha(0.45f), 3);
}

// One signal: its letters, and its line from `low` (or with 0 in the middle) to 1.
void signal_strip(const Ui& ui, Rect r, std::string_view letters, const std::deque<float>& samples, float low) {
    const float room = ui.px(26);
    put(ui, {r.x, r.y + (r.h - line_height(ui, Face::small)) / 2}, letters, ui.palette.second_text, Face::small);
    const Rect plot{r.x + room, r.y, r.w - room, r.h};
    ground(ui, plot);
    if (low < 0)
        ImGui::GetWindowDrawList()->AddLine({plot.x, plot.y + plot.h / 2}, {plot.x + plot.w, plot.y + plot.h / 2},
                                            paint(ui.palette.line), ui.px(1));
    line(ui, plot, samples, History::signal_samples, low, 1, ui.palette.text, [](float v) { return v; });
}

void signals(const History& history, Ui& ui) {
    constexpr float height = 20, row = 28;  // layout pixels
    constexpr std::string_view letters[]{"SL", "SR", "ML", "MR"};
    const float seconds = static_cast<float>(History::signal_samples * History::signal_period) / 60;
    subheading(ui, fill(ui.strings("info.last_seconds"), {fixed(seconds, 0)}));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float space = ui.px(12), half = (card_width(ui) - space) / 2;
    for (std::size_t i = 0; i < 4; ++i) {
        const Rect place{at.x + (i % 2 ? half + space : 0), at.y + ui.px(2) + ui.px(row) * (i < 2 ? 0.0f : 1.0f), half,
                         ui.px(height)};
        signal_strip(ui, place, letters[i], history.signals[i], i < 2 ? 0.0f : -1.0f);
    }
    ImGui::Dummy({card_width(ui), ui.px(2 * row - 4)});
    mark(ui, "info.signals", {at.x, at.y, card_width(ui), ui.px(2 * row - 4)});
}

void population(const History& history, Ui& ui) {
    subheading(ui, ui.strings("info.over_time"));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect plot{at.x, at.y + ui.px(2), card_width(ui), ui.px(36)};
    ground(ui, plot);
    float most = 1;
    for (const auto& sample : history.population) most = std::max({most, sample[0], sample[1]});
    for (const std::size_t side : {std::size_t{1}, std::size_t{0}}) {
        const Role role = side == 0 ? Role::predator : Role::prey;
        line(ui, plot, history.population, History::population_samples, 0, most * 1.1f, colour_of(ui.palette, role),
             [side](const auto& sample) { return sample[side]; });
        const float y = plot.y + plot.h * (1 - history.population.back()[side] / (most * 1.1f));
        put_role(ui, {plot.x + plot.w - ui.px(3), y}, ui.px(8), role);
    }
    ImGui::Dummy({plot.w, plot.h + ui.px(4)});
    mark(ui, "info.over_time", plot);
}

}  // namespace

void strips(const LabView& view, const History& history, Ui& ui) {
    if (!history.signals[0].empty()) signals(history, ui);
    if (view.now->predators + view.now->prey > 0 && !history.population.empty()) population(history, ui);
}

}  // namespace braitenlab
