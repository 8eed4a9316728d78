// What the map of behaviour shows: the value on each axis with its range, the measure and the number of starts.
#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "ui/panels/map/map_parts.h"
#include "ui/panels/value_choice.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/number_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using insight::AxisValue;
using insight::MapAxis;
using insight::MapMeasure;

namespace {

// A small button that unfolds a list below its row.
SmallButton opener_look(const MapFrame& frame, std::string_view id, MapList list, std::string_view words) {
    const bool open = frame.state.open == list;
    return {id, open ? icon::unfolded : icon::folded, words, open};
}

void opener(const MapFrame& frame, const SmallButton& look, MapList list, std::string_view how, ImVec2 at) {
    MapState& state = frame.state;
    ImGui::SetCursorScreenPos(at);
    const Item shown = small_button(frame.ui, look);
    tooltip(frame.ui, shown, frame.ui.strings(how));
    if (!shown.pressed) return;
    state.open = state.open == list ? MapList::none : list;
    if (state.open == MapList::x) state.group = group_of(frame.x->owner);
    if (state.open == MapList::y) state.group = group_of(frame.y->owner);
}

// The ends of an axis as two sliders.
void range_sliders(const MapFrame& frame, bool is_x, float width) {
    Ui& ui = frame.ui;
    const MapAxis& now = is_x ? frame.map.x : frame.map.y;
    const AxisValue& value = is_x ? *frame.x : *frame.y;
    const std::string unit = unit_after(value.unit);
    MapRange range{now.from, now.to};
    bool changed = false;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    for (float* end : {&range.from, &range.to}) {
        const bool is_from = end == &range.from;
        SliderLook look = end_look(ui, value, is_from, *end);
        look.tooltip = ui.strings("map.end_how");
        look.unit = unit;
        const std::string id = std::string(is_x ? "map.x." : "map.y.") + (is_from ? "from" : "to");
        if (const auto edit = slider(ui, frame.sliders, id, *end, width, frame.view.wall_seconds, look))
            *end = edit->value, changed = true;
    }
    ImGui::PopStyleVar();
    if (!changed || range.from == range.to) return;
    MapRequest request;
    (is_x ? request.x_range : request.y_range) = range;
    ui.outbox.emplace_back(request);
}

// The list of values: the group, its values, and the range of the present one.
void axes(const MapFrame& frame, float width) {
    Ui& ui = frame.ui;
    MapState& state = frame.state;
    const bool is_x = state.open == MapList::x;
    const AxisValue& now = is_x ? *frame.x : *frame.y;
    const std::string begin = is_x ? "map.x" : "map.y";
    if (const AxisValue* chosen = value_choice(ui, frame.values, begin, now.id, state.group, width)) {
        MapRequest request;
        (is_x ? request.x : request.y) = chosen->id;
        ui.outbox.emplace_back(request);
        state.open = MapList::none;
    }
    if (group_of(now.owner) == state.group) range_sliders(frame, is_x, width);
}

void measures(const MapFrame& frame, float right) {
    Ui& ui = frame.ui;
    const MapView& map = frame.map;
    for (const auto& row : insight::map_measure_table)
        if (choice_in_row(ui, "map.measure." + std::string(row.word), measure_words(ui, row.value),
                          row.value == map.measure, row.value == MapMeasure::behaviour, right)) {
            ui.outbox.emplace_back(MapRequest{.measure = row.value});
            frame.state.open = MapList::none;
        }
    for (const int seeds : {1, 5})
        if (choice_in_row(ui, "map.seeds." + std::to_string(seeds),
                          fill(ui.strings(seeds == 1 ? "map.one_start" : "map.starts"), {std::to_string(seeds)}),
                          seeds == map.seeds, seeds == 1, right))
            ui.outbox.emplace_back(MapRequest{.seeds = seeds});
}

// An end of an axis with as few decimals as it needs.
std::string end_words(const Ui& ui, const AxisValue& value, float end, bool unit) {
    int decimals = 0;
    for (float scaled = end; decimals < 3 && std::fabs(scaled - std::round(scaled)) > 1e-3f * std::fabs(scaled);)
        ++decimals, scaled *= 10;
    return fixed(ui, end, decimals) + (unit ? unit_after(value.unit) : "");
}

struct AxisEnds {
    std::string low, high;
    float width(const Ui& ui) const {
        return std::max(text_width(ui, Face::small, low), text_width(ui, Face::small, high));
    }
};

AxisEnds ends_of(const Ui& ui, const AxisValue& value, const MapAxis& axis) {
    return {end_words(ui, value, axis.from, false), end_words(ui, value, axis.to, true)};
}

// A number with its right end here, in the size of the name of the axis.
void put_end(Ui& ui, std::string_view anchor, const std::string& number, float right, float y) {
    const float width = text_width(ui, Face::small, number);
    put_right(ui, {right, y}, number, ui.least_type > 0 ? ui.palette.text : ui.palette.second_text, Face::small);
    mark(ui, anchor, {right - width, y, width, line_height(ui, Face::small)});
}

}  // namespace

std::string value_words(const Ui& ui, const AxisValue& value, const MapAxis& axis, float number) {
    const float span = std::fabs(axis.to - axis.from);
    const int decimals = span >= 60 ? 0 : span >= 6 ? 1 : 2;
    return fixed(ui, number, decimals) + unit_after(value.unit);
}

std::string measure_words(const Ui& ui, MapMeasure measure) {
    return std::string(ui.strings("map.measure." + std::string(row_of(measure).word)));
}

void map_upper_row(const MapFrame& frame, float width) {
    Ui& ui = frame.ui;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    std::string axis = axis_words(ui, *frame.y), measure = measure_words(ui, frame.map.measure);
    const float gap_between = ui.px(spacing::small);
    const float bare =
        small_button_width(ui, opener_look(frame, "map.y", MapList::y, axis), true) - text_width(ui, Face::small, axis);
    const float room = width - gap_between - 2 * bare;  // for the words of both
    measure = shortened(ui, measure, Face::small, std::max(room / 2, room - text_width(ui, Face::small, axis)));
    axis = shortened(ui, axis, Face::small, room - text_width(ui, Face::small, measure));
    const SmallButton shown = opener_look(frame, "map.measure", MapList::measure, measure);
    const float right = small_button_width(ui, shown, true);
    opener(frame, opener_look(frame, "map.y", MapList::y, axis), MapList::y, "map.up_how", at);
    const float row = ui.px(ui.tall(small_button_height) + 4);
    opener(frame, shown, MapList::measure, "map.shows_how", {at.x + width - right, at.y});
    ImGui::SetCursorScreenPos({at.x, at.y + row});
    if (frame.state.open == MapList::y) axes(frame, width);
    if (frame.state.open == MapList::measure) measures(frame, at.x + width);
    frame.state.added_height = ImGui::GetCursorScreenPos().y - at.y - row;
}

float map_ends_width(const MapFrame& frame) {
    const AxisEnds ends = ends_of(frame.ui, *frame.y, frame.map.y);
    return std::ceil(ends.width(frame.ui) + frame.ui.px(spacing::tight));
}

void map_vertical_ends(const MapFrame& frame, Rect field) {
    Ui& ui = frame.ui;
    const AxisEnds ends = ends_of(ui, *frame.y, frame.map.y);
    const float right = field.x - ui.px(spacing::tight);
    put_end(ui, "map.y.high", ends.high, right, field.y);
    put_end(ui, "map.y.low", ends.low, right, field.y + field.h - line_height(ui, Face::small));
}

void map_lower_row(const MapFrame& frame, Rect field, float left, float width) {
    Ui& ui = frame.ui;
    const float y = ImGui::GetCursorScreenPos().y;
    const AxisEnds ends = ends_of(ui, *frame.x, frame.map.x);
    const float beside = ends.width(ui) + ui.px(6), most = left + width - field.x;
    std::string axis = axis_words(ui, *frame.x);
    const float bare =
        small_button_width(ui, opener_look(frame, "map.x", MapList::x, axis), true) - text_width(ui, Face::small, axis);
    axis = shortened(ui, axis, Face::small, most - 2 * beside - bare);
    const SmallButton x = opener_look(frame, "map.x", MapList::x, axis);
    const float room = small_button_width(ui, x, true);
    // Wider than the field where the words need it.
    const float row = std::max(field.w, room + 2 * beside), numbers = y + ui.px(spacing::hair);
    put_end(ui, "map.x.low", ends.low, field.x + text_width(ui, Face::small, ends.low), numbers);
    put_end(ui, "map.x.high", ends.high, field.x + row, numbers);
    opener(frame, x, MapList::x, "map.across_how", {field.x + (row - room) / 2, y});
    ImGui::SetCursorScreenPos({left, y + ui.px(ui.tall(small_button_height) + 4)});
    if (frame.state.open != MapList::x) return;
    const float top = ImGui::GetCursorScreenPos().y;
    axes(frame, width);
    frame.state.added_height += ImGui::GetCursorScreenPos().y - top;
}

}  // namespace braitenlab::ui
