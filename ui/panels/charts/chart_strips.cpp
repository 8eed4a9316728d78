#include "ui/panels/charts/chart_strips.h"

#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/charts/chart_data.h"
#include "ui/panels/charts/chart_parts.h"
#include "ui/panels/panels.h"
#include "ui/panels/signal_drag.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float most_name_room = 78, number_room = 44, sign_room = 26;  // layout pixels
constexpr float least_row = 24, largest_row = 56, column_gap = spacing::large;

// A button of one sign at the right end of a row.
struct RowButton {
    std::string anchor;
    std::string_view icon, word;  // the word stands for the icon without the font of the icons
    std::string_view how;
    bool on = false;
};

bool row_button(Ui& ui, Rect row, const RowButton& look) {
    const float size = ui.px(ui.tall(least_row));
    ImGui::SetCursorScreenPos({row.x + row.w - size, row.y + (row.h - size) / 2});
    const Item at = item(ui, look.anchor, {size, size});
    const Colour colour = look.on ? ui.palette.accent : mix(ui.palette.second_text, ui.palette.text, at.warmth);
    if (at.warmth > 0) fill_box(ui, at.rect, ui.palette.raised.with_alpha(at.warmth), Corner::box);
    const ImVec2 middle{at.middle_x(), at.middle_y()};
    if (has_icons(ui))
        put_icon(ui, middle, look.icon, colour, Face::small);
    else
        put_centred(ui, {middle.x, middle.y - line_height(ui, Face::small) / 2}, look.word, colour, Face::small);
    tooltip(ui, at, look.how);
    return at.pressed;
}

struct StripPlace {
    Rect row;
    const Axis& time;
    float name_room;   // window pixels
    std::string name;  // as shown
};

// One signal: its name, its line, and its value now or under the pointer.
void signal_strip(const History& history, const Signal& signal, Ui& ui, const StripPlace& place) {
    const Rect r{place.row.x, place.row.y, place.row.w - ui.px(sign_room), place.row.h};
    const float room = place.name_room, number = ui.px(number_room);
    const float y = r.y + (r.h - line_height(ui, Face::small)) / 2;
    put(ui, {r.x, y}, shortened(ui, place.name, Face::small, room - ui.px(6)), ui.palette.second_text, Face::small);
    const Rect plot{r.x + room, r.y + ui.px(2), r.w - room - number, r.h - ui.px(4)};
    fill_box(ui, plot, ui.palette.ground.with_alpha(0.45f), Corner::box);
    const SignalRange range = range_of(history, signal);
    const Axis value{range.low, range.high};
    plot_line(ui, plot, place.time, value, history.signals.size(), ui.palette.accent, 1.5f, [&](std::size_t k) {
        const History::Signals& s = history.signals[k];
        return PlotPoint{s.seconds, signal.value(s)};
    });
    const auto at = plot_cursor(ui, plot, place.time);
    const float shown = signal.value(at ? nearest_sample(history.signals, *at) : history.signals.back());
    const bool is_signed = signal.of != Signal::Of::sensor;
    put_right(ui, {r.x + r.w, y}, is_signed ? with_sign(ui, shown, 2) : fixed(ui, shown, 2), ui.palette.text,
              Face::small);
    mark(ui, "charts.strip." + signal.name, plot);
}

// The name of a strip as a part that can be dragged.
void name_to_drag(PanelState& state, Ui& ui, const Signal& signal, Rect row, float width, std::string_view how) {
    ImGui::SetCursorScreenPos({row.x, row.y});
    const Item at = item(ui, "charts.name." + signal.name, {width, row.h}, false);
    if (at.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    drag_signal(state, ui, ImGui::IsItemActive(), signal.name);
    if (wants_tooltip(ui, at)) tooltip(ui, at, fill(ui.strings(how), {signal.name}));
}

std::string shown_name(const LabView& view, const VehicleView& vehicle, const Signal& signal) {
    return wiring::short_name(kind_of(*view.now, vehicle).sensors, signal.name);
}

// The width of the column of names.
float room_of_names(const LabView& view, const VehicleView& vehicle, const Ui& ui, const std::vector<Signal>& signals) {
    float widest = 0;
    for (const Signal& signal : signals)
        widest = std::max(widest, text_width(ui, Face::small, shown_name(view, vehicle, signal)));
    return std::min(widest + ui.px(8), ui.px(most_name_room));
}

// In the place of the next strip of two columns: how many signals have no room.
void count_hidden(const Ui& ui, Rect r, float row, std::size_t shown, std::size_t count) {
    if (shown == count) return;
    put_right(ui, {r.x + r.w, r.y + row * static_cast<float>(shown / 2) + ui.px(4)},
              fill(ui.strings("info.more"), {std::to_string(count - shown)}), ui.palette.second_text, Face::small);
}

// As many as fit into two columns of so many rows; the last place is for the number of the others.
std::size_t fitting(std::size_t count, std::size_t rows) { return count <= 2 * rows ? count : 2 * rows - 1; }

Axis axis_of(const History& history) {
    return time_axis(history.signals.front().seconds, history.signals.back().seconds, 5);
}

}  // namespace

void choose_strip(PanelState& state, std::string_view name) {
    const bool is_there =
        std::find(state.charts.strips.begin(), state.charts.strips.end(), name) != state.charts.strips.end();
    if (!is_there && state.charts.strips.size() < most_strips) state.charts.strips.emplace_back(name);
}

void move_strip(PanelState& state, std::string_view name, std::string_view onto) {
    std::vector<std::string>& strips = state.charts.strips;
    const auto from = std::find(strips.begin(), strips.end(), name), to = std::find(strips.begin(), strips.end(), onto);
    if (from == strips.end() || to == strips.end()) return;
    from < to ? std::rotate(from, from + 1, to + 1) : std::rotate(to, from, from + 1);
}

void all_strips(const LabView& view, PanelState& state, Ui& ui, Rect r) {
    mark(ui, "charts.picture", r);
    const History& history = state.charts.history;
    const VehicleView* vehicle = find_vehicle(*view.now, history.vehicle);
    if (!vehicle || history.signals.size() < 2) return no_samples(ui, r);
    const Axis time = axis_of(history);
    const float row = ui.px(least_row), space = ui.px(column_gap), width = (r.w - space) / 2;
    const auto rows = static_cast<std::size_t>(std::max(1.0f, r.h / row));
    const std::vector<Signal> signals = all_signals(history);
    const float room = room_of_names(view, *vehicle, ui, signals);
    const std::size_t count = signals.size();
    const std::size_t shown = fitting(count, rows);
    for (std::size_t i = 0; i < shown; ++i) {
        const Signal& signal = signals[i];
        const Rect place{r.x + (i % 2 == 0 ? 0 : width + space), r.y + row * static_cast<float>(i / 2), width, row};
        signal_strip(history, signal, ui, {place, time, room, shown_name(view, *vehicle, signal)});
        name_to_drag(state, ui, signal, place, room, "charts.drag_how");
        const auto chosen = std::find(state.charts.strips.begin(), state.charts.strips.end(), signal.name);
        const bool is_chosen = chosen != state.charts.strips.end();
        const RowButton look{"charts.add." + signal.name, is_chosen ? icon::check : icon::add, is_chosen ? "–" : "+",
                             ui.strings(is_chosen ? "charts.remove_how" : "charts.add_how"), is_chosen};
        if (!row_button(ui, place, look)) continue;
        if (is_chosen)
            state.charts.strips.erase(chosen);
        else
            choose_strip(state, signal.name);
    }
    count_hidden(ui, r, row, shown, count);
}

void chosen_strips(const LabView& view, PanelState& state, Ui& ui, Rect r) {
    state.charts.drag.onto.clear();
    mark(ui, "charts.picture", r);
    const History& history = state.charts.history;
    std::vector<Signal> signals;
    for (const std::string& name : state.charts.strips)
        if (auto signal = signal_named(history, name)) signals.push_back(std::move(*signal));
    const VehicleView* vehicle = find_vehicle(*view.now, history.vehicle);
    if (!vehicle || signals.empty()) {
        const float line = line_height(ui, Face::small);
        return put_centred(ui, {r.x + r.w / 2, r.y + r.h / 2 - line},
                           shortened(ui, ui.strings("charts.choose_how"), Face::small, r.w), ui.palette.second_text,
                           Face::small);
    }
    if (history.signals.size() < 2) return no_samples(ui, r);
    const Axis time = axis_of(history);
    const float room = room_of_names(view, *vehicle, ui, signals);
    const std::size_t count = signals.size();
    const auto in_one = static_cast<std::size_t>(std::max(1.0f, r.h / ui.px(least_row)));
    const std::size_t columns = count > in_one ? 2 : 1, rows = (count + columns - 1) / columns;
    const float space = ui.px(column_gap) * static_cast<float>(columns - 1);
    const float width = (r.w - space) / static_cast<float>(columns);
    const float row = std::clamp(r.h / static_cast<float>(rows), ui.px(least_row), ui.px(largest_row));
    const std::size_t shown = fitting(count, in_one);
    for (std::size_t i = 0; i < shown; ++i) {
        const Rect place{r.x + (width + space) * static_cast<float>(i % columns),
                         r.y + row * static_cast<float>(i / columns), width, row};
        signal_strip(history, signals[i], ui, {place, time, room, shown_name(view, *vehicle, signals[i])});
        if (count > 1) name_to_drag(state, ui, signals[i], place, room, "charts.order_how");
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        if (place.contains(mouse.x, mouse.y))
            state.charts.drag.onto = signals[i].name, state.charts.drag.onto_row = place;
        const RowButton look{"charts.remove." + signals[i].name, icon::cross, "×", ui.strings("charts.remove_how")};
        if (row_button(ui, place, look)) std::erase(state.charts.strips, signals[i].name);
    }
    count_hidden(ui, r, row, shown, count);
}

}  // namespace braitenlab::ui
