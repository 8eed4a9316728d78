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

void fit(CanvasState& state, const Layout& layout, Rect area, float ui_scale) {
    const float side = 28 * ui_scale, top = 56 * ui_scale, bottom = 24 * ui_scale;  // above stand the buttons
    const vec2 size = layout.high - layout.low;
    const vec2 room{std::max(area.w - 2 * side, 1.0f), std::max(area.h - top - bottom, 1.0f)};
    state.zoom = std::clamp(std::min(room.x / size.x, room.y / size.y) / ui_scale, least_zoom, 1.4f);
    state.middle = (layout.low + layout.high) / 2;
    const float scale = view_of(state, area, ui_scale).scale, above = (area.h - size.y * scale) / 2;
    if (above < top) state.middle.y -= (top - above) / scale;
    state.own_view = false;
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
