// How the canvas lies in the window: zoom, fit, and what it takes to see a point.
#include <algorithm>

#include "ui/wiring/interaction.h"

namespace braitenlab {

using maths::vec2;

View view_of(const CanvasState& state, Rect area, float ui_scale) {
    const float scale = state.zoom * ui_scale;
    return {vec2{area.x + area.w / 2, area.y + area.h / 2} - state.middle * scale, scale};
}

void zoom_at(CanvasState& state, Rect area, float ui_scale, vec2 pixel, float factor) {
    const vec2 fixed = view_of(state, area, ui_scale).to_canvas(pixel);
    state.zoom = std::clamp(state.zoom * factor, least_zoom, most_zoom);
    state.middle += fixed - view_of(state, area, ui_scale).to_canvas(pixel);
    state.own_view = true;
}

namespace {

// Layout pixels around the fitted brain; `buttons` is the width of the canvas buttons.
constexpr float fit_side = 28, fit_bottom = 24, fit_top = 56, fit_buttons = 212;

float zoom_in(vec2 room, vec2 size, float ui_scale) {
    const float zoom = std::min(std::max(room.x, 1.0f) / size.x, std::max(room.y, 1.0f) / size.y) / ui_scale;
    return std::clamp(zoom, least_zoom, 1.4f);
}

}  // namespace

void fit(CanvasState& state, const Layout& layout, Rect area, float ui_scale) {
    const vec2 size = layout.high - layout.low;
    const float below =
        zoom_in({area.w - 2 * fit_side * ui_scale, area.h - (fit_top + fit_bottom) * ui_scale}, size, ui_scale);
    const float beside =
        zoom_in({area.w - (fit_side + fit_buttons) * ui_scale, area.h - 2 * fit_bottom * ui_scale}, size, ui_scale);
    const bool stands_beside = beside > 1.1f * below;  // in a low room the buttons would cost half of it
    state.zoom = stands_beside ? beside : below;
    state.middle = (layout.low + layout.high) / 2;
    state.own_view = false;
    const float scale = view_of(state, area, ui_scale).scale;
    const float above = (area.h - size.y * scale) / 2, right = (area.w - size.x * scale) / 2;
    if (stands_beside && right < fit_buttons * ui_scale) state.middle.x += (fit_buttons * ui_scale - right) / scale;
    if (!stands_beside && above < fit_top * ui_scale) state.middle.y -= (fit_top * ui_scale - above) / scale;
}

void reveal(CanvasState& state, Rect area, float ui_scale, vec2 point) {
    const View view = view_of(state, area, ui_scale);
    const vec2 at = view.to_window(point);
    const vec2 rim{std::min(96 * ui_scale, area.w / 3), std::min(72 * ui_scale, area.h / 3)};
    const vec2 wanted{std::clamp(at.x, area.x + rim.x, area.x + area.w - rim.x),
                      std::clamp(at.y, area.y + rim.y, area.y + area.h - rim.y)};
    if (wanted == at) return;
    state.middle += (at - wanted) / view.scale;
    state.own_view = true;
}

}  // namespace braitenlab
