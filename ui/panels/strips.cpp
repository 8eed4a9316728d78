// Pictures over time: the selected vehicle's eyes and motors, and the numbers of predators and prey.
#include <algorithm>
#include <string>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"

namespace braitenlab {

namespace {

void ground(const Ui& ui, Rect r) {
    fill_box(ui, {r.x, r.y - ui.px(2), r.w, r.h + ui.px(4)}, ui.palette.ground.with_alpha(0.45f), 3);
}

constexpr double shown_seconds = 10;

// The newest samples, as long as they are not older than the strips are wide.
std::size_t first_shown(const History& history) {
    const auto& all = history.signals;
    const double from = all.back().seconds - shown_seconds;
    const auto first = std::lower_bound(all.begin(), all.end(), from,
                                        [](const History::Signals& s, double at) { return s.seconds < at; });
    return static_cast<std::size_t>(first - all.begin());
}

// One signal: its letters, and its line from `low` (or with 0 in the middle) to 1, the newest at the right edge.
void signal_strip(const Ui& ui, Rect r, std::string_view letters, const History& history, std::size_t signal,
                  float low) {
    const float room = ui.px(26);
    put(ui, {r.x, r.y + (r.h - line_height(ui, Face::small)) / 2}, letters, ui.palette.second_text, Face::small);
    const Rect plot{r.x + room, r.y, r.w - room, r.h};
    ground(ui, plot);
    if (low < 0)
        ImGui::GetWindowDrawList()->AddLine({plot.x, plot.y + plot.h / 2}, {plot.x + plot.w, plot.y + plot.h / 2},
                                            paint(ui.palette.line), ui.px(1));
    const auto newest = static_cast<float>(history.signals.back().seconds);
    const Axis time{newest - static_cast<float>(shown_seconds), newest}, value{low, 1};
    const std::size_t first = first_shown(history);
    plot_line(ui, plot, time, value, history.signals.size() - first, ui.palette.text, 1.5f, [&](std::size_t i) {
        const History::Signals& s = history.signals[first + i];
        return ImVec2{static_cast<float>(s.seconds), s.values[signal]};
    });
}

void signals(const History& history, Ui& ui) {
    constexpr float height = 20, row = 28;  // layout pixels
    constexpr std::string_view letters[]{"SL", "SR", "ML", "MR"};
    subheading(ui, fill(ui.strings("info.last_seconds"), {fixed(static_cast<float>(shown_seconds), 0)}));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float space = ui.px(12), half = (card_width(ui) - space) / 2;
    for (std::size_t i = 0; i < 4; ++i) {
        const Rect place{at.x + (i % 2 ? half + space : 0), at.y + ui.px(2) + ui.px(row) * (i < 2 ? 0.0f : 1.0f), half,
                         ui.px(height)};
        signal_strip(ui, place, letters[i], history, i, i < 2 ? 0.0f : -1.0f);
    }
    ImGui::Dummy({card_width(ui), ui.px(2 * row - 4)});
    mark(ui, "info.signals", {at.x, at.y, card_width(ui), ui.px(2 * row - 4)});
}

void population(const History& history, Ui& ui) {
    subheading(ui, ui.strings("info.over_time"));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect plot{at.x, at.y + ui.px(2), card_width(ui), ui.px(36)};
    ground(ui, plot);
    constexpr std::size_t shown = 120;  // samples, one a second
    const auto& all = history.population;
    const std::size_t first = all.size() > shown ? all.size() - shown : 0;
    int most = 1;
    for (std::size_t i = first; i < all.size(); ++i) most = std::max({most, all[i].count[0], all[i].count[1]});
    const auto newest = static_cast<float>(all.back().seconds);
    const Axis time{newest - static_cast<float>(shown), newest}, value{0, static_cast<float>(most) * 1.1f};
    for (const std::size_t side : {std::size_t{1}, std::size_t{0}}) {
        const Role role = side == 0 ? Role::predator : Role::prey;
        plot_line(ui, plot, time, value, all.size() - first, colour_of(ui.palette, role), 1.5f, [&](std::size_t i) {
            return ImVec2{static_cast<float>(all[first + i].seconds), static_cast<float>(all[first + i].count[side])};
        });
        const float y = plot_point(plot, time, value, newest, static_cast<float>(all.back().count[side])).y;
        put_role(ui, {plot.x + plot.w - ui.px(3), y}, ui.px(8), role);
    }
    ImGui::Dummy({plot.w, plot.h + ui.px(4)});
    mark(ui, "info.over_time", plot);
}

}  // namespace

void strips(const LabView& view, const History& history, Ui& ui) {
    if (!history.signals.empty()) signals(history, ui);
    if (view.now->predators + view.now->prey > 0 && !history.population.empty()) population(history, ui);
}

}  // namespace braitenlab
