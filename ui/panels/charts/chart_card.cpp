// The card of the large charts: signals of the selected vehicle (strips: chart_strips.cpp), population and mean energy
// over time, and the energy of each vehicle as bars.
#include <algorithm>
#include <array>
#include <string>

#include <imgui.h>

#include "ui/panels/cards.h"
#include "ui/panels/charts/chart_data.h"
#include "ui/panels/charts/chart_parts.h"
#include "ui/panels/charts/chart_strips.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr std::array chart_roles{Role::predator, Role::prey, Role::none};
constexpr std::array line_widths{3.6f, 2.0f, 1.2f};  // drawn in this order: lines on top of each other stay visible

// Values beside the pointer, one line each.
class ReadOut {
public:
    void add(std::string words, Colour colour) {
        if (count_ == words_.size()) return;
        words_[count_] = std::move(words);
        colours_[count_++] = colour;
    }
    void show(const Ui& ui, Rect inner, float pixel_x) const {
        std::array<std::string_view, most> lines;
        for (std::size_t i = 0; i < count_; ++i) lines[i] = words_[i];
        plot_words(ui, inner, pixel_x, lines.data(), colours_.data(), static_cast<int>(count_));
    }

private:
    static constexpr std::size_t most = 6;
    std::array<std::string, most> words_;
    std::array<Colour, most> colours_{};
    std::size_t count_ = 0;
};

Rect rest_of_card(Ui& ui, Rect card) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    return {at.x, at.y, card_width(ui), std::max(ui.px(40), card.y + card.h - ui.px(12) - at.y)};
}

// Left and right sensor, or left and right motor. The left line is wide and the right one narrow: both are visible
// where they overlap.
void signal_pair(const History& history, const ShownSignals& shown, Ui& ui, Rect r, const Axis& time,
                 std::size_t first) {
    const bool motors = first == 2;
    const Axis value{motors ? -1.0f : 0.0f, 1, "", 1};
    // The upper chart has no minus signs beside its axis: indent it, so that both time axes are aligned.
    if (!motors) {
        const float minus =
            text_width(ui, Face::small, fixed(ui, -1, 1)) - text_width(ui, Face::small, fixed(ui, 1, 1));
        r.x += minus, r.w -= minus;
    }
    const Rect inner = plot_ground(ui, r, time, value);
    const Colour left = ui.palette.accent, right = ui.palette.text;
    for (const std::size_t i : {first, first + 1})
        plot_line(ui, inner, time, value, history.signals.size(), i == first ? left : right, i == first ? 2.6f : 1.3f,
                  [&](std::size_t k) {
                      const History::Signals& s = history.signals[k];
                      return PlotPoint{s.seconds, shown.value(s, i)};
                  });
    // The names stand above the lines, where no line crosses them.
    const float above = inner.y - line_height(ui, Face::small);
    const float after = put(ui, {inner.x, above}, shown.names[first], left, Face::small);
    put(ui, {inner.x + after + ui.px(spacing::small), above}, shown.names[first + 1], right, Face::small);
    const auto at = plot_cursor(ui, inner, time);
    if (!at) return;
    const History::Signals& s = nearest_sample(history.signals, *at);
    ReadOut words;
    words.add(fill(ui.strings("time.seconds"), {fixed(ui, s.seconds, 2)}), ui.palette.second_text);
    for (const std::size_t i : {first, first + 1}) {
        const float at_pointer = shown.value(s, i);
        words.add(shown.names[i] + " " + (motors ? with_sign(ui, at_pointer, 2) : fixed(ui, at_pointer, 2)),
                  i == first ? left : right);
    }
    words.show(ui, inner, ImGui::GetIO().MousePos.x);
}

void signal_chart(const History& history, const ShownSignals& shown, Ui& ui, Rect r) {
    if (history.signals.size() < 2) return no_samples(ui, r);
    const Axis time = time_axis(history.signals.front().seconds, history.signals.back().seconds, 5);
    // The upper chart shares the numbers of the lower one's time axis.
    const float line = line_height(ui, Face::small), names = line / 2;
    r.y += names, r.h -= names;
    const float half = (r.h - line) / 2;
    Axis bare = time;
    bare.numbers = false;
    signal_pair(history, shown, ui, {r.x, r.y, r.w, half + 0.4f * line}, bare, 0);  // room for both numbers
    signal_pair(history, shown, ui, {r.x, r.y + half, r.w, half + line}, time, 2);
}

std::string_view group_name(const Ui& ui, std::size_t group) {
    constexpr std::array<std::string_view, 3> keys{"info.predators", "info.prey", "info.others"};
    return ui.strings(keys[group]);
}

// The legend above the chart. Returns its height.
float legend_row(const Ui& ui, ImVec2 at, const std::array<bool, 3>& there) {
    const float line = line_height(ui, Face::small), sign = ui.px(9);
    float x = at.x + ui.px(24);
    for (std::size_t g = 0; g < 3; ++g) {
        if (!there[g]) continue;
        put_role(ui, {x + sign / 2, at.y + line / 2}, sign, chart_roles[g]);
        x += sign + ui.px(5);
        x += put(ui, {x, at.y}, group_name(ui, g), ui.palette.text, Face::small) + ui.px(14);
    }
    return line;
}

// One line per group that is not empty: its number, or its mean energy.
void population_chart(const History& history, Ui& ui, Rect r, bool energy) {
    const auto& samples = history.population;
    if (samples.size() < 2) return no_samples(ui, r);
    const Axis time = time_axis(samples.front().seconds, samples.back().seconds, 10);
    int most = 4;
    std::array<bool, 3> there{};
    for (const History::Population& p : samples)
        for (std::size_t g = 0; g < 3; ++g) {
            most = std::max(most, p.count[g]);
            there[g] |= p.count[g] > 0;
        }
    const Axis value{0, energy ? 1.0f : static_cast<float>(most) * 1.08f, "", energy ? 1 : 0};
    const float legend = legend_row(ui, {r.x, r.y}, there);
    const Rect inner = plot_ground(ui, {r.x, r.y + legend, r.w, r.h - legend}, time, value);
    for (std::size_t g = 0; g < 3; ++g) {
        if (!there[g]) continue;
        const Colour colour = colour_of(ui.palette, chart_roles[g]);
        const auto shown = [&](std::size_t k) {
            return energy ? samples[k].energy[g] : static_cast<float>(samples[k].count[g]);
        };
        plot_line(ui, inner, time, value, samples.size(), colour, line_widths[g], [&](std::size_t k) {
            return PlotPoint{samples[k].seconds, shown(k)};
        });
    }
    const auto at = plot_cursor(ui, inner, time);
    if (!at) return;
    const History::Population& p = nearest_sample(samples, *at);
    ReadOut words;
    words.add(fill(ui.strings("time.seconds"), {fixed(ui, p.seconds, 0)}), ui.palette.second_text);
    for (std::size_t g = 0; g < 3; ++g)
        if (there[g])
            words.add((energy ? fixed(ui, p.energy[g], 2) : std::to_string(p.count[g])) + " " +
                          std::string(group_name(ui, g)),
                      ui.palette.text);
    words.show(ui, inner, ImGui::GetIO().MousePos.x);
}

// Headers of the bars: a click sorts by one, a second click reverses the order.
void sort_headers(PanelState& state, Ui& ui) {
    const std::array<std::string_view, 3> words{ui.strings("charts.by_number"), ui.strings("charts.by_energy"),
                                                ui.strings("charts.by_kind")};
    constexpr std::array<std::string_view, 3> anchors{"charts.sort.number", "charts.sort.energy", "charts.sort.kind"};
    EnergyOrder& order = state.charts.energy_order;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto by = static_cast<EnergyOrder::By>(i);
        const bool on = order.by == by;
        const std::string text = std::string(words[i]) + (on ? order.falling ? " ↓" : " ↑" : "");
        if (i > 0) ImGui::SameLine(0, ui.px(spacing::small));
        if (!small_push_button(ui, {anchors[i], {}, text, on}, ui.strings("charts.sort_how"))) continue;
        order.falling = on ? !order.falling : by == EnergyOrder::By::energy;
        order.by = by;
    }
}

// One bar per vehicle, in the chosen order. Vehicles without room are counted.
void energy_bars(const LabView& view, PanelState& state, Ui& ui, Rect card) {
    const float headers = ImGui::GetCursorScreenPos().y;
    sort_headers(state, ui);
    const Rect r = rest_of_card(ui, card);
    sort(*view.now, state.charts.energy_order, state.charts.energy_rows);
    const auto& rows = state.charts.energy_rows;
    if (rows.empty()) return no_samples(ui, r);
    const float room = r.w - ui.px(40);
    const auto count = static_cast<float>(rows.size());
    const float stride = std::clamp(room / count, ui.px(3), ui.px(28));
    const std::size_t shown = std::min(rows.size(), static_cast<std::size_t>(room / stride));
    // No numbers along the bars: the read-out shows the number of the vehicle.
    const Axis place{0, static_cast<float>(shown), "", 0, false}, energy{0, 1, "", 1};
    const Rect inner = plot_ground(ui, r, place, energy);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool over = inner.contains(mouse.x, mouse.y) && ImGui::IsWindowHovered();
    const float width = std::min(inner.w / static_cast<float>(shown), ui.px(28));
    for (std::size_t i = 0; i < shown; ++i) {
        const VehicleView& v = view.now->vehicles[rows[i]];
        const float x = inner.x + width * static_cast<float>(i), gap = width > ui.px(5) ? ui.px(1.5f) : ui.px(0.5f);
        const ImVec2 top = plot_point(inner, place, energy, {0, v.energy});
        const Rect bar{x + gap, top.y, width - 2 * gap, inner.y + inner.h - top.y};
        fill_box(ui, bar, colour_of(ui.palette, v.role), Corner::bar);
        if (width >= ui.px(6))
            put_role(ui, {x + width / 2, inner.y + inner.h + ui.px(8)}, std::min(width, ui.px(9)), v.role);
        if (v.id == view.settings.selection.vehicle)
            line_box(ui, {x, inner.y, width, inner.h}, ui.palette.text, Corner::bar, 1.5f);
        if (!over || mouse.x < x || mouse.x >= x + width) continue;
        line_box(ui, {x, inner.y, width, inner.h}, ui.palette.second_text, Corner::bar, 1);
        ReadOut words;
        words.add(
            fill(ui.strings("info.one"), {kind_name(view, ui, v), std::to_string(v.id + 1), fixed(ui, v.energy, 2)}),
            ui.palette.text);
        words.show(ui, inner, x + width);
        if (ImGui::IsMouseClicked(0)) ui.outbox.push_back(SelectRequest{v.id});
    }
    mark(ui, "charts.bars", {inner.x, inner.y, width * static_cast<float>(shown), inner.h});
    if (shown < rows.size())
        put_right(ui, {inner.x + inner.w, headers + ui.px(4)},  // above the bars, which may fill the chart
                  fill(ui.strings("info.more"), {std::to_string(rows.size() - shown)}), ui.palette.second_text,
                  Face::small);
}

}  // namespace

void export_csv(const LabView& view, const PanelState& state, Outbox& outbox) {
    const Chart shown = state.charts.shown;
    if (shown == Chart::bars)
        outbox.push_back(ExportRequest{"energies", energies_csv(*view.now)});
    else if (shown == Chart::population || shown == Chart::energy)
        outbox.push_back(ExportRequest{"population", population_csv(state.charts.history)});
    else
        outbox.push_back(ExportRequest{"signals", signals_csv(state.charts.history)});
}

void chart_card(const LabView& view, PanelState& state, Ui& ui, Rect place) {
    std::array buttons{HeadingButton{"charts.csv", ui.strings("charts.csv"), ui.strings("tooltip.csv")}};
    const bool open = open_card(state, ui, Card::charts, place, buttons);
    if (open) {
        if (buttons[0].pressed) export_csv(view, state, ui.outbox);
        const std::array words{ui.strings("charts.signals"), ui.strings("charts.all"),
                               ui.strings("charts.chosen"),  ui.strings("charts.population"),
                               ui.strings("charts.energy"),  ui.strings("charts.bars")};
        const int chosen = segments(ui, "charts.tab", words, static_cast<int>(state.charts.shown), card_width(ui));
        if (chosen >= 0) state.charts.shown = static_cast<Chart>(chosen);
        const Rect picture = rest_of_card(ui, place);
        if (state.charts.shown == Chart::bars) {
            energy_bars(view, state, ui, place);
        } else if (state.charts.shown == Chart::all) {
            all_strips(view, state, ui, picture);
        } else if (state.charts.shown == Chart::chosen) {
            chosen_strips(view, state, ui, picture);
        } else {
            const Item area = item(ui, "charts.picture", {picture.w, picture.h}, false);
            if (state.charts.shown == Chart::signals)
                signal_chart(state.charts.history, shown_signals(state.charts.history, view), ui, area.rect);
            else
                population_chart(state.charts.history, ui, area.rect, state.charts.shown == Chart::energy);
        }
    }
    CardState& card = state.card(Card::charts);
    end_card(ui, card);
    if (card.folded) card.folded = state.charts.open = false;  // folding closes it
}

}  // namespace braitenlab::ui
