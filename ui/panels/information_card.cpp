// The card of the population: numbers, energy of each vehicle, events, and the last seconds as strip charts.
#include <algorithm>
#include <array>
#include <string>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/cards.h"
#include "ui/panels/charts/chart_data.h"
#include "ui/panels/panels.h"
#include "ui/shortcuts.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr std::size_t most_bars = 120;
constexpr float told_after = 2;  // s without movement

// A caption over its figure.
void number_below(const Ui& ui, ImVec2 at, std::string_view caption, std::string_view value) {
    put(ui, at, caption, ui.palette.second_text, Face::small);
    put(ui, {at.x, at.y + line_height(ui, Face::small)}, value, ui.palette.text, Face::strong);
}

void population_numbers(const LabView& view, Ui& ui) {
    const Snapshot& now = *view.now;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float third = card_width(ui) / 3;
    const bool hunted = now.predators + now.prey > 0;
    number_below(ui, at, ui.strings("info.population"), std::to_string(now.vehicles.size()));
    number_below(ui, {at.x + third, at.y}, ui.strings("info.generation"), std::to_string(now.generation));
    const VehicleView* selected = find_vehicle(now, view.settings.selection.vehicle);
    if (hunted)
        number_below(ui, {at.x + 2 * third, at.y}, ui.strings("info.captures"), std::to_string(now.events.captures));
    else if (selected)
        number_below(ui, {at.x + 2 * third, at.y}, ui.strings("info.speed"),
                     fill(ui.strings("info.metres_a_second"), {fixed(ui, selected->speed, 2)}));
    const float height = line_height(ui, Face::small) + line_height(ui, Face::strong);
    ImGui::Dummy({card_width(ui), height});
    mark(ui, "info.figures", {at.x, at.y, card_width(ui), height});
}

// Numbers of predators and prey, their ratio, and a bar divided in that ratio.
void ratio(const Snapshot& now, Ui& ui) {
    const int all = now.predators + now.prey;
    if (all == 0) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = card_width(ui), h = line_height(ui, Face::text), sign = ui.px(11);
    put_role(ui, {at.x + sign / 2, at.y + h / 2}, sign, Role::predator);
    const std::string predators = std::to_string(now.predators) + " " + std::string(ui.strings("info.predators"));
    const std::string prey = std::to_string(now.prey) + " " + std::string(ui.strings("info.prey"));
    put(ui, {at.x + sign + ui.px(6), at.y}, predators, ui.palette.text);
    put_right(ui, {at.x + width, at.y}, prey, ui.palette.text);
    const float free_from = at.x + sign + ui.px(6) + text_width(ui, Face::text, predators);
    const float free_to = at.x + width - text_width(ui, Face::text, prey) - ui.px(6) - sign;
    put_role(ui, {free_to + sign / 2, at.y + h / 2}, sign, Role::prey);
    if (now.prey > 0 && now.predators > 0) {
        const float each = static_cast<float>(now.prey) / static_cast<float>(now.predators);
        const std::string words = fill(ui.strings("info.prey_each"), {fixed(ui, each, 1)});
        if (text_width(ui, Face::small, words) + ui.px(12) <= free_to - free_from)
            put_centred(ui, {(free_from + free_to) / 2, at.y + (h - line_height(ui, Face::small)) / 2}, words,
                        ui.palette.second_text, Face::small);
    }
    const float y = at.y + h + ui.px(4), bar = ui.px(6);
    const float cut = width * static_cast<float>(now.predators) / static_cast<float>(all);
    if (now.predators > 0)
        fill_box(ui, {at.x, y, std::max(bar, cut - ui.px(1)), bar}, ui.palette.predator, Corner::round);
    if (now.prey > 0)
        fill_box(ui, {at.x + cut + ui.px(1), y, std::max(bar, width - cut - ui.px(1)), bar}, ui.palette.prey,
                 Corner::round);
    ImGui::Dummy({width, h + ui.px(spacing::tight) + bar});
    mark(ui, "info.ratio", {at.x, at.y, width, h + ui.px(4) + bar});
}

void inactivity(const Snapshot& now, Ui& ui) {
    const float whole = now.scene->ecology.inactivity;
    const float left = now.inactivity_left;
    if (whole <= 0 || left <= 0 || whole - left < told_after || now.vehicles.empty()) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = card_width(ui), h = line_height(ui, Face::small);
    put(ui, at, ui.strings("info.inactivity"), ui.palette.second_text, Face::small);
    put_right(ui, {at.x + width, at.y}, fill(ui.strings("time.seconds"), {fixed(ui, now.inactivity_left, 1)}),
              ui.palette.text, Face::small);
    const float y = at.y + h + ui.px(2), bar = ui.px(3);
    fill_box(ui, {at.x, y, width, bar}, ui.palette.line, Corner::round);
    fill_box(ui, {at.x, y, width * std::clamp(now.inactivity_left / whole, 0.0f, 1.0f), bar}, ui.palette.second_text,
             Corner::round);
    ImGui::Dummy({width, h + ui.px(spacing::hair) + bar});
    mark(ui, "info.inactivity", {at.x, at.y, width, h + ui.px(5)});
}

// Without an energy drain all bars are always full.
bool energy_matters(const Snapshot& now) { return now.predators + now.prey > 0 || now.scene->ecology.drain > 0; }

// The caption of the bars. A click changes their order: number, falling energy, rising energy, kind.
void energy_caption(PanelState& state, Ui& ui, ImVec2 at, std::string_view words) {
    using Order = EnergyOrder;
    constexpr std::array turns{Order{}, Order{Order::By::energy, true}, Order{Order::By::energy, false},
                               Order{Order::By::kind, false}};
    ImGui::SetCursorScreenPos(at);
    const Item caption = item(ui, "info.energy.sort", {text_width(ui, Face::small, words), ui.px(ui.tall(24))});
    put(ui, {at.x, at.y + ui.px(3)}, words, mix(ui.palette.second_text, ui.palette.text, caption.warmth), Face::small);
    tooltip(ui, caption, ui.strings("info.sort"));
    if (!caption.pressed) return;
    const auto here = std::find(turns.begin(), turns.end(), state.charts.energy_order);
    const auto next = here == turns.end() ? 0 : static_cast<std::size_t>(here - turns.begin() + 1) % turns.size();
    state.charts.energy_order = turns[next];
}

// One bar per vehicle, in the chosen order; a click selects the vehicle.
void energies(const LabView& view, PanelState& state, Ui& ui) {
    const Snapshot& now = *view.now;
    sort(now, state.charts.energy_order, state.charts.energy_rows);
    const std::size_t shown = std::min(most_bars, now.vehicles.size());
    if (shown == 0) return;
    const std::string_view caption = ui.strings("info.energy");
    const float aside = text_width(ui, Face::small, caption) + ui.px(12);
    const float width = card_width(ui) - aside, bar_h = ui.px(18), space = ui.px(3);
    // The width of a bar falls with the number of vehicles.
    const float bar_w = ui.px(shown <= 24 ? 9.0f : 5.0f);
    const int per_row = std::max(1, static_cast<int>((width + space - ui.px(2)) / (bar_w + space)));
    const ImVec2 cursor = ImGui::GetCursorScreenPos(), at{cursor.x + aside, cursor.y + ui.px(2)};
    energy_caption(state, ui, cursor, caption);
    ImGui::SetCursorScreenPos(cursor);
    const int rows = (static_cast<int>(shown) + per_row - 1) / per_row;
    const float row_h = bar_h + ui.px(12);
    const Item area = item(ui, "info.energy", {width + aside, row_h * static_cast<float>(rows) - ui.px(2)}, false);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const VehicleView* under = nullptr;
    for (std::size_t i = 0; i < shown; ++i) {
        const VehicleView& vehicle = now.vehicles[state.charts.energy_rows[i]];
        const float x = at.x + static_cast<float>(static_cast<int>(i) % per_row) * (bar_w + space);
        const float y = at.y + static_cast<float>(static_cast<int>(i) / per_row) * row_h;
        const Rect bar{x, y, bar_w, bar_h};
        const float filled = bar_h * std::clamp(vehicle.energy, 0.0f, 1.0f);
        fill_box(ui, bar, ui.palette.line.with_alpha(0.7f), Corner::bar);
        fill_box(ui, {x, y + bar_h - filled, bar_w, filled}, colour_of(ui.palette, vehicle.role), Corner::bar);
        put_role(ui, {x + bar_w / 2, y + bar_h + ui.px(5)}, std::min(bar_w, ui.px(6)), vehicle.role);
        const Rect around{x - space / 2, y, bar_w + space, row_h};
        const bool over = area.hovered && around.contains(mouse.x, mouse.y);
        if (over) under = &vehicle;
        if (vehicle.id == view.settings.selection.vehicle || over)
            line_box(ui, {x - ui.px(1.5f), y - ui.px(1.5f), bar_w + ui.px(3), bar_h + ui.px(3)},
                     vehicle.id == view.settings.selection.vehicle ? ui.palette.text : ui.palette.second_text,
                     Corner::bar, 1.5f);
    }
    if (under) {
        tooltip(ui, area,
                fill(ui.strings("info.one"),
                     {kind_name(view, ui, *under), std::to_string(under->id + 1), fixed(ui, under->energy, 2)}));
        if (ImGui::IsMouseClicked(0)) ui.outbox.push_back(SelectRequest{under->id});
    }
    if (now.vehicles.size() > shown)
        paragraph(ui, fill(ui.strings("info.more"), {std::to_string(now.vehicles.size() - shown)}),
                  ui.palette.second_text, Face::small);
}

void strip_ground(const Ui& ui, Rect r) {
    fill_box(ui, {r.x, r.y - ui.px(2), r.w, r.h + ui.px(4)}, ui.palette.ground.with_alpha(0.45f), Corner::box);
}

// One signal: its name, and a line on an axis from `low` to 1; the newest sample is at the right edge.
void signal_strip(const Ui& ui, Rect r, const History& history, const ShownSignals& shown, std::size_t signal,
                  float low) {
    const float room = ui.px(44);
    put(ui, {r.x, r.y + (r.h - line_height(ui, Face::label)) / 2},
        shortened(ui, shown.names[signal], Face::label, room - ui.px(2)), ui.palette.second_text, Face::label);
    const Rect plot{r.x + room, r.y, r.w - room, r.h};
    strip_ground(ui, plot);
    if (low < 0)
        ImGui::GetWindowDrawList()->AddLine({plot.x, plot.y + plot.h / 2}, {plot.x + plot.w, plot.y + plot.h / 2},
                                            paint(ui.palette.line), ui.px(1));
    const double newest = history.signals.back().seconds;
    const Axis time{newest - strip_seconds, newest}, value{low, 1};
    const std::size_t first = first_in_strip(history);
    plot_line(ui, plot, time, value, history.signals.size() - first, ui.palette.text, 1.5f, [&](std::size_t i) {
        const History::Signals& s = history.signals[first + i];
        return PlotPoint{s.seconds, shown.value(s, signal)};
    });
}

void signal_strips(const History& history, const ShownSignals& shown, Ui& ui) {
    constexpr float height = 20, row = 28;  // layout pixels
    subheading(ui, fill(ui.strings("info.last_seconds"), {fixed(ui, static_cast<float>(strip_seconds), 0)}));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float space = ui.px(spacing::medium), half = (card_width(ui) - space) / 2;
    for (std::size_t i = 0; i < 4; ++i) {
        const Rect place{at.x + (i % 2 ? half + space : 0), at.y + ui.px(2) + ui.px(row) * (i < 2 ? 0.0f : 1.0f), half,
                         ui.px(height)};
        signal_strip(ui, place, history, shown, i, i < 2 ? 0.0f : -1.0f);
    }
    ImGui::Dummy({card_width(ui), ui.px(2 * row - spacing::tight)});
    mark(ui, "info.signals", {at.x, at.y, card_width(ui), ui.px(2 * row - spacing::tight)});
}

void population_strip(const History& history, Ui& ui) {
    subheading(ui, ui.strings("info.over_time"));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect plot{at.x, at.y + ui.px(2), card_width(ui), ui.px(36)};
    strip_ground(ui, plot);
    constexpr std::size_t shown = 120;  // samples, one a second
    const auto& all = history.population;
    const std::size_t first = all.size() > shown ? all.size() - shown : 0;
    int most = 1;
    for (std::size_t i = first; i < all.size(); ++i) most = std::max({most, all[i].count[0], all[i].count[1]});
    const double newest = all.back().seconds;
    const Axis time{newest - shown, newest}, value{0, most * 1.1};
    for (const std::size_t side : {std::size_t{1}, std::size_t{0}}) {
        const Role role = side == 0 ? Role::predator : Role::prey;
        plot_line(ui, plot, time, value, all.size() - first, colour_of(ui.palette, role), 1.5f, [&](std::size_t i) {
            return PlotPoint{all[first + i].seconds, static_cast<double>(all[first + i].count[side])};
        });
        const float y = plot_point(plot, time, value, {newest, static_cast<double>(all.back().count[side])}).y;
        put_role(ui, {plot.x + plot.w - ui.px(3), y}, ui.px(8), role);
    }
    ImGui::Dummy({plot.w, plot.h + ui.px(spacing::tight)});
    mark(ui, "info.over_time", plot);
}

}  // namespace

void information_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect) {
    const std::string key = key_name(Action::charts, ui.strings);
    std::array buttons{HeadingButton{"button.charts", ui.strings("button.charts"), ui.strings("tooltip.charts"), key,
                                     state.charts.open}};
    const bool open = open_card(state, ui, Card::information, place, buttons);
    if (buttons[0].pressed) state.charts.open = !state.charts.open;
    if (open) {
        population_numbers(view, ui);
        ratio(*view.now, ui);
        if (energy_matters(*view.now)) energies(view, state, ui);
        if (!state.charts.history.signals.empty())
            signal_strips(state.charts.history, shown_signals(state.charts.history, view), ui);
        if (view.now->predators + view.now->prey > 0 && !state.charts.history.population.empty())
            population_strip(state.charts.history, ui);
        inactivity(*view.now, ui);
    }
    end_card(ui, state.card(Card::information));
}

}  // namespace braitenlab::ui
