// The card of the map of behaviour: a cell for each pair of values, the dot of the present brain, and a legend.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/map_look.h"
#include "ui/panels/cards.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

using insight::Behaviour;
using insight::MapAxis;
using insight::MapCell;
using insight::MapMeasure;
using insight::MapPlace;

// Layout pixels.
constexpr float dot_radius = 6, dot_grip = 12, least_marked_cell = 6, legend_sign = 13, least_field = 160,
                least_field_in_lecture = 128;

Colour as_colour(MapColour c) { return {c.r, c.g, c.b, 1}; }
MapColour as_map_colour(Colour c) { return {c.r, c.g, c.b}; }

float lightness(MapColour c) { return 0.3f * c.r + 0.59f * c.g + 0.11f * c.b; }

// "LL = RR", "θ LL".
std::string axis_words(const MapAxis& axis) {
    constexpr std::string_view of_threshold = "threshold_";
    std::string words;
    for (const Dial dial : axis.dials) {
        const std::string_view key = name(dial);
        words += words.empty() ? "" : " = ";
        words += key.starts_with(of_threshold) ? "θ " + std::string(key.substr(of_threshold.size())) : std::string(key);
    }
    return words;
}

std::string in_words(const Ui& ui, Behaviour kind) {
    return std::string(ui.strings("map.kind." + std::string(row_of(kind).word)));
}

std::string measure_words(const Ui& ui, MapMeasure measure) {
    return std::string(ui.strings("map.measure." + std::string(row_of(measure).word)));
}

std::string number_words(const Ui& ui, float number, MapMeasure measure) {
    if (!std::isfinite(number)) return std::string(ui.strings("map.never"));
    const std::string_view unit = row_of(measure).unit;
    return fixed(ui, number, unit.empty() ? 0 : 1) + (unit.empty() ? "" : " " + std::string(unit));
}

class MapCard {
public:
    MapCard(const LabView& view, MapState& state, SliderState& sliders, Ui& ui, const VehicleView& vehicle)
        : view_(view),
          map_(*view.map),
          state_(state),
          sliders_(sliders),
          ui_(ui),
          target_(target_of(view, vehicle)),
          pair_(shown_pair(view, vehicle)),
          dials_(read_dials(*brain_of(*view.now, vehicle), pair_)),
          size_(map_.cells->size) {}

    // `room`: height of the card at most, window pixels. The field is smaller where the card would not fit.
    void draw(float room) {
        const float width = card_width(ui_);
        constexpr float heading_and_gaps = 108, rows = 2 * (small_button_height + 4);  // layout pixels
        const auto lines = static_cast<float>(legend_rows() + (view_.lecture ? 0 : 1));
        const float words_and_legend =
            line_height(ui_, Face::strong) + lines * (line_height(ui_, Face::small) + ui_.px(4));
        const float left = room - ui_.px(heading_and_gaps + rows) - words_and_legend;
        const float side =
            std::clamp(left, std::min(ui_.px(view_.lecture ? least_field_in_lecture : least_field), width), width);
        upper_row(width);
        const Item area = item(ui_, "map", {side, side});
        field_ = area.rect;
        cells();
        react(area);
        dot(area);
        progress();
        lower_row(side);
        words(width);
        map_.measure == MapMeasure::behaviour ? legend_of_kinds(width) : legend_of_numbers(width);
    }

private:
    // ── Choices ──
    // A small button that unfolds a list below its row, at this place.
    void opener(std::string_view id, MapList list, const std::string& words, std::string_view how, ImVec2 at) {
        const bool open = state_.open == list;
        ImGui::SetCursorScreenPos(at);
        const Item shown = small_button(ui_, opener_look(id, list, words));
        tooltip(ui_, shown, ui_.strings(how));
        if (shown.pressed) state_.open = open ? MapList::none : list;
    }
    SmallButton opener_look(std::string_view id, MapList list, std::string_view words) const {
        const bool open = state_.open == list;
        return {id, open ? icon::unfolded : icon::folded, words, open};
    }

    // Above the field: the vertical axis with its range, and what is shown.
    void upper_row(float width) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const std::string axis = axis_words(map_.y), measure = measure_words(ui_, map_.measure);
        const float after = small_button_width(ui_, opener_look("map.y", MapList::y, axis), true) + ui_.px(6);
        const float right = small_button_width(ui_, opener_look("map.measure", MapList::measure, measure), true);
        opener("map.y", MapList::y, axis, "map.up_how", at);
        const std::string range =
            fill(ui_.strings("map.range"), {with_sign(ui_, map_.y.from, 0), with_sign(ui_, map_.y.to, 0)});
        if (after + right + text_width(ui_, Face::small, range) < width)
            put(ui_, {at.x + after, at.y + ui_.px(4)}, range, ui_.palette.second_text, Face::small);
        opener("map.measure", MapList::measure, measure, "map.shows_how", {at.x + width - right, at.y});
        ImGui::SetCursorScreenPos({at.x, at.y + ui_.px(small_button_height + 4)});
        if (state_.open == MapList::y) axes(at.x + width);
        if (state_.open == MapList::measure) measures(at.x + width);
    }

    // Below the field: the horizontal axis between the ends of its range.
    void lower_row(float width) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const std::string axis = axis_words(map_.x);
        const float room = small_button_width(ui_, opener_look("map.x", MapList::x, axis), true);
        const Colour quiet = ui_.palette.second_text;
        put(ui_, {at.x, at.y}, with_sign(ui_, map_.x.from, 0), quiet, Face::small);
        put_right(ui_, {at.x + width, at.y}, with_sign(ui_, map_.x.to, 0), quiet, Face::small);
        opener("map.x", MapList::x, axis, "map.across_how", {at.x + (width - room) / 2, at.y});
        ImGui::SetCursorScreenPos({at.x, at.y + ui_.px(small_button_height + 4)});
        if (state_.open == MapList::x) axes(at.x + width);
    }

    // Small buttons in rows. True when the one is clicked.
    bool choice(const std::string& id, const std::string& words, bool on, bool is_first, float right) {
        const SmallButton which{id, {}, words, on};
        if (!is_first) beside_or_below(ui_, small_button_width(ui_, which, true), right);
        return small_button(ui_, which).pressed;
    }

    void axes(float right) {
        const bool is_x = state_.open == MapList::x;
        const MapAxis& now = is_x ? map_.x : map_.y;
        for (const char* path : insight::brain_axes) {
            const std::string words = axis_words(*insight::axis_of(path));
            const bool first = path == insight::brain_axes.front();
            if (!choice((is_x ? "map.x." : "map.y.") + std::string(path), words, now.path == path, first, right))
                continue;
            MapRequest request;
            (is_x ? request.x : request.y) = path;
            ui_.outbox.push_back(request);
            state_.open = MapList::none;
        }
    }

    void measures(float right) {
        for (const auto& row : insight::map_measure_table)
            if (choice("map.measure." + std::string(row.word), measure_words(ui_, row.value), row.value == map_.measure,
                       row.value == MapMeasure::behaviour, right)) {
                ui_.outbox.push_back(MapRequest{.measure = row.value});
                state_.open = MapList::none;
            }
        for (const int seeds : {1, 5})
            if (choice("map.seeds." + std::to_string(seeds),
                       fill(ui_.strings(seeds == 1 ? "map.one_start" : "map.starts"), {std::to_string(seeds)}),
                       seeds == map_.seeds, seeds == 1, right))
                ui_.outbox.push_back(MapRequest{.seeds = seeds});
    }

    // ── The field ──
    Rect cell_rect(MapPlace place) const {
        const float w = field_.w / static_cast<float>(size_), h = field_.h / static_cast<float>(size_);
        const float x = std::floor(field_.x + w * static_cast<float>(place.x));
        const float y = std::floor(field_.y + h * static_cast<float>(size_ - 1 - place.y));
        return {x, y, std::floor(field_.x + w * static_cast<float>(place.x + 1)) - x,
                std::floor(field_.y + h * static_cast<float>(size_ - place.y)) - y};
    }

    void cells() const {
        fill_box(ui_, field_, ui_.palette.ground, 0);
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const MapScale scale = scale_of(map_.cells->cells, map_.measure);
        const bool is_kind = map_.measure == MapMeasure::behaviour;
        const bool has_marks = is_kind && field_.w / static_cast<float>(size_) >= least_marked_cell;
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x) {
                const MapCell* cell = map_.cells->shown({x, y});
                if (!cell) continue;
                const Rect r = cell_rect({x, y});
                const MapColour colour =
                    cell_colour(cell->outcome, cell->agree, map_.measure, scale, as_map_colour(ui_.palette.panel));
                draw.AddRectFilled({r.x, r.y}, {r.x + r.w, r.y + r.h}, paint(as_colour(colour)));
                // Every second cell has its mark, so that a field of one kind stays quiet.
                if (has_marks && (x + y) % 2 == 0) draw_mark(draw, r, cell->outcome.behaviour, colour);
            }
        line_box(ui_, field_, ui_.palette.line, 0);
    }

    void draw_mark(ImDrawList& draw, Rect r, Behaviour kind, MapColour on) const {
        const float dot = std::max(1.0f, std::floor(std::min(r.w, r.h) / (mark_size + 2)));
        const float x = std::floor(r.x + (r.w - dot * mark_size) / 2),
                    y = std::floor(r.y + (r.h - dot * mark_size) / 2);
        const ImU32 ink = paint(lightness(on) < 0.5f ? Colour{1, 1, 1, 0.9f} : Colour{0, 0, 0, 0.75f});
        for (int row = 0; row < mark_size; ++row)
            for (int column = 0; column < mark_size; ++column) {
                if (!is_marked(kind, column, row)) continue;
                int end = column + 1;
                while (end < mark_size && is_marked(kind, end, row)) ++end;
                const float top = y + dot * static_cast<float>(row);
                draw.AddRectFilled({x + dot * static_cast<float>(column), top},
                                   {x + dot * static_cast<float>(end), top + dot}, ink);
                column = end;
            }
    }

    // The place on the axis, 0..1 across the field, and back.
    float share_of(const MapAxis& axis) const {
        const float value = at(dials_, axis.dials.front());
        const float index = (value - axis.from) / (axis.to - axis.from) * static_cast<float>(size_ - 1);
        return std::clamp((index + 0.5f) / static_cast<float>(size_), 0.0f, 1.0f);
    }
    float value_of(const MapAxis& axis, float share) const {
        const float index = share * static_cast<float>(size_) - 0.5f;
        const float value = axis.from + (axis.to - axis.from) * index / static_cast<float>(size_ - 1);
        return std::round(std::clamp(value, axis.from, axis.to) * 100) / 100;
    }
    MapPlace cell_at(float x, float y) const {
        const auto index = [&](float share) {
            return std::clamp(static_cast<int>(share * static_cast<float>(size_)), 0, size_ - 1);
        };
        return {index((x - field_.x) / field_.w), index(1 - (y - field_.y) / field_.h)};
    }
    ImVec2 dot_at() const {
        return {field_.x + share_of(map_.x) * field_.w, field_.y + (1 - share_of(map_.y)) * field_.h};
    }

    void set(float x, float y) {
        const std::uint64_t gesture = gestures::panels + sliders_.gesture;
        for (const auto& [axis, value] : {std::pair(&map_.x, x), std::pair(&map_.y, y)})
            for (const Dial dial : axis->dials)
                if (at(dials_, dial) != value)
                    ui_.outbox.push_back(EditRequest{TurnDial{target_, dial, value, pair_}, gesture});
    }
    void apply(MapPlace place) {
        ++sliders_.gesture;
        set(insight::value_at(map_.x, place.x, size_), insight::value_at(map_.y, place.y, size_));
    }

    void react(const Item& area) {
        const ImVec2 mouse = ImGui::GetIO().MousePos, dot = dot_at();
        const bool is_over = area.hovered && field_.contains(mouse.x, mouse.y);
        const float away = std::hypot(mouse.x - dot.x, mouse.y - dot.y);
        if (is_over && ImGui::IsMouseClicked(0)) {
            state_.drags = away <= ui_.px(dot_grip);
            if (state_.drags)
                ++sliders_.gesture;
            else
                state_.pressed = cell_at(mouse.x, mouse.y);
        }
        if (!ImGui::IsMouseDown(0)) {
            if (state_.pressed && is_over && state_.pressed == cell_at(mouse.x, mouse.y)) apply(*state_.pressed);
            state_.drags = false;
            state_.pressed.reset();
        }
        const bool moved = ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0;
        if (state_.drags && moved)
            set(value_of(map_.x, (mouse.x - field_.x) / field_.w),
                value_of(map_.y, 1 - (mouse.y - field_.y) / field_.h));
        if (is_over && !state_.drags && away > ui_.px(dot_grip)) state_.hovered = cell_at(mouse.x, mouse.y);
        if (state_.drags || (is_over && away <= ui_.px(dot_grip))) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (area.focused) move_by_keys();
        if (!state_.hovered) tooltip(ui_, area, ui_.strings("map.how"));  // it would cover the path in the scene
    }

    // An arrow moves the dot to the next cell.
    void move_by_keys() {
        const MapPlace now = cell_at(dot_at().x, dot_at().y);
        MapPlace to = now;
        while (take(*ui_.keyboard, key::left)) --to.x;
        while (take(*ui_.keyboard, key::right)) ++to.x;
        while (take(*ui_.keyboard, key::down)) --to.y;
        while (take(*ui_.keyboard, key::up)) ++to.y;
        to = {std::clamp(to.x, 0, size_ - 1), std::clamp(to.y, 0, size_ - 1)};
        if (to != now) apply(to);
    }

    // The present brain; hollow where the numbers of an axis differ, so that it is not one of the map.
    void dot(const Item& area) {
        const auto has_one_value = [&](const MapAxis& axis) {
            return std::all_of(axis.dials.begin(), axis.dials.end(),
                               [&](Dial dial) { return at(dials_, dial) == at(dials_, axis.dials.front()); });
        };
        const bool is_of_map = has_one_value(map_.x) && has_one_value(map_.y);
        const ImVec2 at = dot_at();
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const float radius = ui_.px(dot_radius + (state_.drags ? 1.5f : area.warmth));
        draw.AddCircleFilled(at, radius + ui_.px(1.5f), paint({0, 0, 0, 0.85f}), 24);
        draw.AddCircleFilled(at, radius, paint({1, 1, 1, 1}), 24);
        draw.AddCircleFilled(at, radius - ui_.px(2), paint(is_of_map ? ui_.palette.accent : Colour{0, 0, 0, 1}), 24);
        if (!is_of_map) draw.AddCircleFilled(at, radius - ui_.px(3), paint({1, 1, 1, 1}), 24);
        const float grip = ui_.px(dot_grip);
        mark(ui_, "map.dot", {at.x - grip, at.y - grip, 2 * grip, 2 * grip});
        if (state_.hovered) {
            const Rect r = cell_rect(*state_.hovered);
            line_box(ui_, {r.x - 1, r.y - 1, r.w + 2, r.h + 2}, {1, 1, 1, 1}, 0, 2);
            line_box(ui_, {r.x - 2, r.y - 2, r.w + 4, r.h + 4}, {0, 0, 0, 1}, 0);
        }
    }

    // ── Words ──
    // Along the lower edge of the field.
    void progress() const {
        if (map_.progress >= 1) return;
        const float height = ui_.px(4), y = field_.y + field_.h - height;
        fill_box(ui_, {field_.x, y, field_.w, height}, ui_.palette.panel, 0);
        fill_box(ui_, {field_.x, y, field_.w * map_.progress, height}, ui_.palette.accent, 0);
    }

    // What the cell under the pointer shows, else that of the present brain.
    void words(float width) {
        const MapPlace place = state_.hovered ? *state_.hovered : cell_at(dot_at().x, dot_at().y);
        const MapCell* cell = map_.cells->shown(place);
        const ImVec2 at_line = ImGui::GetCursorScreenPos();
        const float line = view_.lecture ? 0 : line_height(ui_, Face::small);
        std::string where(ui_.strings("map.now"));
        if (state_.hovered)
            where = axis_words(map_.x) + " " + fixed(ui_, insight::value_at(map_.x, place.x, size_), 2) + ", " +
                    axis_words(map_.y) + " " + fixed(ui_, insight::value_at(map_.y, place.y, size_), 2);
        if (!view_.lecture)
            put(ui_, at_line, shortened(ui_, where, Face::small, width), ui_.palette.second_text, Face::small);
        if (cell) {
            std::string what = in_words(ui_, cell->outcome.behaviour);
            if (map_.measure != MapMeasure::behaviour)
                what += ", " + measure_words(ui_, map_.measure) + ": " +
                        number_words(ui_, number_of(cell->outcome, map_.measure), map_.measure);
            if (map_.seeds > 1)
                what += " (" +
                        fill(ui_.strings("map.agree"),
                             {std::to_string(std::lround(cell->agree * static_cast<float>(map_.seeds))),
                              std::to_string(map_.seeds)}) +
                        ")";
            put(ui_, {at_line.x, at_line.y + line}, shortened(ui_, what, Face::strong, width), ui_.palette.text,
                Face::strong);
        }
        ImGui::Dummy({1, line + line_height(ui_, Face::strong) + ui_.px(4)});
    }

    // All kinds; in a lecture, where type is large, those of the map.
    std::vector<Behaviour> shown_kinds() const {
        std::vector<Behaviour> kinds;
        for (const auto& row : insight::behaviour_table) {
            const auto& all = map_.cells->cells;
            const bool occurs = std::any_of(all.begin(), all.end(), [&](const std::optional<MapCell>& cell) {
                return cell && cell->outcome.behaviour == row.value;
            });
            if (occurs || !view_.lecture) kinds.push_back(row.value);
        }
        return kinds;
    }
    int legend_rows() const {
        return map_.measure == MapMeasure::behaviour ? static_cast<int>(shown_kinds().size() + 1) / 2 : 2;
    }

    void legend_of_kinds(float width) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float row = line_height(ui_, Face::small) + ui_.px(4), sign = ui_.px(legend_sign);
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const std::vector<Behaviour> kinds = shown_kinds();
        const int rows = legend_rows();
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const BehaviourLook& look = look_of(kinds[i]);
            const int column = static_cast<int>(i) / rows;
            const float x = at.x + static_cast<float>(column) * width / 2;
            const float y = at.y + static_cast<float>(static_cast<int>(i) % rows) * row;
            const Rect box{x, std::floor(y + (row - sign) / 2), sign, sign};
            draw.AddRectFilled({box.x, box.y}, {box.x + sign, box.y + sign}, paint(as_colour(look.colour)));
            draw_mark(draw, box, look.value, look.colour);
            put(ui_, {x + sign + ui_.px(6), y + ui_.px(2)},
                shortened(ui_, in_words(ui_, look.value), Face::small, width / 2 - sign - ui_.px(10)), ui_.palette.text,
                Face::small);
        }
        ImGui::Dummy({1, static_cast<float>(rows) * row});
    }

    void legend_of_numbers(float width) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const MapScale scale = scale_of(map_.cells->cells, map_.measure);
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        constexpr int steps = 32;
        const float height = ui_.px(legend_sign), w = width / steps;
        for (int i = 0; i < steps; ++i)
            draw.AddRectFilled({at.x + w * static_cast<float>(i), at.y},
                               {at.x + w * static_cast<float>(i + 1), at.y + height},
                               paint(as_colour(scale_colour(static_cast<float>(i) / (steps - 1)))));
        const float y = at.y + height + ui_.px(2);
        put(ui_, {at.x, y}, number_words(ui_, scale.low, map_.measure), ui_.palette.text, Face::small);
        put_right(ui_, {at.x + width, y}, number_words(ui_, scale.high, map_.measure), ui_.palette.text, Face::small);
        ImGui::Dummy({1, height + line_height(ui_, Face::small) + ui_.px(4)});
    }

    const LabView& view_;
    const MapView& map_;
    MapState& state_;
    SliderState& sliders_;
    Ui& ui_;
    Target target_;
    SensorPair pair_;
    FourNeurons dials_;
    int size_;
    Rect field_;
};

// Folds the card of the scene, above the map, where the column is too low for both.
void make_room(const LabView& view, PanelState& state, const Ui& ui, Rect place) {
    CardState& scene = state.card(Card::scene);
    const CardState& map = state.card(Card::map);
    const bool is_cut = map.content > 0 && wanted_height(ui, map) > place.h + 1;
    if (view.lesson || !is_cut || scene.folded || scene.opened_by_user) return;
    scene.folded = state.map.folded_scene = true;
}

}  // namespace

void follow_map(const LabView& view, PanelState& state) {
    if (view.settings.map) return;
    if (state.map.folded_scene) state.card(Card::scene).folded = false;
    state.map = {};
}

void map_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect column) {
    const bool open = open_card(state, ui, Card::map, place);
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (open && view.map && vehicle)
        MapCard(view, state.map, state.sliders, ui, *vehicle)
            .draw(column.h - (view.lecture ? 0 : folded_height(ui) + ui.px(12)));  // of the card below
    else if (open)
        paragraph(ui, ui.strings(vehicle ? "unavailable.map" : "unavailable.no_vehicle"), ui.palette.second_text,
                  Face::small);
    CardState& card = state.card(Card::map);
    end_card(card);
    make_room(view, state, ui, place);
    if (!card.folded) return;
    card.folded = false;  // folding closes it
    ui.outbox.push_back(Action::map);
}

}  // namespace braitenlab::ui
