// The words below the map of behaviour and the legend of its colours.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/map/map_parts.h"
#include "ui/panels/value_choice.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/number_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using insight::Behaviour;
using insight::MapAxis;
using insight::MapCell;
using insight::MapMeasure;
using insight::MapPlace;

namespace {

constexpr float legend_sign = 13;  // layout pixels
constexpr std::size_t most_apart_lines = 3;

std::string in_words(const Ui& ui, Behaviour kind) {
    return std::string(ui.strings("map.kind." + std::string(row_of(kind).word)));
}

std::string number_words(const Ui& ui, float number, MapMeasure measure) {
    if (!std::isfinite(number)) return std::string(ui.strings("map.never"));
    const std::string_view unit = row_of(measure).unit;
    return fixed(ui, number, unit.empty() ? 0 : 1) + unit_after(unit);
}

// How the present values differ from every cell of the map, where those of an axis differ; else empty.
std::string apart_words(const MapFrame& frame) {
    const Ui& ui = frame.ui;
    for (const insight::AxisValue* value : {frame.x, frame.y}) {
        if (value->is_one) continue;
        const auto brain = brain_of(frame.subject.now, frame.subject.vehicle);
        if (value->dials.empty() || !brain) return std::string(ui.strings("map.sides_apart"));
        const FourNeurons dials = read_dials(*brain, frame.subject.pair);
        const auto part = [&](Dial dial) { return std::string(name(dial)) + " " + fixed(ui, at(dials, dial), 2); };
        return fill(ui.strings("map.apart"), {part(value->dials.front()), part(value->dials.back())});
    }
    return {};
}

// All kinds; in a lecture, where type is large, those of the map.
std::vector<Behaviour> shown_kinds(const MapFrame& frame) {
    std::vector<Behaviour> kinds;
    for (const auto& row : insight::behaviour_table) {
        const auto& all = frame.map.cells->cells;
        const bool occurs = std::any_of(all.begin(), all.end(), [&](const std::optional<MapCell>& cell) {
            return cell && cell->outcome.behaviour == row.value;
        });
        if (occurs || !frame.view.lecture) kinds.push_back(row.value);
    }
    return kinds;
}

// Of the legend below the map: one column where the words of some kind are wider than half of the card.
int legend_columns(const MapFrame& frame) {
    const Ui& ui = frame.ui;
    for (const Behaviour kind : shown_kinds(frame))
        if (text_width(ui, Face::small, in_words(ui, kind)) > card_width(ui) / 2 - ui.px(legend_sign + 10)) return 1;
    return 2;
}

// Draws it at the cursor; each column has this width.
void legend_of_kinds(const MapFrame& frame, float column_width, int columns) {
    Ui& ui = frame.ui;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float row = line_height(ui, Face::small) + ui.px(4), sign = ui.px(legend_sign);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const std::vector<Behaviour> kinds = shown_kinds(frame);
    const int rows = (static_cast<int>(kinds.size()) + columns - 1) / columns;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const BehaviourLook& look = look_of(kinds[i]);
        const int column = static_cast<int>(i) / rows;
        const float x = at.x + static_cast<float>(column) * column_width;
        const float y = at.y + static_cast<float>(static_cast<int>(i) % rows) * row;
        const Rect box{x, std::floor(y + (row - sign) / 2), sign, sign};
        draw.AddRectFilled({box.x, box.y}, {box.x + sign, box.y + sign}, paint(as_colour(look.colour)));
        draw_map_mark(draw, box, look.value, look.colour);
        put(ui, {x + sign + ui.px(6), y + ui.px(2)},
            shortened(ui, in_words(ui, look.value), Face::small, column_width - sign - ui.px(10)), ui.palette.text,
            Face::small);
    }
    ImGui::Dummy({1, static_cast<float>(rows) * row});
}

void legend_of_numbers(const MapFrame& frame, float width) {
    Ui& ui = frame.ui;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const MapScale scale = scale_of(frame.map.cells->cells, frame.map.measure);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    constexpr int steps = 32;
    const float height = ui.px(legend_sign), w = width / steps;
    for (int i = 0; i < steps; ++i)
        draw.AddRectFilled({at.x + w * static_cast<float>(i), at.y},
                           {at.x + w * static_cast<float>(i + 1), at.y + height},
                           paint(as_colour(scale_colour(static_cast<float>(i) / (steps - 1)))));
    const float y = at.y + height + ui.px(2);
    put(ui, {at.x, y}, number_words(ui, scale.low, frame.map.measure), ui.palette.text, Face::small);
    put_right(ui, {at.x + width, y}, number_words(ui, scale.high, frame.map.measure), ui.palette.text, Face::small);
    ImGui::Dummy({1, height + line_height(ui, Face::small) + ui.px(spacing::tight)});
}

}  // namespace

int map_legend_rows(const MapFrame& frame) {
    if (frame.map.measure != MapMeasure::behaviour) return 2;
    const int columns = legend_columns(frame);
    return (static_cast<int>(shown_kinds(frame).size()) + columns - 1) / columns;
}

void map_words(const MapFrame& frame, float width) {
    Ui& ui = frame.ui;
    const MapPlace place = frame.state.hovered ? *frame.state.hovered : frame.cell_of_now();
    const MapCell* cell = frame.map.cells->shown(place);
    const ImVec2 at_line = ImGui::GetCursorScreenPos();
    const float line = frame.view.lecture ? 0 : line_height(ui, Face::small);
    std::string where(ui.strings("map.now"));
    if (frame.state.hovered)
        where = axis_words(ui, *frame.x) + " " +
                value_words(ui, *frame.x, frame.map.x, insight::value_at(frame.map.x, place.x, frame.size())) + ", " +
                axis_words(ui, *frame.y) + " " +
                value_words(ui, *frame.y, frame.map.y, insight::value_at(frame.map.y, place.y, frame.size()));
    if (!frame.view.lecture)
        put(ui, at_line, shortened(ui, where, Face::small, width), ui.palette.second_text, Face::small);
    // The share that is computed: in place of a cell that is not known yet, else where the words leave room for it.
    const std::string share =
        frame.map.progress < 1 ? fill(ui.strings("map.computed"), {fixed(ui, 100 * frame.map.progress, 1)}) : "";
    const std::string apart = frame.state.hovered ? std::string{} : apart_words(frame);
    if (!apart.empty()) {
        put_lines(ui, {at_line.x, at_line.y + line}, apart, ui.palette.text, Face::strong, width, most_apart_lines);
        ImGui::Dummy({1, map_words_height(frame, width)});
        return;
    }
    std::string what = share;
    if (cell) {
        what = in_words(ui, cell->outcome.behaviour);
        if (frame.map.measure != MapMeasure::behaviour)
            what += ", " + measure_words(ui, frame.map.measure) + ": " +
                    number_words(ui, number_of(cell->outcome, frame.map.measure), frame.map.measure);
        if (frame.map.seeds > 1)
            what += " (" +
                    fill(ui.strings("map.agree"),
                         {std::to_string(std::lround(cell->agree * static_cast<float>(frame.map.seeds))),
                          std::to_string(frame.map.seeds)}) +
                    ")";
        // A coarse cell's middle, which may be of another kind.
        if (!frame.map.cells->at(place)) what = fill(ui.strings("map.coarse"), {what});
        const float both = text_width(ui, Face::strong, what) + text_width(ui, Face::strong, share);
        if (!share.empty() && both + ui.px(spacing::medium) <= width)
            put_right(ui, {at_line.x + width, at_line.y + line}, share, ui.palette.second_text, Face::strong);
    }
    put(ui, {at_line.x, at_line.y + line}, shortened(ui, what, Face::strong, width), ui.palette.text, Face::strong);
    ImGui::Dummy({1, line + line_height(ui, Face::strong) + ui.px(spacing::tight)});
}

float map_words_height(const MapFrame& frame, float width) {
    const Ui& ui = frame.ui;
    const std::string apart = apart_words(frame);
    const auto lines = apart.empty() ? 1 : lines_of_words(ui, apart, Face::strong, width).size();
    return (frame.view.lecture ? 0 : line_height(ui, Face::small)) +
           static_cast<float>(std::min<std::size_t>(lines, most_apart_lines)) * line_height(ui, Face::strong) +
           ui.px(spacing::tight);
}

void map_legend(const MapFrame& frame, float width) {
    if (frame.map.measure != MapMeasure::behaviour) return legend_of_numbers(frame, width);
    const int columns = legend_columns(frame);
    legend_of_kinds(frame, width / static_cast<float>(columns), columns);
}

float map_legend_width(const MapFrame& frame) {
    float widest = 0;
    for (const Behaviour kind : shown_kinds(frame))
        widest = std::max(widest, text_width(frame.ui, Face::small, in_words(frame.ui, kind)));
    return widest + frame.ui.px(legend_sign + 11);
}

void map_legend_beside(const MapFrame& frame, Rect field, float width) {
    const ImVec2 below = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({field.x + field.w + frame.ui.px(beside_field), field.y});
    legend_of_kinds(frame, width, 1);
    ImGui::SetCursorScreenPos(below);
}

}  // namespace braitenlab::ui
