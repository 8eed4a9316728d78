// The field of the map of behaviour: its cells, the dot of the present values, and the mouse and keys over them.
#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "ui/panels/map/map_parts.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using insight::Behaviour;
using insight::MapAxis;
using insight::MapCell;
using insight::MapMeasure;
using insight::MapPlace;

namespace {

constexpr float dot_radius = 6, dot_grip = 12, least_marked_cell = 6;  // layout pixels

MapColour as_map_colour(Colour c) { return {c.r, c.g, c.b}; }
float lightness(MapColour c) { return 0.3f * c.r + 0.59f * c.g + 0.11f * c.b; }

class MapField {
public:
    MapField(const MapFrame& frame, Rect field)
        : frame_(frame), map_(frame.map), state_(frame.state), ui_(frame.ui), field_(field), size_(frame.size()) {}

    void draw(const Item& area) {
        cells();
        react(area);
        dot(area);
        progress();
    }

private:
    Rect cell_rect(MapPlace place) const {
        const float w = field_.w / static_cast<float>(size_), h = field_.h / static_cast<float>(size_);
        const float x = std::floor(field_.x + w * static_cast<float>(place.x));
        const float y = std::floor(field_.y + h * static_cast<float>(size_ - 1 - place.y));
        return {x, y, std::floor(field_.x + w * static_cast<float>(place.x + 1)) - x,
                std::floor(field_.y + h * static_cast<float>(size_ - place.y)) - y};
    }

    void cells() const {
        fill_box(ui_, field_, ui_.palette.ground, Corner::square);
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
                if (has_marks && (x + y) % 2 == 0) draw_map_mark(draw, r, cell->outcome.behaviour, colour);
            }
        line_box(ui_, field_, ui_.palette.line, Corner::square);
    }

    MapPlace cell_at(float x, float y) const {
        const auto index = [&](float share) {
            return std::clamp(static_cast<int>(share * static_cast<float>(size_)), 0, size_ - 1);
        };
        return {index((x - field_.x) / field_.w), index(1 - (y - field_.y) / field_.h)};
    }
    ImVec2 dot_at() const {
        return {field_.x + frame_.share_of(map_.x, frame_.x->now) * field_.w,
                field_.y + (1 - frame_.share_of(map_.y, frame_.y->now)) * field_.h};
    }

    void set(float x, float y) {
        const std::uint64_t gesture = gestures::panels + frame_.sliders.gesture;
        for (const auto& [value, to] : {std::pair(frame_.x, x), std::pair(frame_.y, y)})
            for (Command& command : commands_that_set(frame_.subject, *value, to))
                ui_.outbox.emplace_back(EditRequest{std::move(command), gesture});
    }
    void apply(MapPlace place) {
        ++frame_.sliders.gesture;
        set(insight::value_at(map_.x, place.x, size_), insight::value_at(map_.y, place.y, size_));
    }

    void react(const Item& area) {
        const ImVec2 mouse = ImGui::GetIO().MousePos, dot = dot_at();
        const bool is_over = area.hovered && field_.contains(mouse.x, mouse.y);
        const float away = std::hypot(mouse.x - dot.x, mouse.y - dot.y);
        if (is_over && ImGui::IsMouseClicked(0)) {
            state_.drags = away <= ui_.px(dot_grip);
            if (state_.drags)
                ++frame_.sliders.gesture;
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
            set(frame_.value_of(map_.x, (mouse.x - field_.x) / field_.w),
                frame_.value_of(map_.y, 1 - (mouse.y - field_.y) / field_.h));
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

    // The present values; hollow where those of an axis differ, so that they are not in the map.
    void dot(const Item& area) {
        const bool is_of_map = frame_.x->is_one && frame_.y->is_one;
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
            line_box(ui_, {r.x - 1, r.y - 1, r.w + 2, r.h + 2}, {1, 1, 1, 1}, Corner::square, 2);
            line_box(ui_, {r.x - 2, r.y - 2, r.w + 4, r.h + 4}, {0, 0, 0, 1}, Corner::square);
        }
    }

    // Along the lower edge of the field.
    void progress() const {
        if (map_.progress >= 1) return;
        const float height = ui_.px(4), y = field_.y + field_.h - height;
        fill_box(ui_, {field_.x, y, field_.w, height}, ui_.palette.panel, Corner::square);
        fill_box(ui_, {field_.x, y, field_.w * map_.progress, height}, ui_.palette.accent, Corner::square);
    }

    const MapFrame& frame_;
    const MapView& map_;
    MapState& state_;
    Ui& ui_;
    Rect field_;
    int size_;
};

}  // namespace

float MapFrame::share_of(const MapAxis& axis, float value) const {
    const float index = (value - axis.from) / (axis.to - axis.from) * static_cast<float>(size() - 1);
    return std::clamp((index + 0.5f) / static_cast<float>(size()), 0.0f, 1.0f);
}

float MapFrame::value_of(const MapAxis& axis, float share) const {
    const float index = share * static_cast<float>(size()) - 0.5f;
    const float value = axis.from + (axis.to - axis.from) * index / static_cast<float>(size() - 1);
    const auto [low, high] = std::minmax(axis.from, axis.to);
    const float steps = high - low >= 60 ? 10 : high - low > 0.5f ? 100 : 1000;  // to a unit
    return std::clamp(std::round(value * steps) / steps, low, high);
}

MapPlace MapFrame::cell_of_now() const {
    const auto index = [&](const MapAxis& axis, float value) {
        return std::clamp(static_cast<int>(share_of(axis, value) * static_cast<float>(size())), 0, size() - 1);
    };
    return {index(map.x, x->now), index(map.y, y->now)};
}

void draw_map_mark(ImDrawList& draw, Rect r, Behaviour kind, MapColour on) {
    const float dot = std::max(1.0f, std::floor(std::min(r.w, r.h) / (mark_size + 2)));
    const float x = std::floor(r.x + (r.w - dot * mark_size) / 2), y = std::floor(r.y + (r.h - dot * mark_size) / 2);
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

void map_field(const MapFrame& frame, float side) {
    const Item area = item(frame.ui, "map", {side, side});
    MapField(frame, area.rect).draw(area);
}

}  // namespace braitenlab::ui
